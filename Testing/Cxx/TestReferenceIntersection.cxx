// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Ray intersections against closed forms: balls, cylinders, mantle points of cones, balls inside
 * balls, rays along axis and mantle and from inside, volume and silhouette area of a capsule, and
 * the ownership of edges and corners of triangles; in double and in single precision.
 */

#include "RayIntersection.h"
#include "ReferenceTesting.h"

#include <random>

namespace
{
template <typename Real>
using Vec = pellucid::Vector3<Real>;

template <typename Real>
pellucid::Ray<Real> MakeRay(const Vec<Real>& origin, const Vec<Real>& direction)
{
  pellucid::Ray<Real> ray;
  ray.origin = origin;
  ray.direction = glm::normalize(direction);
  return ray;
}

template <typename Real>
void TestSphere(Checks& checks, Real tolerance)
{
  const Vec<Real> center(1, 2, -10);
  const auto through =
    pellucid::IntersectSphere(MakeRay<Real>({ 1, 2, 0 }, { 0, 0, -1 }), center, Real(2));
  checks.Near("ball, central entry", through.begin, 8, tolerance);
  checks.Near("ball, central exit", through.end, 12, tolerance);

  // A chord at distance h has half length sqrt(r^2 - h^2).
  const auto chord =
    pellucid::IntersectSphere(MakeRay<Real>({ Real(2.2), 2, 0 }, { 0, 0, -1 }), center, Real(2));
  checks.Near("ball, chord entry", chord.begin, 10 - 1.6, tolerance);
  checks.Near("ball, chord exit", chord.end, 10 + 1.6, tolerance);

  const auto inside =
    pellucid::IntersectSphere(MakeRay<Real>(center, { 1, 1, 1 }), center, Real(2));
  checks.Near("ball, from its centre", inside.begin, -2, tolerance);
  checks.Near("ball, from its centre", inside.end, 2, tolerance);

  checks.True("ball, missed",
    pellucid::IntersectSphere(MakeRay<Real>({ Real(3.1), 2, 0 }, { 0, 0, -1 }), center, Real(2))
      .IsEmpty());
  checks.True("ball of radius 0",
    pellucid::IntersectSphere(MakeRay<Real>({ 1, 2, 0 }, { 0, 0, -1 }), center, Real(0)).IsEmpty());
}

template <typename Real>
void TestCylinder(Checks& checks, Real tolerance)
{
  // Equal radii: a cylinder of radius 1 about the x axis, from -2 to 2, with round ends.
  const pellucid::RoundedCone<Real> capsule{ { Vec<Real>(-2, 0, 0), Vec<Real>(2, 0, 0) },
    { Real(1), Real(1) } };
  const auto side =
    pellucid::IntersectRoundedCone(MakeRay<Real>({ 1, Real(0.6), 5 }, { 0, 0, -1 }), capsule);
  checks.True("cylinder is hit", side.has_value());
  checks.Near("cylinder, entry", side->entry.t, 5 - 0.8, tolerance);
  checks.Near("cylinder, exit", side->exit.t, 5 + 0.8, tolerance);
  checks.Near("cylinder, axis", side->entry.axis, 0.75, tolerance);
  const auto normal =
    pellucid::RoundedConeNormal(capsule, Vec<Real>(1, Real(0.6), Real(0.8)), side->entry.axis);
  checks.Near("cylinder, normal x", normal.x, 0, tolerance);
  checks.Near("cylinder, normal y", normal.y, 0.6, tolerance);
  checks.Near("cylinder, normal z", normal.z, 0.8, tolerance);

  const auto along =
    pellucid::IntersectRoundedCone(MakeRay<Real>({ -9, 0, 0 }, { 1, 0, 0 }), capsule);
  checks.Near("along the axis, entry", along->entry.t, 6, tolerance);
  checks.Near("along the axis, exit", along->exit.t, 12, tolerance);
  checks.Near("along the axis, entry at the first end", along->entry.axis, 0, tolerance);
  checks.Near("along the axis, exit at the last end", along->exit.axis, 1, tolerance);

  const auto parallel =
    pellucid::IntersectRoundedCone(MakeRay<Real>({ -9, Real(0.6), 0 }, { 1, 0, 0 }), capsule);
  checks.Near("parallel to the axis, entry", parallel->entry.t, 9 - 2.8, tolerance);
  checks.Near("parallel to the axis, exit", parallel->exit.t, 9 + 2.8, tolerance);

  const auto inside =
    pellucid::IntersectRoundedCone(MakeRay<Real>({ 0, 0, 0 }, { 0, 1, 0 }), capsule);
  checks.Near("from inside, entry behind", inside->entry.t, -1, tolerance);
  checks.Near("from inside, exit", inside->exit.t, 1, tolerance);

  checks.True("cylinder, missed",
    !pellucid::IntersectRoundedCone(MakeRay<Real>({ 0, Real(1.01), 5 }, { 0, 0, -1 }), capsule));
}

template <typename Real>
void TestCone(Checks& checks, Real tolerance)
{
  // Radii 5 and 2 at distance 5: sine 3/5, cosine 4/5. The mantle touches the ball at x = 5 s,
  // whose radius is 5 - 3 s, at the height 4/5 of that radius and 3/5 of it further along x.
  for (const bool reversed : { false, true })
  {
    const Vec<Real> a(0, 0, 0);
    const Vec<Real> b(5, 0, 0);
    const auto cone = reversed ? pellucid::RoundedCone<Real>{ { b, a }, { Real(2), Real(5) } }
                               : pellucid::RoundedCone<Real>{ { a, b }, { Real(5), Real(2) } };
    const std::string name = reversed ? "widening cone" : "narrowing cone";
    for (const double s : { 0.0, 0.25, 0.5, 1.0 })
    {
      const double radius = 5 - 3 * s;
      const double x = 5 * s + 0.6 * radius;
      const double height = 0.8 * radius;
      const auto hit = pellucid::IntersectRoundedCone(
        MakeRay<Real>({ static_cast<Real>(x), 0, 20 }, { 0, 0, -1 }), cone);
      checks.True(name + " is hit", hit.has_value());
      checks.Near(name + ", mantle", hit->entry.t, 20 - height, tolerance);
      checks.Near(name + ", opposite mantle", hit->exit.t, 20 + height, tolerance);
      checks.Near(name + ", axis", hit->entry.axis, reversed ? 1 - s : s, tolerance);
      const auto normal = pellucid::RoundedConeNormal(
        cone, Vec<Real>(static_cast<Real>(x), 0, static_cast<Real>(height)), hit->entry.axis);
      checks.Near(name + ", normal along the axis", normal.x, 0.6, tolerance);
      checks.Near(name + ", normal across", normal.z, 0.8, tolerance);
    }

    // The mantle in the plane y = 0 falls by 3 on 4; along it the quadratic term vanishes.
    const Vec<Real> touching(3, 0, 4);
    const Vec<Real> slope(Real(0.8), 0, Real(-0.6));
    const Vec<Real> inwards(Real(-0.6), 0, Real(-0.8));
    const auto parallel =
      pellucid::IntersectRoundedCone(MakeRay<Real>(touching + inwards, slope), cone);
    checks.Near(name + ", parallel to the mantle, entry", parallel->entry.t, -3, tolerance);
    checks.Near(
      name + ", parallel to the mantle, exit", parallel->exit.t, 4 + std::sqrt(3.0), tolerance);
  }

  const pellucid::RoundedCone<Real> swallowed{ { Vec<Real>(0, 0, 0), Vec<Real>(1, 0, 0) },
    { Real(3), Real(1) } };
  const auto ball =
    pellucid::IntersectRoundedCone(MakeRay<Real>({ 0, 0, 9 }, { 0, 0, -1 }), swallowed);
  checks.Near("ball within a ball, entry", ball->entry.t, 6, tolerance);
  checks.Near("ball within a ball, exit", ball->exit.t, 12, tolerance);
  checks.Near("ball within a ball, axis", ball->entry.axis, 0, tolerance);

  const pellucid::RoundedCone<Real> tip{ { Vec<Real>(0, 0, 0), Vec<Real>(0, 0, 5) },
    { Real(3), Real(0) } };
  const auto atTip = pellucid::IntersectRoundedCone(MakeRay<Real>({ 0, 0, 9 }, { 0, 0, -1 }), tip);
  checks.Near("tip of a cone, exit at the wide end", atTip->exit.t, 12, tolerance);
}

/** Volume by chord lengths, and area of the silhouette by hits, on a regular grid of rays. */
void TestCapsuleMeasures(Checks& checks)
{
  constexpr double pi = 3.14159265358979323846;
  const double radius = 0.7;
  const double length = 2.0;
  const pellucid::RoundedCone<double> capsule{ { Vec<double>(-1, 0, 0), Vec<double>(1, 0, 0) },
    { radius, radius } };
  constexpr int n = 600;
  const double width = 4.0;
  const double cell = (width / n) * (width / n);
  double volume = 0.0;
  double area = 0.0;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      const auto ray = MakeRay<double>(
        { ((i + 0.5) / n - 0.5) * width, ((j + 0.5) / n - 0.5) * width, 10 }, { 0, 0, -1 });
      if (const auto hit = pellucid::IntersectRoundedCone(ray, capsule))
      {
        volume += cell * (hit->exit.t - hit->entry.t);
        area += cell;
      }
    }
  }
  const double exactVolume = pi * radius * radius * (length + 4.0 / 3.0 * radius);
  const double exactArea = 2 * radius * length + pi * radius * radius;
  checks.Near("capsule, relative volume", volume / exactVolume, 1, 1e-4);
  checks.Near("capsule, relative area", area / exactArea, 1, 1e-3);
}

/** A hit lies on the surface: its distance to the swept balls, minimised by sampling, is 0. */
void TestRandomCones(Checks& checks)
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&]
  { return Vec<double>(uniform(generator), uniform(generator), uniform(generator)); };
  int hits = 0;
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const pellucid::RoundedCone<double> cone{ { vector(), vector() },
      { std::abs(uniform(generator)), std::abs(uniform(generator)) } };
    const Vec<double> eye = 1000.0 * vector();
    const auto ray = MakeRay<double>(eye, vector() - eye);
    const auto hit = pellucid::IntersectRoundedCone(ray, cone);
    if (!hit)
    {
      continue;
    }
    ++hits;
    for (const auto& end : { hit->entry, hit->exit })
    {
      double distance = 1e300;
      for (int k = 0; k <= 4000; ++k)
      {
        const double s = k / 4000.0;
        distance = std::min(distance,
          glm::distance(ray.At(end.t), glm::mix(cone.center[0], cone.center[1], s)) -
            glm::mix(cone.radius[0], cone.radius[1], s));
      }
      worst = std::max(worst, std::abs(distance));
    }
  }
  checks.True("random cones: enough hits", hits > 500);
  checks.Near("random cones: distance of hits to the surface", worst, 0, 1e-6);
}

void TestTriangle(Checks& checks)
{
  const std::array<Vec<double>, 3> flat{ Vec<double>(0, 0, 1), Vec<double>(1, 0, 1),
    Vec<double>(0, 1, 1) };
  const auto hit = pellucid::IntersectTriangle(flat, 0.25, 0.5);
  checks.True("triangle is hit", hit.has_value());
  checks.True("counterclockwise is the front", hit->frontFacing);
  checks.Near("weight of the first corner", hit->weights.x, 0.25, 1e-15);
  checks.Near("weight of the second corner", hit->weights.y, 0.25, 1e-15);
  checks.Near("weight of the third corner", hit->weights.z, 0.5, 1e-15);
  const auto back = pellucid::IntersectTriangle<double>({ flat[0], flat[2], flat[1] }, 0.25, 0.5);
  checks.True("clockwise is the back", back && !back->frontFacing);
  checks.True("triangle, missed", !pellucid::IntersectTriangle(flat, 0.6, 0.5));

  // An edge from w = 1 to w = 3: its middle on the screen is at 3/4 of the weight of the near end.
  const auto perspective = pellucid::IntersectTriangle<double>(
    { Vec<double>(0, 0, 1), Vec<double>(3, 0, 3), Vec<double>(0, 1, 1) }, 0.5, 1e-12);
  checks.Near("perspective-correct weight", perspective->weights.x, 0.75, 1e-9);

  // The third corner is behind the eye, so that the triangle reaches down to infinity.
  const std::array<Vec<double>, 3> open{ Vec<double>(-1, -1, 1), Vec<double>(1, -1, 1),
    Vec<double>(0, -3, -1) };
  checks.True(
    "a corner behind the eye, above", !pellucid::IntersectTriangle<double>(open, 0.0, 5.0));
  checks.True("a corner behind the eye, below",
    pellucid::IntersectTriangle<double>(open, 0.0, -5.0).has_value());
}

/** Every pixel of a grid is owned once by a mesh whose edges and corners lie on pixels. */
void TestSharedEdges(Checks& checks)
{
  constexpr int n = 4;
  std::mt19937 generator(11);
  for (const bool flipped : { false, true })
  {
    for (int y = 1; y < 4 * n; ++y)
    {
      for (int x = 1; x < 4 * n; ++x)
      {
        int hits = 0;
        for (int j = 0; j < n; ++j)
        {
          for (int i = 0; i < n; ++i)
          {
            const auto corner = [&](int dx, int dy)
            {
              const double w = 1 + (i + dx) + 2 * (j + dy);
              return Vec<double>(4 * w * (i + dx), 4 * w * (j + dy), w);
            };
            std::array<Vec<double>, 3> lower{ corner(0, 0), corner(1, 0), corner(1, 1) };
            std::array<Vec<double>, 3> upper{ corner(0, 0), corner(1, 1), corner(0, 1) };
            if (flipped)
            {
              std::swap(upper[1], upper[2]);
            }
            std::shuffle(lower.begin(), lower.end(), generator);
            hits += pellucid::IntersectTriangle<double>(lower, x, y).has_value();
            hits += pellucid::IntersectTriangle<double>(upper, x, y).has_value();
          }
        }
        checks.True("pixel " + std::to_string(x) + ", " + std::to_string(y) + " is owned " +
            std::to_string(hits) + " times",
          hits == 1);
      }
    }
  }
}
}

int TestReferenceIntersection(int, char*[])
{
  Checks checks;
  TestSphere<double>(checks, 1e-13);
  TestSphere<float>(checks, 1e-5f);
  TestCylinder<double>(checks, 1e-13);
  TestCylinder<float>(checks, 1e-5f);
  TestCone<double>(checks, 1e-12);
  TestCone<float>(checks, 5e-5f);
  TestCapsuleMeasures(checks);
  TestRandomCones(checks);
  TestTriangle(checks);
  TestSharedEdges(checks);
  return checks.Result();
}
