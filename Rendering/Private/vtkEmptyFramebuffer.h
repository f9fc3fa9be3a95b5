// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A framebuffer without attachments: for draws whose shaders write to buffers only. Needs a current
 * OpenGL 4.3 context.
 */

#ifndef vtkEmptyFramebuffer_h
#define vtkEmptyFramebuffer_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses

#include <functional>

VTK_ABI_NAMESPACE_BEGIN

class vtkOpenGLRenderWindow;

class vtkEmptyFramebuffer
{
public:
  vtkEmptyFramebuffer() = default;
  ~vtkEmptyFramebuffer() = default;
  vtkEmptyFramebuffer(const vtkEmptyFramebuffer&) = delete;
  void operator=(const vtkEmptyFramebuffer&) = delete;

  /** Call `draw` while it is bound, with that size. Viewport and scissor stay the caller's. */
  void Use(vtkOpenGLRenderWindow* window, int width, int height, const std::function<void()>& draw);

  void Release();

private:
  GLuint Handle = 0;
};

VTK_ABI_NAMESPACE_END
#endif
