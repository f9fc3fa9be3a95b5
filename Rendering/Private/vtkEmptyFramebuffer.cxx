// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkEmptyFramebuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkEmptyFramebuffer::Use(
  vtkOpenGLRenderWindow* window, int width, int height, const std::function<void()>& draw)
{
  vtkOpenGLState* state = window->GetState();
  if (this->Handle == 0)
  {
    glGenFramebuffers(1, &this->Handle);
  }
  state->PushFramebufferBindings();
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, this->Handle);
  state->vtkglDrawBuffer(GL_NONE);
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
  glFramebufferParameteri(GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
  draw();
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkEmptyFramebuffer::Release()
{
  glDeleteFramebuffers(1, &this->Handle);
  this->Handle = 0;
}

VTK_ABI_NAMESPACE_END
