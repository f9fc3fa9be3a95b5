// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BufferMemory.h"

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses

namespace pellucid
{
namespace benchmark
{
namespace
{
// OpenGL cannot list its buffers, but all drivers number them from 1 on and use the numbers of
// those that are deleted again. More in a row than this are not unused between two that are used.
constexpr GLuint LargestGap = 4096;
}

//------------------------------------------------------------------------------
vtkIdType FindBufferBytes()
{
  GLint bound = 0;
  glGetIntegerv(GL_COPY_READ_BUFFER_BINDING, &bound);
  vtkIdType sum = 0;
  GLuint last = 0;
  for (GLuint buffer = 1; buffer <= last + LargestGap; ++buffer)
  {
    if (glIsBuffer(buffer))
    {
      GLint64 bytes = 0;
      glBindBuffer(GL_COPY_READ_BUFFER, buffer);
      glGetBufferParameteri64v(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
      sum += bytes;
      last = buffer;
    }
  }
  glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(bound));
  return sum;
}
}
}
