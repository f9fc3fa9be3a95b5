// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNodeGroups
 * @brief   Groups of consecutive nodes of trajectories, and how a view draws each of them.
 *
 * Groups that lie outside the view are not drawn. Where no segment of a group is larger than a few
 * pixels, each is a point sprite: a vertex instead of four, and a square of whole pixels instead of
 * two triangles, both of which would cover the pixels along their common edge. Measured with Mesa's
 * software renderer, 100,000 segments of 3 pixels: 0.75 of the time that quads take. Longer
 * segments are quads, since a square around a slanted one is mostly empty.
 *
 * Cost: one pass over the nodes when they change, 72 bytes for each group; eight corners of each
 * group for each view.
 */

#ifndef vtkNodeGroups_h
#define vtkNodeGroups_h

#include "vtkBoundingBox.h" // for the groups
#include "vtkMatrix4x4.h"   // for the view
#include "vtkType.h"        // for vtkIdType

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkTrajectoryNodes;

class vtkNodeGroups
{
public:
  enum class Shape
  {
    None, ///< outside the view
    Sprite,
    Quad
  };

  /** A plane (n, d) with a unit normal, or 0, that keeps the points p with dot(n, p) + d >= 0. */
  using Plane = std::array<double, 4>;

  struct View
  {
    const vtkMatrix4x4* NodeToView = nullptr; ///< transposed, as VTK's key matrices are
    std::array<Plane, 6> Frustum{};           ///< in view coordinates
    bool Parallel = false;
    double PixelsPerUnit = 0.0; ///< at distance 1 from the eye; in parallel projection everywhere
    double LargestSlope =
      0.0; ///< the tangent of the angle between the middle and a corner of the view
    bool HasSprites = true;   ///< whether OpenGL can draw them exactly
    bool HasOneShape = false; ///< for all nodes, also those outside: sprites if these can show all
  };

  ///@{
  /** Sprites are at most as wide, in pixels: where segments are not longer than their radius, and
   * so fill a square, and else. OpenGL implementations allow 63 and more. */
  static constexpr double LargestSprite = 32.0;
  static constexpr double LargestLongSprite = 12.0;
  ///@}

  /** Divide the nodes. */
  void Build(const vtkTrajectoryNodes& nodes);

  /** Choose the shapes for a view. */
  void Update(const View& view);

  /** Whether a group has that shape. */
  bool Has(Shape shape) const;

  /** Call draw(begin, end) for the nodes in [first, last) of that shape, for neighbours together.
   */
  template <typename Draw>
  void ForEach(Shape shape, vtkIdType first, vtkIdType last, Draw&& draw) const
  {
    while (first < last)
    {
      const Shape here = this->Shapes[first / GroupSize];
      vtkIdType end = first;
      while (end < last && this->Shapes[end / GroupSize] == here)
      {
        end = (end / GroupSize + 1) * GroupSize;
      }
      end = end < last ? end : last;
      if (here == shape)
      {
        draw(first, end);
      }
      first = end;
    }
  }

private:
  static constexpr vtkIdType GroupSize = 1024;

  struct Group
  {
    vtkBoundingBox Points; ///< of its nodes, and of the one that its last segment leads to
    double LongestSegment = 0.0;
    double LargestRadius = 0.0;
    double LargestAspect = 0.0; ///< length of a segment by the larger one of its radii
  };

  static Shape ChooseShape(const Group& group, const View& view, double stretch);

  std::vector<Group> Groups;
  std::vector<Shape> Shapes;
};

VTK_ABI_NAMESPACE_END
#endif
