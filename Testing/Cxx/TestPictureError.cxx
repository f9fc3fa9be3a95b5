// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The error measures of the benchmark on pictures where they have a closed form.
 */

#include "PictureError.h"
#include "ReferenceTesting.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <functional>
#include <limits>
#include <stdexcept>

namespace
{
using pellucid::benchmark::Differences;
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

using Count = std::function<int(int x, int y)>;

vtkSmartPointer<vtkImageData> MakeCounts(const Count& count, int width = Width)
{
  auto counts = vtkSmartPointer<vtkImageData>::New();
  counts->SetDimensions(width, Height, 1);
  counts->AllocateScalars(VTK_INT, 1);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      counts->SetScalarComponentFromDouble(x, y, 0, 0, count(x, y));
    }
  }
  return counts;
}

// Green falls or rises so much, in steps of 8 bits.
vtkSmartPointer<vtkImageData> MakeChanges(const Value& green)
{
  auto changes = vtkSmartPointer<vtkImageData>::New();
  changes->SetDimensions(Width, Height, 1);
  changes->AllocateScalars(VTK_DOUBLE, 6);
  changes->GetPointData()->GetScalars()->Fill(0.0);
  for (int y = 0; y < Height; ++y)
  {
    for (int x = 0; x < Width; ++x)
    {
      const double change = green(x, y) / 255.0;
      changes->SetScalarComponentFromDouble(x, y, 0, change < 0.0 ? 1 : 4, change);
    }
  }
  return changes;
}

int One(int, int)
{
  return 1;
}

ExpectedPicture MakeExpected(const Value& value, int width = Width, const Count& count = One)
{
  return ExpectedPicture(
    MakePicture(VTK_DOUBLE, 1.0 / 255.0, value, width), MakeCounts(count, width));
}

double Pattern(int x, int y)
{
  return (37 * x + 91 * y) % 200;
}

void TestEqual(Checks& checks)
{
  const ExpectedPicture expected = MakeExpected(Pattern);
  const PictureError error = FindPictureError(MakeShown(Pattern), expected);
  checks.Near("equal, RMSE", error.RootMeanSquare, 0.0, 1e-12);
  checks.Near("equal, maximum", error.Maximum, 0.0, 0.0);
  checks.True("equal, PSNR", error.PeakSignalToNoise > 300.0);
  checks.Near("equal, SSIM", error.StructuralSimilarity, 1.0, 1e-12);
  checks.True("equal, no edges", error.EdgePixels == 0);
  const Value black = [](int, int) { return 0.0; };
  checks.True("black, PSNR",
    FindPictureError(MakeShown(black), MakeExpected(black)).PeakSignalToNoise ==
      std::numeric_limits<double>::infinity());
}

// A constant picture that is brighter: only the means of the similarity differ.
void TestShift(Checks& checks)
{
  const double dark = 100.0;
  const double bright = 110.0;
  const PictureError error = FindPictureError(
    MakeShown([=](int, int) { return bright; }), MakeExpected([=](int, int) { return dark; }));
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
      MakeExpected([&](int x, int) { return isWrong(x) ? 50.0 : 50.25; }));
  checks.Near("half, RMSE", error.RootMeanSquare, std::sqrt(0.5 * (36.0 + 0.0625)), 1e-9);
  checks.Near("half, maximum", error.Maximum, 6.0, 1e-9);
}

// A random pattern against its negative, about the same mean.
void TestNegative(Checks& checks)
{
  const Value negative = [](int x, int y) { return 199.0 - Pattern(x, y); };
  const PictureError error = FindPictureError(MakeShown(negative), MakeExpected(Pattern));
  checks.True("negative, SSIM", error.StructuralSimilarity < -0.8);
}

void CheckDifferences(
  Checks& checks, const std::string& what, const Differences& found, double rmse, double maximum)
{
  checks.Near(what + ", RMSE", found.RootMeanSquare, rmse, 1e-9);
  checks.Near(what + ", maximum", found.Maximum, maximum, 1e-9);
}

// Columns of a surface, the last of which has an edge, and the second one, where two surfaces
// intersect, are wrong altogether; the background is right. A little displacement changes colours a
// little everywhere.
void TestEdges(Checks& checks)
{
  const int covered = 8;
  const auto count = [](int x, int) { return x < covered ? 2 : 0; };
  const Value value = [](int x, int) { return x < covered ? 200.0 : 20.0; };
  ExpectedPicture expected = MakeExpected(value, Width, count);
  const auto shift = [&value](double change)
  {
    return MakePicture(VTK_DOUBLE, 1.0 / 255.0, [=](int x, int y) { return value(x, y) + change; });
  };
  expected.AddDisplaced(
    shift(0.9), MakeCounts([&](int x, int) { return x < covered - 1 ? 2 : 0; }));
  expected.AddDisplaced(MakePicture(VTK_DOUBLE, 1.0 / 255.0,
                          [&](int x, int y) { return value(x, y) - (x == 1 ? 1.1 : 0.0); }),
    MakeCounts(count));
  expected.AddDisplaced(shift(-0.9), MakeCounts(count));
  const auto isWrong = [](int x) { return x == 1 || x == covered - 1; };
  const PictureError error =
    FindPictureError(MakeShown([&](int x, int y)
                       { return isWrong(x) ? 0.0 : value(x, y) + (x < covered ? 3.0 : 0.0); }),
      expected);
  checks.True("edges", error.EdgePixels == 2 * Height);
  checks.True("covered", error.CoveredPixels == covered * Height);
  CheckDifferences(checks, "no edges", error, std::sqrt(9.0 * 6.0 / (Width - 2)), 3.0);
  CheckDifferences(checks, "covered", error.Covered, 3.0, 3.0);
  CheckDifferences(
    checks, "all", error.All, std::sqrt((9.0 * 6.0 + 2.0 * 200.0 * 200.0) / Width), 200.0);
}

void TestUnresolvedOrder(Checks& checks)
{
  ExpectedPicture expected = MakeExpected(Pattern);
  expected.AddOrderChanges(MakeChanges(
    [](int x, int) {
      return x == 3 ? 0.51 : x == 5 ? -0.51 : x % 2 == 0 ? 0.49 : -0.49;
    }));
  expected.AddDisplaced(
    expected.GetPicture(), MakeCounts([](int x, int) { return x == 5 || x == 7 ? 2 : 1; }));
  const PictureError error = FindPictureError(
    MakeShown([](int x, int y) { return x == 3 || x == 5 || x == 7 ? 0.0 : Pattern(x, y); }),
    expected);
  checks.True("unresolved orders and edges", error.EdgePixels == 3 * Height);
  checks.True("unresolved orders", error.OrderPixels == Height);
  CheckDifferences(checks, "resolved orders", error, 0.0, 0.0);
}

void TestOnlyEdges(Checks& checks)
{
  ExpectedPicture expected = MakeExpected(Pattern);
  expected.AddDisplaced(expected.GetPicture(), MakeCounts([](int, int) { return 2; }));
  const PictureError error = FindPictureError(MakeShown(Pattern), expected);
  checks.True("only edges", error.EdgePixels == Width * Height);
  checks.True("only edges, no error",
    std::isnan(error.RootMeanSquare) && std::isnan(error.Maximum) &&
      std::isnan(error.PeakSignalToNoise) && std::isnan(error.Covered.RootMeanSquare));
  CheckDifferences(checks, "only edges, all", error.All, 0.0, 0.0);
}

void TestNothingCovered(Checks& checks)
{
  const PictureError error =
    FindPictureError(MakeShown(Pattern), MakeExpected(Pattern, Width, [](int, int) { return 0; }));
  checks.True("nothing covered", error.CoveredPixels == 0);
  checks.True("nothing covered, no error", std::isnan(error.Covered.RootMeanSquare));
  CheckDifferences(checks, "nothing covered, all", error, 0.0, 0.0);
}

void CheckRefusal(Checks& checks, const std::string& what, const std::function<void()>& act)
{
  try
  {
    act();
    checks.True(what + " is refused", false);
  }
  catch (const std::invalid_argument& error)
  {
    checks.True(what + ", message",
      std::string(error.what()) ==
        "a picture of 40x30 pixels was expected to compare with, found are 39x30");
  }
}

void TestSizes(Checks& checks)
{
  ExpectedPicture expected = MakeExpected(Pattern);
  const int other = Width - 1;
  CheckRefusal(
    checks, "another picture", [&] { FindPictureError(MakeShown(Pattern, other), expected); });
  CheckRefusal(checks, "another displaced one",
    [&] { expected.AddDisplaced(expected.GetPicture(), MakeCounts(One, other)); });
  CheckRefusal(checks, "another displaced picture",
    [&] { expected.AddDisplaced(MakeExpected(Pattern, other).GetPicture(), MakeCounts(One)); });
  CheckRefusal(checks, "other changes",
    [&] { expected.AddOrderChanges(MakeExpected(Pattern, other).GetPicture()); });
  CheckRefusal(checks, "another number of counts",
    [&] { ExpectedPicture(expected.GetPicture(), MakeCounts(One, other)); });
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
  TestUnresolvedOrder(checks);
  TestOnlyEdges(checks);
  TestNothingCovered(checks);
  TestSizes(checks);
  TestNarrow(checks);
  return checks.Result();
}
