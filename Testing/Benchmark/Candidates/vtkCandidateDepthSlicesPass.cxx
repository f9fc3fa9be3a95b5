// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCandidateDepthSlicesPass.h"

#include "vtkAbstractMapper.h"
#include "vtkCandidateCullDec.h"
#include "vtkCandidateOpacitiesDec.h"
#include "vtkCandidateOpacitiesFS.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkCandidateDepthSlicesPass);

//------------------------------------------------------------------------------
vtkMTimeType vtkCandidateDepthSlicesPass::GetShaderStageMTime()
{
  return std::max(this->Superclass::GetShaderStageMTime(), this->LevelsTime.GetMTime());
}

//------------------------------------------------------------------------------
void vtkCandidateDepthSlicesPass::Define(vtkShaderDefinitions& definitions)
{
  this->Superclass::Define(definitions);
  definitions.Define("OPACITIES_BINDING", static_cast<int>(OpacitiesBinding));
  definitions.Define("LEVELS", this->Levels);
}

//------------------------------------------------------------------------------
std::string vtkCandidateDepthSlicesPass::GetDeclarations()
{
  return this->Superclass::GetDeclarations() + vtkCandidateOpacitiesDec;
}

//------------------------------------------------------------------------------
bool vtkCandidateDepthSlicesPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  vtkShaderProgram::Substitute(vertexShader, "//VTK::DrawOrder::Dec",
    std::string("//VTK::DrawOrder::Dec\n") + vtkCandidateOpacitiesDec + vtkCandidateCullDec, false);
  vtkShaderProgram::Substitute(vertexShader, "//VTK::NodeValue::Impl",
    "if (pellucidIsBehindSaturated(min(x1 - r1, x2 - r2), max(x1 + r1, x2 + r2)))\n"
    "  {\n"
    "    return;\n"
    "  }\n"
    "  //VTK::NodeValue::Impl",
    false);
  if (mapper->IsA("vtkRoundedConeMapper"))
  {
    // Before the ray is intersected.
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::UniformFlow::Impl",
      "if (pellucidIsSaturated(ivec2(gl_FragCoord.xy)))\n"
      "  {\n"
      "    discard;\n"
      "  }\n"
      "  //VTK::UniformFlow::Impl",
      false);
  }
  return this->Superclass::PreReplaceShaderValues(
    vertexShader, geometryShader, fragmentShader, mapper, prop);
}

//------------------------------------------------------------------------------
bool vtkCandidateDepthSlicesPass::RenderTranslucent(const vtkRenderState* state)
{
  int levels = 1;
  while (1 << levels < std::max(this->Viewport[2], this->Viewport[3]))
  {
    ++levels;
  }
  if (levels != this->Levels)
  {
    this->Levels = levels;
    this->LevelsTime.Modified();
  }
  const vtkIdType texels = ((vtkIdType{ 1 } << (2 * levels)) - 1) / 3;
  const auto bytes = texels * static_cast<vtkIdType>(sizeof(float));
  if (!this->Reserve(OpacitiesBinding, bytes))
  {
    return false;
  }
  this->Buffers.Clear(OpacitiesBinding, bytes);
  this->OpacitiesShader = this->AssembleShader(vtkCandidateOpacitiesFS);
  this->HasDrawn = false;
  return this->Superclass::RenderTranslucent(state);
}

//------------------------------------------------------------------------------
void vtkCandidateDepthSlicesPass::DrawNodes(vtkRenderer* renderer, vtkProp* prop, int nodes)
{
  for (int slice = 0; slice < this->Slices; ++slice)
  {
    const auto getStart = [&](vtkIdType number)
    { return static_cast<int>(number * nodes / this->Slices); };
    if (this->HasDrawn)
    {
      this->UpdateOpacities();
    }
    this->HasDrawn = true;
    this->DrawSlice(renderer, prop, getStart(slice), getStart(slice + 1));
  }
}

//------------------------------------------------------------------------------
void vtkCandidateDepthSlicesPass::UpdateOpacities()
{
  vtkStageTimers::Scope stage(this->Timers, "mip map");
  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  vtkOpenGLState::ScopedglEnableDisable scissorSaver(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  for (int level = 1; level <= this->Levels; ++level)
  {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    state->vtkglViewport(
      0, 0, ((this->Viewport[2] - 1) >> level) + 1, ((this->Viewport[3] - 1) >> level) + 1);
    this->DrawPixels(this->OpacitiesShader,
      [level](vtkShaderProgram* program) { program->SetUniformi("pellucidLevel", level); });
  }
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkCandidateDepthSlicesPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Slices: " << this->Slices << "\n";
}

VTK_ABI_NAMESPACE_END
