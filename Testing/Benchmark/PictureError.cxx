// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PictureError.h"

#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr double White = 255.0;

// Of components, across an edge.
constexpr double Step = 1.0;

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
ExpectedPicture::ExpectedPicture(vtkSmartPointer<vtkImageData> picture)
  : Picture(std::move(picture))
  , Edges(this->Picture->GetNumberOfPoints(), false)
{
}

//------------------------------------------------------------------------------
void ExpectedPicture::AddDisplaced(vtkImageData* displaced)
{
  const auto pixels = GetPixels(this->Picture);
  const auto others = GetPixels(displaced);
  for (vtkIdType pixel = 0; pixel < pixels.size(); ++pixel)
  {
    for (int i = 0; i < 3; ++i)
    {
      if (White * std::abs(others[pixel][i] - pixels[pixel][i]) > Step)
      {
        this->Edges[pixel] = true;
      }
    }
  }
}

//------------------------------------------------------------------------------
PictureError FindPictureError(vtkImageData* shown, const ExpectedPicture& expected)
{
  const auto found = vtk::DataArrayTupleRange(
    vtkUnsignedCharArray::SafeDownCast(shown->GetPointData()->GetScalars()));
  const auto wanted = GetPixels(expected.GetPicture());
  PictureError error;
  double squares = 0.0;
  for (vtkIdType pixel = 0; pixel < found.size(); ++pixel)
  {
    if (expected.IsEdge(pixel))
    {
      ++error.EdgePixels;
      continue;
    }
    for (int i = 0; i < 3; ++i)
    {
      const double value = White * wanted[pixel][i];
      const double difference = found[pixel][i] - value;
      squares += difference * difference;
      error.Maximum = std::max(error.Maximum, std::abs(found[pixel][i] - std::round(value)));
    }
  }
  const vtkIdType measured = found.size() - error.EdgePixels;
  error.RootMeanSquare = measured > 0 ? std::sqrt(squares / (3.0 * measured)) : 0.0;
  error.PeakSignalToNoise = 20.0 * std::log10(White / error.RootMeanSquare);
  error.StructuralSimilarity = FindMeanSimilarity(shown, expected.GetPicture());
  return error;
}
}
}
