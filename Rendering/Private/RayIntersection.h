// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    RayIntersection.h
 * @brief   Where a view ray meets balls, rounded cones, half-spaces and triangles, in closed form.
 *
 * Everything here is a template on the scalar type and knows neither VTK nor OpenGL. Lengths are in
 * any one unit, directions are unit vectors, and ray parameters are therefore lengths too.
 *
 * A rounded cone is the volume that a ball sweeps while its centre moves along a segment and its
 * radius changes linearly (Gross and Gumhold 2021, section 5: "sphere-swept segment"). It is the
 * convex hull of its two end balls, so that a ray meets it in one interval, or not at all; when one
 * end ball contains the other, it is that ball.
 */

#ifndef RayIntersection_h
#define RayIntersection_h

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace pellucid
{
template <typename Real>
using Vector3 = glm::vec<3, Real, glm::defaultp>;
template <typename Real>
using Vector4 = glm::vec<4, Real, glm::defaultp>;

/** The part begin <= t <= end of the line origin + t * direction. */
template <typename Real>
struct Ray
{
  Vector3<Real> origin{ Real(0) };
  Vector3<Real> direction{ Real(0), Real(0), Real(-1) };
  Real begin = 0;
  Real end = std::numeric_limits<Real>::infinity();

  Vector3<Real> At(Real t) const { return this->origin + t * this->direction; }
  bool Contains(Real t) const { return t >= this->begin && t <= this->end; }
};

/** A range of ray parameters; empty unless begin < end. */
template <typename Real>
struct Interval
{
  Real begin = std::numeric_limits<Real>::infinity();
  Real end = -std::numeric_limits<Real>::infinity();

  bool IsEmpty() const { return !(this->begin < this->end); }
};

/** The points p with dot(normal, p - point) >= 0; a zero normal stands for all of space. */
template <typename Real>
struct HalfSpace
{
  Vector3<Real> point{ Real(0) };
  Vector3<Real> normal{ Real(0) };

  Real Height(const Vector3<Real>& p) const { return glm::dot(this->normal, p - this->point); }
};

/** Keep the part of `interval` that lies in the half-space. */
template <typename Real>
void Clip(Interval<Real>& interval, const Ray<Real>& ray, const HalfSpace<Real>& space)
{
  const Real height = space.Height(ray.origin);
  const Real slope = glm::dot(space.normal, ray.direction);
  if (slope > 0)
  {
    interval.begin = std::max(interval.begin, -height / slope);
  }
  else if (slope < 0)
  {
    interval.end = std::min(interval.end, -height / slope);
  }
  else if (height < 0)
  {
    interval = Interval<Real>();
  }
}

/** The ball of radius `radius[i]` at `center[i]` is the end i; radii are not negative. */
template <typename Real>
struct RoundedCone
{
  std::array<Vector3<Real>, 2> center{};
  std::array<Real, 2> radius{};

  /** Whether one end contains the other. */
  bool IsOneBall() const
  {
    return std::abs(this->radius[0] - this->radius[1]) >=
      glm::length(this->center[1] - this->center[0]);
  }
};

/**
 * A point where a ray crosses the surface of a rounded cone: the ray parameter, and the position
 * along the axis, in [0,1], of the ball that touches the surface there. Radius and attributes of
 * the point are those of the two ends, interpolated with `axis`.
 */
template <typename Real>
struct ConeHit
{
  Real t;
  Real axis;
};

/** Entry and exit of the whole line of a ray; entry.t <= exit.t, and either may be negative. */
template <typename Real>
struct ConeCrossing
{
  ConeHit<Real> entry;
  ConeHit<Real> exit;
};

/**
 * Where the line of a ray is inside a ball. The half chord comes from the distance of the line to
 * the centre, not from the difference of squared distances along the ray, so that it stays accurate
 * however far away the ray begins. Touching lines miss.
 */
template <typename Real>
Interval<Real> IntersectSphere(const Ray<Real>& ray, const Vector3<Real>& center, Real radius)
{
  const Vector3<Real> toCenter = center - ray.origin;
  const Real middle = glm::dot(toCenter, ray.direction);
  const Vector3<Real> offset = toCenter - middle * ray.direction;
  const Real squaredHalfChord = radius * radius - glm::dot(offset, offset);
  if (!(squaredHalfChord > 0))
  {
    return {};
  }
  const Real halfChord = std::sqrt(squaredHalfChord);
  return { middle - halfChord, middle + halfChord };
}

/**
 * Real roots of a t^2 + 2 b t + c = 0, in any order, without cancellation; a missing root is NaN.
 * When a is 0, as for a ray parallel to the mantle of a cone, the one finite root is returned.
 */
template <typename Real>
std::array<Real, 2> SolveQuadratic(Real a, Real b, Real c)
{
  constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
  const Real discriminant = b * b - a * c;
  if (!(discriminant >= 0))
  {
    return { none, none };
  }
  const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
  return { a != 0 ? q / a : none, q != 0 ? c / q : none };
}

/**
 * Where the line of a ray is inside a rounded cone, or nothing. The crossing is found on the two
 * end balls and on the part of the tangent cone between the circles in which it touches them; since
 * the volume is convex, the entry is the first of these points and the exit the last.
 */
template <typename Real>
std::optional<ConeCrossing<Real>> IntersectRoundedCone(
  const Ray<Real>& ray, const RoundedCone<Real>& cone)
{
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  ConeCrossing<Real> crossing{ { infinity, 0 }, { -infinity, 0 } };
  const auto add = [&crossing](Real t, Real axis)
  {
    if (t < crossing.entry.t)
    {
      crossing.entry = { t, axis };
    }
    if (t > crossing.exit.t)
    {
      crossing.exit = { t, axis };
    }
  };

  const Vector3<Real> axis = cone.center[1] - cone.center[0];
  const Real length = glm::length(axis);
  const Real narrowing = cone.radius[0] - cone.radius[1];
  const bool oneBall = cone.IsOneBall();
  for (int end = 0; end < 2; ++end)
  {
    if (oneBall && end != (narrowing < 0 ? 1 : 0))
    {
      continue;
    }
    const auto chord = IntersectSphere(ray, cone.center[end], cone.radius[end]);
    if (!chord.IsEmpty())
    {
      add(chord.begin, static_cast<Real>(end));
      add(chord.end, static_cast<Real>(end));
    }
  }

  if (!oneBall)
  {
    // Points of the tangent cone are those at height y along the axis and distance rho from it with
    // cosine * rho + sine * y = radius[0]. Ray parameters are counted from the point of the ray
    // next to the middle of the axis.
    const Real sine = narrowing / length;
    const Real squaredCosine = (1 - sine) * (1 + sine);
    const Vector3<Real> unit = axis / length;
    const Real shift = glm::dot(cone.center[0] + Real(0.5) * axis - ray.origin, ray.direction);
    const Vector3<Real> start = ray.At(shift) - cone.center[0];
    const Real height = glm::dot(start, unit);
    const Real climb = glm::dot(ray.direction, unit);
    const Vector3<Real> across = start - height * unit;
    const Vector3<Real> drift = ray.direction - climb * unit;
    const Real tangentRadius = cone.radius[0] - sine * height;

    const auto roots =
      SolveQuadratic<Real>(squaredCosine * glm::dot(drift, drift) - sine * sine * climb * climb,
        squaredCosine * glm::dot(across, drift) + sine * climb * tangentRadius,
        squaredCosine * glm::dot(across, across) - tangentRadius * tangentRadius);
    for (const Real root : roots)
    {
      const Real y = height + root * climb;
      const Real position = (y - cone.radius[0] * sine) / (length * squaredCosine);
      if (position >= 0 && position <= 1)
      {
        add(root + shift, position);
      }
    }
  }
  if (!(crossing.entry.t <= crossing.exit.t))
  {
    return std::nullopt;
  }
  return crossing;
}

/** The outward unit normal at a point of the surface; `axis` is that of the hit. */
template <typename Real>
Vector3<Real> RoundedConeNormal(
  const RoundedCone<Real>& cone, const Vector3<Real>& point, Real axis)
{
  const Vector3<Real> center = glm::mix(cone.center[0], cone.center[1], axis);
  return glm::normalize(point - center);
}

/** Barycentric coordinates of a hit, adding up to 1, and the side of the triangle that is seen. */
template <typename Real>
struct TriangleHit
{
  Vector3<Real> weights;
  bool frontFacing;
};

/** Where a pixel lies relative to a directed edge: `value` is proportional to the distance, `side`
 * is 1 on the left, -1 on the right, and 0 only for an edge of no length. */
template <typename Real>
struct EdgeSide
{
  Real value;
  int side;
};

/**
 * The side of the edge from `a` to `b`, given as the x, y, w of clip coordinates, on which a pixel
 * (x, y, 1) of normalised device coordinates lies (Olano and Greer 1997, "Triangle scan conversion
 * using 2D homogeneous coordinates"). A pixel exactly on the edge is decided as if it lay an
 * infinitesimal step to the right, and a still smaller one upwards. Both results for the edge from
 * `b` to `a` are the exact negatives, since they are computed from the same order of the ends.
 */
template <typename Real>
EdgeSide<Real> LocateAtEdge(
  const Vector3<Real>& a, const Vector3<Real>& b, const Vector3<Real>& pixel)
{
  const bool swapped = a.x != b.x ? b.x < a.x : (a.y != b.y ? b.y < a.y : b.z < a.z);
  const Vector3<Real> line = swapped ? glm::cross(b, a) : glm::cross(a, b);
  const int sign = swapped ? -1 : 1;
  const Real value = glm::dot(line, pixel);
  const Real decisive = value != 0 ? value : (line.x != 0 ? line.x : line.y);
  return { sign * value, sign * ((decisive > 0) - (decisive < 0)) };
}

/**
 * The point of a triangle that the ray of a pixel at (x, y) of normalised device coordinates meets,
 * with perspective-correct weights. The corners are the x, y, w of clip coordinates; corners behind
 * the eye are allowed. Of the triangles of a mesh that share an edge or a corner exactly on the
 * pixel, one owns it (see LocateAtEdge), so that crossing the mesh once gives one hit. Triangles
 * seen edge-on are missed.
 */
template <typename Real>
std::optional<TriangleHit<Real>> IntersectTriangle(
  const std::array<Vector3<Real>, 3>& corners, Real x, Real y)
{
  const Vector3<Real> pixel(x, y, 1);
  Vector3<Real> weights;
  int sides = 0;
  for (int i = 0; i < 3; ++i)
  {
    const auto edge = LocateAtEdge(corners[(i + 1) % 3], corners[(i + 2) % 3], pixel);
    weights[i] = edge.value;
    sides += edge.side;
  }
  const Real area = glm::dot(corners[0], glm::cross(corners[1], corners[2]));
  const Real sum = weights.x + weights.y + weights.z;
  if (!(area * sides > 0) || std::abs(sides) != 3 || sum == 0)
  {
    return std::nullopt;
  }
  return TriangleHit<Real>{ weights / sum, area > 0 };
}
}

#endif
