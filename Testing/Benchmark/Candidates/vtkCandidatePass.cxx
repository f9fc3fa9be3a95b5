// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCandidatePass.h"

#include "vtkCandidateBlendDec.h"
#include "vtkCandidateDec.h"
#include "vtkExactTransparencyPass.h"
#include "vtkFragmentColorDec.h"
#include "vtkFragmentHook.h"
#include "vtkOpaqueDepthDec.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
std::string vtkCandidatePass::GetReasonUnsupported(vtkOpenGLRenderWindow* window)
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  return samples > 1 ? "it draws into windows without multisampling only, found " +
      std::to_string(samples) + " samples; use vtkRenderWindow::SetMultiSamples(0)"
                     : vtkExactTransparencyPass::GetReasonUnsupported(window);
}

//------------------------------------------------------------------------------
void vtkCandidatePass::Render(const vtkRenderState* state)
{
  auto* renderer = static_cast<vtkOpenGLRenderer*>(state->GetRenderer());
  this->Window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  this->Statistics->Reset();
  this->LossyPixels = 0;
  this->ClearLights(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  {
    vtkStageTimers::Scope stage(this->Timers, "opaque");
    renderer->DeviceRenderOpaqueGeometry(state->GetFrameBuffer());
  }
  const bool isTranslucent =
    std::any_of(state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount(),
      [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
  if (isTranslucent)
  {
    this->Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport.data());
    const std::string reason = this->GetReasonUnsupported(this->Window);
    if (reason.empty())
    {
      this->DrawFrame(state);
    }
    else
    {
      this->ReportOnce(reason);
    }
  }
  this->Timers.Collect(this->Statistics);
  this->Statistics->SetBufferBytes(this->Buffers.GetBytes() + this->Opaque.GetBytes());
}

//------------------------------------------------------------------------------
void vtkCandidatePass::DrawFrame(const vtkRenderState* state)
{
  vtkOpenGLState* glState = this->Window->GetState();
  {
    vtkStageTimers::Scope stage(this->Timers, "copy");
    this->Opaque.Copy(glState, this->Viewport);
  }
  this->Opaque.Activate(glState);
  if (this->Reserve(CountersBinding, sizeof(Counters)) && this->RenderTranslucent(state))
  {
    const Counters counters = this->ReadCounters();
    this->Statistics->SetFragments(counters.Fragments);
    this->Statistics->SetLongestList(counters.LongestList);
    this->LossyPixels = counters.LossyPixels;
  }
  else
  {
    this->ReportOnce("OpenGL has no room for a buffer of " + std::to_string(this->NeededBytes) +
      " bytes, the largest that it allows has " +
      std::to_string(vtkCandidateBuffers::GetLargestBytes()) + "; draw a smaller picture");
  }
  vtkCandidateBuffers::Unbind();
  this->Opaque.Deactivate(glState);
}

//------------------------------------------------------------------------------
void vtkCandidatePass::ReportOnce(const std::string& reason)
{
  this->LossyPixels = this->GetNumberOfPixels();
  if (!this->HasReported)
  {
    vtkErrorMacro("Only the opaque scene is drawn, because " << reason << ".");
    this->HasReported = true;
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkCandidatePass::GetNumberOfPixels() const
{
  return static_cast<vtkIdType>(this->Viewport[2]) * this->Viewport[3];
}

//------------------------------------------------------------------------------
bool vtkCandidatePass::Reserve(GLuint binding, vtkIdType bytes)
{
  this->NeededBytes = bytes;
  return this->Buffers.Reserve(binding, bytes);
}

//------------------------------------------------------------------------------
vtkCandidatePass::Counters vtkCandidatePass::ReadCounters() const
{
  Counters counters;
  this->Buffers.Read(CountersBinding, sizeof(counters), &counters);
  return counters;
}

//------------------------------------------------------------------------------
std::string vtkCandidatePass::GetDefinitions()
{
  vtkShaderDefinitions definitions;
  definitions.Define("COUNTERS_BINDING", static_cast<int>(CountersBinding));
  definitions.Define("NEGLIGIBLE_TRANSMITTANCE", this->NegligibleTransmittance);
  definitions.Define("VISIBLE_TRANSMITTANCE", ExactTransmittance);
  this->Define(definitions);
  return this->Opaque.GetShaderDefinitions() + definitions.GetText();
}

//------------------------------------------------------------------------------
void vtkCandidatePass::SetPixelUniforms(vtkShaderProgram* program)
{
  program->SetUniform2i("pellucidViewportOrigin", this->Viewport.data());
  program->SetUniform2i("pellucidViewportSize", this->Viewport.data() + 2);
  this->Opaque.SetUniforms(program);
}

//------------------------------------------------------------------------------
void vtkCandidatePass::DrawOffScreen(const std::function<void()>& draw)
{
  this->Framebuffer.Use(this->Window, this->Viewport[0] + this->Viewport[2],
    this->Viewport[1] + this->Viewport[3], draw);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
void vtkCandidatePass::DrawProps(const vtkRenderState* state)
{
  this->PreRender(state);
  this->DrawOffScreen(
    [&]
    {
      for (vtkProp* prop : this->GetDrawnProps(state))
      {
        this->DrawProp(state->GetRenderer(), prop);
      }
    });
  this->PostRender(state);
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkCandidatePass::GetDrawnProps(const vtkRenderState* state)
{
  return { state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount() };
}

//------------------------------------------------------------------------------
void vtkCandidatePass::DrawProp(vtkRenderer* renderer, vtkProp* prop)
{
  prop->RenderTranslucentPolygonalGeometry(renderer);
}

//------------------------------------------------------------------------------
std::string vtkCandidatePass::AssembleShader(
  const std::string& fragmentShader, const std::string& moreDefinitions)
{
  std::string source = fragmentShader;
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Definitions", this->GetDefinitions() + moreDefinitions);
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Declarations",
    std::string(vtkCandidateDec) + vtkFragmentColorDec + this->GetDeclarations());
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Blend", vtkCandidateBlendDec);
  return source;
}

//------------------------------------------------------------------------------
void vtkCandidatePass::DrawPixels(
  const std::string& shader, const vtkStageDraw::SetUniforms& setUniforms)
{
  this->Stage.Draw(this->Window, shader,
    [&](vtkShaderProgram* program)
    {
      this->SetPixelUniforms(program);
      if (setUniforms)
      {
        setUniforms(program);
      }
    });
}

//------------------------------------------------------------------------------
bool vtkCandidatePass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  vtkHookFragments(fragmentShader,
    this->GetDefinitions() + vtkCandidateDec + vtkFragmentColorDec + vtkOpaqueDepthDec +
      this->GetDeclarations() + this->GetStoreCode(),
    "", this->GetStoreFunction());
  return true;
}

//------------------------------------------------------------------------------
bool vtkCandidatePass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  this->SetPixelUniforms(program);
  this->SetStoreUniforms(program);
  return true;
}

//------------------------------------------------------------------------------
void vtkCandidatePass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  // VTK asks for it before a window has a context, too.
  if (window && window == this->Window)
  {
    window->MakeCurrent();
    this->Buffers.Release();
    this->Opaque.Release();
    this->Framebuffer.Release();
    this->Stage.Release();
    this->Window = nullptr;
  }
}

//------------------------------------------------------------------------------
void vtkCandidatePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NegligibleTransmittance: " << this->NegligibleTransmittance << "\n";
  os << indent << "LossyPixels: " << this->LossyPixels << "\n";
  os << indent << "Statistics:\n";
  this->Statistics->PrintSelf(os, indent.GetNextIndent());
}

VTK_ABI_NAMESPACE_END
