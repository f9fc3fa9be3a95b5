// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The storage buffers of one candidate, each at the binding of its number. Needs a current
 * OpenGL 4.3 context.
 */

#ifndef vtkCandidateBuffers_h
#define vtkCandidateBuffers_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses
#include "vtkStorageBuffer.h"
#include "vtkType.h"

#include <array>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

class vtkCandidateBuffers
{
public:
  /** The least number of bindings that OpenGL 4.3 promises. */
  static constexpr GLuint NumberOfBuffers = 8;

  vtkCandidateBuffers() = default;
  ~vtkCandidateBuffers() = default;
  vtkCandidateBuffers(const vtkCandidateBuffers&) = delete;
  void operator=(const vtkCandidateBuffers&) = delete;

  /** Most bytes that a shader sees of one buffer. */
  static vtkIdType GetLargestBytes()
  {
    GLint64 bytes = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    return bytes;
  }

  /** Make room for so many bytes, forgetting the content if that is more than there was. False when
   * OpenGL has none, or allows less. */
  bool Reserve(GLuint binding, vtkIdType bytes)
  {
    if (this->Bytes[binding] < bytes)
    {
      const bool allocated = bytes <= vtkCandidateBuffers::GetLargestBytes() &&
        vtkAllocateStorage(this->Handles[binding], bytes, nullptr);
      this->Bytes[binding] = allocated ? bytes : 0;
    }
    return this->Bytes[binding] >= bytes;
  }

  /** Set the first bytes to 0. */
  void Clear(GLuint binding, vtkIdType bytes)
  {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[binding]);
    glClearBufferSubData(
      GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, bytes, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  }

  void Read(GLuint binding, vtkIdType bytes, void* data) const
  {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[binding]);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, data);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  }

  void Write(GLuint binding, vtkIdType bytes, const void* data)
  {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[binding]);
    glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, data);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  }

  void Bind() const
  {
    for (GLuint binding = 0; binding < NumberOfBuffers; ++binding)
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, this->Handles[binding]);
    }
  }

  static void Unbind()
  {
    for (GLuint binding = 0; binding < NumberOfBuffers; ++binding)
    {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, 0);
    }
  }

  vtkIdType GetBytes() const
  {
    return std::accumulate(this->Bytes.begin(), this->Bytes.end(), vtkIdType{ 0 });
  }

  void Release()
  {
    glDeleteBuffers(NumberOfBuffers, this->Handles.data());
    this->Handles.fill(0);
    this->Bytes.fill(0);
  }

private:
  std::array<GLuint, NumberOfBuffers> Handles{};
  std::array<vtkIdType, NumberOfBuffers> Bytes{};
};

VTK_ABI_NAMESPACE_END
#endif
