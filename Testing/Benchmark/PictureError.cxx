// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PictureError.h"

#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr double White = 255.0;

// Steps of 8 bits. What changes by less within the error of a rasteriser is at most one step off
// where both pictures are rounded.
constexpr double LargestChange = 1.0;

// Of a component: half a step.
constexpr double VisibleChange = 0.5 / White;

// Of the structural similarity.
constexpr double WindowDeviation = 1.5;
constexpr int WindowRadius = 5;
constexpr double LuminanceConstant = (0.01 * White) * (0.01 * White);
constexpr double ContrastConstant = (0.03 * White) * (0.03 * White);

// What is averaged over the windows: two pictures x and y, their squares, their product.
enum Moments
{
  X,
  Y,
  XX,
  YY,
  XY,
  NumberOfMoments
};

//------------------------------------------------------------------------------
auto GetPixels(vtkImageData* picture)
{
  return vtk::DataArrayTupleRange(
    vtkDoubleArray::SafeDownCast(picture->GetPointData()->GetScalars()));
}

//------------------------------------------------------------------------------
auto GetCounts(vtkImageData* counts)
{
  return vtk::DataArrayValueRange<1>(
    vtkIntArray::SafeDownCast(counts->GetPointData()->GetScalars()));
}

//------------------------------------------------------------------------------
template <typename Pixel>
bool IsOtherColor(const Pixel& a, const Pixel& b)
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) }) * White >
    LargestChange;
}

//------------------------------------------------------------------------------
std::string DescribeSize(vtkImageData* picture)
{
  const int* size = picture->GetDimensions();
  return std::to_string(size[0]) + "x" + std::to_string(size[1]);
}

//------------------------------------------------------------------------------
void CheckSameSize(vtkImageData* picture, vtkImageData* expected)
{
  const std::string found = DescribeSize(picture);
  const std::string wanted = DescribeSize(expected);
  if (found != wanted)
  {
    throw std::invalid_argument(
      "a picture of " + wanted + " pixels was expected to compare with, found are " + found);
  }
}

//------------------------------------------------------------------------------
// Differences of the pixels that have been added.
class DifferenceSum
{
public:
  template <typename Found, typename Wanted>
  void Add(const Found& found, const Wanted& wanted)
  {
    ++this->Pixels;
    for (int i = 0; i < 3; ++i)
    {
      const double value = White * wanted[i];
      const double difference = found[i] - value;
      this->Squares += difference * difference;
      this->Maximum = std::max(this->Maximum, std::abs(found[i] - std::round(value)));
    }
  }

  Differences Get() const
  {
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    return this->Pixels > 0
      ? Differences{ std::sqrt(this->Squares / (3.0 * this->Pixels)), this->Maximum }
      : Differences{ notANumber, notANumber };
  }

private:
  vtkIdType Pixels = 0;
  double Squares = 0.0;
  double Maximum = 0.0;
};

//------------------------------------------------------------------------------
// ITU-R BT.601.
template <typename Pixel>
double GetLuminance(const Pixel& pixel)
{
  return 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
}

//------------------------------------------------------------------------------
// The similarity of one window, from the averages over it.
template <typename Averages>
double FindSimilarity(const Averages& mean)
{
  const double varianceX = mean[XX] - mean[X] * mean[X];
  const double varianceY = mean[YY] - mean[Y] * mean[Y];
  const double covariance = mean[XY] - mean[X] * mean[Y];
  return (2.0 * mean[X] * mean[Y] + LuminanceConstant) * (2.0 * covariance + ContrastConstant) /
    ((mean[X] * mean[X] + mean[Y] * mean[Y] + LuminanceConstant) *
      (varianceX + varianceY + ContrastConstant));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> AverageOverWindows(vtkImageData* moments)
{
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetDimensionality(2);
  smooth->SetStandardDeviations(WindowDeviation, WindowDeviation);
  // The filter rounds the product of deviation and factor down to whole pixels.
  const double factor = (WindowRadius + 0.5) / WindowDeviation;
  smooth->SetRadiusFactors(factor, factor);
  smooth->SetInputData(moments);
  smooth->Update();
  return smooth->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> FindMoments(vtkImageData* shown, vtkImageData* expected)
{
  const auto found = vtk::DataArrayTupleRange(
    vtkUnsignedCharArray::SafeDownCast(shown->GetPointData()->GetScalars()));
  const auto wanted = GetPixels(expected);
  auto moments = vtkSmartPointer<vtkImageData>::New();
  moments->SetDimensions(shown->GetDimensions());
  moments->AllocateScalars(VTK_DOUBLE, NumberOfMoments);
  auto products = GetPixels(moments);
  for (vtkIdType pixel = 0; pixel < found.size(); ++pixel)
  {
    const double x = GetLuminance(found[pixel]);
    const double y = White * GetLuminance(wanted[pixel]);
    const double values[NumberOfMoments] = { x, y, x * x, y * y, x * y };
    std::copy(values, values + NumberOfMoments, products[pixel].begin());
  }
  return moments;
}

//------------------------------------------------------------------------------
double FindMeanSimilarity(vtkImageData* shown, vtkImageData* expected)
{
  const auto averages = AverageOverWindows(FindMoments(shown, expected));
  const auto values = GetPixels(averages);
  const int width = shown->GetDimensions()[0];
  const int height = shown->GetDimensions()[1];
  double sum = 0.0;
  vtkIdType windows = 0;
  for (int y = WindowRadius; y < height - WindowRadius; ++y)
  {
    for (int x = WindowRadius; x < width - WindowRadius; ++x, ++windows)
    {
      sum += FindSimilarity(values[static_cast<vtkIdType>(y) * width + x]);
    }
  }
  return windows > 0 ? sum / windows : std::numeric_limits<double>::quiet_NaN();
}
}

//------------------------------------------------------------------------------
ExpectedPicture::ExpectedPicture(
  vtkSmartPointer<vtkImageData> picture, vtkSmartPointer<vtkImageData> counts)
  : Picture(std::move(picture))
  , Counts(std::move(counts))
  , Edges(this->Picture->GetNumberOfPoints(), false)
  , Unordered(this->Edges)
{
  CheckSameSize(this->Counts, this->Picture);
}

//------------------------------------------------------------------------------
void ExpectedPicture::AddDisplaced(vtkImageData* picture, vtkImageData* counts)
{
  CheckSameSize(picture, this->Picture);
  CheckSameSize(counts, this->Picture);
  const auto colorsHere = GetPixels(this->Picture);
  const auto colorsThere = GetPixels(picture);
  const auto here = GetCounts(this->Counts);
  const auto there = GetCounts(counts);
  for (vtkIdType pixel = 0; pixel < here.size(); ++pixel)
  {
    if (here[pixel] != there[pixel] || IsOtherColor(colorsHere[pixel], colorsThere[pixel]))
    {
      this->Edges[pixel] = true;
    }
  }
}

//------------------------------------------------------------------------------
void ExpectedPicture::AddOrderChanges(vtkImageData* changes)
{
  CheckSameSize(changes, this->Picture);
  const auto bounds = GetPixels(changes);
  for (vtkIdType pixel = 0; pixel < bounds.size(); ++pixel)
  {
    const auto change = bounds[pixel];
    if (std::any_of(change.begin(), change.end(),
          [](double value) { return std::abs(value) > VisibleChange; }))
    {
      this->Unordered[pixel] = true;
    }
  }
}

//------------------------------------------------------------------------------
bool ExpectedPicture::IsCovered(vtkIdType pixel) const
{
  return GetCounts(this->Counts)[pixel] > 0;
}

//------------------------------------------------------------------------------
PictureError FindPictureError(vtkImageData* shown, const ExpectedPicture& expected)
{
  CheckSameSize(shown, expected.GetPicture());
  const auto found = vtk::DataArrayTupleRange(
    vtkUnsignedCharArray::SafeDownCast(shown->GetPointData()->GetScalars()));
  const auto wanted = GetPixels(expected.GetPicture());
  PictureError error;
  DifferenceSum inner;
  DifferenceSum covered;
  DifferenceSum all;
  for (vtkIdType pixel = 0; pixel < found.size(); ++pixel)
  {
    const bool isEdge = expected.IsEdge(pixel);
    const bool isCovered = expected.IsCovered(pixel);
    error.EdgePixels += isEdge;
    error.OrderPixels += expected.IsEdgeByOrder(pixel);
    error.CoveredPixels += isCovered;
    all.Add(found[pixel], wanted[pixel]);
    if (!isEdge)
    {
      inner.Add(found[pixel], wanted[pixel]);
    }
    if (isCovered && !isEdge)
    {
      covered.Add(found[pixel], wanted[pixel]);
    }
  }
  static_cast<Differences&>(error) = inner.Get();
  error.Covered = covered.Get();
  error.All = all.Get();
  error.PeakSignalToNoise = 20.0 * std::log10(White / error.RootMeanSquare);
  error.StructuralSimilarity = FindMeanSimilarity(shown, expected.GetPicture());
  return error;
}
}
}
