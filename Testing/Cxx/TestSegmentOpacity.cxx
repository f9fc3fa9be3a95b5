// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The least opacity of each segment; smoothing on lines, surfaces and points, and interpolation,
 * with undefined segments that never leak.
 */

#include "ReferenceTesting.h"
#include "SegmentOpacity.h"

namespace
{
using Opacities = std::vector<double>;

constexpr double Undefined = pellucid::UndefinedOpacity<double>();

bool Same(double a, double b)
{
  return std::isnan(a) ? std::isnan(b) : std::abs(a - b) <= 1e-15;
}

bool Same(const Opacities& a, const Opacities& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](double first, double second) { return Same(first, second); });
}

// Lines of these numbers of segments, one after the other.
pellucid::SegmentNeighbors Lines(const std::vector<int>& sizes)
{
  pellucid::SegmentNeighbors neighbors;
  pellucid::SegmentId first = 0;
  for (const int size : sizes)
  {
    for (pellucid::SegmentId i = first; i < first + size; ++i)
    {
      if (i > first)
      {
        neighbors.ids.push_back(i - 1);
      }
      if (i + 1 < first + size)
      {
        neighbors.ids.push_back(i + 1);
      }
      neighbors.offsets.push_back(neighbors.ids.size());
    }
    first += size;
  }
  return neighbors;
}

Opacities Smooth(Opacities opacities, const pellucid::SegmentNeighbors& neighbors, int iterations,
  double relaxation = 0.5)
{
  pellucid::SmoothOpacities(opacities, neighbors, iterations, relaxation);
  return opacities;
}

void TestMinimum(Checks& checks)
{
  const pellucid::OpacityParameters<double> parameters;
  const std::vector<pellucid::OpacityFragment<double>> list{ { 0, 2, &parameters },
    { 0, 0, &parameters }, { 0, -1, nullptr }, { 0, 2, &parameters } };
  Opacities segments(4, Undefined);
  pellucid::LowerSegmentOpacities(list, { 0.5, 0.75, 0.0, 0.25 }, segments);
  checks.True("one pixel", Same(segments, { 0.75, Undefined, 0.25, Undefined }));
  pellucid::LowerSegmentOpacities(list, { 1.0, 0.5, 0.0, 1.0 }, segments);
  checks.True("two pixels", Same(segments, { 0.5, Undefined, 0.25, Undefined }));
}

void TestSmoothing(Checks& checks)
{
  const auto line = Lines({ 3 });
  checks.True("none", Same(Smooth({ 0, 1, 0.5 }, line, 0), { 0, 1, 0.5 }));
  checks.True("one step", Same(Smooth({ 0, 1, 0.5 }, line, 1), { 0.5, 0.625, 0.75 }));
  checks.True("two steps", Same(Smooth({ 0, 1, 0.5 }, line, 2), { 0.5625, 0.625, 0.6875 }));
  checks.True("to the mean at once", Same(Smooth({ 0, 1, 0.5 }, line, 1, 1.0), { 1, 0.25, 1 }));
  checks.True(
    "a quarter of the way", Same(Smooth({ 0, 1, 0.5 }, line, 1, 0.25), { 0.25, 0.8125, 0.625 }));
  checks.True("constant", Same(Smooth({ 0.3, 0.3, 0.3 }, line, 50, 0.3), { 0.3, 0.3, 0.3 }));

  // 0.5 at both ends of the line and of a defined part is what no leak can leave untouched.
  checks.True("undefined segments stay so and do not leak",
    Same(Smooth({ Undefined, 0.5, Undefined, 0.25, 0.75, Undefined }, Lines({ 6 }), 1),
      { Undefined, 0.5, Undefined, 0.5, 0.5, Undefined }));
  checks.True("lines do not mix",
    Same(Smooth({ 0.25, 0.75, 1, 0, 0 }, Lines({ 2, 1, 2 }), 9), { 0.5, 0.5, 1, 0, 0 }));

  pellucid::SegmentNeighbors points;
  points.offsets.assign(4, 0);
  checks.True("points", Same(Smooth({ 0, 1, Undefined }, points, 9), { 0, 1, Undefined }));

  // The middle of a patch of nine cells, each the neighbour of all others.
  pellucid::SegmentNeighbors patch;
  for (pellucid::SegmentId i = 0; i < 9; ++i)
  {
    for (pellucid::SegmentId j = 0; j < 9; ++j)
    {
      if (i != j)
      {
        patch.ids.push_back(j);
      }
    }
    patch.offsets.push_back(patch.ids.size());
  }
  const auto surface = Smooth({ 1, 0, 0, 0, 0, 0, 0, 0, 0 }, patch, 1);
  checks.True("a surface", Same(surface.front(), 0.5) && Same(surface.back(), 1.0 / 16));
}

void TestInterpolation(Checks& checks)
{
  const Opacities line{ 0.25, 0.75, Undefined, Undefined, 0.5 };
  checks.True("at a centre", pellucid::InterpolateOpacity(line, 1, 0.0) == 0.75);
  checks.True("between", Same(pellucid::InterpolateOpacity(line, 0, 0.25), 0.375));
  checks.True("next to an undefined one", pellucid::InterpolateOpacity(line, 1, 0.9) == 0.75);
  checks.True("behind an undefined one", pellucid::InterpolateOpacity(line, 3, 0.1) == 0.5);
  checks.True("nothing defined", pellucid::InterpolateOpacity(line, 2, 0.5) == 1);
  checks.True("the last has no next", pellucid::InterpolateOpacity(line, 4, 0.0) == 0.5);

  const pellucid::SegmentId segments[] = { 0, 1, 2, 4 };
  const double weights[] = { 0.25, 0.25, 0.25, 0.25 };
  checks.True("four of a surface, one undefined",
    Same(pellucid::InterpolateOpacity(line, segments, weights, 4), 0.5));
  const double ends[] = { 0, 0, 1, Undefined };
  checks.True("only an undefined one", pellucid::InterpolateOpacity(line, segments, ends, 4) == 1);
  checks.True("no segment", pellucid::InterpolateOpacity(line, segments, weights, 0) == 1);
  for (int k = 0; k < 100; ++k)
  {
    checks.True("never above 1", pellucid::InterpolateOpacity({ 1.0, 1.0 }, 0, k / 100.0) == 1);
  }
}
}

int TestSegmentOpacity(int, char*[])
{
  Checks checks;
  TestMinimum(checks);
  TestSmoothing(checks);
  TestInterpolation(checks);
  return checks.Result();
}
