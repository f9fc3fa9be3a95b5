// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeatGeodesics
 * @brief   Geodesic distances on triangles by the heat method.
 *
 * Private to the module. K. Crane, C. Weischedel, M. Wardetzky, "Geodesics in heat", ACM
 * Transactions on Graphics 32(5), 2013, algorithm 1: heat flows from the sources for the time h^2,
 * h being the mean length of an edge; its gradient has the direction of the distance's, whose
 * length is 1; the function with that gradient solves Poisson's equation. Both systems are factored
 * once, and every set of sources costs one back-substitution in each.
 *
 * Borders have Neumann conditions: no heat leaves the surface. (The paper's mean with Dirichlet
 * conditions costs half as much again and changes distances close to borders only.)
 *
 * The triangles are those of vtkIntrinsicTriangulation. The Laplacian of finite elements is a sum
 * over triangles, whatever their number at an edge: it is positive semi-definite.
 *
 * @sa vtkSurfaceSegments
 */

#ifndef vtkHeatGeodesics_h
#define vtkHeatGeodesics_h

#include "vtkType.h"

#include "vtk_eigen.h" // for the matrices
#include VTK_EIGEN(Core)
#include VTK_EIGEN(SparseCholesky)
#include VTK_EIGEN(SparseCore)

#include <array>  // for corners
#include <vector> // for triangles

VTK_ABI_NAMESPACE_BEGIN
class vtkTriangleSurface;

class vtkHeatGeodesics
{
public:
  /** Set up and factor both systems. */
  explicit vtkHeatGeodesics(const vtkTriangleSurface& surface);

  /**
   * False if the systems could not be factored: Solve() must not be called then. No surface of
   * finite points is known that fails.
   */
  bool IsFactored() const;

  /**
   * A value for each vertex that increases with the distance from the nearest of the sources by as
   * much as the distance does: the difference from the value at that source is the distance,
   * in the units of the surface. Threads may call it at the same time.
   */
  Eigen::VectorXd Solve(const std::vector<vtkIdType>& sources) const;

private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Eigen::Index>;

  // A triangle, laid into a plane.
  struct Element
  {
    std::array<vtkIdType, 3> Vertices;
    Eigen::Matrix<double, 2, 3> Gradients; // of the functions that are 1 at one corner
    double Area;
    double Time; // for which heat flows
  };

  void Factor(const vtkTriangleSurface& surface);

  std::vector<Element> Elements;
  Eigen::SimplicialLDLT<Matrix> HeatFlow;
  Eigen::SimplicialLDLT<Matrix> Poisson;
};

VTK_ABI_NAMESPACE_END
#endif
