// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    RayScene.h
 * @brief   Camera, surfaces, triangles and tubes, ready to be met by view rays.
 *
 * All positions and normals are in view coordinates (the eye at the origin, looking along -z), so
 * that scenes far from the origin of the world lose no digits.
 */

#ifndef RayScene_h
#define RayScene_h

#include "FragmentCompositing.h"
#include "SurfaceShading.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pellucid
{
/** The projection, and the image it fills. */
template <typename Real>
struct View
{
  /** View to clip coordinates, with depths from -w at the near to w at the far plane. */
  glm::mat<4, 4, Real, glm::defaultp> projection{ Real(1) };
  int width = 0;
  int height = 0;
  bool parallel = false;

  /** The same view in a picture of 1/scale of the width and height, rounded up. */
  View Reduced(int scale) const
  {
    View reduced = *this;
    reduced.width = (this->width + scale - 1) / scale;
    reduced.height = (this->height + scale - 1) / scale;
    return reduced;
  }

  /** Normalised device coordinates of a pixel's centre; rows count upwards. */
  Real NormalizedX(int x) const { return (2 * x + 1) / static_cast<Real>(this->width) - 1; }
  Real NormalizedY(int y) const { return (2 * y + 1) / static_cast<Real>(this->height) - 1; }

  /**
   * The line of sight of a pixel, from the near to the far plane. It is where the two planes that
   * project to the pixel's column and row intersect, which holds for any projection and needs no
   * inverse matrix.
   */
  Ray<Real> PixelRay(int x, int y) const
  {
    const auto rows = glm::transpose(this->projection);
    const Vector4<Real> column = rows[0] - this->NormalizedX(x) * rows[3];
    const Vector4<Real> row = rows[1] - this->NormalizedY(y) * rows[3];
    const Vector4<Real> nearPlane = rows[3] + rows[2];
    const Vector4<Real> farPlane = rows[3] - rows[2];
    const Vector3<Real> c(column);
    const Vector3<Real> r(row);
    const Vector3<Real> n(nearPlane);

    Ray<Real> ray;
    const Vector3<Real> line = glm::cross(c, r);
    const Real slope = glm::dot(line, n);
    ray.origin =
      -(column.w * glm::cross(r, n) + row.w * glm::cross(n, c) + nearPlane.w * line) / slope;
    ray.direction = glm::normalize(slope < 0 ? -line : line);
    ray.end = -glm::dot(farPlane, Vector4<Real>(ray.origin, 1)) /
      glm::dot(Vector3<Real>(farPlane), ray.direction);
    return ray;
  }

  Vector4<Real> ClipCoordinates(const Vector3<Real>& position) const
  {
    return this->projection * Vector4<Real>(position, 1);
  }

  /** 0 at the near plane, 1 at the far plane. */
  static Real WindowDepth(const Vector4<Real>& clip) { return (clip.z / clip.w + 1) / 2; }
};

/** Colours to look up with a coordinate in [0,1]^2; the texel that contains the point is taken. */
template <typename Real>
struct ColorTable
{
  int width = 0;
  int height = 0;
  std::vector<Vector4<Real>> texels;

  const Vector4<Real>& Lookup(Real s, Real t) const
  {
    const int column = static_cast<int>(Saturate(s) * this->width);
    const int row = static_cast<int>(Saturate(t) * this->height);
    return this->texels[std::min(column, this->width - 1) +
      static_cast<std::size_t>(this->width) * std::min(row, this->height - 1)];
  }
};

/** Where the colour of a surface comes from. */
enum class ColorSource
{
  Material, ///< its materials
  Vertices, ///< straight RGBA of the vertices, interpolated
  Table     ///< the table, at the first two colour components of the vertices, interpolated
};

/** How all primitives of one prop look. `front` and `back` are equal where the prop does not
 * distinguish its two sides. */
template <typename Real>
struct Surface
{
  Material<Real> front;
  Material<Real> back;
  ColorSource colorSource = ColorSource::Material;
  ColorTable<Real> table;
  std::vector<HalfSpace<Real>> clipping;               ///< only what lies in all of these is shown
  std::optional<OpacityParameters<Real>> optimization; ///< where the opacities are optimised
  std::optional<OcclusionAvoidance<Real>> avoidance;   ///< where they follow from this instead
  bool opaque = true;
  bool lit = true;
  bool cullFront = false;
  bool cullBack = false;

  /** Whether opacities follow from importance. */
  bool HasImportance() const { return this->optimization || this->avoidance; }

  const OpacityParameters<Real>* GetOptimization() const
  {
    return this->optimization ? &*this->optimization : nullptr;
  }
  const OcclusionAvoidance<Real>* GetAvoidance() const
  {
    return this->avoidance ? &*this->avoidance : nullptr;
  }
};

/** The importance at a point, and where it lies between the centres of two segments of a line. */
template <typename Real>
struct SegmentNode
{
  Real importance = 0;
  SegmentId base = 0;
  Real weight = 0;
};

/** A zero normal stands for none: the face's own is used. Normals need no unit length. */
template <typename Real>
struct Vertex
{
  Vector3<Real> position{ Real(0) };
  Vector3<Real> normal{ Real(0) };
  Vector4<Real> color{ Real(1) };
  Real opacity = 1;            ///< a factor, interpolated
  SegmentNode<Real> segment{}; ///< `base` is the segment nearest to it; `weight` does not count
  SegmentId corner = -1;       ///< the opacity at the vertex, if it is not that of the segment
};

struct Triangle
{
  std::array<std::size_t, 3> vertices;
  std::uint32_t surface;
};

/** The ball at a point of a polyline. */
template <typename Real>
struct TubePoint
{
  Vector3<Real> position{ Real(0) };
  Real radius = 0;
  Vector4<Real> color{ Real(1) };
  Real opacity = 1; ///< a factor, interpolated
  SegmentNode<Real> segment{};
};

/**
 * The part of a tube that belongs to one segment of its polyline: the rounded cone between the
 * points `first` and `last`, as far as it lies on this segment's side of the bisector planes at
 * inner points: normal to the sum of the unit directions of the two segments that meet there. The
 * planes of Gross and Gumhold 2021, eq. 11, normal to the chord from the previous to the next
 * point, are the same where both segments have one length; elsewhere the cross-sections of the two
 * tubes in them differ, and rays that pass between miss both. A point on a plane belongs to the
 * segment that starts there. A sphere is a tube of one piece whose two points are the same.
 */
template <typename Real>
struct TubePiece
{
  std::size_t first;
  std::size_t last;
  HalfSpace<Real> start; ///< belongs where the height is >= 0
  HalfSpace<Real> end;   ///< belongs where the height is < 0, if there is a plane at all
  std::uint32_t tube;
  std::uint32_t surface;

  bool Owns(const Vector3<Real>& point) const
  {
    return !(this->start.Height(point) < 0) &&
      (this->end.normal == Vector3<Real>(Real(0)) || this->end.Height(point) < 0);
  }
};

/** Everything that is in the picture. The pieces of one tube follow each other. */
template <typename Real>
class Scene
{
public:
  View<Real> view;
  Lighting<Real> lighting;
  std::vector<Surface<Real>> surfaces;
  std::vector<Vertex<Real>> vertices;
  std::vector<Triangle> triangles;
  std::vector<TubePoint<Real>> tubePoints;
  std::vector<TubePiece<Real>> tubePieces;

  /**
   * Add the tube around a polyline. A point that is not finite splits it and costs the segments
   * that touch it. Consecutive points at one place count as the first of them, and a polyline that
   * is all at one place is a ball. Negative radii are 0, and a segment with two radii of 0 is not
   * drawn. Returns the number of points that were not finite.
   */
  std::size_t AddTube(const std::vector<TubePoint<Real>>& polyline, std::uint32_t surface)
  {
    std::size_t rejected = 0;
    std::vector<TubePoint<Real>> run;
    for (const auto& point : polyline)
    {
      if (!IsFinite(point))
      {
        ++rejected;
        this->AddRun(run, surface);
        run.clear();
      }
      else if (run.empty() || run.back().position != point.position)
      {
        run.push_back(point);
        run.back().radius = std::max(point.radius, Real(0));
      }
    }
    this->AddRun(run, surface);
    return rejected;
  }

private:
  static bool IsFinite(const TubePoint<Real>& point)
  {
    return std::isfinite(point.position.x) && std::isfinite(point.position.y) &&
      std::isfinite(point.position.z) && std::isfinite(point.radius);
  }

  /** The plane that halves the angle between the segments that meet at a point; none where the line
   * turns straight back, to 1e-6 radians. */
  static HalfSpace<Real> JointPlane(
    const Vector3<Real>& previous, const Vector3<Real>& point, const Vector3<Real>& next)
  {
    const Vector3<Real> sum = glm::normalize(point - previous) + glm::normalize(next - point);
    const Real length = glm::length(sum);
    return { point, length > Real(1e-6) ? sum / length : Vector3<Real>(Real(0)) };
  }

  void AddRun(const std::vector<TubePoint<Real>>& run, std::uint32_t surface)
  {
    if (run.empty())
    {
      return;
    }
    const std::uint32_t tube = this->tubes++;
    const std::size_t offset = this->tubePoints.size();
    this->tubePoints.insert(this->tubePoints.end(), run.begin(), run.end());
    const std::size_t pieces = std::max<std::size_t>(run.size() - 1, 1);
    HalfSpace<Real> joint;
    for (std::size_t first = 0; first < pieces; ++first)
    {
      const std::size_t last = std::min(first + 1, run.size() - 1);
      TubePiece<Real> piece{ offset + first, offset + last, joint, {}, tube, surface };
      if (first + 1 < pieces)
      {
        joint = JointPlane(run[first].position, run[last].position, run[last + 1].position);
        piece.end = joint;
      }
      if (run[first].radius > 0 || run[last].radius > 0)
      {
        this->tubePieces.push_back(piece);
      }
    }
  }

  std::uint32_t tubes = 0;
};
}

#endif
