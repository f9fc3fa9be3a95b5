// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferenceComparison_h
#define ReferenceComparison_h

#include "Picture.h"

#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkExactTransparencyPass.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkReferenceRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkTransparencyInstaller.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

/**
 * Compares what a window shows with the double-precision reference.
 *
 * A rasteriser places vertices on a grid of 1/256 pixel and interpolates in single precision, so a
 * pixel whose centre lies that close to an edge may show either side of it, shaded with a normal
 * that is extrapolated beyond the edge. Such a pixel is explained when a ray displaced by 1/64
 * pixel in some direction leaves at most half of the difference, and at most 16 of 255: so no pixel
 * near which the reference does not change is explained. It is counted as a silhouette pixel and
 * not measured. So is one of VIEW_PICTURE that differs, in each component, neither more nor in
 * another direction than other orders of fragments that are closer in depth than single precision
 * tells may change it (vtkReferenceRenderer::GetOrderChanges()).
 *
 * Through smoothed attributes or the least opacity of a segment, such a pixel decides on others
 * too. Displacing all rays together does not show what the one and not the next does, but it shows
 * which pixels depend on such decisions, and how much: their colours differ from displacement to
 * displacement. A pixel that is within the range of these colours, widened by half of it on either
 * side for decisions that add up, is counted as a dependent pixel, one of the unexplained ones.
 *
 * `tolerance` is in steps of 8 bits: 1, or 2 where VTK rounds twice. Where our pass draws into a
 * window with alpha bit planes, alpha is compared too.
 */
class ReferenceComparison
{
public:
  ReferenceComparison(vtkRenderWindow* window, vtkRenderer* renderer, double tolerance = 1.0)
    : ReferenceComparison(Picture::Render(window), renderer,
        window->GetAlphaBitPlanes() > 0 && vtkTransparencyInstaller::GetPass(renderer), tolerance)
  {
  }

  ReferenceComparison(Picture shown, vtkRenderer* renderer, bool hasAlpha, double tolerance = 1.0)
    : Shown(std::move(shown))
    , HasAlpha(hasAlpha)
    , Renderer(renderer)
    , Tolerance(tolerance)
  {
    const std::vector<double> reference = this->RenderReference(0.0, 0.0);
    std::vector<DoubtfulPixel> doubtful;
    MeanSquare picture;
    MeanSquare covered;
    for (std::size_t pixel = 0; pixel < reference.size() / 4; ++pixel)
    {
      const double difference = this->GetDifference(reference, pixel);
      if (difference > this->Tolerance)
      {
        doubtful.push_back({ pixel, difference, ColorRange(&reference[4 * pixel]) });
        continue;
      }
      this->LargestDifference = std::max(this->LargestDifference, difference);
      for (int i = 0; i < 3; ++i)
      {
        const double error = this->Shown.Rgba[4 * pixel + i] - 255.0 * reference[4 * pixel + i];
        picture.Add(error);
        if (this->FragmentCounts[pixel] > 0)
        {
          covered.Add(error);
        }
      }
    }
    this->FewestDifferences = static_cast<vtkIdType>(doubtful.size());
    this->RootMeanSquare = picture.GetRoot();
    this->CoveredRootMeanSquare = covered.GetRoot();
    this->ExplainByOrder(reference, doubtful);
    this->ExplainByEdges(std::move(doubtful));
  }

  /// Over the whole picture, and over the pixels with translucent fragments alone.
  double GetCoveredRootMeanSquare() const { return this->CoveredRootMeanSquare; }
  double GetRootMeanSquare() const { return this->RootMeanSquare; }
  double GetLargestDifference() const { return this->LargestDifference; }
  vtkIdType GetSilhouettePixels() const { return this->SilhouettePixels; }
  /// Pixels that differ from the reference, or from that with displaced rays which has the fewest;
  /// of the displacements until all is explained. Where one pixel decides on many, these are
  /// silhouette pixels all, and yet few are here.
  vtkIdType GetFewestDifferences() const { return this->FewestDifferences; }
  vtkIdType GetUnexplainedPixels() const
  {
    return this->DependentPixels + static_cast<vtkIdType>(this->Independent.size());
  }
  /// Of the unexplained ones.
  vtkIdType GetDependentPixels() const { return this->DependentPixels; }
  vtkIdType GetNumberOfFragments() const { return this->Fragments; }
  vtkIdType GetLongestList() const { return this->LongestList; }

  /// Print what the first unexplained pixels show, but for the dependent ones, and the fragments of
  /// the reference there.
  void DescribeUnexplained() const
  {
    vtkNew<vtkReferenceRenderer> reference;
    this->Update(reference);
    for (std::size_t i = 0; i < std::min<std::size_t>(this->Independent.size(), 5); ++i)
    {
      const int x = static_cast<int>(this->Independent[i] % this->Shown.Width);
      const int y = static_cast<int>(this->Independent[i] / this->Shown.Width);
      const unsigned char* shown = this->Shown.GetPixel(x, y);
      std::cout << "unexplained pixel " << x << " " << y << ": shown " << int(shown[0]) << " "
                << int(shown[1]) << " " << int(shown[2]) << ", expected";
      for (int component = 0; component < 3; ++component)
      {
        std::cout << " "
                  << 255.0 * reference->GetImage()->GetScalarComponentAsDouble(x, y, 0, component);
      }
      std::cout << std::endl;
      vtkNew<vtkTable> fragments;
      reference->GetPixelFragments(x, y, fragments);
      fragments->Dump(20);
    }
  }

  /// Print the figures and check them against the rounding limit of an 8-bit picture.
  bool Passes(const std::string& scene, double largestSilhouettePart = 0.001) const
  {
    if (!this->Independent.empty())
    {
      this->DescribeUnexplained();
    }
    const double part =
      static_cast<double>(this->SilhouettePixels) / (this->Shown.Width * this->Shown.Height);
    std::cout << scene << ": RMSE " << this->RootMeanSquare << ", under fragments "
              << this->CoveredRootMeanSquare << ", maximum " << this->LargestDifference
              << " of 255, " << this->SilhouettePixels << " silhouette pixels, "
              << this->GetUnexplainedPixels() << " unexplained, " << this->Fragments
              << " fragments, longest list " << this->LongestList << std::endl;
    // Rounding alone is 0.289 for a distribution of colours, up to 0.5 for a single one. Single
    // precision adds a little where the shading is steep.
    const bool uniform = this->IsUniform();
    bool passed = Check(this->RootMeanSquare <= this->Tolerance * (uniform ? 0.5 : 0.30),
      scene + ": the RMSE of the picture is not that of rounding");
    passed &= Check(this->CoveredRootMeanSquare <= this->Tolerance * (uniform ? 0.5 : 0.33),
      scene + ": the RMSE under fragments is not that of rounding");
    passed &=
      Check(this->GetUnexplainedPixels() == 0, scene + ": pixels differ without explanation");
    passed &= Check(part <= largestSilhouettePart, scene + ": too many silhouette pixels");
    return passed;
  }

private:
  class MeanSquare
  {
  public:
    void Add(double error)
    {
      this->Sum += error * error;
      ++this->Count;
    }
    double GetRoot() const { return this->Count > 0 ? std::sqrt(this->Sum / this->Count) : 0.0; }

  private:
    double Sum = 0.0;
    std::size_t Count = 0;
  };

  /** Of RGBA in [0,1]. */
  class ColorRange
  {
  public:
    explicit ColorRange(const double* color)
    {
      std::copy_n(color, 4, this->Least.begin());
      this->Largest = this->Least;
    }

    void Add(const double* color)
    {
      for (int i = 0; i < 4; ++i)
      {
        this->Least[i] = std::min(this->Least[i], color[i]);
        this->Largest[i] = std::max(this->Largest[i], color[i]);
      }
    }

    /// How far a value is outside of the range, widened on either side by a part of its width.
    double GetExcess(int component, double value, double margin) const
    {
      const double least = this->Least[component];
      const double largest = this->Largest[component];
      const double width = margin * (largest - least);
      return std::max({ least - width - value, value - largest - width, 0.0 });
    }

  private:
    std::array<double, 4> Least;
    std::array<double, 4> Largest;
  };

  struct DoubtfulPixel
  {
    std::size_t Index;
    double Difference;
    ColorRange Range; // over the displacements
  };

  static constexpr double SilhouetteTolerance = 16.0;

  /// Render what the pass of the renderer shows, if it has one.
  void Update(vtkReferenceRenderer* reference) const
  {
    reference->SetRenderer(this->Renderer);
    reference->SetSize(this->Shown.Width, this->Shown.Height);
    reference->SetTransparentBackground(this->HasAlpha);
    if (vtkExactTransparencyPass* pass = vtkTransparencyInstaller::GetPass(this->Renderer))
    {
      reference->SetView(pass->GetView());
      reference->SetLayer(pass->GetLayer());
      reference->SetGatherScale(pass->GetGatherScale());
    }
    reference->Update();
  }

  /// How many there were.
  template <typename Predicate>
  static vtkIdType Remove(std::vector<DoubtfulPixel>& pixels, Predicate isExplained)
  {
    const auto end = std::remove_if(pixels.begin(), pixels.end(), isExplained);
    const auto count = static_cast<vtkIdType>(pixels.end() - end);
    pixels.erase(end, pixels.end());
    return count;
  }

  /// Remove what another order explains.
  void ExplainByOrder(const std::vector<double>& colors, std::vector<DoubtfulPixel>& doubtful)
  {
    // The changes are those of the picture.
    vtkExactTransparencyPass* pass = vtkTransparencyInstaller::GetPass(this->Renderer);
    if (doubtful.empty() || (pass && pass->GetView() != vtkExactTransparencyPass::VIEW_PICTURE))
    {
      return;
    }
    vtkNew<vtkReferenceRenderer> reference;
    reference->ComputeOrderChangesOn();
    this->Update(reference);
    const std::vector<double> changes = GetValues(reference->GetOrderChanges());
    this->SilhouettePixels += Remove(doubtful,
      [&](const DoubtfulPixel& pixel) {
        return this->GetDifference(colors, pixel.Index, &changes[6 * pixel.Index]) <=
          this->Tolerance;
      });
  }

  /// The reference's RGBA, with the view displaced by a part of a pixel.
  std::vector<double> RenderReference(double dx, double dy)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const std::array<double, 2> center{ camera->GetWindowCenter()[0],
      camera->GetWindowCenter()[1] };
    camera->SetWindowCenter(
      center[0] + 2.0 * dx / this->Shown.Width, center[1] + 2.0 * dy / this->Shown.Height);
    vtkNew<vtkReferenceRenderer> reference;
    this->Update(reference);
    camera->SetWindowCenter(center[0], center[1]);
    this->Fragments = reference->GetNumberOfFragments();
    this->LongestList = reference->GetLongestList();
    this->FragmentCounts = GetValues(reference->GetFragmentCounts());
    return GetValues(reference->GetImage());
  }

  static std::vector<double> GetValues(vtkImageData* image)
  {
    vtkDataArray* tuples = image->GetPointData()->GetScalars();
    std::vector<double> values(tuples->GetNumberOfValues());
    for (vtkIdType i = 0; i < tuples->GetNumberOfTuples(); ++i)
    {
      tuples->GetTuple(i, &values[tuples->GetNumberOfComponents() * i]);
    }
    return values;
  }

  bool IsUniform() const
  {
    const unsigned char* first = this->Shown.GetPixel(0, 0);
    bool uniform = true;
    for (std::size_t i = 0; i < this->Shown.Rgba.size(); i += 4)
    {
      uniform &= std::equal(first, first + 3, &this->Shown.Rgba[i]);
    }
    return uniform;
  }

  /// In steps of 8 bits, beyond what red, green and blue may fall and rise by.
  double GetDifference(
    const std::vector<double>& reference, std::size_t pixel, const double* changes = nullptr) const
  {
    double largest = 0.0;
    for (int i = 0; i < (this->HasAlpha ? 4 : 3); ++i)
    {
      // As an 8-bit picture would show it.
      const double expected = std::floor(255.0 * reference[4 * pixel + i] + 0.5);
      const double difference = this->Shown.Rgba[4 * pixel + i] - expected;
      const double fall = changes && i < 3 ? 255.0 * changes[i] : 0.0;
      const double rise = changes && i < 3 ? 255.0 * changes[3 + i] : 0.0;
      largest = std::max({ largest, fall - difference, difference - rise });
    }
    return largest;
  }

  vtkIdType CountDifferences(const std::vector<double>& reference) const
  {
    vtkIdType count = 0;
    for (std::size_t pixel = 0; pixel < reference.size() / 4; ++pixel)
    {
      count += this->GetDifference(reference, pixel) > this->Tolerance;
    }
    return count;
  }

  /// In steps of 8 bits.
  double GetExcess(const DoubtfulPixel& pixel, double margin) const
  {
    double largest = 0.0;
    for (int i = 0; i < (this->HasAlpha ? 4 : 3); ++i)
    {
      const double shown = this->Shown.Rgba[4 * pixel.Index + i] / 255.0;
      largest = std::max(largest, 255.0 * pixel.Range.GetExcess(i, shown, margin));
    }
    return largest;
  }

  bool IsSilhouette(const DoubtfulPixel& pixel) const
  {
    return this->GetExcess(pixel, 0.0) <= std::min(0.5 * pixel.Difference, SilhouetteTolerance);
  }

  // With half a step, as an 8-bit picture would show it.
  bool IsDependent(const DoubtfulPixel& pixel) const
  {
    return this->GetExcess(pixel, 0.5) <= this->Tolerance + 0.5;
  }

  void ExplainByEdges(std::vector<DoubtfulPixel> doubtful)
  {
    const vtkIdType fragments = this->Fragments;
    const vtkIdType longest = this->LongestList;
    const double step = 1.0 / 64.0;
    for (const auto& direction : { std::array<int, 2>{ 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 },
           { 1, 1 }, { -1, -1 }, { 1, -1 }, { -1, 1 } })
    {
      if (doubtful.empty())
      {
        break;
      }
      const std::vector<double> reference =
        this->RenderReference(step * direction[0], step * direction[1]);
      this->FewestDifferences =
        std::min(this->FewestDifferences, this->CountDifferences(reference));
      for (DoubtfulPixel& pixel : doubtful)
      {
        pixel.Range.Add(&reference[4 * pixel.Index]);
      }
      this->SilhouettePixels +=
        Remove(doubtful, [this](const DoubtfulPixel& pixel) { return this->IsSilhouette(pixel); });
    }
    this->DependentPixels =
      Remove(doubtful, [this](const DoubtfulPixel& pixel) { return this->IsDependent(pixel); });
    for (const DoubtfulPixel& pixel : doubtful)
    {
      this->Independent.push_back(pixel.Index);
    }
    this->Fragments = fragments;
    this->LongestList = longest;
  }

  Picture Shown;
  bool HasAlpha;
  vtkRenderer* Renderer;
  double Tolerance;
  std::vector<double> FragmentCounts; // of the last reference
  double RootMeanSquare = 0.0;
  double CoveredRootMeanSquare = 0.0;
  double LargestDifference = 0.0;
  vtkIdType SilhouettePixels = 0;
  vtkIdType FewestDifferences = 0;
  vtkIdType DependentPixels = 0;
  std::vector<std::size_t> Independent; // of the unexplained ones
  vtkIdType Fragments = 0;
  vtkIdType LongestList = 0;
};

#endif
