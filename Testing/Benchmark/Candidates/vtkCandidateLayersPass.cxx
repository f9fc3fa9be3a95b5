// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCandidateLayersPass.h"

#include "vtkCandidateLayersDec.h"
#include "vtkCandidateLayersFS.h"
#include "vtkCandidateLayersStoreDec.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr const char* Interlock = "GL_ARB_fragment_shader_interlock";
constexpr std::uint32_t LossyBit = 0x80000000u;
constexpr vtkIdType DepthBytes = 4;
constexpr vtkIdType ColorBytes = 8;
constexpr vtkIdType StateBytes = 8;
constexpr vtkIdType FrontBytes = 16;

bool HasExtension(const std::string& name)
{
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i)
  {
    if (name == reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, i)))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
std::string vtkCandidateLayersPass::GetReasonUnordered(
  const std::string& renderer, bool hasInterlock)
{
  const bool isSerial = renderer.find("llvmpipe") != std::string::npos ||
    renderer.find("softpipe") != std::string::npos;
  return hasInterlock || isSerial ? std::string()
                                  : "it needs " + std::string(Interlock) +
      " or one of Mesa's software renderers, found \"" + renderer + "\"";
}

//------------------------------------------------------------------------------
std::string vtkCandidateLayersPass::GetReasonUnsupported(vtkOpenGLRenderWindow* window)
{
  this->HasInterlock = HasExtension(Interlock);
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const std::string reason = this->Superclass::GetReasonUnsupported(window);
  return reason.empty() ? vtkCandidateLayersPass::GetReasonUnordered(renderer, this->HasInterlock)
                        : reason;
}

//------------------------------------------------------------------------------
void vtkCandidateLayersPass::Define(vtkShaderDefinitions& definitions)
{
  definitions.Define("DEPTHS_BINDING", static_cast<int>(DepthsBinding));
  definitions.Define("COLORS_BINDING", static_cast<int>(ColorsBinding));
  definitions.Define("STATES_BINDING", static_cast<int>(StatesBinding));
  definitions.Define("FRONTS_BINDING", static_cast<int>(FrontsBinding));
  definitions.Define("LAYERS", this->Layers);
  definitions.Define("LOSSY", LossyBit);
  definitions.Define("INTERLOCK", this->HasInterlock ? 1 : 0);
}

//------------------------------------------------------------------------------
std::string vtkCandidateLayersPass::GetDeclarations()
{
  return vtkCandidateLayersDec;
}

//------------------------------------------------------------------------------
std::string vtkCandidateLayersPass::GetStoreCode()
{
  return this->GetOverflowCode() + vtkCandidateLayersStoreDec;
}

//------------------------------------------------------------------------------
bool vtkCandidateLayersPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  if (this->HasInterlock)
  {
    vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec",
      std::string("//VTK::System::Dec\n#extension ") + Interlock + " : require\n", false);
  }
  return this->Superclass::PostReplaceShaderValues(
    vertexShader, geometryShader, fragmentShader, mapper, prop);
}

//------------------------------------------------------------------------------
bool vtkCandidateLayersPass::RenderTranslucent(const vtkRenderState* state)
{
  const vtkIdType pixels = this->GetNumberOfPixels();
  if (!this->Reserve(DepthsBinding, pixels * this->Layers * DepthBytes) ||
    !this->Reserve(ColorsBinding, pixels * this->Layers * ColorBytes) ||
    !this->Reserve(StatesBinding, pixels * StateBytes) ||
    !this->Reserve(FrontsBinding, pixels * FrontBytes))
  {
    return false;
  }
  {
    vtkStageTimers::Scope stage(this->Timers, "gather");
    this->Buffers.Clear(CountersBinding, sizeof(Counters));
    this->Buffers.Clear(StatesBinding, pixels * StateBytes);
    this->Buffers.Clear(FrontsBinding, pixels * FrontBytes);
    this->Buffers.Bind();
    this->DrawProps(state);
  }
  vtkStageTimers::Scope stage(this->Timers, "resolve");
  this->DrawPixels(this->AssembleShader(vtkCandidateLayersFS));
  return true;
}

//------------------------------------------------------------------------------
void vtkCandidateLayersPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Layers: " << this->Layers << "\n";
}

VTK_ABI_NAMESPACE_END
