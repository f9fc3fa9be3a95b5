// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOpacityOptimization
 * @brief   How an actor fades where it hides, or clutters, what is more important.
 *
 * Attach() it to an actor that a vtkExactTransparencyPass draws, and each fragment of the actor
 * gets the opacity that minimises, in its pixel, the energy of T. Guenther, H. Theisel and M.
 * Gross, Decoupled Opacity Optimization for Points, Lines and Surfaces (2017), equation 9:
 *
 *     opacity = 1 / (1 + (1 - g)^(2 lambda) (r sum of g^2 in front + q sum of g^2 behind))
 *
 * where g is the importance of the fragment, in [0,1], and the sums are over the fragments of all
 * actors that take part. Parameters belong to the fragment's own actor, so each actor may have its
 * own.
 *
 * Each segment of a line or patch of a surface takes the least opacity of its fragments; these are
 * smoothed along lines and surfaces and interpolated between the middles of the segments (section
 * 5 there). Data that has passed vtkTrajectorySegments or vtkSurfaceSegments brings its segments.
 * Other data is one segment, each part of composite data: it fades as a whole, to the least opacity
 * that any of its fragments has.
 *
 * Where all actors that take part have one and the same importance, nothing is to be preferred to
 * anything else, and nothing fades.
 *
 * The opacities do not depend on the distance of the camera beyond the sampling by pixels.
 *
 * @par Reference
 * T. Guenther, H. Theisel, M. Gross: Decoupled Opacity Optimization for Points, Lines and
 * Surfaces. Computer Graphics Forum 36(2), 2017, equation 9 and section 5.
 *
 * @sa vtkOcclusionAvoidance vtkExactTransparencyPass vtkImportance vtkTrajectorySegments
 * vtkSurfaceSegments
 */

#ifndef vtkOpacityOptimization_h
#define vtkOpacityOptimization_h

#include "vtkImportanceDrivenOpacity.h"
#include "vtkPellucidRenderingModule.h" // for the export macro

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDRENDERING_EXPORT vtkOpacityOptimization : public vtkImportanceDrivenOpacity
{
public:
  static vtkOpacityOptimization* New();
  vtkTypeMacro(vtkOpacityOptimization, vtkImportanceDrivenOpacity);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Settings with names. UsePreset() sets the four parameters below; another name is an error that
   * lists the known ones, changes nothing and gives false. In the order q, r, lambda, s:
   * - "clear-front": 400, 50, 4, 5, the defaults: what hides goes; pathways of trace gases (figure
   *   7). Of all, it showed what is important most clearly in data that none was chosen for;
   * - "balanced": 50, 100, 3, 5: more of the surroundings stays; clouds and streamlines (figure 6);
   * - "focus": 1000, 50, 3.5, 50: little but the important stays; a tornado (figure 10);
   * - "clear-back": 50, 400, 2, 15: a quiet background; knotted field lines (figure 8);
   * - "points": 200, 50, 3, 0: particles, which have no neighbours to smooth over (figure 11).
   * s is for the segments of lines. The patches of surfaces are larger, and all fade alike after
   * more than 5 steps, which `forSurfaces` limits s to.
   */
  static int GetNumberOfPresets();
  static const char* GetPresetName(int preset);
  bool UsePreset(const char* name, bool forSurfaces = false);
  ///@}

  ///@{
  /**
   * q, at least 0: fades what lies in front of something important. Default is 400. Published
   * settings are 50 to 1000.
   */
  vtkSetClampMacro(OcclusionWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(OcclusionWeight, double);
  ///@}

  ///@{
  /**
   * r, at least 0: fades what clutters the background of something important. Default is 50.
   * Published settings are 10 to 400.
   */
  vtkSetClampMacro(ClutterWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(ClutterWeight, double);
  ///@}

  ///@{
  /**
   * lambda, in [0.01, 100]: the greater it is, the more of what is of medium importance stays.
   * Default is 4. Published settings are 2 to 4.
   */
  vtkSetClampMacro(Emphasis, double, 0.01, 100.0);
  vtkGetMacro(Emphasis, double);
  ///@}

  ///@{
  /**
   * s, in [0, 10000]: steps of Laplacian smoothing of the opacities over neighbouring segments. In
   * each, a segment moves half of the way to the mean of its visible neighbours; the paper gives
   * no such factor. Default is 5. Published settings are 5 to 50.
   */
  vtkSetClampMacro(SmoothingIterations, int, 0, 10000);
  vtkGetMacro(SmoothingIterations, int);
  ///@}

  ///@{
  /**
   * Whether a segment may hide or clutter itself. Off (the default), of fragments of one segment
   * that follow one another in a pixel only the first counts.
   */
  vtkSetMacro(SelfOcclusion, bool);
  vtkGetMacro(SelfOcclusion, bool);
  vtkBooleanMacro(SelfOcclusion, bool);
  ///@}

protected:
  vtkOpacityOptimization() = default;
  ~vtkOpacityOptimization() override = default;

private:
  vtkOpacityOptimization(const vtkOpacityOptimization&) = delete;
  void operator=(const vtkOpacityOptimization&) = delete;

  double OcclusionWeight = 400.0;
  double ClutterWeight = 50.0;
  double Emphasis = 4.0;
  int SmoothingIterations = 5;
  bool SelfOcclusion = false;
};

VTK_ABI_NAMESPACE_END
#endif
