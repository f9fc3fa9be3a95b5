// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkBufferTexture.h"

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses
#include "vtkOpenGLRenderWindow.h"

#include <type_traits>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
template <typename Value>
bool vtkBufferTexture::Upload(
  vtkOpenGLRenderWindow* window, const Value* values, std::size_t count, int components)
{
  this->Texture->SetContext(window);
  this->Texture->ResetFormatAndType(); // or it keeps those of the last upload
  int type = std::is_same<Value, float>::value ? VTK_FLOAT : VTK_UNSIGNED_CHAR;
  if (std::is_same<Value, int>::value)
  {
    // VTK would make floats of them.
    type = VTK_INT;
    this->Texture->SetInternalFormat(GL_RGBA32I);
  }
  this->Current =
    this->Buffer->Upload(values, count * components, vtkOpenGLBufferObject::TextureBuffer) &&
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(count), components, type, this->Buffer);
  return this->Current;
}

template bool vtkBufferTexture::Upload(vtkOpenGLRenderWindow*, const float*, std::size_t, int);
template bool vtkBufferTexture::Upload(vtkOpenGLRenderWindow*, const int*, std::size_t, int);
template bool vtkBufferTexture::Upload(
  vtkOpenGLRenderWindow*, const unsigned char*, std::size_t, int);

//------------------------------------------------------------------------------
void vtkBufferTexture::Release(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Buffer->ReleaseGraphicsResources();
  this->Current = false;
}

VTK_ABI_NAMESPACE_END
