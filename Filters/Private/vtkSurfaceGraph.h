// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceGraph
 * @brief   Straight paths on a surface between near vertices, and the nearest sources along them.
 *
 * Private to the module. The paths are the edges and, for an edge of exactly two triangles, the
 * straight line between their other corners in the plane into which the two unfold, where that
 * line crosses the edge. All of them lie on the surface: a distance along them is never less
 * than the geodesic distance, and exceeds it by some per cent on usual meshes, instead of some 15
 * per cent along edges alone.
 *
 * @sa vtkSurfaceSegments
 */

#ifndef vtkSurfaceGraph_h
#define vtkSurfaceGraph_h

#include "vtkType.h"

#include <limits> // for lengths
#include <vector> // for paths

VTK_ABI_NAMESPACE_BEGIN
class vtkTriangleSurface;

class vtkSurfaceGraph
{
public:
  struct Path
  {
    vtkIdType From;
    vtkIdType To;
    float Length;
  };

  /** A path that is shorter counts as that long: different vertices have a distance. */
  static constexpr float LeastLength = std::numeric_limits<float>::min();

  explicit vtkSurfaceGraph(const vtkTriangleSurface& surface);

  vtkIdType GetNumberOfVertices() const { return static_cast<vtkIdType>(this->Begins.size()) - 1; }

  ///@{
  /** Paths from a vertex. */
  const Path* BeginPaths(vtkIdType vertex) const
  {
    return this->Paths.data() + this->Begins[vertex];
  }
  const Path* EndPaths(vtkIdType vertex) const { return this->BeginPaths(vertex + 1); }
  ///@}

private:
  std::vector<std::size_t> Begins;
  std::vector<Path> Paths; // ordered by where they begin
};

/**
 * The nearest sources of every vertex, by Dijkstra's algorithm. Of equal distances, that
 * of the lesser id is the nearer.
 */
class vtkNearestSources
{
public:
  struct Source
  {
    float Distance;
    int Id; // -1: there is none
  };

  /** A vertex as far from a source as this. */
  struct Arrival
  {
    Source From;
    vtkIdType Vertex;
  };

  /** Keep up to `count` sources for each vertex. */
  vtkNearestSources(const vtkSurfaceGraph& graph, int count);

  /**
   * Add sources near these vertices. Costs what they change, O(n log n) for n pairs of a vertex and
   * a source.
   */
  void Add(const std::vector<Arrival>& starts);

  ///@{
  /** The sources of a vertex, nearest first. */
  const Source* Begin(vtkIdType vertex) const
  {
    return this->Sources.data() + vertex * this->Count;
  }
  const Source* End(vtkIdType vertex) const { return this->Begin(vertex + 1); }
  ///@}

private:
  bool Has(vtkIdType vertex, const Source& source) const;
  bool Improve(vtkIdType vertex, const Source& source);

  const vtkSurfaceGraph& Graph;
  int Count;
  std::vector<Source> Sources; // Count for each vertex
};

VTK_ABI_NAMESPACE_END
#endif
