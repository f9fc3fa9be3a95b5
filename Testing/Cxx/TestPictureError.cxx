// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The error measures of the benchmark on pictures where they have a closed form.
 */

#include "PictureError.h"
#include "ReferenceTesting.h"

#include <functional>
#include <limits>

namespace
{
using pellucid::benchmark::ExpectedPicture;
using pellucid::benchmark::FindPictureError;
using pellucid::benchmark::PictureError;

constexpr int Width = 40;
constexpr int Height = 30;

// Of a pixel, in steps of 8 bits.
using Value = std::function<double(int x, int y)>;

vtkSmartPointer<vtkImageData> MakePicture(
  int type, double scale, const Value& value, int width = Width)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, Height, 1);
  picture->AllocateScalars(type, type == VTK_DOUBLE ? 4 : 3);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int i = 0; i < 3; ++i)
      {
        picture->SetScalarComponentFromDouble(x, y, 0, i, scale * value(x, y));
      }
    }
  }
  return picture;
}

vtkSmartPointer<vtkImageData> MakeShown(const Value& value, int width = Width)
{
  return MakePicture(VTK_UNSIGNED_CHAR, 1.0, value, width);
}

vtkSmartPointer<vtkImageData> MakeExpected(const Value& value, int width = Width)
{
  return MakePicture(VTK_DOUBLE, 1.0 / 255.0, value, width);
}

double Pattern(int x, int y)
{
  return (37 * x + 91 * y) % 200;
}

void TestEqual(Checks& checks)
{
  const ExpectedPicture expected(MakeExpected(Pattern));
  const PictureError error = FindPictureError(MakeShown(Pattern), expected);
  checks.Near("equal, RMSE", error.RootMeanSquare, 0.0, 1e-12);
  checks.Near("equal, maximum", error.Maximum, 0.0, 0.0);
  checks.True("equal, PSNR", error.PeakSignalToNoise > 300.0);
  checks.Near("equal, SSIM", error.StructuralSimilarity, 1.0, 1e-12);
  checks.True("equal, no edges", error.EdgePixels == 0);
  const Value black = [](int, int) { return 0.0; };
  checks.True("black, PSNR",
    FindPictureError(MakeShown(black), ExpectedPicture(MakeExpected(black))).PeakSignalToNoise ==
      std::numeric_limits<double>::infinity());
}

// A constant picture that is brighter: only the means of the similarity differ.
void TestShift(Checks& checks)
{
  const double dark = 100.0;
  const double bright = 110.0;
  const PictureError error = FindPictureError(MakeShown([=](int, int) { return bright; }),
    ExpectedPicture(MakeExpected([=](int, int) { return dark; })));
  checks.Near("shift, RMSE", error.RootMeanSquare, 10.0, 1e-9);
  checks.Near("shift, maximum", error.Maximum, 10.0, 1e-9);
  checks.Near("shift, PSNR", error.PeakSignalToNoise, 20.0 * std::log10(25.5), 1e-9);
  const double c1 = 2.55 * 2.55;
  checks.Near("shift, SSIM", error.StructuralSimilarity,
    (2.0 * dark * bright + c1) / (dark * dark + bright * bright + c1), 1e-9);
}

// Half of the pixels are wrong by 6, all the others by 1/4, which rounds to none.
void TestHalf(Checks& checks)
{
  const auto isWrong = [](int x) { return x < Width / 2; };
  const PictureError error =
    FindPictureError(MakeShown([&](int x, int) { return isWrong(x) ? 56.0 : 50.0; }),
      ExpectedPicture(MakeExpected([&](int x, int) { return isWrong(x) ? 50.0 : 50.25; })));
  checks.Near("half, RMSE", error.RootMeanSquare, std::sqrt(0.5 * (36.0 + 0.0625)), 1e-9);
  checks.Near("half, maximum", error.Maximum, 6.0, 1e-9);
}

// A random pattern against its negative, about the same mean.
void TestNegative(Checks& checks)
{
  const Value negative = [](int x, int y) { return 199.0 - Pattern(x, y); };
  const PictureError error =
    FindPictureError(MakeShown(negative), ExpectedPicture(MakeExpected(Pattern)));
  checks.True("negative, SSIM", error.StructuralSimilarity < -0.8);
}

// One column lies on an edge: both sides are right, and it is wrong altogether.
void TestEdges(Checks& checks)
{
  const Value left = [](int x, int) { return x < 7 ? 200.0 : 20.0; };
  const Value right = [](int x, int) { return x < 8 ? 200.0 : 20.0; };
  ExpectedPicture expected(MakeExpected(left));
  expected.AddDisplaced(MakeExpected(right));
  expected.AddDisplaced(MakeExpected([&](int x, int y) { return left(x, y) + 0.9; }));
  const PictureError error = FindPictureError(
    MakeShown([](int x, int) { return x < 7 ? 203.0
                                 : x < 8    ? 0.0
                                            : 20.0; }), expected);
  checks.True("edges", error.EdgePixels == Height);
  checks.Near("edges, RMSE", error.RootMeanSquare, std::sqrt(9.0 * 7.0 / (Width - 1)), 1e-9);
  checks.Near("edges, maximum", error.Maximum, 3.0, 1e-9);
}

// The similarity needs windows of 11 pixels.
void TestNarrow(Checks& checks)
{
  const PictureError narrow =
    FindPictureError(MakeShown(Pattern, 10), ExpectedPicture(MakeExpected(Pattern, 10)));
  checks.True("narrow, no SSIM", std::isnan(narrow.StructuralSimilarity));
  const PictureError window =
    FindPictureError(MakeShown(Pattern, 11), ExpectedPicture(MakeExpected(Pattern, 11)));
  checks.Near("one window, SSIM", window.StructuralSimilarity, 1.0, 1e-12);
}
}

int TestPictureError(int, char*[])
{
  Checks checks;
  TestEqual(checks);
  TestShift(checks);
  TestHalf(checks);
  TestNegative(checks);
  TestEdges(checks);
  TestNarrow(checks);
  return checks.Result();
}
