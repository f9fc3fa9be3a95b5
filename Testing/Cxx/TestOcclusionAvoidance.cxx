// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The attributes of a pixel in closed form, whatever the order of its fragments; their smoothing
 * without empty pixels; the factors of both modes.
 */

#include "OcclusionAvoidance.h"
#include "ReferenceTesting.h"

#include <random>

namespace
{
using Fragment = pellucid::AttributeFragment<double>;
using Attributes = pellucid::PixelAttributes<double>;
using Avoidance = pellucid::OcclusionAvoidance<double>;
using Vector = pellucid::Vector3<double>;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

const Vector X(1, 0, 0);
const Vector Y(0, 1, 0);
const Vector None(0.0);

double Variance(const std::vector<Vector>& tangents)
{
  std::vector<Fragment> fragments;
  fragments.reserve(tangents.size());
  for (const auto& tangent : tangents)
  {
    fragments.push_back({ 1.0, 0.5, tangent });
  }
  return pellucid::ComputePixelAttributes(fragments).directionalVariance;
}

void TestAttributes(Checks& checks)
{
  const auto empty = pellucid::ComputePixelAttributes<double>({});
  checks.True("nothing",
    empty.coverage == 0 && empty.importance == 0 && empty.depth == 0 &&
      empty.directionalVariance == 0);

  std::vector<Fragment> fragments{ { 5, 0.25, X }, { 9, 0.75, X }, { 6, 0.75, X },
    { 2, NotANumber, X }, { 7, -3, X } };
  std::mt19937 generator(1);
  for (int run = 0; run < 20; ++run)
  {
    std::shuffle(fragments.begin(), fragments.end(), generator);
    const auto pixel = pellucid::ComputePixelAttributes(fragments);
    checks.True("coverage", pixel.coverage == 5);
    checks.True("greatest importance", pixel.importance == 0.75);
    checks.True("depth of the nearest that has it", pixel.depth == 6);
  }
  const auto unimportant =
    pellucid::ComputePixelAttributes<double>({ { 5, 0, X }, { 3, NotANumber, X } });
  checks.True("of no importance", unimportant.importance == 0 && unimportant.depth == 3);

  // Depths that differ by less than 16 bits can tell.
  const auto close =
    pellucid::ComputePixelAttributes<double>({ { 1 + 1e-9, 1, X }, { 1, 1 - 1e-4, X } });
  checks.True("no precision is lost", close.depth == 1 + 1e-9);
  const auto equal = pellucid::ComputePixelAttributes<double>({ { 2, 1, X }, { 1, 1 - 1e-7, X } });
  checks.True("rounding does not decide", equal.depth == 1 && equal.importance == 1);
}

void TestVariance(Checks& checks)
{
  checks.Near("parallel", Variance({ X, X, X }), 0, 0);
  checks.Near("opposite", Variance({ X, -X }), 1, 0);
  checks.Near("at right angles", Variance({ X, Y }), 1 - std::sqrt(0.5), 1e-15);
  checks.Near("without a direction", Variance({ None, None }), 0, 0);
  checks.Near(
    "some without", Variance({ X, None, Vector(NotANumber), Y }), 1 - std::sqrt(0.5), 1e-15);
}

void TestSmoothing(Checks& checks)
{
  // 7 x 6 pixels, empty but for three; the third is out of reach of the first.
  constexpr int width = 7;
  std::vector<Attributes> pixels(width * 6);
  pixels[0] = { 1, 1.0, 10, 0.5 };
  pixels[2 * width + 2] = { 3, 0.5, 20, 0.25 };
  pixels[4 * width + 4] = { 2, 0.0, 60, 0.0 };
  pellucid::SmoothPixelAttributes(pixels, width);
  checks.Near("a corner, importance", pixels[0].importance, 0.75, 1e-15);
  checks.Near("a corner, depth", pixels[0].depth, 15, 1e-13);
  checks.Near("the middle, importance", pixels[2 * width + 2].importance, 0.5, 1e-15);
  checks.Near("the middle, depth", pixels[2 * width + 2].depth, 30, 1e-13);
  checks.Near("the other end", pixels[4 * width + 4].depth, 40, 1e-13);
  checks.True(
    "coverage and variance stay", pixels[0].coverage == 1 && pixels[0].directionalVariance == 0.5);
  checks.True("empty pixels stay so", pixels[1].coverage == 0 && pixels[1].depth == 0);

  std::vector<Attributes> none;
  pellucid::SmoothPixelAttributes(none, 0);
  checks.True("an empty image", none.empty());
}

void TestFactors(Checks& checks)
{
  const Attributes pixel{ 4, 0.75, 6, 0.5 };
  Avoidance avoidance;
  checks.True("penalty in front", avoidance.Factor(5.9, 0.1, pixel) == 0.25);
  checks.True("no penalty at the most important", avoidance.Factor(6, 0.75, pixel) == 1);
  checks.True("no penalty behind it", avoidance.Factor(7, 0.1, pixel) == 1);
  avoidance.penalty = 0;
  checks.True("removal", avoidance.Factor(5, 0.1, pixel) == 0);

  avoidance.mode = Avoidance::WEIGHTING;
  checks.True("no weights", avoidance.Factor(5, 0.1, pixel) == 1);
  avoidance.lambda = 2;
  avoidance.importanceWeight = 2;
  avoidance.coverageWeight = 0.5;
  avoidance.varianceWeight = 3;
  avoidance.depthWeight = 7;
  checks.Near("behind", avoidance.Factor(6, 0.5, pixel), 1 / (1 + 0.75 * 5), 1e-15);
  checks.Near("in front", avoidance.Factor(5, 0.5, pixel), 1 / (1 + 0.75 * 12), 1e-15);
  checks.Near("missing importance", avoidance.Factor(6, NotANumber, pixel), 1.0 / 6, 1e-15);
  checks.True("greatest importance", avoidance.Factor(5, 1.5, pixel) == 1);

  avoidance.globalOpacity = 0.5;
  checks.True("weighting, global opacity", avoidance.Factor(5, 1, pixel) == 0.5);
  avoidance.mode = Avoidance::PENALTY;
  checks.True("penalty, global opacity", avoidance.Factor(7, 0, pixel) == 0.5);
}
}

int TestOcclusionAvoidance(int, char*[])
{
  Checks checks;
  TestAttributes(checks);
  TestVariance(checks);
  TestSmoothing(checks);
  TestFactors(checks);
  return checks.Result();
}
