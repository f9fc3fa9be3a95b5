// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Order and blending of the fragments of a pixel against closed forms: the alpha of the whole is
 * 1 - prod(1 - alpha_i), also for a hundred thousand layers; no order of arrival shows; equal
 * depths are ordered by content; opaque surfaces hide.
 */

#include "FragmentCompositing.h"
#include "ReferenceTesting.h"

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

namespace
{
using Fragment = pellucid::Fragment<double>;
using Pixel = pellucid::PixelFragments<double>;
using Color = pellucid::Vector4<double>;

void TestLayers(Checks& checks, int layers, double alpha)
{
  Pixel pixel;
  for (int i = 0; i < layers; ++i)
  {
    pixel.Add(
      { (i * 7919 % layers) / static_cast<double>(layers), Color(1, 0.5, 0, alpha) }, false);
  }
  pixel.Sort();
  const Color result = pixel.Composite(Color(0.0));
  const double expected = -std::expm1(layers * std::log1p(-alpha));
  const std::string name = std::to_string(layers) + " layers of " + std::to_string(alpha);
  checks.Near(name + ", alpha", result.a, expected, 1e-11);
  checks.Near(name + ", red", result.r, expected, 1e-11);
  checks.Near(name + ", green", result.g, 0.5 * expected, 1e-11);
  checks.True(
    name + ", none lost", pixel.GetTranslucent().size() == static_cast<std::size_t>(layers));
}

void TestOrderChange(Checks& checks)
{
  Pixel pixel;
  using Change = pellucid::Vector3<double>;
  const auto check = [&](const std::string& name, double resolution, Change fall, Change rise)
  {
    pixel.Sort();
    const auto change = pixel.GetOrderChange(resolution);
    for (int i = 0; i < 3; ++i)
    {
      checks.Near(name + ", fall", change.fall[i], fall[i], 1e-15);
      checks.Near(name + ", rise", change.rise[i], rise[i], 1e-15);
    }
  };
  const Change none(0.0);
  check("no fragment", 1.0, none, none);
  pixel.Add({ 0.2, Color(1, 0, 0, 0.5) }, false);
  check("one fragment", 1.0, none, none);
  // The exchange changes red by 0.5 * 0.4, then blue by 0.5 * 0.4 * 0.2 * 0.5.
  pixel.Add({ 0.5, Color(0, 0, 0, 0.4) }, false);
  pixel.Add({ 0.6, Color(0, 0, 0.5, 0.2) }, false);
  check("no pair is so close", 0.09, none, none);
  check("the nearest pair", 0.11, none, Change(0, 0, 0.02));
  check("two pairs", 0.31, Change(-0.2, 0, 0), Change(0, 0, 0.02));
  // The third may come to the front, too: 0.5 * 0.2 of red, and half of that of blue.
  check("all pairs", 0.5, Change(-0.3, 0, 0), Change(0, 0, 0.07));
  pixel.Add({ 0.6, Color(0, 0.5, 0.5, 0.2) }, false);
  check("none for equal depths", 0.11, none, Change(0, 0.02, 0.04));
}

// No order of random fragments changes the pixel by more, and two fragments change it by as much.
void TestOrderChangeOfAllOrders(Checks& checks)
{
  std::mt19937 generator(11);
  std::uniform_int_distribution<int> level(0, 4);
  const auto composite = [](const std::vector<Fragment>& fragments)
  {
    Pixel pixel;
    for (std::size_t i = 0; i < fragments.size(); ++i)
    {
      pixel.Add({ 0.1 * i, fragments[i].color }, false);
    }
    pixel.Sort();
    return pixel.Composite(Color(0.0));
  };
  const double resolution = 0.5; // of depths from 0 to 0.8
  bool isBound = true;
  bool isReached = true;
  for (int repeat = 0; repeat < 300; ++repeat)
  {
    const int count = 2 + repeat % 4;
    Pixel pixel;
    for (int i = 0; i < count; ++i)
    {
      pixel.Add({ 0.2 * level(generator) + 1e-3 * i,
                  Color(level(generator) / 4.0, 0.0, 0.0, (1 + level(generator)) / 5.0) },
        false);
    }
    pixel.Sort();
    const std::vector<Fragment> sorted = pixel.GetTranslucent();
    const auto change = pixel.GetOrderChange(resolution);
    const double red = composite(sorted).r;
    double fall = 0.0;
    double rise = 0.0;
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    do
    {
      std::vector<Fragment> fragments;
      bool isResolved = false;
      for (auto next = order.begin(); next != order.end(); ++next)
      {
        fragments.push_back(sorted[*next]);
        isResolved |= std::any_of(order.begin(), next,
          [&](std::size_t front)
          { return sorted[front].depth - sorted[*next].depth >= resolution; });
      }
      if (!isResolved)
      {
        fall = std::min(fall, composite(fragments).r - red);
        rise = std::max(rise, composite(fragments).r - red);
      }
    } while (std::next_permutation(order.begin(), order.end()));
    isBound &= change.fall.r <= fall + 1e-14 && change.rise.r >= rise - 1e-14 &&
      change.fall.r >= -1.0 - 1e-14 && change.rise.r <= 1.0 + 1e-14;
    isReached &= count > 2 ||
      (std::abs(change.fall.r - fall) < 1e-14 && std::abs(change.rise.r - rise) < 1e-14);
  }
  checks.True("no order changes a pixel by more", isBound);
  checks.True("two fragments change it by as much", isReached);
}

void TestOrder(Checks& checks)
{
  // Half of red over half of green over opaque blue.
  Pixel pixel;
  pixel.Add({ 0.5, Color(0, 1, 0, 0.5) }, false);
  pixel.Add({ 0.8, Color(0, 0, 1, 1) }, true);
  pixel.Add({ 0.9, Color(1, 1, 1, 1) }, true);
  pixel.Add({ 0.2, Color(1, 0, 0, 0.5) }, false);
  pixel.Add({ 0.85, Color(1, 1, 1, 0.5) }, false);
  pixel.Sort();
  const Color result = pixel.Composite(Color(1.0));
  checks.Near("red in front", result.r, 0.5, 1e-15);
  checks.Near("green behind it", result.g, 0.25, 1e-15);
  checks.Near("blue behind both", result.b, 0.25, 1e-15);
  checks.Near("opaque as a whole", result.a, 1.0, 1e-15);
  checks.True("hidden fragments are dropped", pixel.GetTranslucent().size() == 2);

  pixel.Clear();
  pixel.Add({ 0.5, Color(1, 0, 0, 0.5) }, false);
  pixel.Add({ 0.5, Color(0, 0, 1, 1) }, true);
  pixel.Sort();
  checks.Near("at the depth of the opaque surface", pixel.Composite(Color(0.0)).r, 0.5, 1e-15);

  pixel.Clear();
  pixel.Sort();
  const Color empty = pixel.Composite(Color(0.1, 0.2, 0.3, 0.0));
  checks.True("an empty pixel is the background", empty == Color(0.1, 0.2, 0.3, 0.0));

  pixel.Clear();
  pixel.Add({ 0.5, Color(1, 0, 0, 0.0) }, false);
  pixel.Add({ 0.5, Color(1, 0, 0, 1e-14) }, false);
  checks.True("full transparency leaves no fragment", pixel.GetTranslucent().empty());
  pixel.Add({ 0.5, Color(1, 0, 0, 1e-10) }, false);
  checks.True("any other does", pixel.GetTranslucent().size() == 1);
}

void TestShuffles(Checks& checks)
{
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> level(0, 7);
  std::vector<Fragment> fragments;
  for (int i = 0; i < 500; ++i)
  {
    fragments.push_back({ level(generator) / 8.0,
      Color(level(generator) / 7.0, level(generator) / 7.0, level(generator) / 7.0,
        (1 + level(generator)) / 20.0) });
  }
  Color first(0.0);
  for (int run = 0; run < 10; ++run)
  {
    Pixel pixel;
    for (const auto& fragment : fragments)
    {
      pixel.Add(fragment, false);
    }
    pixel.Sort();
    const Color result = pixel.Composite(Color(0.2));
    checks.True("same bits in any order", run == 0 || result == first);
    first = result;
    std::shuffle(fragments.begin(), fragments.end(), generator);
  }
}

void TestEqualDepths(Checks& checks)
{
  Pixel pixel;
  pixel.Add({ 0.5, Color(0, 1, 0, 0.8) }, false);
  pixel.Add({ 0.5, Color(1, 0, 0, 0.2) }, false);
  pixel.Add({ 0.5, Color(0.5, 0, 0, 0.2) }, false);
  pixel.Sort();
  const auto& list = pixel.GetTranslucent();
  checks.Near("less red first", list[0].color.r, 0.5, 0);
  checks.Near("more red next", list[1].color.r, 1, 0);
  checks.Near("more opaque last", list[2].color.a, 0.8, 0);
}
}

int TestReferenceCompositing(int, char*[])
{
  Checks checks;
  TestLayers(checks, 1, 1e-4);
  TestLayers(checks, 64, 0.1);
  TestLayers(checks, 500, 0.0019);
  TestLayers(checks, 1000, 0.3);
  TestLayers(checks, 100000, 1e-4);
  TestOrder(checks);
  TestOrderChange(checks);
  TestOrderChangeOfAllOrders(checks);
  TestShuffles(checks);
  TestEqualDepths(checks);
  return checks.Result();
}
