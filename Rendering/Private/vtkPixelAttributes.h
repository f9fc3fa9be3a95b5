// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Attributes of the pixels of the whole picture in graphics memory, for occlusion avoidance that
 * smooths them. glsl/vtkPixelAttributesDec.glsl is the other side of this class.
 *
 * A current OpenGL 4.3 context is needed by every function but the static ones.
 */

#ifndef vtkPixelAttributes_h
#define vtkPixelAttributes_h

#include "OcclusionAvoidance.h"
#include "vtkFragmentTiles.h" // for vtkPixelRectangle
#include "vtkOpenGLError.h"   // for OpenGL itself, through the loader that this VTK uses

#include <array>
#include <cstdint>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkRenderer;
class vtkShaderProgram;

class vtkPixelAttributes
{
public:
  using Attributes = pellucid::PixelAttributes<double>;

  vtkPixelAttributes() = default;
  ~vtkPixelAttributes() = default;
  vtkPixelAttributes(const vtkPixelAttributes&) = delete;
  void operator=(const vtkPixelAttributes&) = delete;

  /** `#define`s for the shaders, which go with those of vtkFragmentLists. */
  static std::string GetShaderDefinitions(bool smooths);

  /** Take the picture and its projection. With `smooths` there is room for its pixels; returns
   * false when OpenGL is out of memory. */
  bool Prepare(vtkRenderer* renderer, const vtkPixelRectangle& picture, bool smooths);

  /** Whether attributes are smoothed. */
  bool Smooths() const { return this->HasSmoothing; }

  void Bind() const;
  void SetUniforms(vtkShaderProgram* program) const;

  /** Distance from the eye along the view direction. */
  double GetDistance(double windowDepth) const;

  ///@{
  /** Importances and distances of all pixels, row by row, and back; for lists left to the CPU. */
  std::vector<Attributes> Read() const;
  void Write(const std::vector<Attributes>& pixels);
  ///@}

  /** Place of a pixel of a tile among these. */
  std::size_t GetIndex(const vtkPixelRectangle& tile, std::uint32_t pixel) const;

  /** One of them, smoothed; empty where there are none. */
  Attributes Smooth(const std::vector<Attributes>& pixels, std::size_t index) const;

  vtkIdType GetBytes() const { return this->Bytes; }
  void Release();

private:
  bool HasSmoothing = false;
  vtkPixelRectangle Picture;
  std::array<float, 4> DepthToDistance{};
  GLuint Handle = 0;
  vtkIdType Bytes = 0;
};

VTK_ABI_NAMESPACE_END
#endif
