// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points that cover squares of whole pixels: one vertex each, and no edge through them.
 */

#ifndef vtkSquarePoints_h
#define vtkSquarePoints_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses

VTK_ABI_NAMESPACE_BEGIN

/** The side, in pixels, that they may have: 0 in the compatibility profile, where points may be
 * discs. */
inline float vtkGetLargestSquarePoint()
{
  GLint profile = 0;
  glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
  GLfloat sizes[2] = { 0.0f, 0.0f };
  glGetFloatv(GL_POINT_SIZE_RANGE, sizes);
  return (profile & GL_CONTEXT_CORE_PROFILE_BIT) != 0 ? sizes[1] : 0.0f;
}

/** While it lives, vertex shaders set the size of points. vtkOpenGLState does not know of this
 * state. */
class vtkProgramPointSize
{
public:
  vtkProgramPointSize()
    : WasEnabled(glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE)
  {
    glEnable(GL_PROGRAM_POINT_SIZE);
  }
  ~vtkProgramPointSize()
  {
    if (!this->WasEnabled)
    {
      glDisable(GL_PROGRAM_POINT_SIZE);
    }
  }
  vtkProgramPointSize(const vtkProgramPointSize&) = delete;
  void operator=(const vtkProgramPointSize&) = delete;

private:
  bool WasEnabled;
};

VTK_ABI_NAMESPACE_END
#endif
