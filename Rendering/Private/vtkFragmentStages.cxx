// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFragmentStages.h"

#include "vtkExactTransparencyPass.h"
#include "vtkFragmentAvoidFS.h"
#include "vtkFragmentBlocksVS.h"
#include "vtkFragmentColorDec.h"
#include "vtkFragmentImportanceDec.h"
#include "vtkFragmentLists.h"
#include "vtkFragmentListsDec.h"
#include "vtkFragmentResolveFS.h"
#include "vtkFragmentSolveFS.h"
#include "vtkFragmentSortFS.h"
#include "vtkOpaqueDepthDec.h"
#include "vtkOpaqueLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOptimizedOpacityDec.h"
#include "vtkPictureViewDec.h"
#include "vtkPixelAttributes.h"
#include "vtkPixelAttributesDec.h"
#include "vtkPixelAttributesFS.h"
#include "vtkPowerDec.h"
#include "vtkSegmentOpacities.h"
#include "vtkSegmentTablesDec.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"
#include "vtkSquarePoints.h"
#include "vtkTangentDec.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
std::string GetViewDefinitions(const vtkPictureView& view)
{
  using Pass = vtkExactTransparencyPass;
  vtkShaderDefinitions definitions;
  definitions.Define("VIEW", view.Kind);
  definitions.Define("ROUND_LAYERS", view.RoundsLayers ? 1 : 0);
  definitions.Define("VIEW_OPACITY", static_cast<int>(Pass::VIEW_OPACITY));
  definitions.Define("VIEW_IMPORTANCE", static_cast<int>(Pass::VIEW_IMPORTANCE));
  definitions.Define("VIEW_SEGMENTS", static_cast<int>(Pass::VIEW_SEGMENTS));
  definitions.Define("VIEW_LENGTH", static_cast<int>(Pass::VIEW_LENGTH));
  definitions.Define("VIEW_FIRST_LAYERS", static_cast<int>(Pass::VIEW_FIRST_LAYERS));
  definitions.Define("VIEW_LAYER", static_cast<int>(Pass::VIEW_LAYER));
  return definitions.GetText();
}

//------------------------------------------------------------------------------
// OpenGL 4.3 does not ask for storage buffers in vertex shaders. Without, all pixels are drawn.
bool CanDrawBlocks()
{
  GLint buffers = 0;
  glGetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &buffers);
  return buffers > 0 && vtkGetLargestSquarePoint() >= vtkFragmentLists::BlockSide;
}
}

//------------------------------------------------------------------------------
void vtkFragmentStages::SetTile(vtkShaderProgram* program, const vtkPixelRectangle& tile)
{
  program->SetUniform2i("pellucidTileOrigin", tile.Origin.data());
  program->SetUniform2i("pellucidTileSize", tile.Size.data());
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Draw(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
  const vtkPixelRectangle& tile, std::uint32_t blocks, const char* fragmentShader,
  const std::string& moreDefinitions, const vtkStageDraw::SetUniforms& setMoreUniforms)
{
  vtkShaderDefinitions blockDefinitions;
  blockDefinitions.Define("DRAWN_BLOCKS", blocks);
  const std::string definitions = opaque.GetShaderDefinitions() +
    vtkFragmentLists::GetShaderDefinitions(this->StoresImportance) +
    vtkSegmentOpacities::GetShaderDefinitions() + moreDefinitions;
  const auto whereStored = [this](const char* code) { return this->StoresImportance ? code : ""; };
  std::string source = fragmentShader;
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Definitions", definitions);
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Lists", std::string(vtkFragmentListsDec) + vtkFragmentColorDec);
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::OpaqueDepth", vtkOpaqueDepthDec);
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Importance", whereStored(vtkFragmentImportanceDec));
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Segments", whereStored(vtkSegmentTablesDec));
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Opacity", whereStored(vtkOptimizedOpacityDec));

  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Power", vtkPowerDec);
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Tangent", vtkTangentDec);
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Attributes", vtkPixelAttributesDec);
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::View", vtkPictureViewDec);
  const auto setUniforms = [&](vtkShaderProgram* program)
  {
    vtkFragmentStages::SetTile(program, tile);
    opaque.SetUniforms(program);
    if (setMoreUniforms)
    {
      setMoreUniforms(program);
    }
  };
  if (blocks == 0 || !CanDrawBlocks())
  {
    this->Stage.Draw(window, source, setUniforms);
    return;
  }
  std::string vertexShader = vtkFragmentBlocksVS;
  vtkShaderProgram::Substitute(
    vertexShader, "//VTK::Pellucid::Definitions", definitions + blockDefinitions.GetText());
  vtkShaderProgram::Substitute(vertexShader, "//VTK::Pellucid::Lists", vtkFragmentListsDec);
  const std::array<int, 2> grid = vtkFragmentLists::GetBlocks(tile.Size);
  vtkOpenGLState::ScopedglViewport viewportSaver(window->GetState());
  window->GetState()->vtkglViewport(tile.Origin[0], tile.Origin[1],
    grid[0] * vtkFragmentLists::BlockSide, grid[1] * vtkFragmentLists::BlockSide);
  this->Stage.DrawPoints(window, grid[0] * grid[1], vertexShader, source, setUniforms);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::DrawSort(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
  const vtkPixelRectangle& tile, std::uint32_t blocks, bool breaksTies)
{
  vtkShaderDefinitions definitions;
  definitions.Define("BREAK_TIES", breaksTies ? 1 : 0);
  definitions.Define("DROPS_HIDDEN", this->KeepsHidden ? 0 : 1);
  this->Draw(window, opaque, tile, blocks, vtkFragmentSortFS, definitions.GetText());
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Sort(
  vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile)
{
  this->DrawSort(window, opaque, tile, vtkFragmentLists::BlockHasFragments, false);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::BreakTies(
  vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile)
{
  this->DrawSort(window, opaque, tile, vtkFragmentLists::BlockHasTies, true);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Solve(
  vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque, const vtkPixelRectangle& tile)
{
  this->Draw(window, opaque, tile, vtkFragmentLists::BlockHasFragments, vtkFragmentSolveFS);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::DrawAttributes(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
  const vtkPixelRectangle& tile, std::uint32_t blocks, const char* fragmentShader,
  const vtkPixelAttributes& attributes)
{
  this->Draw(window, opaque, tile, blocks, fragmentShader,
    vtkPixelAttributes::GetShaderDefinitions(attributes.Smooths()),
    [&attributes](vtkShaderProgram* program) { attributes.SetUniforms(program); });
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::FindAttributes(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
  const vtkPixelRectangle& tile, const vtkPixelAttributes& attributes)
{
  this->DrawAttributes(window, opaque, tile, 0, vtkPixelAttributesFS, attributes);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Avoid(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
  const vtkPixelRectangle& tile, const vtkPixelAttributes& attributes)
{
  this->DrawAttributes(
    window, opaque, tile, vtkFragmentLists::BlockHasFragments, vtkFragmentAvoidFS, attributes);
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Resolve(vtkOpenGLRenderWindow* window, const vtkOpaqueLayer& opaque,
  const vtkPixelRectangle& tile, const vtkPictureView& view)
{
  const auto setView = [&view](vtkShaderProgram* program)
  {
    program->SetUniformi("pellucidLayer", view.Layer);
    program->SetUniformi("pellucidLongestOfPicture", static_cast<int>(view.LongestList));
  };
  const std::string definitions = GetViewDefinitions(view) + "#define PELLUCID_SAMPLE_SHADING ";
  this->Draw(window, opaque, tile, vtkFragmentLists::BlockHasFragments, vtkFragmentResolveFS,
    definitions + "0\n", setView);
  if (opaque.GetSamples() > 1)
  {
    this->Draw(window, opaque, tile, vtkFragmentLists::BlockHasFragments, vtkFragmentResolveFS,
      definitions + "1\n", setView);
  }
}

//------------------------------------------------------------------------------
void vtkFragmentStages::Release()
{
  this->Stage.Release();
}

VTK_ABI_NAMESPACE_END
