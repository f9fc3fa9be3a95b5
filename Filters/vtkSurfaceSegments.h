// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSurfaceSegments
 * @brief   Divide surfaces into segments of nearly equal area, with neighbors and blending weights.
 *
 * The discretization of surfaces for opacity optimization: T. Guenther, H. Theisel, M. Gross,
 * "Decoupled opacity optimization for points, lines and surfaces", Computer Graphics Forum 36(2),
 * 2017, section
 * 5. A segment has one opacity; the opacities are smoothed over neighboring segments, and at a
 * vertex they are blended.
 *
 * Input: vtkPolyData with polygons or triangle strips, of any quality: several components,
 * borders, more than two triangles at an edge, triangles without area. Points at exactly the
 * same place count as one vertex; surfaces that share a vertex are one component. Vertices and
 * lines are left out.
 *
 * Output: vtkPolyData with triangles of which no two share a point: triangle t has the points
 * 3 t, 3 t + 1 and 3 t + 2, so that a renderer finds the other corners from one. The point data are
 * copied to every corner (normals too, if there are any, so that shading stays the same), the
 * cell data to every triangle; global ids of points are not copied, because they would not be
 * unique. A closed mesh has six times the points that it had. Added are
 *
 * - point data "SegmentIds", 4 components, vtkTypeInt32: the nearest segments of the point's
 *   component, nearest first. The first is the segment that the point belongs to. A component of
 *   fewer segments repeats the first;
 * - point data "SegmentWeights", 4 components, float: the weights of these segments at the point,
 *   not negative, with the sum 1; exactly the same for all copies of a vertex;
 * - field data "NumberOfSegments", one vtkTypeInt32;
 * - field data "SegmentArea", a double for each segment: a third of the triangles at each of its
 *   vertices, in square units of the coordinates. The sum is the area of the surface;
 * - field data "SegmentNeighbors", 8 components, vtkTypeInt32, for each segment: the geodesically
 *   nearest other segments of its component, nearest first; -1 where there are no more. A neighbor
 *   of a segment need not have that segment as a neighbor.
 *
 * Segments are the Voronoi cells of vertices of the surface, their samples: placed by
 * farthest-point sampling and then moved forty times to make the areas more equal, towards the
 * centroids of their cells (Lloyd's algorithm). The coefficient of variation of the areas on a
 * sphere is 0.05 with 100 vertices in a segment, 0.08 with 25 and 0.16 with 6; before moving it is
 * 0.16 or more. On a square, whose borders are harder, it is 0.07 instead of 0.40. Components have
 * segments in proportion to their area, at least one each, not more than they have vertices; ids of
 * a component are consecutive.
 *
 * Distances are those of the heat method (K. Crane,
 * C. Weischedel, M. Wardetzky, "Geodesics in heat", ACM Transactions on Graphics 32(5), 2013), with
 * Neumann conditions at borders, and are never below the straight line or above the shortest path
 * along edges and across pairs of triangles.
 *
 * The weights are those of R. Franke and G. Nielson (International Journal for Numerical Methods in
 * Engineering 15(11), 1980): with the distances d_1 <= d_2 <= ... of a vertex from the samples,
 *
 *     w_i = f_i / (f_1 + ... + f_4),    f_i = ((R - d_i) / (R d_i))^2,    R = (1 + 1e-6) d_5
 *
 * and R infinite where the component has fewer than five segments. They are continuous: a segment
 * that comes or goes among the nearest four does so with the weight 0. At a sample its own
 * segment has the weight 1.
 *
 * The result is the same, to the bit, for any number of threads.
 *
 * Cost: about 25 times the solution of two sparse systems that are factored once, whatever the
 * number of segments is. One core takes 3 s for 100,000 triangles, with 2 kB of memory for each;
 * factors and solutions use several.
 *
 * Warnings: points that are not finite (the triangles at them are left out), no triangle (an
 * empty output), or a system that cannot be factored (distances are then those of the shortest
 * paths above, some per cent too long).
 *
 * @par Reference
 * T. Guenther, H. Theisel, M. Gross: Decoupled Opacity Optimization for Points, Lines and
 * Surfaces. Computer Graphics Forum 36(2), 2017, section 5; for distances and weights the works
 * named above.
 *
 * @sa vtkTrajectorySegments
 */

#ifndef vtkSurfaceSegments_h
#define vtkSurfaceSegments_h

#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for corners

VTK_ABI_NAMESPACE_BEGIN

class vtkPoints;
class vtkTriangleSurface;

class VTKPELLUCIDFILTERS_EXPORT vtkSurfaceSegments : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceSegments* New();
  vtkTypeMacro(vtkSurfaceSegments, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Segments wanted in the whole data set, at least 1; components of little area may make them
   * more, few vertices fewer. Default is 400. Used if SegmentArea is 0.
   */
  vtkSetClampMacro(NumberOfSegments, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfSegments, int);
  ///@}

  ///@{
  /**
   * Area of a segment, in square units of the coordinates; data sets of different size are then
   * divided alike. 0 (the default) means to go by NumberOfSegments.
   */
  vtkSetClampMacro(SegmentArea, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SegmentArea, double);
  ///@}

protected:
  vtkSurfaceSegments() = default;
  ~vtkSurfaceSegments() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSurfaceSegments(const vtkSurfaceSegments&) = delete;
  void operator=(const vtkSurfaceSegments&) = delete;

  void WarnOfLoss(vtkPolyData* triangles, vtkPolyData* output);
  double GetTarget(const vtkTriangleSurface& surface) const;
  bool AddSegments(vtkPoints* points, const std::vector<vtkIdType>& corners, vtkPolyData* output);
  bool ReportProgress(double progress);

  int NumberOfSegments = 400;
  double SegmentArea = 0.0;
};

VTK_ABI_NAMESPACE_END
#endif
