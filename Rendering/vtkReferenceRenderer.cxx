// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReferenceRenderer.h"

#include "Private/ViewColors.h"
#include "Private/vtkReferenceOpacities.h"
#include "Private/vtkReferenceScene.h"
#include "Private/vtkReferenceSweep.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkExactTransparencyPass.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkTable.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkReferenceRenderer);

namespace
{
// Of window depth: eight steps of single precision below 1, in which OpenGL has positions and
// depths.
constexpr double DepthResolution = 4.0 * std::numeric_limits<float>::epsilon();

using Vec3 = pellucid::Vector3<double>;
using Vec4 = pellucid::Vector4<double>;
using Pixel = pellucid::PixelFragments<double>;
using Attributes = pellucid::PixelAttributes<double>;

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

/** What a view shows of the fragments of a pixel; VIEW_LENGTH needs those of all pixels. */
void ApplyView(int view, int layer, Pixel& pixel)
{
  if (pixel.GetTranslucent().empty())
  {
    return;
  }
  const auto& nearest = pixel.GetTranslucent().front();
  const auto& place = nearest.place.nearest;
  switch (view)
  {
    case vtkExactTransparencyPass::VIEW_OPACITY:
      pixel.ShowNearest(pellucid::HotColor(nearest.fading));
      break;
    case vtkExactTransparencyPass::VIEW_IMPORTANCE:
      pixel.ShowNearest(pellucid::HotColor(place.importance));
      break;
    case vtkExactTransparencyPass::VIEW_SEGMENTS:
      pixel.ShowNearest(pellucid::SegmentColor<double>(
        place.parameters ? static_cast<std::uint32_t>(place.segment) : 0));
      break;
    case vtkExactTransparencyPass::VIEW_FIRST_LAYERS:
      pixel.KeepLayers(1, layer);
      break;
    case vtkExactTransparencyPass::VIEW_LAYER:
      pixel.KeepLayers(layer, layer);
      break;
    default:
      break;
  }
}
}

/** The last scene, kept for questions about single pixels, and the images made of it. */
struct vtkReferenceRenderer::vtkInternals
{
  std::unique_ptr<vtkReferenceScene> Source;
  std::unique_ptr<pellucid::RayCaster<double>> Caster;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkImageData> FragmentCounts;
  vtkNew<vtkImageData> OrderChanges;
  vtkIdType NumberOfFragments = 0;
  vtkIdType LongestList = 0;

  void Reset()
  {
    this->Caster.reset();
    this->Source.reset();
    this->Image->Initialize();
    this->FragmentCounts->Initialize();
    this->OrderChanges->Initialize();
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

  /** Where there is a fragment, its colour becomes that of the number of fragments. */
  void ShowFragmentCounts()
  {
    const int* counts = static_cast<int*>(this->FragmentCounts->GetScalarPointer());
    auto* image = static_cast<double*>(this->Image->GetScalarPointer());
    for (vtkIdType i = 0; i < this->FragmentCounts->GetNumberOfPoints(); ++i)
    {
      if (counts[i] > 0)
      {
        const Vec4 color(pellucid::HotColor(static_cast<double>(counts[i]) / this->LongestList), 1);
        std::copy_n(glm::value_ptr(color), 4, image + 4 * i);
      }
    }
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
  const pellucid::RayCaster<double>& caster = *internals.Caster;
  const vtkOptimizedScene& optimized = internals.Source->GetOptimizedScene();
  const std::vector<double> opacities = optimized.HasOptimization()
    ? vtkSolveReferenceOpacities(caster, optimized, this->GatherScale)
    : std::vector<double>();
  const std::vector<Attributes> smoothAttributes = vtkSmoothReferenceAttributes(caster);
  internals.Image->SetDimensions(width, height, 1);
  internals.Image->AllocateScalars(VTK_DOUBLE, 4);
  internals.FragmentCounts->SetDimensions(width, height, 1);
  internals.FragmentCounts->AllocateScalars(VTK_INT, 1);
  double* changes = nullptr;
  if (this->ComputeOrderChanges)
  {
    internals.OrderChanges->SetDimensions(width, height, 1);
    internals.OrderChanges->AllocateScalars(VTK_DOUBLE, 6);
    changes = static_cast<double*>(internals.OrderChanges->GetScalarPointer());
  }
  auto* image = static_cast<double*>(internals.Image->GetScalarPointer());
  auto* counts = static_cast<int*>(internals.FragmentCounts->GetScalarPointer());

  vtkForEachReferencePixel(caster,
    [&](int x, int y, Pixel& pixel)
    {
      const vtkIdType index = static_cast<vtkIdType>(y) * width + x;
      counts[index] = static_cast<int>(pixel.GetTranslucent().size());
      pixel.Fade(opacities, smoothAttributes.empty() ? Attributes() : smoothAttributes[index]);
      if (changes)
      {
        const auto change = pixel.GetOrderChange(DepthResolution);
        std::copy_n(glm::value_ptr(change.fall), 3, changes + 6 * index);
        std::copy_n(glm::value_ptr(change.rise), 3, changes + 6 * index + 3);
      }
      ApplyView(this->View, this->Layer, pixel);
      const Vec4 color =
        pixel.Composite(Background(this->Renderer, y, height, this->TransparentBackground));
      std::copy_n(glm::value_ptr(color), 4, image + 4 * index);
    });
  internals.CountFragments();
  if (this->View == vtkExactTransparencyPass::VIEW_LENGTH)
  {
    internals.ShowFragmentCounts();
  }
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
vtkImageData* vtkReferenceRenderer::GetOrderChanges()
{
  return this->Internals->OrderChanges;
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
  std::vector<Pixel> pixels;
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
  std::vector<Pixel> pixels;
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
     << indent << "ComputeOrderChanges: " << this->ComputeOrderChanges << "\n"
     << indent << "NumberOfFragments: " << this->GetNumberOfFragments() << "\n"
     << indent << "LongestList: " << this->GetLongestList() << "\n";
}
VTK_ABI_NAMESPACE_END
