// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of vtkTrajectoryMapper compare with: the first hit of a ray with the lines and
 * vertices of a vtkPolyData, in double precision and by search along the axis instead of formulas.
 *
 * A rounded cone is the union of the balls (c(u), r(u)), 0 <= u <= 1. The depth at which a ray
 * dives into a ball, r(u) - distance(ray, c(u)), is concave in u: a golden-section search tells
 * whether and where the ray meets the cone. Within that interval the entry is the least entry of
 * all balls.
 */

#ifndef TrajectoryReference_h
#define TrajectoryReference_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <vector>

namespace TrajectoryReference
{
using Vector = std::array<double, 3>;

inline Vector Combine(const Vector& a, double factor, const Vector& b)
{
  return { { a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2] } };
}

inline double Dot(const Vector& a, const Vector& b)
{
  return vtkMath::Dot(a.data(), b.data());
}

inline double Length(const Vector& a)
{
  return std::sqrt(Dot(a, a));
}

// A point (w 1) or a direction (w 0) by a matrix.
inline Vector Transform(vtkMatrix4x4* matrix, const Vector& v, double w)
{
  double p[4] = { v[0], v[1], v[2], w };
  matrix->MultiplyPoint(p, p);
  const double scale = w == 0.0 ? 1.0 : 1.0 / p[3];
  return { { scale * p[0], scale * p[1], scale * p[2] } };
}

// Unit length; 0 for a vector of length 0.
inline Vector Normalize(const Vector& a)
{
  const double length = Length(a);
  return Combine({ { 0, 0, 0 } }, length > 0.0 ? 1.0 / length : 0.0, a);
}

// Normal of the plane that halves the angle at a joint; 0 where the line turns straight back.
inline Vector Bisector(const Vector& from, const Vector& joint, const Vector& to)
{
  const Vector before = Normalize(Combine(joint, -1.0, from));
  const Vector after = Normalize(Combine(to, -1.0, joint));
  const Vector sum = Combine(before, 1.0, after);
  return Length(sum) > 1e-6 ? Normalize(sum) : Vector{ { 0, 0, 0 } };
}

struct Segment
{
  Vector Ends[2];
  double Radii[2];
  Vector Normals[2]; // of the joint planes, outward; 0: none
  int Line;
};

struct Ray
{
  Vector Start;     // on the near plane
  Vector Direction; // unit length
};

struct Hit
{
  double Distance = std::numeric_limits<double>::infinity();
  double Slack = 0.0;    // how far the distance may move when the ray is off by 1 % of the radius
  bool Doubtful = false; // within rounding of an outline, a joint or a clipping plane
};

// The point of a unimodal function on [a, b] where it is least.
inline double Minimize(const std::function<double(double)>& f, double a, double b)
{
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double x1 = b - golden * (b - a);
  double x2 = a + golden * (b - a);
  double f1 = f(x1);
  double f2 = f(x2);
  for (int i = 0; i < 60; ++i)
  {
    if (f1 < f2)
    {
      b = x2;
      x2 = x1;
      f2 = f1;
      x1 = b - golden * (b - a);
      f1 = f(x1);
    }
    else
    {
      a = x1;
      x1 = x2;
      f1 = f2;
      x2 = a + golden * (b - a);
      f2 = f(x2);
    }
  }
  const double middle = 0.5 * (a + b);
  const double least = std::min({ f(0.0), f(1.0), f(middle) });
  return least == f(middle) ? middle : least == f(0.0) ? 0.0 : 1.0;
}

class Cone
{
public:
  Cone(const Segment& segment, const Ray& ray)
    : S(segment)
    , R(ray)
  {
    this->Deepest = Minimize([this](double u) { return -this->Depth(u); }, 0.0, 1.0);
    this->Margin = this->Depth(this->Deepest) / this->Radius(this->Deepest);
  }

  Vector Center(double u) const
  {
    return Combine(Combine({ { 0, 0, 0 } }, 1.0 - u, this->S.Ends[0]), u, this->S.Ends[1]);
  }
  double Radius(double u) const { return (1.0 - u) * this->S.Radii[0] + u * this->S.Radii[1]; }

  double Depth(double u) const
  {
    const Vector way = Combine(this->Center(u), -1.0, this->R.Start);
    const double along = Dot(way, this->R.Direction);
    return this->Radius(u) - Length(Combine(way, -along, this->R.Direction));
  }

  // Where the ray enters (side -1) or leaves (+1), as distance from its start.
  double Cross(double side) const
  {
    const double low = this->Border(0.0);
    const double high = this->Border(1.0);
    const double u = Minimize(
      [&](double x) { return -side * this->CrossBall(side, low + x * (high - low)); }, 0.0, 1.0);
    return this->CrossBall(side, low + u * (high - low));
  }

  bool Contains(const Vector& point) const
  {
    const auto outside = [&](double u)
    { return Length(Combine(point, -1.0, this->Center(u))) - this->Radius(u); };
    return outside(Minimize(outside, 0.0, 1.0)) <= 0.0;
  }

  double Margin; // depth over radius; negative: the ray misses

private:
  double CrossBall(double side, double u) const
  {
    const Vector way = Combine(this->Center(u), -1.0, this->R.Start);
    const double along = Dot(way, this->R.Direction);
    const double off = Length(Combine(way, -along, this->R.Direction));
    const double r = this->Radius(u);
    return along + side * std::sqrt(std::max((r - off) * (r + off), 0.0));
  }

  // The last u on the way to `end` at which the ray still meets the ball.
  double Border(double end) const
  {
    double in = this->Deepest;
    double out = end;
    if (this->Depth(end) >= 0.0)
    {
      return end;
    }
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (in + out);
      (this->Depth(middle) >= 0.0 ? in : out) = middle;
    }
    return in;
  }

  const Segment& S;
  const Ray& R;
  double Deepest;
};

inline std::vector<Segment> GetSegments(
  vtkPolyData* data, double radius, vtkDataArray* radii, vtkMatrix4x4* toWorld)
{
  std::vector<Segment> segments;
  int line = 0;
  const auto add = [&](vtkIdList* ids)
  {
    std::vector<Vector> points;
    std::vector<double> sizes;
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      double p[4] = { 0, 0, 0, 1 };
      data->GetPoint(ids->GetId(i), p);
      toWorld->MultiplyPoint(p, p);
      const Vector point{ { p[0], p[1], p[2] } };
      if (points.empty() || point != points.back())
      {
        points.push_back(point);
        sizes.push_back(radii ? radii->GetTuple1(ids->GetId(i)) : radius);
      }
    }
    if (points.size() == 1)
    {
      points.push_back(points[0]);
      sizes.push_back(sizes[0]);
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      Segment s{ { points[i], points[i + 1] }, { sizes[i], sizes[i + 1] }, {}, line };
      s.Normals[0] =
        i > 0 ? Bisector(points[i + 1], points[i], points[i - 1]) : Vector{ { 0, 0, 0 } };
      s.Normals[1] = i + 2 < points.size() ? Bisector(points[i], points[i + 1], points[i + 2])
                                           : Vector{ { 0, 0, 0 } };
      segments.push_back(s);
    }
    ++line;
  };
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    add(ids);
  }
  return segments;
}

// `evaluatePlane` gives the distance of a point from a clipping plane, negative where it is cut.
inline Hit Cast(const std::vector<Segment>& segments, const Ray& ray, int planes,
  const std::function<double(const Vector&, int)>& evaluatePlane)
{
  double begin = 0.0;
  for (int k = 0; k < planes; ++k)
  {
    const double height = evaluatePlane(ray.Start, k);
    const double slope = evaluatePlane(Combine(ray.Start, 1.0, ray.Direction), k) - height;
    begin = slope > 0.0 ? std::max(begin, -height / slope) : begin;
  }
  const Vector start = Combine(ray.Start, begin, ray.Direction);
  std::vector<bool> startsInside;
  std::vector<double> exits;
  std::vector<Cone> cones;
  for (const Segment& s : segments)
  {
    cones.emplace_back(s, ray);
    startsInside.resize(s.Line + 1, false);
    exits.resize(s.Line + 1, std::numeric_limits<double>::infinity());
    startsInside[s.Line] = startsInside[s.Line] || cones.back().Contains(start);
  }
  Hit first;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    const Segment& s = segments[i];
    const Cone& cone = cones[i];
    const double radius = std::max(s.Radii[0], s.Radii[1]);
    const bool grazing = std::abs(cone.Margin) < 0.01;
    if (cone.Margin < 0.0)
    {
      first.Doubtful = first.Doubtful || grazing;
      continue;
    }
    bool doubtful = grazing;
    const auto isCut = [&](double t)
    {
      bool cut = t < 0.0;
      const Vector p = Combine(ray.Start, t, ray.Direction);
      for (int k = 0; k < planes; ++k)
      {
        const double value = evaluatePlane(p, k);
        doubtful = doubtful || std::abs(value) < 0.01 * radius;
        cut = cut || value < 0.0;
      }
      return cut;
    };
    const auto isBetween = [&](double t)
    {
      const Vector p = Combine(ray.Start, t, ray.Direction);
      const double a = Dot(s.Normals[0], Combine(p, -1.0, s.Ends[0]));
      const double b = Dot(s.Normals[1], Combine(p, -1.0, s.Ends[1]));
      doubtful = doubtful || (Length(s.Normals[0]) > 0.0 && std::abs(a) < 0.01 * radius) ||
        (Length(s.Normals[1]) > 0.0 && std::abs(b) < 0.01 * radius);
      return a <= 0.0 && (b < 0.0 || Length(s.Normals[1]) == 0.0);
    };
    const double entry = cone.Cross(-1.0);
    const double exit = cone.Cross(1.0);
    const bool cut = isCut(entry);
    double t = std::numeric_limits<double>::infinity();
    if (!cut && isBetween(entry))
    {
      t = entry;
    }
    else if ((cut || startsInside[s.Line]) && !isCut(exit) && isBetween(exit))
    {
      t = exit;
    }
    first.Doubtful = first.Doubtful || doubtful;
    if (t < first.Distance)
    {
      first.Distance = t;
      // a ray at depth m of a unit ball moves 1 / sqrt(2 m) along for each unit that it moves aside
      first.Slack = 0.01 * radius / std::sqrt(std::min(2.0 * std::max(cone.Margin, 0.01), 1.0));
    }
  }
  return first;
}

struct Comparison
{
  int Hits = 0;     // pixels that the reference covers
  int Wrong = 0;    // pixels that differ and are not doubtful
  int Doubtful = 0; // pixels not compared
};

// Compare the depth buffer of a rendered window with the reference, pixel by pixel.
inline Comparison Compare(vtkRenderWindow* window, vtkRenderer* renderer,
  std::vector<Segment> segments, double tolerance, vtkPlaneCollection* clips)
{
  const int* size = window->GetSize();
  vtkNew<vtkFloatArray> depths;
  window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths);
  // Rays in view coordinates: far from the origin the matrix from clip to world coordinates is not
  // accurate enough. Segments come to them by the rigid view transformation.
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkMatrix4x4* toView = camera->GetViewTransformMatrix();
  vtkMatrix4x4* toClip =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  vtkNew<vtkMatrix4x4> fromClip;
  vtkMatrix4x4::Invert(toClip, fromClip);
  vtkNew<vtkMatrix4x4> fromView;
  vtkMatrix4x4::Invert(toView, fromView);
  for (Segment& segment : segments)
  {
    for (int end = 0; end < 2; ++end)
    {
      segment.Ends[end] = Transform(toView, segment.Ends[end], 1.0);
      segment.Normals[end] = Transform(toView, segment.Normals[end], 0.0);
    }
  }
  const auto unproject = [&](double x, double y, double z) {
    return Transform(fromClip, { { x, y, z } }, 1.0);
  };
  const auto windowDepth = [&](const Vector& point)
  {
    double p[4] = { point[0], point[1], point[2], 1.0 };
    toClip->MultiplyPoint(p, p);
    return p[3] > 0.0 ? 0.5 * p[2] / p[3] + 0.5 : -1.0;
  };
  const auto evaluatePlane = [&](const Vector& point, int plane)
  {
    Vector world = Transform(fromView, point, 1.0);
    return clips->GetItem(plane)->EvaluateFunction(world.data());
  };
  const int planes = clips ? clips->GetNumberOfItems() : 0;
  Comparison result;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const double clipX = (2.0 * x + 1.0) / size[0] - 1.0;
      const double clipY = (2.0 * y + 1.0) / size[1] - 1.0;
      Ray ray;
      ray.Start = unproject(clipX, clipY, -1.0);
      ray.Direction = Combine(unproject(clipX, clipY, 1.0), -1.0, ray.Start);
      vtkMath::Normalize(ray.Direction.data());
      Hit hit = Cast(segments, ray, planes, evaluatePlane);
      const double depth = depths->GetValue(y * size[0] + x);
      const auto at = [&](double t) { return windowDepth(Combine(ray.Start, t, ray.Direction)); };
      const bool covered = std::isfinite(hit.Distance) && at(hit.Distance) < 1.0;
      result.Hits += covered;
      if (hit.Doubtful)
      {
        ++result.Doubtful;
        continue;
      }
      const bool right = covered ? depth >= at(hit.Distance - hit.Slack) - tolerance &&
          depth <= at(hit.Distance + hit.Slack) + tolerance
                                 : depth == 1.0;
      if (!right && result.Wrong < 3)
      {
        std::cout << "  pixel " << x << " " << y << ": depth " << depth << ", expected "
                  << (covered ? at(hit.Distance) : 1.0) << "\n";
      }
      result.Wrong += !right;
    }
  }
  return result;
}
}
#endif
