// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReferenceRenderer.h"

#include "Private/RayCasting.h"
#include "Private/vtkReferenceOpacities.h"
#include "Private/vtkReferenceScene.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <numeric>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkReferenceRenderer);

namespace
{
using Vec3 = pellucid::Vector3<double>;
using Vec4 = pellucid::Vector4<double>;
using Pixels = std::vector<pellucid::PixelFragments<double>>;

/** The background of a row of the image; a gradient runs from the lower to the upper border. */
Vec4 Background(vtkRenderer* renderer, int y, int height, bool transparent)
{
  const double* lower = renderer->GetBackground();
  const double* upper = renderer->GetGradientBackground() ? renderer->GetBackground2() : lower;
  const double position = (y + 0.5) / height;
  return Vec4(
    glm::mix(Vec3(lower[0], lower[1], lower[2]), Vec3(upper[0], upper[1], upper[2]), position),
    transparent ? 0.0 : 1.0);
}
}

/** The last scene, kept for questions about single pixels, and the images made of it. */
struct vtkReferenceRenderer::vtkInternals
{
  std::unique_ptr<vtkReferenceScene> Source;
  std::unique_ptr<pellucid::RayCaster<double>> Caster;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkImageData> FragmentCounts;
  vtkIdType NumberOfFragments = 0;
  vtkIdType LongestList = 0;

  void Reset()
  {
    this->Caster.reset();
    this->Source.reset();
    this->Image->Initialize();
    this->FragmentCounts->Initialize();
    this->NumberOfFragments = 0;
    this->LongestList = 0;
  }

  void CountFragments()
  {
    const int* counts = static_cast<int*>(this->FragmentCounts->GetScalarPointer());
    const vtkIdType size = this->FragmentCounts->GetNumberOfPoints();
    this->NumberOfFragments = std::accumulate(counts, counts + size, vtkIdType(0));
    this->LongestList = *std::max_element(counts, counts + size);
  }
};

//------------------------------------------------------------------------------
vtkReferenceRenderer::vtkReferenceRenderer()
  : Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkReferenceRenderer::~vtkReferenceRenderer() = default;

//------------------------------------------------------------------------------
void vtkReferenceRenderer::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != renderer)
  {
    this->Renderer = renderer;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkRenderer* vtkReferenceRenderer::GetRenderer()
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
void vtkReferenceRenderer::Update()
{
  auto& internals = *this->Internals;
  internals.Reset();
  const int width = this->Size[0];
  const int height = this->Size[1];
  if (!this->Renderer)
  {
    vtkErrorMacro("No renderer: set the scene with SetRenderer() before Update().");
    return;
  }
  if (width < 1 || height < 1)
  {
    vtkErrorMacro("The image size must be at least 1 x 1, but is " << width << " x " << height
                                                                   << ": use SetSize().");
    return;
  }

  internals.Source = std::make_unique<vtkReferenceScene>(this->Renderer, width, height);
  internals.Caster = std::make_unique<pellucid::RayCaster<double>>(internals.Source->GetScene());
  const vtkOptimizedScene& optimized = internals.Source->GetOptimizedScene();
  const std::vector<double> opacities = optimized.HasEffect()
    ? vtkSolveReferenceOpacities(*internals.Caster, optimized)
    : std::vector<double>();
  internals.Image->SetDimensions(width, height, 1);
  internals.Image->AllocateScalars(VTK_DOUBLE, 4);
  internals.FragmentCounts->SetDimensions(width, height, 1);
  internals.FragmentCounts->AllocateScalars(VTK_INT, 1);
  auto* image = static_cast<double*>(internals.Image->GetScalarPointer());
  auto* counts = static_cast<int*>(internals.FragmentCounts->GetScalarPointer());

  vtkSMPThreadLocal<Pixels> localPixels;
  vtkSMPTools::For(0, internals.Caster->GetNumberOfTiles(), 8,
    [&](vtkIdType begin, vtkIdType end)
    {
      Pixels& pixels = localPixels.Local();
      for (int tile = static_cast<int>(begin); tile < end; ++tile)
      {
        const auto area = internals.Caster->GetTile(tile);
        internals.Caster->Cast(tile, area, pixels);
        auto pixel = pixels.begin();
        for (int y = area.y0; y < area.y1; ++y)
        {
          const Vec4 background =
            Background(this->Renderer, y, height, this->TransparentBackground);
          for (int x = area.x0; x < area.x1; ++x, ++pixel)
          {
            const vtkIdType index = static_cast<vtkIdType>(y) * width + x;
            const Vec4 color = pixel->Composite(background, opacities);
            for (int component = 0; component < 4; ++component)
            {
              image[4 * index + component] = color[component];
            }
            counts[index] = static_cast<int>(pixel->GetTranslucent().size());
          }
        }
      }
    });
  internals.CountFragments();
  const std::string omissions = this->GetOmissions();
  if (!omissions.empty())
  {
    vtkWarningMacro("The reference picture lacks: " << omissions << ".");
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkReferenceRenderer::GetImage()
{
  return this->Internals->Image;
}

//------------------------------------------------------------------------------
vtkImageData* vtkReferenceRenderer::GetFragmentCounts()
{
  return this->Internals->FragmentCounts;
}

//------------------------------------------------------------------------------
vtkIdType vtkReferenceRenderer::GetNumberOfFragments()
{
  return this->Internals->NumberOfFragments;
}

//------------------------------------------------------------------------------
vtkIdType vtkReferenceRenderer::GetLongestList()
{
  return this->Internals->LongestList;
}

//------------------------------------------------------------------------------
void vtkReferenceRenderer::GetPixelFragments(int x, int y, vtkTable* fragments)
{
  fragments->Initialize();
  vtkNew<vtkDoubleArray> columns[5];
  const char* names[5] = { "Depth", "Red", "Green", "Blue", "Alpha" };
  for (int i = 0; i < 5; ++i)
  {
    columns[i]->SetName(names[i]);
    fragments->AddColumn(columns[i]);
  }
  int size[3];
  this->Internals->Image->GetDimensions(size);
  if (!this->Internals->Caster || x < 0 || y < 0 || x >= size[0] || y >= size[1])
  {
    return;
  }
  const auto& caster = *this->Internals->Caster;
  Pixels pixels;
  caster.Cast(caster.GetTileOfPixel(x, y), { x, y, x + 1, y + 1 }, pixels);
  for (const auto& fragment : pixels.front().GetTranslucent())
  {
    columns[0]->InsertNextValue(fragment.depth);
    for (int i = 0; i < 4; ++i)
    {
      columns[i + 1]->InsertNextValue(fragment.color[i]);
    }
  }
}

//------------------------------------------------------------------------------
void vtkReferenceRenderer::GetPixelSegments(vtkCellArray* lists)
{
  lists->Initialize();
  const auto* caster = this->Internals->Caster.get();
  Pixels pixels;
  for (int tile = 0; caster && tile < caster->GetNumberOfTiles(); ++tile)
  {
    caster->Cast(tile, caster->GetTile(tile), pixels);
    for (const auto& pixel : pixels)
    {
      lists->InsertNextCell(0);
      int count = 0;
      for (const auto& fragment : pixel.GetTranslucent())
      {
        if (fragment.place.nearest.parameters)
        {
          lists->InsertCellPoint(static_cast<vtkIdType>(fragment.place.nearest.segment) - 1);
          ++count;
        }
      }
      lists->UpdateCellCount(count);
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkReferenceRenderer::GetOmissions()
{
  std::ostringstream text;
  if (this->Internals->Source)
  {
    const char* separator = "";
    for (const auto& [kind, count] : this->Internals->Source->GetOmissions())
    {
      text << separator << count << " x " << kind;
      separator = ", ";
    }
  }
  return text.str();
}

//------------------------------------------------------------------------------
void vtkReferenceRenderer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Renderer: " << this->Renderer << "\n"
     << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n"
     << indent << "TransparentBackground: " << this->TransparentBackground << "\n"
     << indent << "View: " << this->View << "\n"
     << indent << "Layer: " << this->Layer << "\n"
     << indent << "GatherScale: " << this->GatherScale << "\n"
     << indent << "NumberOfFragments: " << this->GetNumberOfFragments() << "\n"
     << indent << "LongestList: " << this->GetLongestList() << "\n";
}
VTK_ABI_NAMESPACE_END
