// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/** How a render pass takes the fragments of VTK's mappers out of their shaders. */

#ifndef vtkFragmentHook_h
#define vtkFragmentHook_h

#include "vtkABINamespace.h" // for the namespace macros
#include "vtkShaderProgram.h"

#include <regex>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

/**
 * Let a mapper's fragment shader call `take(vec4 color, float depth)`, a function that
 * `declarations` have, for each fragment that the opaque scene does not hide; the colour is shaded
 * and straight, the depth that of the window. The declarations have glsl/vtkOpaqueDepthDec.glsl
 * too. `before` is code that comes before the call.
 */
inline void vtkHookFragments(std::string& fragmentShader, const std::string& declarations,
  const std::string& before, const std::string& take)
{
  // VTK's template names gl_FragDepth in a comment in any case.
  static const std::regex assignment("gl_FragDepth\\s*=[^=]");
  const std::string depth =
    std::regex_search(fragmentShader, assignment) ? "gl_FragDepth" : "gl_FragCoord.z";
  // VTK's shader cache begins the shaders of mappers with version 150.
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec",
    "//VTK::System::Dec\n"
    "#extension GL_ARB_shader_storage_buffer_object : require\n"
    "#extension GL_ARB_shading_language_420pack : require\n"
    "#extension GL_ARB_shader_bit_encoding : require\n",
    false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Dec", declarations, false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::PreColor",
    "if (pellucidIsHidden(" + depth + ")) { discard; }\n", false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Impl",
    before + take + "(gl_FragData[0], " + depth + ");\n", false);
}

VTK_ABI_NAMESPACE_END
#endif
