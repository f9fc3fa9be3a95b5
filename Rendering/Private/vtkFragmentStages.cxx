// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFragmentStages.h"

#include "vtkFragmentImportanceDec.h"
#include "vtkFragmentLists.h"
#include "vtkFragmentListsDec.h"
#include "vtkFragmentResolveFS.h"
#include "vtkFragmentSolveFS.h"
#include "vtkFragmentSortFS.h"
#include "vtkOpaqueDepthDec.h"
#include "vtkOpaqueLayer.h"
#include "vtkOptimizedOpacityDec.h"
#include "vtkSegmentOpacities.h"
#include "vtkSegmentTablesDec.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkFragmentStages::SetTile(vtkShaderProgram* program, const vtkPixelRectangle& tile)
{
  program->SetUniform2i("pellucidTileOrigin", tile.Origin.data());
  program->SetUniform2i("pellucidTileSize", tile.Size.data());
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Draw(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
  const vtkPixelRectangle& tile, const char* fragmentShader, const std::string& moreDefinitions)
{
  const std::string definitions =
    vtkFragmentLists::GetShaderDefinitions(opaque.GetSamples(), this->Optimize) +
    vtkSegmentOpacities::GetShaderDefinitions() + moreDefinitions;
  const auto whereOptimizing = [this](const char* code) { return this->Optimize ? code : ""; };
  std::string source = fragmentShader;
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Definitions", definitions);
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Lists", vtkFragmentListsDec);
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::OpaqueDepth", vtkOpaqueDepthDec);
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Importance", whereOptimizing(vtkFragmentImportanceDec));
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Segments", whereOptimizing(vtkSegmentTablesDec));
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Opacity", whereOptimizing(vtkOptimizedOpacityDec));

  this->Stage.Draw(window, source,
    [&](vtkShaderProgram* program)
    {
      vtkFragmentStages::SetTile(program, tile);
      opaque.SetUniforms(program);
    });
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Sort(
  vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile)
{
  this->Draw(window, opaque, tile, vtkFragmentSortFS);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Solve(
  vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile)
{
  this->Draw(window, opaque, tile, vtkFragmentSolveFS);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Resolve(
  vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile)
{
  this->Draw(window, opaque, tile, vtkFragmentResolveFS, "#define PELLUCID_SAMPLE_SHADING 0\n");
  if (opaque.GetSamples() > 1)
  {
    this->Draw(window, opaque, tile, vtkFragmentResolveFS, "#define PELLUCID_SAMPLE_SHADING 1\n");
  }
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Release()
{
  this->Stage.Release();
}

VTK_ABI_NAMESPACE_END
