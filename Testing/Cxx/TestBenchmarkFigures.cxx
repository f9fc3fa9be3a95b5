// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which methods the benchmark recommends, and the statistics that it reports.
 */

#include "ParetoFront.h"
#include "ReferenceTesting.h"
#include "Row.h"
#include "Statistics.h"

#include <limits>

namespace
{
using pellucid::benchmark::FindMedian;
using pellucid::benchmark::FindParetoFront;
using pellucid::benchmark::FindQuantile;
using pellucid::benchmark::FitExponent;
using pellucid::benchmark::MarkFronts;
using pellucid::benchmark::PictureError;
using pellucid::benchmark::Row;

using Flags = std::vector<bool>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

void TestFront(Checks& checks)
{
  checks.True("none", FindParetoFront({}).empty());
  checks.True("one", FindParetoFront({ { 3.0, 3.0, 2.0 } }) == Flags{ true });
  checks.True("a front of three, and two that others beat",
    FindParetoFront({ { 1.0, 1.1, 9.0 }, { 2.0, 2.2, 4.0 }, { 8.0, 8.8, 0.5 }, { 3.0, 3.3, 5.0 },
      { 8.0, 8.1, 0.6 } }) == Flags{ true, true, true, false, false });
  checks.True(
    "equal ones", FindParetoFront({ { 1.0, 1.0, 1.0 }, { 1.0, 1.0, 1.0 } }) == Flags{ true, true });
  checks.True("as fast, but worse",
    FindParetoFront({ { 1.0, 1.5, 1.0 }, { 1.0, 1.0, 2.0 } }) == Flags{ true, false });
  checks.True("as good, but slower",
    FindParetoFront({ { 2.0, 2.5, 1.0 }, { 1.0, 1.5, 1.0 } }) == Flags{ false, true });
  checks.True("without an error",
    FindParetoFront({ { 0.1, 0.1, NotANumber }, { 1.0, 1.0, 1.0 },
      { NotANumber, NotANumber, 0.0 } }) == Flags{ false, true, false });
}

/// What is within the noise of times, or the tolerance of errors, beats nobody.
void TestNoise(Checks& checks)
{
  checks.True("times that overlap",
    FindParetoFront({ { 1.0, 2.1, 0.3 }, { 2.0, 3.0, 0.3 } }) == Flags{ true, true });
  checks.True("times that do not",
    FindParetoFront({ { 1.0, 1.9, 0.3 }, { 2.0, 3.0, 0.3 } }) == Flags{ true, false });
  checks.True("faster, and worse by less than the tolerance",
    FindParetoFront({ { 1.0, 1.0, 0.309 }, { 2.0, 2.0, 0.3 } }) == Flags{ true, false });
  checks.True("faster, and worse by more than the tolerance",
    FindParetoFront({ { 1.0, 1.0, 0.311 }, { 2.0, 2.0, 0.3 } }) == Flags{ true, true });
  checks.True("better, and as fast within the noise",
    FindParetoFront({ { 1.0, 2.0, 0.32 }, { 1.9, 3.0, 0.3 } }) == Flags{ false, true });
}

Row MakeRow(const std::string& scene, const std::string& shape, double milliseconds, double error)
{
  Row row;
  row.Scene = scene;
  row.Shape = shape;
  row.Milliseconds = { milliseconds };
  row.Error = PictureError();
  row.Error->RootMeanSquare = error;
  return row;
}

void TestRows(Checks& checks)
{
  std::vector<Row> rows = { MakeRow("a", "cones", 1.0, 5.0), MakeRow("b", "cones", 2.0, 6.0),
    MakeRow("a", "cones", 2.0, 6.0), MakeRow("a", "cones", 3.0, 0.2889),
    MakeRow("a", "cones", 4.0, 0.2887), MakeRow("a", "cones", 0.5, 0.0),
    MakeRow("a", "triangles", 5.0, 7.0), MakeRow("a", "triangles", 6.0, 8.0),
    MakeRow("a", "cones", 0.5, 0.0), Row() };
  rows[5].HasOptimizedOpacities = true;
  rows[8].IsCold = true;
  rows[9].Scene = "a";
  // One slow frame is none of its quartiles.
  rows[0].Milliseconds = { 0.1, 1.0, 1.0, 2.0, 100.0 };
  MarkFronts(rows);
  const Flags expected = { true, true, false, true, false, false, true, false, false, false };
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    checks.True("row " + std::to_string(i), rows[i].IsOnFront == expected[i]);
  }
}

void TestMedian(Checks& checks)
{
  checks.Near("median of an odd number", FindMedian({ 5.0, 1.0, 9.0 }), 5.0, 0.0);
  checks.Near("median of an even number", FindMedian({ 4.0, 1.0, 9.0, 2.0 }), 3.0, 0.0);
  checks.Near("quartile", FindQuantile({ 5.0, 1.0, 2.0 }, 0.25), 1.5, 1e-12);
  checks.Near("least", FindQuantile({ 5.0, 1.0, 2.0 }, 0.0), 1.0, 0.0);
  checks.Near("largest", FindQuantile({ 5.0, 1.0, 2.0 }, 1.0), 5.0, 0.0);
  checks.True("median of nothing", std::isnan(FindMedian({})));
  const Row empty;
  checks.True("no frame",
    std::isnan(empty.GetMedian()) && std::isnan(empty.GetTime(0.0)) &&
      std::isnan(empty.GetTime(1.0)));
}

void TestQuantiles(Checks& checks)
{
  const std::vector<double> numbers = { 4.0, 1.0, 16.0, 9.0, 25.0 };
  checks.Near("the least", FindQuantile(numbers, 0.0), 1.0, 0.0);
  checks.Near("a quartile", FindQuantile(numbers, 0.25), 4.0, 0.0);
  checks.Near("between two", FindQuantile(numbers, 0.9), 16.0 + 0.6 * 9.0, 1e-12);
  checks.Near("the largest", FindQuantile(numbers, 1.0), 25.0, 0.0);
  checks.Near("of one", FindQuantile({ 7.0 }, 0.25), 7.0, 0.0);
  checks.True("of none", std::isnan(FindQuantile({}, 0.25)));
}

void TestExponent(Checks& checks)
{
  checks.Near(
    "a power law", FitExponent({ 1.0, 10.0, 100.0 }, { 5.0, 40.0, 320.0 }), std::log10(8.0), 1e-12);
  checks.Near("a constant", FitExponent({ 1e3, 1e7 }, { 2.0, 2.0 }), 0.0, 1e-12);
  checks.Near(
    "zeros are left out", FitExponent({ 1.0, 2.0, 3.0, 0.0 }, { 1.0, 2.0, 0.0, 9.0 }), 1.0, 1e-12);
  checks.True("of one size", std::isnan(FitExponent({ 7.0, 7.0 }, { 1.0, 2.0 })));
  checks.True("of nothing", std::isnan(FitExponent({}, {})));
}
}

int TestBenchmarkFigures(int, char*[])
{
  Checks checks;
  TestFront(checks);
  TestNoise(checks);
  TestRows(checks);
  TestMedian(checks);
  TestQuantiles(checks);
  TestExponent(checks);
  return checks.Result();
}
