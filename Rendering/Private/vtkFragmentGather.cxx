// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFragmentGather.h"

#include "Importance.h"
#include "vtkFragmentAppendDec.h"
#include "vtkFragmentColorDec.h"
#include "vtkFragmentHook.h"
#include "vtkFragmentImportanceDec.h"
#include "vtkFragmentLists.h"
#include "vtkFragmentListsDec.h"
#include "vtkFragmentStages.h"
#include "vtkImportanceDrivenOpacity.h"
#include "vtkOpaqueDepthDec.h"
#include "vtkOpaqueLayer.h"
#include "vtkOptimizedScene.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkRoundedConeMapper.h"
#include "vtkSegmentOpacities.h"
#include "vtkShaderProgram.h"
#include "vtkSurfaceImportanceDec.h"
#include "vtkSurfaceImportanceGS.h"
#include "vtkSurfaceImportanceVS.h"
#include "vtkTangentDec.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Where importances join the positions that VTK passes from shader to shader.
constexpr const char* PositionDeclarations = "//VTK::PositionVC::Dec";
constexpr const char* PositionImplementation = "//VTK::PositionVC::Impl";

bool PassesImportance(const std::string& shader)
{
  return shader.find("pellucidPassImportance") != std::string::npos;
}
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkFragmentGather::GetProps(const vtkRenderState* state)
{
  return { state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount() };
}

//------------------------------------------------------------------------------
void vtkFragmentGather::ForgetProps()
{
  this->RenderedProps.clear();
  this->PropsWithoutHooks.clear();
}

//------------------------------------------------------------------------------
void vtkFragmentGather::SetFormat(const vtkOpaqueLayer& opaque, bool storesImportance)
{
  const std::string opaqueDefinitions = opaque.GetShaderDefinitions();
  if (this->OpaqueDefinitions != opaqueDefinitions || this->StoresImportance != storesImportance)
  {
    this->OpaqueDefinitions = opaqueDefinitions;
    this->StoresImportance = storesImportance;
    this->ShaderTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkFragmentGather::DrawProps(const vtkRenderState* state, const vtkPixelRectangle& tile,
  const vtkFragmentLists& lists, const vtkOpaqueLayer& opaque, const vtkOptimizedScene& scene)
{
  this->Tile = tile;
  this->Lists = &lists;
  this->Opaque = &opaque;
  this->Scene = &scene;
  // All props, as VTK does: some draw translucent geometry without saying so before.
  for (vtkProp* prop : vtkFragmentGather::GetProps(state))
  {
    this->Prop = prop;
    this->RanHook = false;
    if (prop->RenderTranslucentPolygonalGeometry(state->GetRenderer()) > 0)
    {
      this->RenderedProps.insert(prop);
      if (!this->RanHook)
      {
        this->PropsWithoutHooks.insert(prop);
      }
    }
  }
  this->Prop = nullptr;
}

//------------------------------------------------------------------------------
bool vtkFragmentGather::NeedsImportance(vtkAbstractMapper* mapper) const
{
  return this->StoresImportance && !vtkRoundedConeMapper::SafeDownCast(mapper);
}

//------------------------------------------------------------------------------
void vtkFragmentGather::EditVertexShaders(
  std::string& vertexShader, std::string& geometryShader, vtkAbstractMapper* mapper) const
{
  // Mappers of composite data and glyphs come twice.
  if (!this->NeedsImportance(mapper) || PassesImportance(vertexShader))
  {
    return;
  }
  const auto edit = [](std::string& shader, const char* declarations, const char* call)
  {
    vtkShaderProgram::Substitute(
      shader, PositionDeclarations, std::string(declarations) + PositionDeclarations, false);
    vtkShaderProgram::Substitute(
      shader, PositionImplementation, std::string(call) + PositionImplementation, false);
  };
  edit(vertexShader, vtkSurfaceImportanceVS, "pellucidPassImportance();\n");
  edit(geometryShader, vtkSurfaceImportanceGS, "pellucidPassImportance(i);\n");
}

//------------------------------------------------------------------------------
void vtkFragmentGather::EditFragmentShader(const std::string& vertexShader,
  const std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper) const
{
  // Impostors have shaders without a place for it: their fragments are unimportant.
  const bool needsImportance = this->NeedsImportance(mapper) && PassesImportance(vertexShader) &&
    (geometryShader.empty() || PassesImportance(geometryShader));
  const std::string declarations = this->OpaqueDefinitions +
    vtkFragmentLists::GetShaderDefinitions(this->StoresImportance) +
    vtkSegmentOpacities::GetShaderDefinitions() + vtkFragmentListsDec + vtkFragmentColorDec +
    vtkOpaqueDepthDec +
    (this->StoresImportance ? std::string(vtkFragmentImportanceDec) + vtkTangentDec : "") +
    vtkFragmentAppendDec + (needsImportance ? vtkSurfaceImportanceDec : "");
  vtkHookFragments(fragmentShader, declarations,
    needsImportance ? "pellucidSetImportance();\n" : "", "pellucidAppend");
}

//------------------------------------------------------------------------------
void vtkFragmentGather::SetUniforms(vtkShaderProgram* program, vtkAbstractMapper* mapper)
{
  if (!program->IsUniformUsed("pellucidNodeCapacity"))
  {
    return;
  }
  this->RanHook = true;
  vtkFragmentStages::SetTile(program, this->Tile);
  this->Opaque->SetUniforms(program);
  program->SetUniformi("pellucidNodeCapacity", static_cast<int>(this->Lists->GetNodeCapacity()));
  if (program->IsUniformUsed("pellucidFirstSegment"))
  {
    const vtkOptimizedScene::Member* member = this->Scene->Find(this->Prop);
    const vtkOptimizedScene::Part part =
      member ? member->FindPart(mapper) : vtkOptimizedScene::Part();
    // Vertices of data without importance hold whatever OpenGL has in place of it.
    const auto range = part.HasImportance
      ? pellucid::ImportanceRange<float>(member->Settings->GetImportanceRange())
      : pellucid::ImportanceRange<float>::None();
    const float numbers[] = { range.direction, range.first, range.last, range.scale };
    program->SetUniform4f("pellucidImportanceRange", numbers);
    program->SetUniformi("pellucidFirstSegment", static_cast<int>(part.FirstSegment));
    program->SetUniformi("pellucidAvoids", member && member->Avoids ? 1 : 0);
    program->SetUniformi(
      "pellucidFirstCorner", part.HasCorners ? static_cast<int>(part.FirstCorner) : -1);
    program->SetUniformi("pellucidFirstCornerOpacity",
      static_cast<int>(this->Scene->GetNumberOfSegments() + part.FirstCorner));
  }
}

VTK_ABI_NAMESPACE_END
