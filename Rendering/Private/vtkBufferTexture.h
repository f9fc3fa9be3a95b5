// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An array of values in graphics memory that shaders fetch by index.
 */

#ifndef vtkBufferTexture_h
#define vtkBufferTexture_h

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h" // for the values
#include "vtkTextureObject.h"      // for the access of shaders

#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN

class vtkOpenGLRenderWindow;
class vtkWindow;

class vtkBufferTexture
{
public:
  explicit vtkBufferTexture(const char* sampler)
    : Sampler(sampler)
  {
  }

  const char* Sampler; ///< its name in the shaders
  vtkNew<vtkTextureObject> Texture;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  bool Current = false; ///< what the graphics memory holds is what shall be drawn

  /** Take `count` elements of 1 to 4 `components` each; for float, int and unsigned char. */
  template <typename Value>
  bool Upload(
    vtkOpenGLRenderWindow* window, const Value* values, std::size_t count, int components);

  void Release(vtkWindow* window);
};

VTK_ABI_NAMESPACE_END
#endif
