// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIntrinsicTriangulation
 * @brief   A surface as triangles of given side lengths, as near to Delaunay's as it can be.
 *
 * Private to the module. The Laplacian of these triangles has no negative weights, which obtuse
 * triangles would bring, and with which heat would be negative. The vertices and the shape
 * stay what they are; the sides become geodesics that may cross the triangles of the surface.
 *
 * - Triangles with a repeated corner are left out.
 * - In every component the sides are prolonged by the least common amount that makes all triangles
 *   proper ones (N. Sharp, K. Crane, "A Laplacian for nonmanifold triangle meshes", Computer
 * Graphics Forum 39(5), 2020, section 4.5), so that triangles without area do no harm.
 * - Sides between two triangles are flipped until the angles opposite them have a sum of at most
 *   180 degrees (M. Fisher, B. Springborn, A. Bobenko, P. Schroeder, "An algorithm for the
 * construction of intrinsic Delaunay triangulations", Computing 81(2), 2007). Sides of one
 * triangle, of more than two, and the seam of a one-sided surface stay.
 *
 * @sa vtkHeatGeodesics
 */

#ifndef vtkIntrinsicTriangulation_h
#define vtkIntrinsicTriangulation_h

#include "vtkType.h"

#include <array>   // for corners
#include <cstddef> // for sides
#include <utility> // for coordinates
#include <vector>  // for triangles

VTK_ABI_NAMESPACE_BEGIN
class vtkTriangleSurface;

class vtkIntrinsicTriangulation
{
public:
  struct Triangle
  {
    std::array<vtkIdType, 3> Vertices; // may repeat one after flips
    std::array<double, 3> Lengths;     // of the sides opposite them
    double MeanLength;                 // of the sides in its component
  };

  explicit vtkIntrinsicTriangulation(const vtkTriangleSurface& surface);

  const std::vector<Triangle>& GetTriangles() const { return this->Triangles; }

  /** Area of a triangle of these sides; not a number if there is none. */
  static double ComputeArea(std::array<double, 3> lengths);

  /** Two coordinates of the corner between the sides `left` and `right` of a triangle whose side
   * `base` is on the first axis, from the origin, where `left` begins. */
  static std::pair<double, double> LayOut(double base, double left, double right);

private:
  // Side i of triangle t, opposite its corner i, has the number 3 t + i. It runs from the next
  // corner to the one after that.
  using Side = std::ptrdiff_t;
  static constexpr Side NoSide = -1;

  static Side GetNext(Side side) { return side % 3 == 2 ? side - 2 : side + 1; }
  vtkIdType& GetVertex(Side opposite)
  {
    return this->Triangles[opposite / 3].Vertices[opposite % 3];
  }
  double& GetLength(Side side) { return this->Triangles[side / 3].Lengths[side % 3]; }
  double GetCotangent(Side side) const;

  void AddTriangles(const vtkTriangleSurface& surface);
  void ProlongSides(std::vector<Triangle>& component) const;
  void FindMates();
  void Orient();
  void Reverse(Side triangle);
  bool IsDelaunay(Side side) const;
  bool Flip(Side side);
  void FlipToDelaunay();

  std::vector<Triangle> Triangles;
  std::vector<Side> Mates; // the side of the other triangle, in the opposite direction
};

VTK_ABI_NAMESPACE_END
#endif
