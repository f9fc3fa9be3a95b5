// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGlobalOpacitySolver
 * @brief   The opacities of segments that clear the view, by one global least-squares problem.
 *
 * The ancestor of decoupled opacity optimisation, as a reference for it: T. Guenther, H. Theisel
 * and M. Gross, "Decoupled Opacity Optimization for Points, Lines and Surfaces", Computer Graphics
 * Forum 36(2), 2017, eqs. 1 to 4. The opacities alpha_i in [0,1] of the segments i = 1..n minimise
 *
 *   E = sum_i [ (alpha_i - 1)^2
 *             + q sum_j (alpha_i (1 - g_i)^lambda h_ij g_j)^2
 *             + r sum_j (alpha_i (1 - g_i)^lambda h_ji g_j)^2
 *             + s sum_j a_ij (alpha_i - alpha_j)^2 / 2 ] / 2
 *
 * with the importance g_i in [0,1] of a segment, the occlusion degrees h_ij, and a_ij = 1 where
 * segment j is a neighbour of segment i, else 0.
 *
 * The occlusion degree h_ij is the number of pixels in which a fragment of segment i is in front of
 * one of segment j; however many there are, the pixel counts once, and where the two lie
 * in front of each other it counts for both h_ij and h_ji. h_ii is 0. The degrees grow with the
 * size of the image, so that q and r depend on it and on the distance of the camera.
 *
 * E is quadratic, and its Hessian H (symmetric, of non-positive off-diagonal elements, the row sums
 * 1 + d_i with d_i >= 0) is an M-matrix, whose inverse has no negative element. Hence alpha = H^-1
 * 1 is above 0 and 1 - alpha = H^-1 d is not below 0: the bounds are never active, and one sparse
 * Cholesky factorisation (Eigen) solves the bounded problem. GetResidual() verifies that.
 *
 * A segment without a fragment hides nothing; its opacity is 1, or between its neighbours' and 1.
 *
 * The same input gives the same bits, with any number of threads. The cost is that of walking, for
 * each segment in each pixel, over the rest of the pixel's list, and of the factorisation, which is
 * linear in the segments for lines. The memory, beside the input, is about 16 bytes for each
 * fragment and 400 for each segment; the degrees themselves are not kept.
 *
 * Errors, each with a message and without opacities: no importance, or not of one component; an
 * importance that is NaN; no pixel lists; neighbours for another number of segments; cells that
 * contradict themselves, or name a segment that does not exist.
 *
 * @par Reference
 * T. Guenther, H. Theisel, M. Gross: Decoupled Opacity Optimization for Points, Lines and
 * Surfaces. Computer Graphics Forum 36(2), 2017, equations 1 to 4.
 */

#ifndef vtkGlobalOpacitySolver_h
#define vtkGlobalOpacitySolver_h

#include "vtkObject.h"
#include "vtkPellucidFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"          // for the arrays

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataArray;
class vtkDoubleArray;

class VTKPELLUCIDFILTERS_EXPORT vtkGlobalOpacitySolver : public vtkObject
{
public:
  static vtkGlobalOpacitySolver* New();
  vtkTypeMacro(vtkGlobalOpacitySolver, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Importance of each segment: n tuples of one component, moved to the nearer end of [0,1] where
   * it is outside. */
  void SetImportance(vtkDataArray* importance);
  vtkDataArray* GetImportance();
  ///@}

  ///@{
  /** The segments (0..n-1) of the fragments of each pixel, front to back: one cell for each pixel,
   * which may be empty; pixels without a fragment may be left out. */
  void SetPixelLists(vtkCellArray* lists);
  vtkCellArray* GetPixelLists();
  ///@}

  ///@{
  /** The neighbours of each segment: n cells, such as of two segments along a line, or eight on a
   * surface. Naming a neighbour twice, or the segment itself, changes nothing; one that does not
   * name the segment in return counts half. None, the default, means that no segment has any. */
  void SetNeighbors(vtkCellArray* neighbors);
  vtkCellArray* GetNeighbors();
  ///@}

  ///@{
  /** q: how much it counts to hide important segments. Default 50. */
  vtkSetClampMacro(OcclusionWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(OcclusionWeight, double);
  ///@}

  ///@{
  /** r: how much it counts to lie behind important segments. Default 0. */
  vtkSetClampMacro(BackgroundWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(BackgroundWeight, double);
  ///@}

  ///@{
  /** lambda: emphasis of the important, in [0.001, 1000]. Default 1. */
  vtkSetClampMacro(Emphasis, double, 1e-3, 1e3);
  vtkGetMacro(Emphasis, double);
  ///@}

  ///@{
  /** s: how much neighbours are to have the same opacity. Default 1. The relative error of the
   * opacities is at most about 1e-15 times s, and times the greatest number of neighbours. */
  vtkSetClampMacro(Smoothness, double, 0.0, 1e6);
  vtkGetMacro(Smoothness, double);
  ///@}

  /** Solve the problem as it is now. Everything below belongs to the last call. Returns whether it
   * succeeded. */
  bool Solve();

  /** The opacity of each segment, n tuples in [0,1]; empty before the first call and after an
   * error. */
  vtkDoubleArray* GetOpacity();

  /**
   * How far the opacities are from the optimality conditions (Karush, Kuhn and Tucker): the
   * greatest |dE/dalpha_i|, of those that point into the bounds at an opacity of 0 or 1, relative
   * to the sum of the magnitudes of the derivative's terms. Rounding leaves about 1e-15.
   */
  vtkGetMacro(Residual, double);

protected:
  vtkGlobalOpacitySolver();
  ~vtkGlobalOpacitySolver() override;

private:
  vtkGlobalOpacitySolver(const vtkGlobalOpacitySolver&) = delete;
  void operator=(const vtkGlobalOpacitySolver&) = delete;

  bool CheckImportance();
  bool CheckSegments(const char* name, const char* cell, vtkCellArray* cells);

  vtkSmartPointer<vtkDataArray> Importance;
  vtkSmartPointer<vtkCellArray> PixelLists;
  vtkSmartPointer<vtkCellArray> Neighbors;
  double OcclusionWeight = 50.0;
  double BackgroundWeight = 0.0;
  double Emphasis = 1.0;
  double Smoothness = 1.0;
  vtkSmartPointer<vtkDoubleArray> Opacity;
  double Residual = 0.0;
};

VTK_ABI_NAMESPACE_END
#endif
