// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    RayCasting.h
 * @brief   Finds all fragments of all pixels of a scene, one tile of the image at a time.
 *
 * Every primitive is first entered into the tiles that its bounds on the screen touch; a tile then
 * meets only its own primitives, and a primitive only the pixels within its bounds. Tiles are
 * independent of each other and may be worked on by any number of threads.
 */

#ifndef RayCasting_h
#define RayCasting_h

#include "FragmentCompositing.h"
#include "TileBins.h"

namespace pellucid
{
/** Casts the view rays of a scene, which must outlive it unchanged. */
template <typename Real>
class RayCaster
{
public:
  explicit RayCaster(const Scene<Real>& scene)
    : RayCaster(scene, scene.view, {})
  {
  }

  /** With another picture of the scene; not empty, `opaqueDepths` are the depths of the opaque
   * surface in its pixels, row by row, in place of those of the scene. */
  RayCaster(const Scene<Real>& scene, const View<Real>& view, std::vector<Real> opaqueDepths)
    : Input(scene)
    , Picture(view)
    , OpaqueDepths(std::move(opaqueDepths))
    , TriangleBins(view.width, view.height, this->BoundTriangles())
    , PieceBins(view.width, view.height, this->BoundPieces())
  {
  }

  const Scene<Real>& GetScene() const { return this->Input; }
  const View<Real>& GetView() const { return this->Picture; }

  int GetNumberOfTiles() const { return this->Columns() * this->Rows(); }

  /** The pixels of a tile; at the upper and right borders it may be cut. */
  PixelRectangle GetTile(int tile) const
  {
    const int x = tile % this->Columns() * TileBins::TileSize;
    const int y = tile / this->Columns() * TileBins::TileSize;
    return PixelRectangle{ x, y, x + TileBins::TileSize, y + TileBins::TileSize }.Intersection(
      { 0, 0, this->Picture.width, this->Picture.height });
  }

  int GetTileOfPixel(int x, int y) const
  {
    return y / TileBins::TileSize * this->Columns() + x / TileBins::TileSize;
  }

  /**
   * Find the fragments of the pixels `area` of a tile and sort them. `pixels` gets one entry for
   * each pixel, row by row; passing the same vector again and again keeps its memory in use.
   */
  void Cast(int tile, const PixelRectangle& area, std::vector<PixelFragments<Real>>& pixels) const
  {
    pixels.resize(static_cast<std::size_t>(area.Width()) * area.Height());
    for (auto& pixel : pixels)
    {
      pixel.Clear();
    }
    this->CastTriangles(tile, area, pixels);
    if (this->PieceBins.Begin(tile) != this->PieceBins.End(tile))
    {
      this->CastTubes(tile, area, this->PixelRays(area), pixels);
    }
    ForEachPixel(area, area,
      [this, &pixels](int x, int y, std::size_t pixel)
      {
        pixels[pixel].Sort(this->OpaqueDepths.empty()
            ? pixels[pixel].GetOpaqueDepth()
            : this->OpaqueDepths[static_cast<std::size_t>(y) * this->Picture.width + x]);
      });
  }

private:
  using Pixels = std::vector<PixelFragments<Real>>;
  using Rays = std::vector<Ray<Real>>;

  int Columns() const
  {
    return (this->Picture.width + TileBins::TileSize - 1) / TileBins::TileSize;
  }
  int Rows() const { return (this->Picture.height + TileBins::TileSize - 1) / TileBins::TileSize; }

  std::vector<PixelRectangle> BoundTriangles() const
  {
    std::vector<PixelRectangle> bounds;
    bounds.reserve(this->Input.triangles.size());
    for (const Triangle& triangle : this->Input.triangles)
    {
      bounds.push_back(ScreenBounds(this->Picture, this->ClipCorners(triangle)));
    }
    return bounds;
  }

  std::vector<PixelRectangle> BoundPieces() const
  {
    std::vector<PixelRectangle> bounds;
    bounds.reserve(this->Input.tubePieces.size());
    for (const auto& piece : this->Input.tubePieces)
    {
      const auto cone = this->Cone(piece);
      const Vector3<Real> lower =
        glm::min(cone.center[0] - cone.radius[0], cone.center[1] - cone.radius[1]);
      const Vector3<Real> upper =
        glm::max(cone.center[0] + cone.radius[0], cone.center[1] + cone.radius[1]);
      std::array<Vector4<Real>, 8> corners;
      for (int i = 0; i < 8; ++i)
      {
        corners[i] = this->Picture.ClipCoordinates(
          { (i & 1 ? upper : lower).x, (i & 2 ? upper : lower).y, (i & 4 ? upper : lower).z });
      }
      bounds.push_back(ScreenBounds(this->Picture, corners));
    }
    return bounds;
  }

  std::array<Vector4<Real>, 3> ClipCorners(const Triangle& triangle) const
  {
    std::array<Vector4<Real>, 3> corners;
    for (int i = 0; i < 3; ++i)
    {
      corners[i] =
        this->Picture.ClipCoordinates(this->Input.vertices[triangle.vertices[i]].position);
    }
    return corners;
  }

  RoundedCone<Real> Cone(const TubePiece<Real>& piece) const
  {
    const auto& first = this->Input.tubePoints[piece.first];
    const auto& last = this->Input.tubePoints[piece.last];
    return { { first.position, last.position }, { first.radius, last.radius } };
  }

  void CastTriangles(int tile, const PixelRectangle& area, Pixels& pixels) const
  {
    for (auto id = this->TriangleBins.Begin(tile); id != this->TriangleBins.End(tile); ++id)
    {
      const Triangle& triangle = this->Input.triangles[*id];
      const auto clip = this->ClipCorners(triangle);
      std::array<Vector3<Real>, 3> corners;
      for (int i = 0; i < 3; ++i)
      {
        corners[i] = { clip[i].x, clip[i].y, clip[i].w };
      }
      ForEachPixel(area, this->TriangleBins.Rectangle(*id),
        [&](int x, int y, std::size_t pixel)
        {
          const auto hit =
            IntersectTriangle(corners, this->Picture.NormalizedX(x), this->Picture.NormalizedY(y));
          if (hit)
          {
            const Vector4<Real> point =
              hit->weights.x * clip[0] + hit->weights.y * clip[1] + hit->weights.z * clip[2];
            this->AddTriangle(triangle, *hit, View<Real>::WindowDepth(point), pixels[pixel]);
          }
        });
    }
  }

  void AddTriangle(const Triangle& triangle, const TriangleHit<Real>& hit, Real depth,
    PixelFragments<Real>& pixel) const
  {
    const Surface<Real>& surface = this->Input.surfaces[triangle.surface];
    if (!(depth >= 0 && depth <= 1) || (hit.frontFacing ? surface.cullFront : surface.cullBack))
    {
      return;
    }
    const auto& a = this->Input.vertices[triangle.vertices[0]];
    const auto& b = this->Input.vertices[triangle.vertices[1]];
    const auto& c = this->Input.vertices[triangle.vertices[2]];
    const auto blend = [&hit](const auto& x, const auto& y, const auto& z)
    { return hit.weights.x * x + hit.weights.y * y + hit.weights.z * z; };
    const Vector3<Real> position = blend(a.position, b.position, c.position);
    if (!IsInside(surface, position))
    {
      return;
    }
    Vector3<Real> normal = blend(a.normal, b.normal, c.normal);
    const Real length = glm::length(normal);
    if (length > 0)
    {
      normal *= (hit.frontFacing ? 1 : -1) / length;
    }
    else
    {
      normal = this->TowardsViewer(
        glm::normalize(glm::cross(b.position - a.position, c.position - a.position)), position);
    }
    const Real opacity = Interpolate(hit.weights, a.opacity, b.opacity, c.opacity);
    Fragment<Real> fragment;
    fragment.depth = depth;
    fragment.place = PlaceInTriangle(surface, { &a, &b, &c }, hit.weights);
    this->AddFragment(surface, hit.frontFacing, blend(a.color, b.color, c.color), opacity, position,
      normal, fragment, pixel);
  }

  /** Equal values stay the same to the last bit, though weights need not add up to 1. */
  static Real Interpolate(const Vector3<Real>& weights, Real a, Real b, Real c)
  {
    return a + weights.y * (b - a) + weights.z * (c - a);
  }

  static SegmentPlace<Real> PlaceInTriangle(const Surface<Real>& surface,
    const std::array<const Vertex<Real>*, 3>& corners, const Vector3<Real>& weights)
  {
    SegmentPlace<Real> place;
    if (!surface.HasImportance())
    {
      return place;
    }
    const Real importance = Interpolate(weights, corners[0]->segment.importance,
      corners[1]->segment.importance, corners[2]->segment.importance);
    int nearest = 0;
    for (int i = 1; i < 3; ++i)
    {
      nearest = weights[i] > weights[nearest] ? i : nearest;
    }
    place.nearest = { ClampImportance(importance), corners[nearest]->segment.base,
      surface.GetOptimization() };
    for (int i = 0; i < 3; ++i)
    {
      const bool interpolates = corners[i]->corner >= 0;
      place.opacities[i] = interpolates ? corners[i]->corner : corners[i]->segment.base;
      place.shares[i] = interpolates ? weights[i] : Real(i == nearest);
    }
    return place;
  }

  /** `along` is 0 at the first and 1 at the last point of a piece. */
  static SegmentPlace<Real> PlaceOnLine(const Surface<Real>& surface,
    const SegmentNode<Real>& first, const SegmentNode<Real>& last, Real along)
  {
    SegmentPlace<Real> place;
    if (surface.HasImportance())
    {
      const Real steps = static_cast<Real>(last.base - first.base) + last.weight - first.weight;
      const Real centre = first.weight + along * steps;
      const Real whole = std::floor(centre);
      const Real share = centre - whole;
      const SegmentId base = first.base + static_cast<SegmentId>(whole);
      place.nearest = { first.importance + along * (last.importance - first.importance),
        share < Real(0.5) ? base : base + 1, surface.GetOptimization() };
      place.opacities = { base, base + 1, 0 };
      place.shares = { 1 - share, share, 0 };
    }
    return place;
  }

  Vector3<Real> TowardsViewer(const Vector3<Real>& normal, const Vector3<Real>& position) const
  {
    const bool away = this->Picture.parallel ? normal.z < 0 : glm::dot(normal, position) > 0;
    return away ? -normal : normal;
  }

  static bool IsInside(const Surface<Real>& surface, const Vector3<Real>& position)
  {
    return std::all_of(surface.clipping.begin(), surface.clipping.end(),
      [&position](const HalfSpace<Real>& space) { return space.Height(position) >= 0; });
  }

  /** `fragment` has its depth, its place, and its tangent. */
  void AddFragment(const Surface<Real>& surface, bool frontFacing, const Vector4<Real>& attribute,
    Real opacity, const Vector3<Real>& position, const Vector3<Real>& normal,
    Fragment<Real> fragment, PixelFragments<Real>& pixel) const
  {
    Material<Real> material = frontFacing ? surface.front : surface.back;
    Real alpha = opacity * material.opacity;
    if (surface.colorSource != ColorSource::Material)
    {
      const Vector4<Real> color = surface.colorSource == ColorSource::Table
        ? surface.table.Lookup(attribute.x, attribute.y)
        : attribute;
      material.ambientColor = material.diffuseColor = Vector3<Real>(color);
      alpha *= color.a;
    }
    const bool lit = surface.lit && !this->Input.lighting.lights.empty();
    const Vector3<Real> color =
      lit ? Shade(this->Input.lighting, material, position, normal) : Unlit(material);
    fragment.color = { Saturate(color.r), Saturate(color.g), Saturate(color.b),
      surface.opaque ? Real(1) : Saturate(alpha) };
    fragment.distance = -position.z;
    fragment.avoidance = surface.GetAvoidance();
    fragment.tangent = surface.avoidance ? fragment.tangent : Vector3<Real>(Real(0));
    pixel.Add(fragment, surface.opaque);
  }

  /** Calls visit(x, y, index) for the pixels of `area` within `bounds`; index counts in `area`. */
  template <typename Visit>
  static void ForEachPixel(const PixelRectangle& area, const PixelRectangle& bounds, Visit&& visit)
  {
    const PixelRectangle common = area.Intersection(bounds);
    for (int y = common.y0; y < common.y1; ++y)
    {
      for (int x = common.x0; x < common.x1; ++x)
      {
        visit(x, y, static_cast<std::size_t>(y - area.y0) * area.Width() + (x - area.x0));
      }
    }
  }

  Rays PixelRays(const PixelRectangle& area) const
  {
    Rays rays;
    rays.reserve(static_cast<std::size_t>(area.Width()) * area.Height());
    ForEachPixel(area, area,
      [this, &rays](int x, int y, std::size_t) { rays.push_back(this->Picture.PixelRay(x, y)); });
    return rays;
  }

  /** The part of a ray between near and far plane and inside the clipping planes: a single
   * interval, since all of these are half-spaces. */
  static Ray<Real> VisibleRay(const Surface<Real>& surface, Ray<Real> ray)
  {
    Interval<Real> visible{ ray.begin, ray.end };
    for (const auto& space : surface.clipping)
    {
      Clip(visible, ray, space);
    }
    ray.begin = visible.begin;
    ray.end = visible.end;
    return ray;
  }

  void CastTubes(int tile, const PixelRectangle& area, const Rays& rays, Pixels& pixels) const
  {
    auto begin = this->PieceBins.Begin(tile);
    const auto end = this->PieceBins.End(tile);
    while (begin != end)
    {
      const std::uint32_t tube = this->Input.tubePieces[*begin].tube;
      const auto next = std::find_if(begin, end,
        [this, tube](std::size_t id) { return this->Input.tubePieces[id].tube != tube; });
      this->CastTube(begin, next, area, rays, pixels);
      begin = next;
    }
  }

  /**
   * A piece of a tube is seen from outside where its cone is entered at a point that belongs to the
   * piece. A ray that starts inside the tube, cut open by the near plane or a clipping plane, also
   * sees the inner wall, once, where it first leaves the tube.
   */
  template <typename Iterator>
  void CastTube(Iterator begin, Iterator end, const PixelRectangle& area, const Rays& rays,
    Pixels& pixels) const
  {
    const Surface<Real>& surface = this->Input.surfaces[this->Input.tubePieces[*begin].surface];
    std::vector<std::size_t> startInside;
    for (auto id = begin; id != end; ++id)
    {
      ForEachPixel(area, this->PieceBins.Rectangle(*id),
        [&](int, int, std::size_t pixel)
        {
          if (this->CastPiece(
                this->Input.tubePieces[*id], VisibleRay(surface, rays[pixel]), pixels[pixel]))
          {
            startInside.push_back(pixel);
          }
        });
    }
    std::sort(startInside.begin(), startInside.end());
    startInside.erase(std::unique(startInside.begin(), startInside.end()), startInside.end());
    for (const std::size_t pixel : startInside)
    {
      this->CastInnerWall(begin, end, VisibleRay(surface, rays[pixel]), pixels[pixel]);
    }
  }

  /** Adds the front fragment, if there is one; returns whether the ray starts inside the piece. */
  bool CastPiece(
    const TubePiece<Real>& piece, const Ray<Real>& ray, PixelFragments<Real>& pixel) const
  {
    const auto crossing = IntersectRoundedCone(ray, this->Cone(piece));
    if (!crossing || !(ray.begin <= ray.end))
    {
      return false;
    }
    if (ray.Contains(crossing->entry.t) && piece.Owns(ray.At(crossing->entry.t)))
    {
      this->AddTube(piece, ray, crossing->entry, 1, pixel);
    }
    const auto inside = this->InsidePiece(piece, ray, *crossing);
    return inside.begin < ray.begin && ray.begin < inside.end;
  }

  /** The part of a ray that lies in a piece of a tube, before near and clipping planes. */
  Interval<Real> InsidePiece(
    const TubePiece<Real>& piece, const Ray<Real>& ray, const ConeCrossing<Real>& crossing) const
  {
    Interval<Real> inside{ crossing.entry.t, crossing.exit.t };
    Clip(inside, ray, piece.start);
    Clip(inside, ray, { piece.end.point, -piece.end.normal });
    return inside;
  }

  /**
   * Adds the inner wall of the tube in which the ray starts. Pieces are joined, along the ray, into
   * the stretch that the ray passes inside their union; pieces that share a plane join exactly,
   * because both get the same ray parameter for it.
   */
  template <typename Iterator>
  void CastInnerWall(
    Iterator begin, Iterator end, const Ray<Real>& ray, PixelFragments<Real>& pixel) const
  {
    struct Stretch
    {
      Interval<Real> inside;
      const TubePiece<Real>* piece;
      ConeHit<Real> exit;
    };
    std::vector<Stretch> stretches;
    for (auto id = begin; id != end; ++id)
    {
      const auto& piece = this->Input.tubePieces[*id];
      if (const auto crossing = IntersectRoundedCone(ray, this->Cone(piece)))
      {
        const auto inside = this->InsidePiece(piece, ray, *crossing);
        if (!inside.IsEmpty())
        {
          stretches.push_back({ inside, &piece, crossing->exit });
        }
      }
    }
    std::stable_sort(stretches.begin(), stretches.end(),
      [](const Stretch& a, const Stretch& b) { return a.inside.begin < b.inside.begin; });

    const Stretch* last = nullptr;
    Real reached = ray.begin;
    for (const Stretch& stretch : stretches)
    {
      if (stretch.inside.begin <= reached && stretch.inside.end > reached)
      {
        reached = stretch.inside.end;
        last = &stretch;
      }
    }
    if (last && ray.Contains(last->exit.t) && last->piece->Owns(ray.At(last->exit.t)))
    {
      this->AddTube(*last->piece, ray, last->exit, -1, pixel);
    }
  }

  /** `side` is 1 for the outer wall of a tube and -1 for the inner. */
  void AddTube(const TubePiece<Real>& piece, const Ray<Real>& ray, const ConeHit<Real>& hit,
    int side, PixelFragments<Real>& pixel) const
  {
    const Vector3<Real> position = ray.At(hit.t);
    const Vector3<Real> normal =
      RoundedConeNormal(this->Cone(piece), position, hit.axis) * static_cast<Real>(side);
    const auto& first = this->Input.tubePoints[piece.first];
    const auto& last = this->Input.tubePoints[piece.last];
    const Vector4<Real> color = glm::mix(first.color, last.color, hit.axis);
    const Real opacity = first.opacity + hit.axis * (last.opacity - first.opacity);
    const Real depth = View<Real>::WindowDepth(this->Picture.ClipCoordinates(position));
    const Surface<Real>& surface = this->Input.surfaces[piece.surface];
    Fragment<Real> fragment;
    fragment.depth = glm::clamp(depth, Real(0), Real(1));
    fragment.place = PlaceOnLine(surface, first.segment, last.segment, hit.axis);
    if (!this->Cone(piece).IsOneBall())
    {
      fragment.tangent = glm::normalize(last.position - first.position);
    }
    this->AddFragment(surface, true, color, opacity, position, normal, fragment, pixel);
  }

  const Scene<Real>& Input;
  View<Real> Picture;
  std::vector<Real> OpaqueDepths;
  TileBins TriangleBins;
  TileBins PieceBins;
};
}

#endif
