// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Tubes of polylines, seen through the ray caster: a tube that is crossed once gives one fragment
 * whatever its joints, also when joints lie exactly on pixel rays; a ray that starts inside sees
 * the inner wall once; clipping planes open tubes; damaged lines are split; single and double
 * precision agree.
 */

#include "RayCasting.h"
#include "ReferenceTesting.h"

#include <random>

namespace
{
template <typename Real>
using Vec = pellucid::Vector3<Real>;
template <typename Real>
using Line = std::vector<pellucid::TubePoint<Real>>;
template <typename Real>
using Scene = pellucid::Scene<Real>;

/** A parallel view of [-width/2, width/2] x [-height/2, height/2] in units, `scale` pixels each,
 * from z = -1 to z = -11. */
template <typename Real>
Scene<Real> MakeScene(int width, int height, Real scale)
{
  Scene<Real> scene;
  scene.view.width = width;
  scene.view.height = height;
  scene.view.parallel = true;
  scene.view.projection[0][0] = 2 * scale / width;
  scene.view.projection[1][1] = 2 * scale / height;
  scene.view.projection[2][2] = Real(-0.2);
  scene.view.projection[3][2] = Real(-1.2);
  scene.surfaces.emplace_back();
  scene.surfaces.back().opaque = false;
  scene.surfaces.back().front.opacity = Real(0.5);
  scene.surfaces.back().lit = false;
  return scene;
}

template <typename Real>
Line<Real> MakeLine(const std::vector<Vec<Real>>& points, Real radius)
{
  Line<Real> line;
  for (const auto& point : points)
  {
    line.push_back({ point, radius, pellucid::Vector4<Real>(Real(1)) });
  }
  return line;
}

template <typename Real>
std::vector<pellucid::Fragment<Real>> CastPixel(const Scene<Real>& scene, int x, int y)
{
  const pellucid::RayCaster<Real> caster(scene);
  std::vector<pellucid::PixelFragments<Real>> pixels;
  caster.Cast(caster.GetTileOfPixel(x, y), { x, y, x + 1, y + 1 }, pixels);
  return pixels.front().GetTranslucent();
}

/** How many pixels have a given number of fragments, in the order of these numbers. */
template <typename Real>
std::vector<int> CountPixels(const Scene<Real>& scene)
{
  const pellucid::RayCaster<Real> caster(scene);
  std::vector<pellucid::PixelFragments<Real>> pixels;
  std::vector<int> histogram(8);
  for (int tile = 0; tile < caster.GetNumberOfTiles(); ++tile)
  {
    caster.Cast(tile, caster.GetTile(tile), pixels);
    for (const auto& pixel : pixels)
    {
      ++histogram[std::min<std::size_t>(pixel.GetTranslucent().size(), 7)];
    }
  }
  return histogram;
}

/** Distance from the eye of a fragment of MakeScene(). */
template <typename Real>
Real Distance(const pellucid::Fragment<Real>& fragment)
{
  return 1 + 10 * fragment.depth;
}

template <typename Real>
void TestStraight(Checks& checks, Real tolerance)
{
  // Joints at whole units, which are pixel centres, and the tube's outline between pixels.
  auto scene = MakeScene<Real>(41, 21, 2);
  std::vector<Vec<Real>> points;
  for (int i = -4; i <= 4; ++i)
  {
    points.push_back({ static_cast<Real>(i), 0, -6 });
  }
  scene.AddTube(MakeLine(points, Real(1.2)), 0);
  const auto counts = CountPixels(scene);
  int expected = 0;
  for (int y = -10; y <= 10; ++y)
  {
    for (int x = -20; x <= 20; ++x)
    {
      const double beyond = std::max(0.0, std::abs(x / 2.0) - 4.0);
      expected += beyond * beyond + y * y / 4.0 < 1.2 * 1.2;
    }
  }
  checks.Near("straight tube, pixels with one fragment", counts[1], expected, 0);
  checks.Near("straight tube, all other pixels are empty", counts[0] + counts[1], 41 * 21, 0);
  checks.Near("straight tube, distance of its ridge", Distance(CastPixel(scene, 20, 10).front()),
    6 - 1.2, tolerance);
  checks.Near("straight tube, distance of its flank", Distance(CastPixel(scene, 20, 12).front()),
    6 - std::sqrt(1.2 * 1.2 - 1), tolerance);
}

void TestBends(Checks& checks)
{
  // A zigzag with right angles in the plane of the image: no pixel sees two walls or none.
  auto scene = MakeScene<double>(200, 120, 10);
  scene.AddTube(
    MakeLine<double>({ { -6, -2, -6 }, { -2, 2, -6 }, { 2, -2, -6 }, { 6, 2, -6 } }, 0.7), 0);
  auto counts = CountPixels(scene);
  checks.True("zigzag is seen", counts[1] > 1000);
  checks.Near("zigzag, pixels with more than one fragment", counts[2] + counts[3], 0, 0);

  // The same with segments of unequal length: their cross-sections meet in the bisector planes, so
  // that the mantle is covered where the balls of the line are.
  auto unequal = MakeScene<double>(200, 120, 10);
  unequal.AddTube(
    MakeLine<double>({ { -7, -4, -6 }, { -2, 1, -6 }, { -1, 0, -6 }, { 4, 5, -6 } }, 0.6), 0);
  auto balls = MakeScene<double>(200, 120, 10);
  for (const auto& piece : unequal.tubePieces)
  {
    balls.AddTube({ unequal.tubePoints[piece.first], unequal.tubePoints[piece.last] }, 0);
  }
  counts = CountPixels(unequal);
  checks.Near("unequal lengths, pixels with more than one fragment", counts[2] + counts[3], 0, 0);
  checks.Near("unequal lengths, pixels with none", counts[0], CountPixels(balls)[0], 0);

  // The first, narrowing and widening. At the joints the mantles differ a little.
  auto varying = MakeScene<double>(200, 120, 10);
  auto line = MakeLine<double>({ { -6, -2, -6 }, { -2, 2, -6 }, { 2, -2, -6 }, { 6, 2, -6 } }, 0.7);
  line[1].radius = 0.4;
  line[2].radius = 0.9;
  varying.AddTube(line, 0);
  counts = CountPixels(varying);
  checks.True("varying radii, hardly a pixel with two fragments", counts[2] < counts[1] / 100);

  // Straight back: no plane at the joint, and the second half lies in the first.
  auto back = MakeScene<double>(200, 120, 10);
  back.AddTube(MakeLine<double>({ { -6, 0, -6 }, { 6, 0, -6 }, { -6, 0, -6 } }, 0.7), 0);
  checks.True("line that turns back is seen", CountPixels(back)[2] > 0);
}

/** The near plane, at z = -1, cuts a tube open that comes out of it towards the eye. */
void TestInside(Checks& checks)
{
  auto scene = MakeScene<double>(9, 9, 2);
  scene.AddTube(
    MakeLine<double>({ { 0, 0, 3 }, { 0, 0, -2 }, { 0, 0, -4 }, { 0, 0, -6 } }, 1.5), 0);
  const auto hit = CastPixel(scene, 4, 4);
  checks.Near("inside along the axis, fragments", hit.size(), 1, 0);
  checks.Near("inside along the axis, distance", Distance(hit.front()), 7.5, 1e-12);
  const auto side = CastPixel(scene, 6, 4);
  checks.Near("inside beside the axis, fragments", side.size(), 1, 0);
  checks.Near("inside beside the axis, distance", Distance(side.front()),
    6 + std::sqrt(1.5 * 1.5 - 1), 1e-12);
  checks.Near("inside, pixels with more than one fragment", CountPixels(scene)[2], 0, 0);

  // A bend: the ray leaves through the wall of a later segment.
  auto bend = MakeScene<double>(9, 9, 2);
  bend.AddTube(MakeLine<double>({ { 0, 0, 3 }, { 0, 0, -5 }, { 8, 0, -5 } }, 1.5), 0);
  const auto wall = CastPixel(bend, 6, 4);
  checks.Near("inside a bend, fragments", wall.size(), 1, 0);
  checks.Near("inside a bend, distance", Distance(wall.front()), 6.5, 1e-12);

  // A second tube is not affected by starting inside the first.
  bend.AddTube(MakeLine<double>({ { -4, 0, -4 }, { 4, 0, -4 } }, 0.5), 0);
  const auto both = CastPixel(bend, 6, 4);
  checks.Near("a tube within a tube, fragments", both.size(), 2, 0);
  checks.Near("a tube within a tube, its front", Distance(both.front()), 3.5, 1e-12);
}

/** Is a point in a piece of one of the tubes? Searches the balls of each piece. */
bool IsInside(const Scene<double>& scene, const Vec<double>& point)
{
  return std::any_of(scene.tubePieces.begin(), scene.tubePieces.end(),
    [&](const auto& piece)
    {
      const auto& first = scene.tubePoints[piece.first];
      const auto& last = scene.tubePoints[piece.last];
      bool inBall = false;
      for (int i = 0; i <= 200 && !inBall && piece.Owns(point); ++i)
      {
        const double s = i / 200.0;
        inBall = glm::distance(point, glm::mix(first.position, last.position, s)) <=
          glm::mix(first.radius, last.radius, s);
      }
      return inBall;
    });
}

/** Random bent tubes that a clipping plane cuts open: where a march along the ray that starts
 * inside comes out of the tube, the inner wall is seen, behind any other wall. */
void TestRandomCuts(Checks& checks)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  constexpr double step = 0.01;
  int starts = 0;
  for (int run = 0; run < 40; ++run)
  {
    auto scene = MakeScene<double>(16, 16, 2);
    scene.surfaces.front().clipping.push_back(
      { Vec<double>(0, 0, -5), glm::normalize(Vec<double>(uniform(generator), 0.3, -1)) });
    std::vector<Vec<double>> points{ { -4, 0, -5.5 } };
    for (int i = 0; i < 5; ++i)
    {
      points.push_back(points.back() +
        (1.8 + 0.8 * uniform(generator)) *
          glm::normalize(Vec<double>(1, 0.7 * uniform(generator), 0.7 * uniform(generator))));
    }
    scene.AddTube(MakeLine(points, 0.8), 0);
    for (int pixel = 0; pixel < 16; ++pixel)
    {
      const auto& plane = scene.surfaces.front().clipping.front();
      const auto ray = scene.view.PixelRay(pixel, 8);
      double distance = -plane.Height(ray.origin) / glm::dot(plane.normal, ray.direction);
      if (!IsInside(scene, ray.At(distance)))
      {
        continue;
      }
      ++starts;
      while (IsInside(scene, ray.At(distance)))
      {
        distance += step;
      }
      const auto fragments = CastPixel(scene, pixel, 8);
      const bool found = std::any_of(fragments.begin(), fragments.end(),
        [&](const auto& fragment)
        { return std::abs(Distance(fragment) - 1 - distance) < 1.1 * step; });
      checks.True("inner wall of a bent tube at " + std::to_string(distance), found);
    }
  }
  checks.True("enough rays start inside", starts > 100);
}

void TestClipping(Checks& checks)
{
  auto scene = MakeScene<double>(41, 21, 2);
  scene.surfaces.front().clipping.push_back({ Vec<double>(0, 0, -6), Vec<double>(0, 0, -1) });
  scene.AddTube(
    MakeLine<double>({ { -4, 0, -6 }, { -1, 0, -6 }, { 1, 0, -6 }, { 4, 0, -6 } }, 1.5), 0);
  const auto hit = CastPixel(scene, 20, 10);
  checks.Near("cut open, fragments", hit.size(), 1, 0);
  checks.Near("cut open, distance of the far wall", Distance(hit.front()), 7.5, 1e-12);

  scene.surfaces.front().clipping.push_back({ Vec<double>(2, 0, 0), Vec<double>(1, 0, 0) });
  checks.True("clipped away", CastPixel(scene, 20, 10).empty());
  checks.Near("kept beyond the plane", CastPixel(scene, 25, 10).size(), 1, 0);
}

void TestDamage(Checks& checks)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto scene = MakeScene<double>(41, 21, 2);
  auto line = MakeLine<double>({ { -8, 0, -6 }, { -6, 0, -6 }, { -6, 0, -6 }, { -4, 0, -6 },
                                 { 0, nan, -6 }, { 4, 0, -6 }, { 8, 0, -6 } },
    1.0);
  checks.Near("points that are not finite", scene.AddTube(line, 0), 1, 0);
  checks.Near("segments that are left", scene.tubePieces.size(), 3, 0);
  checks.True("nothing where the line is broken", CastPixel(scene, 20, 10).empty());
  checks.Near("a cap at the break", CastPixel(scene, 13, 10).size(), 1, 0);
  checks.Near("one fragment at coincident points", CastPixel(scene, 8, 10).size(), 1, 0);

  auto balls = MakeScene<double>(41, 21, 2);
  balls.AddTube(MakeLine<double>({ { 0, 0, -6 } }, 1.0), 0);
  balls.AddTube(MakeLine<double>({ { 5, 0, -6 }, { 5, 0, -6 } }, 1.0), 0);
  balls.AddTube(MakeLine<double>({ { -5, 0, -6 }, { -4, 0, -6 } }, 0.0), 0);
  balls.AddTube(MakeLine<double>({ { -5, 0, -6 } }, -1.0), 0);
  balls.AddTube({}, 0);
  checks.Near("one point is a ball", CastPixel(balls, 20, 10).size(), 1, 0);
  checks.Near("coincident points are a ball", CastPixel(balls, 30, 10).size(), 1, 0);
  checks.True("no radius, nothing drawn", CastPixel(balls, 10, 10).empty());
  checks.Near("pieces", balls.tubePieces.size(), 2, 0);
}

/** An interpolated colour follows the ball that touches the surface, not the foot of the hit. */
void TestColor(Checks& checks)
{
  auto scene = MakeScene<double>(1, 1, 1);
  scene.surfaces.front().colorSource = pellucid::ColorSource::Vertices;
  // Radii 1 and 0.4 at distance 1: sine 3/5. The ball at s = 1/4 has radius 0.85 and touches at
  // x = 0.25 + 0.85 * 3/5.
  const double foot = 0.25 + 0.85 * 0.6;
  scene.AddTube({ { Vec<double>(-foot, 0, -6), 1.0, { 0, 0, 0, 1 } },
                  { Vec<double>(1 - foot, 0, -6), 0.4, { 1, 1, 1, 1 } } },
    0);
  const auto hit = CastPixel(scene, 0, 0);
  checks.Near("colour of the touching ball", hit.front().color.r, 0.25, 1e-12);
  checks.Near("distance of the mantle", Distance(hit.front()), 6 - 0.85 * 0.8, 1e-12);
}
}

int TestReferenceTubes(int, char*[])
{
  Checks checks;
  TestStraight<double>(checks, 1e-12);
  TestStraight<float>(checks, 1e-4f);
  TestBends(checks);
  TestInside(checks);
  TestRandomCuts(checks);
  TestClipping(checks);
  TestDamage(checks);
  TestColor(checks);
  return checks.Result();
}
