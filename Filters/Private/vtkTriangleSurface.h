// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTriangleSurface
 * @brief   The shape of a set of triangles: vertices, connected components, areas.
 *
 * Private to the module. Points at the same place are one vertex, so that a surface hangs together
 * where its normals or its texture have a seam. Coordinates are relative to the surface's centre,
 * in units of its size: squares of them neither overflow nor vanish. Any triangles are accepted:
 * without area, with a repeated corner, more than two at an edge.
 *
 * @sa vtkSurfaceSegments
 */

#ifndef vtkTriangleSurface_h
#define vtkTriangleSurface_h

#include "vtkType.h"
#include "vtkVector.h"
#include "vtkVectorOperators.h" // for those who use the vectors

#include <array>  // for corners
#include <vector> // for vertices

VTK_ABI_NAMESPACE_BEGIN
class vtkPoints;

class vtkTriangleSurface
{
public:
  /**
   * The triangles whose corners are `corners[3 t]` to `corners[3 t + 2]`, ids of finite points.
   */
  vtkTriangleSurface(vtkPoints* points, const std::vector<vtkIdType>& corners);

  /** Vertices of each triangle. Vertices are numbered in the order of the points' ids. */
  const std::vector<std::array<vtkIdType, 3>>& GetTriangles() const { return this->Triangles; }

  vtkIdType GetNumberOfVertices() const { return static_cast<vtkIdType>(this->Positions.size()); }
  const vtkVector3d& GetPosition(vtkIdType vertex) const { return this->Positions[vertex]; }

  /** Vertices of each connected component, ascending; components in the order of their first. */
  const std::vector<std::vector<vtkIdType>>& GetComponents() const { return this->Components; }

  /** A third of the area of the triangles at the vertex. */
  double GetVertexArea(vtkIdType vertex) const { return this->VertexAreas[vertex]; }

  /** Mean of the normals of the triangles at the vertex, weighted with their areas; 0 if none. */
  const vtkVector3d& GetNormal(vtkIdType vertex) const { return this->Normals[vertex]; }

  double GetArea() const;

  /** Length of the points' coordinate system that is 1 here. */
  double GetUnit() const { return this->Unit; }

private:
  void MergePoints(vtkPoints* points, const std::vector<vtkIdType>& corners);
  void Normalize();
  void FindComponents();
  void ComputeAreasAndNormals();

  std::vector<std::array<vtkIdType, 3>> Triangles;
  std::vector<vtkVector3d> Positions;
  std::vector<std::vector<vtkIdType>> Components;
  std::vector<double> VertexAreas;
  std::vector<vtkVector3d> Normals;
  double Unit = 1.0;
};

VTK_ABI_NAMESPACE_END
#endif
