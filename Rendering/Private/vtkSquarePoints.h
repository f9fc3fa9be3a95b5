// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points that cover squares of whole pixels: one vertex each, and no edge through them.
 */

#ifndef vtkSquarePoints_h
#define vtkSquarePoints_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses

VTK_ABI_NAMESPACE_BEGIN

/** The side, in pixels, that points may have to be squares in the current framebuffer. With samples
 * and in the compatibility profile they are discs: 0. */
inline float vtkGetLargestSquarePoint()
{
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLE_BUFFERS, &samples);
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  GLfloat sizes[2] = { 0.0f, 0.0f };
  glGetFloatv(GL_POINT_SIZE_RANGE, sizes);
  return samples == 0 || (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0 ? sizes[1] : 0.0f;
}

/** Draw `count` points from vertex `first` on, whose size the current vertex shader sets. */
inline void vtkDrawPoints(GLint first, GLsizei count)
{
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, first, count);
  glDisable(GL_PROGRAM_POINT_SIZE);
}

VTK_ABI_NAMESPACE_END
#endif
