// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceSampling
 * @brief   Vertices that divide a surface into Voronoi cells of nearly equal area.
 *
 * Private to the module. Each component gets samples in proportion to its area, at least one and
 * not more than it has vertices. They are placed one by one, each where the distance to those
 * before is greatest (farthest-point sampling). Then they move towards the centroids of their cells
 * (S. Lloyd, IEEE Transactions on Information Theory 28(2), 1982, with over-relaxation), while
 * cells that are too large are held back and small ones let grow, which spreads the samples evenly,
 * also at borders. At last each is the vertex of its cell nearest to where it came, and cells are
 * again those of the nearest sample. Distances are those of vtkSurfaceGraph. Equal candidates: the
 * vertex of the lowest number.
 *
 * @sa vtkSurfaceSegments
 */

#ifndef vtkSurfaceSampling_h
#define vtkSurfaceSampling_h

#include "vtkType.h"
#include "vtkVector.h"

#include <functional> // for the progress
#include <vector>     // for samples

VTK_ABI_NAMESPACE_BEGIN
class vtkSurfaceGraph;
class vtkTriangleSurface;

class vtkSurfaceSampling
{
public:
  /** Is told the part that is done, from 0 to 1; returns whether to go on. */
  using Progress = std::function<bool(double)>;

  vtkSurfaceSampling(
    const vtkTriangleSurface& surface, const vtkSurfaceGraph& graph, const Progress& progress);

  /** The samples for about `count` cells, not more than there are vertices; those of a component
   * together, in no special order. */
  std::vector<vtkIdType> Place(double count) const;

private:
  // What a cell belongs to, between vertices.
  struct Site
  {
    vtkIdType Vertex; // the nearest
    vtkVector3d Position;
    double Delay; // length that its paths have before they begin
  };

  std::vector<vtkIdType> ShareAmongComponents(double count) const;
  std::vector<Site> PlaceFarthest(const std::vector<vtkIdType>& counts) const;
  std::vector<Site> MoveToCentroids(const std::vector<Site>& sites) const;
  std::vector<int> FindCells(const std::vector<Site>& sites) const;

  const vtkTriangleSurface& Surface;
  const vtkSurfaceGraph& Graph;
  Progress Report;
};

VTK_ABI_NAMESPACE_END
#endif
