// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The opacities of a pixel minimise the energy as it is written down, double sums and all; closed
 * forms for a hundred thousand fragments; the more important is never the less opaque; any number
 * is an importance; what its own segment hides is skipped.
 */

#include "OpacitySolution.h"
#include "ReferenceTesting.h"

#include <algorithm>
#include <random>

namespace
{
using Parameters = pellucid::OpacityParameters<double>;
using Fragment = pellucid::OpacityFragment<double>;
using List = std::vector<Fragment>;

constexpr std::size_t Many = 100000;
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::vector<double> Solve(const List& list)
{
  std::vector<double> opacities;
  pellucid::SolveOpacities(list, opacities);
  return opacities;
}

List UniformList(std::size_t size, double importance, const Parameters& parameters)
{
  List list;
  for (std::size_t i = 0; i < size; ++i)
  {
    list.push_back({ importance, static_cast<pellucid::SegmentId>(i), &parameters });
  }
  return list;
}

// The terms with the unknown i of GTG17 eqs. 5 to 7, with the occlusion degrees of eq. 8 for each
// pair; `part` says what takes part. No other term has that unknown.
long double Energy(
  const List& list, const std::vector<bool>& part, std::size_t i, long double opacity)
{
  const auto& own = *list[i].parameters;
  const long double weight = std::pow(
    1 - static_cast<long double>(list[i].importance), static_cast<long double>(own.lambda));
  long double energy = (opacity - 1) * (opacity - 1);
  for (std::size_t j = 0; j < list.size(); ++j)
  {
    const long double hides = part[j] && i < j ? 1 : 0;
    const long double isHidden = part[j] && i > j ? 1 : 0;
    const long double term = opacity * weight * list[j].importance;
    energy += own.q * (hides * term) * (hides * term);
    energy += own.r * (isHidden * term) * (isHidden * term);
  }
  return energy / 2;
}

// Objects of different parameters, segments of up to three fragments, and one object out of four
// that takes no part.
List RandomList(std::mt19937& generator, const std::vector<Parameters>& objects)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  List list(1 + generator() % 40);
  for (auto& fragment : list)
  {
    const auto object = generator() % (objects.size() + 1);
    fragment.importance = uniform(generator);
    fragment.segment = static_cast<pellucid::SegmentId>(3 * object + generator() % 3);
    fragment.parameters = object < objects.size() ? &objects[object] : nullptr;
  }
  return list;
}

void TestEnergies(Checks& checks)
{
  const std::vector<Parameters> objects{ { 50, 400, 2, true }, { 1e5, 0, 0.1, false },
    { 3, 1e5, 20, true } };
  std::mt19937 generator(5);
  for (int run = 0; run < 40; ++run)
  {
    const List list = RandomList(generator, objects);
    const auto solution = Solve(list);
    std::vector<bool> part(list.size());
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      const bool same = i > 0 && list[i - 1].segment == list[i].segment;
      part[i] = list[i].parameters && !(same && list[i].parameters->skipSelfOcclusion);
    }

    for (std::size_t i = 0; i < list.size(); ++i)
    {
      if (!part[i])
      {
        checks.True("what takes no part stays opaque", solution[i] == 1);
        continue;
      }
      checks.True("in range", solution[i] > 0 && solution[i] <= 1);
      // The energy is quadratic: its central differences are its gradient and its curvature.
      const long double least = Energy(list, part, i, solution[i]);
      const long double above = Energy(list, part, i, 2 * static_cast<long double>(solution[i]));
      const long double below = Energy(list, part, i, 0);
      checks.True("a minimum", above > least && below > least);
      checks.Near("its place relative to the solution",
        static_cast<double>((above - below) / (above - 2 * least + below) / 2), 0, 1e-11);
    }
  }
}

void TestManyFragments(Checks& checks)
{
  for (const double lambda : { 0.1, 1.0, 3.5, 20.0 })
  {
    for (const double q : { 0.0, 2000.0, 1e5 })
    {
      for (const double r : { 0.0, 50.0, 1e5 })
      {
        const Parameters parameters{ q, r, lambda, false };
        for (const double constant : { 0.0, 1.0 })
        {
          const auto opacities = Solve(UniformList(Many, constant, parameters));
          checks.True("all of no importance, or all of the greatest, are opaque",
            std::all_of(opacities.begin(), opacities.end(), [](double a) { return a == 1; }));
        }

        List list = UniformList(Many, 0.0, parameters);
        const std::size_t important = Many / 3;
        list[important].importance = 1;
        const auto one = Solve(list);
        checks.True("the important one", one[important] == 1);
        checks.True("in front of it",
          std::all_of(
            one.begin(), one.begin() + important, [q](double a) { return a == 1 / (1 + q); }));
        checks.True("behind it",
          std::all_of(
            one.begin() + important + 1, one.end(), [r](double a) { return a == 1 / (1 + r); }));

        const auto half = Solve(UniformList(Many, 0.5, parameters));
        const double weight = std::pow(0.5, 2 * lambda) / 4;
        for (const std::size_t i : { std::size_t(0), Many / 2, Many - 1 })
        {
          const auto inFront = static_cast<double>(i);
          const double behind = static_cast<double>(Many - 1) - inFront;
          const double expected = 1 / (1 + weight * (r * inFront + q * behind));
          checks.Near("all of half importance", half[i] / expected, 1, 1e-14);
        }
      }
    }
  }

  // Where the sum behind, found by subtraction, does not get back to 0.
  const Parameters noClutter{ 1e5, 0, 1, false };
  List list = UniformList(Many, 0.0, noClutter);
  for (std::size_t i = 0; i < Many; ++i)
  {
    list[i].importance = 1e-3 * static_cast<double>(1 + i * 7919 % 500);
  }
  checks.True("nothing behind the last", Solve(list).back() == 1);
  checks.True("no fragment", Solve({}).empty());
  checks.True("one fragment", Solve(UniformList(1, 0.3, noClutter)).front() == 1);
}

void TestMonotony(Checks& checks)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < 100; ++run)
  {
    const Parameters parameters{ std::pow(10.0, 5 * uniform(generator)),
      std::pow(10.0, 5 * uniform(generator)), 0.1 + 19.9 * uniform(generator), false };
    List list = UniformList(50, 0.0, parameters);
    for (auto& fragment : list)
    {
      fragment.importance = uniform(generator);
    }
    const std::size_t changed = generator() % list.size();
    double last = 0;
    for (int step = 0; step <= 20; ++step)
    {
      list[changed].importance = step / 20.0;
      const double opacity = Solve(list)[changed];
      checks.True("more important, and less opaque", opacity >= last);
      last = opacity;
    }
    checks.True("of the greatest importance, and not opaque", last == 1);
  }
}

void TestAnyNumber(Checks& checks)
{
  const Parameters parameters{ 50, 400, 0.1, false };
  const std::vector<std::pair<double, double>> same{ { NotANumber, 0.0 }, { -Infinity, 0.0 },
    { -0.5, 0.0 }, { Infinity, 1.0 }, { 1.5, 1.0 } };
  for (const auto& [odd, proper] : same)
  {
    List list = UniformList(5, 0.5, parameters);
    list[2].importance = proper;
    const auto expected = Solve(list);
    list[2].importance = odd;
    checks.True("an importance outside [0,1], " + std::to_string(odd), Solve(list) == expected);
  }
}

// As interpolation between points of importance 1 leaves it.
template <typename Real>
void TestFullImportance(Checks& checks)
{
  for (const Real lambda : { Real(0.01), Real(2) })
  {
    const pellucid::OpacityParameters<Real> parameters{ Real(1e30), Real(1e30), lambda, false };
    std::vector<pellucid::OpacityFragment<Real>> list;
    for (int i = 0; i < 5; ++i)
    {
      list.push_back({ Real(1 - 1e-7 * i), i, &parameters });
    }
    std::vector<Real> opacities;
    pellucid::SolveOpacities(list, opacities);
    checks.True("full importance", opacities == std::vector<Real>(5, Real(1)));
  }
}

template <typename Real>
void TestHugeWeights(Checks& checks)
{
  for (const Real weight : { Real(1e38), std::numeric_limits<Real>::max() })
  {
    const pellucid::OpacityParameters<Real> parameters{ weight, weight, 2, false };
    std::vector<pellucid::OpacityFragment<Real>> list;
    for (int i = 0; i < 12; ++i)
    {
      list.push_back({ Real(0.5) * Real(i % 3), i, &parameters });
    }
    std::vector<Real> opacities;
    pellucid::SolveOpacities(list, opacities);
    for (std::size_t i = 0; i < list.size(); ++i)
    {
      checks.True("huge weights: opacity " + std::to_string(opacities[i]),
        i % 3 == 2 ? opacities[i] == 1 : (opacities[i] >= 0 && opacities[i] < Real(1e-6)));
    }
  }
}

void TestObjects(Checks& checks)
{
  // One important fragment between two of other objects: each goes by its own weights.
  const Parameters front{ 3, 0, 1, false };
  const Parameters important{ 1e5, 1e5, 1, false };
  const Parameters back{ 0, 7, 1, false };
  const List list{ { 0, 0, &front }, { 1, 1, &important }, { 0, 2, &back } };
  checks.True("own weights", Solve(list) == std::vector<double>({ 0.25, 1, 0.125 }));

  List bystander = list;
  bystander[1].parameters = nullptr;
  checks.True("what takes no part is of no importance, and opaque",
    Solve(bystander) == std::vector<double>({ 1, 1, 1 }));
}

void TestSelfOcclusion(Checks& checks)
{
  Parameters parameters{ 3, 1, 1, true };
  const auto solve = [&parameters](const std::vector<std::pair<double, int>>& fragments)
  {
    List list;
    for (const auto& [importance, segment] : fragments)
    {
      list.push_back({ importance, segment, &parameters });
    }
    return Solve(list);
  };
  const std::vector<std::pair<double, int>> run{ { 0, 7 }, { 1, 7 }, { 1, 7 }, { 0, 8 } };
  checks.True(
    "a run of one segment counts once", solve(run) == std::vector<double>({ 1, 1, 1, 1 }));
  const std::vector<std::pair<double, int>> apart{ { 0, 7 }, { 1, 8 }, { 0, 7 }, { 0, 7 } };
  checks.True("fragments with another between them are not a run",
    solve(apart) == std::vector<double>({ 0.25, 1, 0.5, 1 }));
  parameters.skipSelfOcclusion = false;
  checks.True("off", solve(run) == std::vector<double>({ 1.0 / 7, 1, 1, 1.0 / 3 }));

  // The predecessor is that of the list, whether its object takes part or not.
  parameters.skipSelfOcclusion = true;
  checks.True("a fragment that takes no part ends a run",
    Solve({ { 0, 7, &parameters }, { 0, 9, nullptr }, { 1, 7, &parameters } }) ==
      std::vector<double>({ 0.25, 1, 1 }));
}
}

int TestOpacitySolution(int, char*[])
{
  Checks checks;
  TestEnergies(checks);
  TestManyFragments(checks);
  TestMonotony(checks);
  TestAnyNumber(checks);
  TestFullImportance<float>(checks);
  TestFullImportance<double>(checks);
  TestHugeWeights<float>(checks);
  TestHugeWeights<double>(checks);
  TestObjects(checks);
  TestSelfOcclusion(checks);
  return checks.Result();
}
