// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPixelAttributes.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkOptimizedScene.h"
#include "vtkRenderer.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"
#include "vtkStorageBuffer.h"

VTK_ABI_NAMESPACE_BEGIN

namespace
{
/** One element of the buffer. */
struct Element
{
  float Importance; // the greatest one
  float Distance;   // of the fragment that has it; negative: there is none
};

// Where the sort has its long lists, which are read by then.
constexpr GLuint AttributesBinding = 3;
}

//------------------------------------------------------------------------------
std::string vtkPixelAttributes::GetShaderDefinitions(bool smooths)
{
  vtkShaderDefinitions definitions;
  definitions.Define("ATTRIBUTES_BINDING", static_cast<int>(AttributesBinding));
  definitions.Define("SMOOTH_ATTRIBUTES", smooths ? 1 : 0);
  definitions.Define("IMPORTANCE_TOLERANCE", pellucid::ImportanceTolerance);
  definitions.Define("DISTANCE_MARGIN", 1.0 + pellucid::DistanceTolerance);
  definitions.Define(
    "AVOIDS_BY_WEIGHTING", static_cast<std::uint32_t>(vtkOptimizedScene::AvoidsByWeighting));
  definitions.Define(
    "SMOOTHS_ATTRIBUTES", static_cast<std::uint32_t>(vtkOptimizedScene::SmoothsAttributes));
  return definitions.GetText();
}

//------------------------------------------------------------------------------
bool vtkPixelAttributes::Prepare(
  vtkRenderer* renderer, const vtkPixelRectangle& picture, bool smooths)
{
  this->Picture = picture;
  this->HasSmoothing = smooths;
  vtkMatrix4x4* projection = renderer->GetActiveCamera()->GetProjectionTransformMatrix(
    renderer->GetTiledAspectRatio(), -1.0, 1.0);
  for (int i = 0; i < 4; ++i)
  {
    this->DepthToDistance[i] = static_cast<float>(projection->GetElement(2 + i / 2, 2 + i % 2));
  }
  const vtkIdType bytes =
    smooths ? picture.GetNumberOfPixels() * static_cast<vtkIdType>(sizeof(Element)) : 0;
  if (bytes > this->Bytes)
  {
    this->Bytes = vtkAllocateStorage(this->Handle, bytes, nullptr) ? bytes : 0;
  }
  return this->Bytes >= bytes;
}

//------------------------------------------------------------------------------
void vtkPixelAttributes::Bind() const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, AttributesBinding, this->Handle);
}

//------------------------------------------------------------------------------
void vtkPixelAttributes::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniform2i("pellucidPictureOrigin", this->Picture.Origin.data());
  program->SetUniform2i("pellucidPictureSize", this->Picture.Size.data());
  program->SetUniform4f("pellucidDepthToDistance", this->DepthToDistance.data());
}

//------------------------------------------------------------------------------
double vtkPixelAttributes::GetDistance(double windowDepth) const
{
  const double depth = 2.0 * windowDepth - 1.0;
  const auto& m = this->DepthToDistance;
  return (depth * m[3] - m[1]) / (depth * m[2] - m[0]);
}

//------------------------------------------------------------------------------
std::vector<vtkPixelAttributes::Attributes> vtkPixelAttributes::Read() const
{
  std::vector<Element> elements(static_cast<std::size_t>(this->Picture.GetNumberOfPixels()));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handle);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
    static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  std::vector<Attributes> pixels(elements.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    pixels[i].coverage = elements[i].Distance >= 0.0f ? 1.0 : 0.0;
    pixels[i].importance = elements[i].Importance;
    pixels[i].depth = elements[i].Distance;
  }
  return pixels;
}

//------------------------------------------------------------------------------
void vtkPixelAttributes::Write(const std::vector<Attributes>& pixels)
{
  std::vector<Element> elements(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    elements[i] = { static_cast<float>(pixels[i].importance),
      pixels[i].coverage > 0.0 ? static_cast<float>(pixels[i].depth) : -1.0f };
  }
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handle);
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
    static_cast<GLsizeiptr>(elements.size() * sizeof(Element)), elements.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
std::size_t vtkPixelAttributes::GetIndex(const vtkPixelRectangle& tile, std::uint32_t pixel) const
{
  const auto width = static_cast<std::uint32_t>(tile.Size[0]);
  const std::size_t column = tile.Origin[0] - this->Picture.Origin[0] + pixel % width;
  const std::size_t row = tile.Origin[1] - this->Picture.Origin[1] + pixel / width;
  return row * this->Picture.Size[0] + column;
}

//------------------------------------------------------------------------------
vtkPixelAttributes::Attributes vtkPixelAttributes::Smooth(
  const std::vector<Attributes>& pixels, std::size_t index) const
{
  const int width = this->Picture.Size[0];
  return pixels.empty() ? Attributes()
                        : pellucid::SmoothPixelAttributes(pixels, width,
                            static_cast<int>(index % width), static_cast<int>(index / width));
}

//------------------------------------------------------------------------------
void vtkPixelAttributes::Release()
{
  glDeleteBuffers(1, &this->Handle);
  this->Handle = 0;
  this->Bytes = 0;
}

VTK_ABI_NAMESPACE_END
