// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    TileBins.h
 * @brief   Which primitives can be seen in which tile of the image.
 */

#ifndef TileBins_h
#define TileBins_h

#include "RayScene.h"

namespace pellucid
{
/** Pixels x0 <= x < x1, y0 <= y < y1. */
struct PixelRectangle
{
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  int Width() const { return std::max(0, this->x1 - this->x0); }
  int Height() const { return std::max(0, this->y1 - this->y0); }

  PixelRectangle Intersection(const PixelRectangle& other) const
  {
    return { std::max(this->x0, other.x0), std::max(this->y0, other.y0),
      std::min(this->x1, other.x1), std::min(this->y1, other.y1) };
  }
};

/**
 * The pixels that the convex hull of some points, given in clip coordinates, can touch in front of
 * the near plane, and one more on each side for rounding. The hull is bounded by the points in
 * front of the plane and by those where a connection of two points passes through it.
 */
template <typename Real, std::size_t N>
PixelRectangle ScreenBounds(const View<Real>& view, const std::array<Vector4<Real>, N>& points)
{
  constexpr Real infinity = std::numeric_limits<Real>::infinity();
  Real lower[2] = { infinity, infinity };
  Real upper[2] = { -infinity, -infinity };
  const auto extend = [&lower, &upper](const Vector4<Real>& point)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      lower[axis] = std::min(lower[axis], point[axis] / point.w);
      upper[axis] = std::max(upper[axis], point[axis] / point.w);
    }
  };
  const auto nearness = [](const Vector4<Real>& point) { return point.z + point.w; };

  for (std::size_t i = 0; i < N; ++i)
  {
    const Real here = nearness(points[i]);
    if (here >= 0)
    {
      extend(points[i]);
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      const Real there = nearness(points[j]);
      if ((here < 0) != (there < 0))
      {
        extend(glm::mix(points[i], points[j], here / (here - there)));
      }
    }
  }

  const auto pixel = [](Real normalized, int size)
  { return static_cast<int>(std::clamp<Real>((normalized + 1) / 2 * size, -1, size + Real(1))); };
  if (!(lower[0] <= upper[0] && lower[1] <= upper[1]))
  {
    return {};
  }
  return PixelRectangle{ pixel(lower[0], view.width) - 1, pixel(lower[1], view.height) - 1,
    pixel(upper[0], view.width) + 2, pixel(upper[1], view.height) + 2 }
    .Intersection({ 0, 0, view.width, view.height });
}

/** For each tile the primitives, in ascending order, whose rectangles touch it. */
class TileBins
{
public:
  static constexpr int TileSize = 8; ///< pixels; keeps the fragments of a tile small in memory

  TileBins() = default;

  TileBins(int width, int height, std::vector<PixelRectangle> rectangles)
    : Columns((width + TileSize - 1) / TileSize)
    , Rectangles(std::move(rectangles))
  {
    const int rows = (height + TileSize - 1) / TileSize;
    this->Offsets.assign(static_cast<std::size_t>(this->Columns) * rows + 1, 0);
    this->ForEachTile([this](std::size_t, std::size_t tile) { ++this->Offsets[tile + 1]; });
    for (std::size_t tile = 1; tile < this->Offsets.size(); ++tile)
    {
      this->Offsets[tile] += this->Offsets[tile - 1];
    }
    this->Primitives.resize(this->Offsets.back());
    std::vector<std::size_t> next(this->Offsets.begin(), this->Offsets.end() - 1);
    this->ForEachTile([this, &next](std::size_t primitive, std::size_t tile)
      { this->Primitives[next[tile]++] = primitive; });
  }

  const std::size_t* Begin(std::size_t tile) const
  {
    return this->Primitives.data() + this->Offsets[tile];
  }
  const std::size_t* End(std::size_t tile) const
  {
    return this->Primitives.data() + this->Offsets[tile + 1];
  }
  const PixelRectangle& Rectangle(std::size_t primitive) const
  {
    return this->Rectangles[primitive];
  }

private:
  template <typename Visit>
  void ForEachTile(Visit&& visit) const
  {
    for (std::size_t primitive = 0; primitive < this->Rectangles.size(); ++primitive)
    {
      const PixelRectangle& r = this->Rectangles[primitive];
      for (int y = r.y0 / TileSize; r.Width() && y * TileSize < r.y1; ++y)
      {
        for (int x = r.x0 / TileSize; x * TileSize < r.x1; ++x)
        {
          visit(primitive, static_cast<std::size_t>(y) * this->Columns + x);
        }
      }
    }
  }

  int Columns = 0;
  std::vector<PixelRectangle> Rectangles;
  std::vector<std::size_t> Offsets{ 0 };
  std::vector<std::size_t> Primitives;
};
}

#endif
