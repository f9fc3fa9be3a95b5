// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSegmentDistances
 * @brief   The nearest samples of every vertex of a surface, and how far they are.
 *
 * Private to the module. Which samples are the nearest, and in which order, is decided by the heat
 * method (vtkHeatGeodesics) among the `Count` nearest of vtkSurfaceGraph. One solution serves all
 * samples that no vertex has in common among its nearest: about 25 solutions are enough for any
 * number of samples.
 *
 * The straight line in space and the path in the graph are bounds of the geodesic distance: a
 * distance is never outside of them, however bad the triangles are.
 *
 * @sa vtkSurfaceSegments
 */

#ifndef vtkSegmentDistances_h
#define vtkSegmentDistances_h

#include "vtkType.h"

#include <functional> // for the progress
#include <vector>     // for distances

VTK_ABI_NAMESPACE_BEGIN
class vtkHeatGeodesics;
class vtkSurfaceGraph;
class vtkTriangleSurface;

class vtkSegmentDistances
{
public:
  /** Nearest samples known for each vertex: itself and eight neighbors for a sample, and a margin,
   * because the graph may give another order than the heat method. */
  static constexpr int Count = 12;

  struct Sample
  {
    double Distance; // in the units of the surface; infinite where there is none
    int Id;          // index of the sample; -1 where the component has fewer
  };

  /** Is told the part that is done, from 0 to 1; returns whether to go on. */
  using Progress = std::function<bool(double)>;

  vtkSegmentDistances(const vtkTriangleSurface& surface, const vtkSurfaceGraph& graph,
    const std::vector<vtkIdType>& samples);

  /** Replace the distances of the graph by those of the heat method. */
  void Refine(const vtkHeatGeodesics& geodesics, const Progress& progress);

  ///@{
  /** The `Count` nearest samples of a vertex, nearest first; of equal ones the first comes first.
   */
  const Sample* Begin(vtkIdType vertex) const { return this->Nearest.data() + vertex * Count; }
  const Sample* End(vtkIdType vertex) const { return this->Begin(vertex + 1); }
  ///@}

private:
  std::vector<std::vector<Sample*>> FindEntriesOfSamples();
  std::vector<std::vector<int>> GroupSamples(
    const std::vector<std::vector<Sample*>>& entriesOfSamples) const;
  vtkIdType GetVertex(const Sample* entry) const { return (entry - this->Nearest.data()) / Count; }

  const vtkTriangleSurface& Surface;
  const std::vector<vtkIdType>& Samples;
  std::vector<Sample> Nearest; // Count for each vertex
};

VTK_ABI_NAMESPACE_END
#endif
