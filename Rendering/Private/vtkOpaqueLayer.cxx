// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpaqueLayer.h"

#include "vtkOpenGLState.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <string>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
GLint GetAttachment(GLenum attachment, GLenum parameter)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, parameter, &value);
  return value;
}

// The sized formats of OpenGL that have a depth, by bits, kind and presence of a stencil.
GLenum GetDepthFormat(int bits, bool isFloat, bool hasStencil)
{
  if (isFloat)
  {
    return hasStencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  }
  if (hasStencil)
  {
    return GL_DEPTH24_STENCIL8;
  }
  return bits == 16 ? GL_DEPTH_COMPONENT16
                    : (bits == 32 ? GL_DEPTH_COMPONENT32 : GL_DEPTH_COMPONENT24);
}
}

//------------------------------------------------------------------------------
bool vtkOpaqueLayer::Format::operator==(const Format& other) const
{
  return std::tie(this->Color, this->Depth, this->Samples, this->Width, this->Height) ==
    std::tie(other.Color, other.Depth, other.Samples, other.Width, other.Height);
}

//------------------------------------------------------------------------------
vtkOpaqueLayer::Format vtkOpaqueLayer::GetFormat(const std::array<int, 4>& viewport)
{
  GLint framebuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  GLint drawBuffer = 0;
  glGetIntegerv(GL_DRAW_BUFFER, &drawBuffer);
  const bool isWindow = framebuffer == 0;
  const GLenum color = isWindow ? GL_BACK_LEFT : static_cast<GLenum>(drawBuffer);
  const GLenum depth = isWindow ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
  const GLenum stencil = isWindow ? GL_STENCIL : GL_STENCIL_ATTACHMENT;

  Format format;
  if (GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING) == GL_SRGB)
  {
    format.Color = GL_SRGB8_ALPHA8;
  }
  else
  {
    const bool isByte = GetAttachment(color, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) <= 8;
    format.Color = isByte ? GL_RGBA8 : GL_RGBA32F;
  }

  format.DepthBits = GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  format.DepthIsFloat = GetAttachment(depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT;
  const bool hasStencil =
    GetAttachment(stencil, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE &&
    GetAttachment(stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE) > 0;
  format.Depth = GetDepthFormat(format.DepthBits, format.DepthIsFloat, hasStencil);

  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  format.Samples = std::max(samples, 1);
  format.Width = viewport[2];
  format.Height = viewport[3];
  return format;
}

//------------------------------------------------------------------------------
void vtkOpaqueLayer::AllocateTexture(
  vtkOpenGLState* state, Texture texture, GLenum internalFormat, GLenum attachment)
{
  const GLenum target = this->Layout.GetTarget();
  const bool isDepth = texture == DepthTexture;
  const bool hasStencil =
    internalFormat == GL_DEPTH24_STENCIL8 || internalFormat == GL_DEPTH32F_STENCIL8;
  state->vtkglActiveTexture(GL_TEXTURE0 + this->Units[texture]);
  glGenTextures(1, &this->Textures[texture]);
  glBindTexture(target, this->Textures[texture]);
  if (this->Layout.Samples > 1)
  {
    glTexImage2DMultisample(target, this->Layout.Samples, internalFormat, this->Layout.Width,
      this->Layout.Height, GL_TRUE);
  }
  else
  {
    glTexStorage2D(target, 1, internalFormat, this->Layout.Width, this->Layout.Height);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER,
    isDepth && hasStencil ? GL_DEPTH_STENCIL_ATTACHMENT : attachment, target,
    this->Textures[texture], 0);
}

//------------------------------------------------------------------------------
void vtkOpaqueLayer::Allocate(vtkOpenGLState* state)
{
  glGenFramebuffers(1, &this->Framebuffer);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  this->Activate(state);
  this->AllocateTexture(state, ColorTexture, this->Layout.Color, GL_COLOR_ATTACHMENT0);
  this->AllocateTexture(state, DepthTexture, this->Layout.Depth, GL_DEPTH_ATTACHMENT);
  this->Deactivate(state);
}

//------------------------------------------------------------------------------
void vtkOpaqueLayer::Copy(vtkOpenGLState* state, const std::array<int, 4>& viewport)
{
  const Format format = vtkOpaqueLayer::GetFormat(viewport);
  this->Origin = { viewport[0], viewport[1] };
  GLint source = 0;
  GLint sourceBuffer = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &source);
  glGetIntegerv(GL_DRAW_BUFFER, &sourceBuffer);

  vtkOpenGLState::ScopedglEnableDisable scissorSaver(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglActiveTexture unitSaver(state);
  state->PushFramebufferBindings();
  if (!(format == this->Layout))
  {
    this->Release();
    this->Layout = format;
    this->Allocate(state);
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, this->Framebuffer);
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(source));
  GLint readBuffer = 0;
  glGetIntegerv(GL_READ_BUFFER, &readBuffer);
  state->vtkglReadBuffer(static_cast<GLenum>(sourceBuffer));
  state->vtkglDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(viewport[0], viewport[1], viewport[0] + viewport[2], viewport[1] + viewport[3],
    0, 0, viewport[2], viewport[3], GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  state->vtkglReadBuffer(static_cast<GLenum>(readBuffer));
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
vtkIdType vtkOpaqueLayer::GetBytes() const
{
  const vtkIdType colorBytes = this->Layout.Color == GL_RGBA32F ? 16 : 4;
  const vtkIdType depthBytes = this->Layout.Depth == GL_DEPTH_COMPONENT16
    ? 2
    : (this->Layout.Depth == GL_DEPTH32F_STENCIL8 ? 8 : 4);
  return this->Framebuffer == 0 ? 0
                                : static_cast<vtkIdType>(this->Layout.Width) * this->Layout.Height *
      this->Layout.Samples * (colorBytes + depthBytes);
}

//------------------------------------------------------------------------------
void vtkOpaqueLayer::Activate(vtkOpenGLState* state)
{
  vtkOpenGLState::ScopedglActiveTexture unitSaver(state);
  for (int i = 0; i < NumberOfTextures; ++i)
  {
    this->Units[i] = state->GetTextureUnitManager()->Allocate();
    state->vtkglActiveTexture(GL_TEXTURE0 + this->Units[i]);
    glBindTexture(this->Layout.GetTarget(), this->Textures[i]);
  }
}

//------------------------------------------------------------------------------
void vtkOpaqueLayer::Deactivate(vtkOpenGLState* state)
{
  vtkOpenGLState::ScopedglActiveTexture unitSaver(state);
  for (int& unit : this->Units)
  {
    state->vtkglActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(this->Layout.GetTarget(), 0);
    state->GetTextureUnitManager()->Free(unit);
    unit = -1;
  }
}

//------------------------------------------------------------------------------
std::string vtkOpaqueLayer::GetShaderDefinitions() const
{
  vtkShaderDefinitions definitions;
  definitions.Define("SAMPLES", this->Layout.Samples);
  const int steps = 1 << std::min(this->Layout.DepthBits, 24);
  definitions.Define("DEPTH_RESOLUTION",
    this->Layout.DepthIsFloat ? "0.0" : "(1.0 / " + std::to_string(steps) + ".0)");
  return definitions.GetText();
}

//------------------------------------------------------------------------------
void vtkOpaqueLayer::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformi("pellucidOpaqueColor", this->Units[ColorTexture]);
  program->SetUniformi("pellucidOpaqueDepth", this->Units[DepthTexture]);
  program->SetUniform2i("pellucidOpaqueOrigin", this->Origin.data());
  program->SetUniformi("pellucidOpaqueScale", this->Scale);
}

//------------------------------------------------------------------------------
void vtkOpaqueLayer::Release()
{
  glDeleteFramebuffers(1, &this->Framebuffer);
  glDeleteTextures(NumberOfTextures, this->Textures.data());
  this->Framebuffer = 0;
  this->Textures.fill(0);
  this->Layout = Format();
}

VTK_ABI_NAMESPACE_END
