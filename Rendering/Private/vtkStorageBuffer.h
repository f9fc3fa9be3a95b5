// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/** Allocation of the storage buffers of vtkFragmentLists and vtkSegmentOpacities. */

#ifndef vtkStorageBuffer_h
#define vtkStorageBuffer_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses
#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN

/**
 * Give the buffer, made here if it is 0, so many bytes, taken from `data` unless that is null.
 * Returns false when OpenGL is out of memory. Errors of earlier calls are forgotten: they must not
 * be taken for one of this.
 */
inline bool vtkAllocateStorage(GLuint& buffer, vtkIdType bytes, const void* data)
{
  if (!buffer)
  {
    glGenBuffers(1, &buffer);
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
  // There is one flag for each kind of error.
  for (int kinds = 0; kinds < 8 && glGetError() != GL_NO_ERROR; ++kinds)
  {
  }
  glBufferData(GL_SHADER_STORAGE_BUFFER, bytes, data, GL_DYNAMIC_COPY);
  const bool allocated = glGetError() != GL_OUT_OF_MEMORY;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return allocated;
}

VTK_ABI_NAMESPACE_END
#endif
