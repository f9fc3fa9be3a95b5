// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkBlockDisplayShader.h
 * @brief   Lets the shaders of a vtkOpenGLPolyDataMapper draw blocks as they are displayed.
 *
 * What is displayed lies in uniforms: when it changes, no buffers are made again, and shaders only
 * where vtkAddBlockColor() is left out as long as no block has a colour.
 */

#ifndef vtkBlockDisplayShader_h
#define vtkBlockDisplayShader_h

#include "vtkActor.h"
#include "vtkDisplayedLeaf.h"
#include "vtkProperty.h"
#include "vtkShaderEdit.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

/** Let the colour of a block override those found before; before the superclass does its part. */
inline void vtkAddBlockColor(vtkShaderEdit& fragment)
{
  fragment.Append("//VTK::Color::Dec", "uniform vec4 blockColor; // alpha 0: none\n");
  fragment.Append("//VTK::Color::Impl",
    "  if (blockColor.a > 0.0)\n"
    "  {\n"
    "    ambientColor = ambientIntensity * blockColor.rgb;\n"
    "    diffuseColor = diffuseIntensity * blockColor.rgb;\n"
    "  }\n");
}

/** What is drawn next is of that block; after the superclass has set what it knows. */
inline void vtkSetBlockDisplay(
  vtkShaderProgram* program, const vtkBlockDisplay& display, vtkActor* actor)
{
  float color[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  if (display.Color)
  {
    std::copy(display.Color->begin(), display.Color->end(), color);
    color[3] = 1.0f;
  }
  program->SetUniform4f("blockColor", color);
  const auto setOpacity = [&](const char* uniform, vtkProperty* property)
  {
    const double opacity = display.Opacity.value_or(property->GetOpacity());
    program->SetUniformf(uniform, static_cast<float>(opacity));
  };
  setOpacity("opacityUniform", actor->GetProperty());
  if (vtkProperty* back = actor->GetBackfaceProperty())
  {
    setOpacity("opacityUniformBF", back);
  }
}

VTK_ABI_NAMESPACE_END
#endif
