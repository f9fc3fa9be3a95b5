// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOcclusionAvoidance
 * @brief   Fades fragments by what else is in their pixel, without an optimisation.
 *
 * An alternative to vtkOpacityOptimization that needs no segments and no smoothing over them, and
 * costs less; its parameters need more care (M. Bandle, Opacity-Based Rendering of Lagrangian
 * Particle Trajectories in Met.3D, 2016, sections 3.2 and 3.3.2). From the fragments of all actors
 * in a pixel come its
 *
 * - coverage C: their number;
 * - maximum importance M, in [0,1], and the depth D of the nearest fragment that has it;
 * - directional variance V = 1 - |sum of the tangents| / their number, in [0,1], over the fragments
 *   of lines that are faded so: 0 where all are parallel, and where there are none. Balls have no
 *   direction, nor has a segment at one end of which the radius is so large that its ball contains
 *   the other.
 *
 * The opacity of each fragment of importance g is multiplied by the global opacity, and by
 *
 * - mode Penalty: the penalty, where the fragment is in front: nearer than D, and less important
 *   than M;
 * - mode Weighting: 1 / (1 + (1 - g^lambda) (m M + c C + v V + d [in front])), equations 3.2
 * and 3.3 there.
 *
 * @par Reference
 * M. Bandle: Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D, 2016,
 * sections 3.2 and 3.3.2.
 *
 * @sa vtkImportanceDrivenOpacity vtkOpacityOptimization vtkExactTransparencyPass
 */

#ifndef vtkOcclusionAvoidance_h
#define vtkOcclusionAvoidance_h

#include "vtkImportanceDrivenOpacity.h"
#include "vtkPellucidRenderingModule.h" // for the export macro

VTK_ABI_NAMESPACE_BEGIN

class VTKPELLUCIDRENDERING_EXPORT vtkOcclusionAvoidance : public vtkImportanceDrivenOpacity
{
public:
  static vtkOcclusionAvoidance* New();
  vtkTypeMacro(vtkOcclusionAvoidance, vtkImportanceDrivenOpacity);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The two ways to find the factor, see above. */
  enum Modes
  {
    PENALTY = 0,
    WEIGHTING = 1
  };

  ///@{
  /** How the factor is found. Default is PENALTY. */
  vtkSetClampMacro(Mode, int, PENALTY, WEIGHTING);
  vtkGetMacro(Mode, int);
  void SetModeToPenalty() { this->SetMode(PENALTY); }
  void SetModeToWeighting() { this->SetMode(WEIGHTING); }
  ///@}

  ///@{
  /** Factor in [0,1] on what is in front of the most important fragment; 0 removes it. Default is
   * 0.25. */
  vtkSetClampMacro(Penalty, double, 0.0, 1.0);
  vtkGetMacro(Penalty, double);
  ///@}

  ///@{
  /** m, at least 0: how much the presence of something important fades. The source names no
   * defaults; that of all four weights here fades what is in front to a tenth, and leaves most of
   * the rest. Default is 1. */
  vtkSetClampMacro(ImportanceWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(ImportanceWeight, double);
  ///@}

  ///@{
  /** c, at least 0: how much each fragment of the pixel fades. Default is 0.02. */
  vtkSetClampMacro(CoverageWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(CoverageWeight, double);
  ///@}

  ///@{
  /** v, at least 0: how much lines of many directions fade. Default is 0.5. */
  vtkSetClampMacro(DirectionalVarianceWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(DirectionalVarianceWeight, double);
  ///@}

  ///@{
  /** d, at least 0: how much what is in front of the most important fragment fades. Default is 10.
   */
  vtkSetClampMacro(DepthWeight, double, 0.0, VTK_FLOAT_MAX);
  vtkGetMacro(DepthWeight, double);
  ///@}

  ///@{
  /** lambda, in [0.01, 100]: exponent of a fragment's own importance in mode Weighting; the greater
   * it is, the more of what is of medium importance fades. Default is 1. */
  vtkSetClampMacro(ImportanceExponent, double, 0.01, 100.0);
  vtkGetMacro(ImportanceExponent, double);
  ///@}

  ///@{
  /** Factor in [0,1] on all opacities, in both modes. Default is 1. */
  vtkSetClampMacro(GlobalOpacity, double, 0.0, 1.0);
  vtkGetMacro(GlobalOpacity, double);
  ///@}

  ///@{
  /**
   * Whether M and D are means over the 5 x 5 pixels around that have a fragment, which softens the
   * borders of what is faded (section 3.2.1 there); D is then a distance along the view direction.
   * Costs one more stage. Off by default.
   */
  vtkSetMacro(SmoothAttributes, bool);
  vtkGetMacro(SmoothAttributes, bool);
  vtkBooleanMacro(SmoothAttributes, bool);
  ///@}

protected:
  vtkOcclusionAvoidance() = default;
  ~vtkOcclusionAvoidance() override = default;

private:
  vtkOcclusionAvoidance(const vtkOcclusionAvoidance&) = delete;
  void operator=(const vtkOcclusionAvoidance&) = delete;

  int Mode = PENALTY;
  double Penalty = 0.25;
  double ImportanceWeight = 1.0;
  double CoverageWeight = 0.02;
  double DirectionalVarianceWeight = 0.5;
  double DepthWeight = 10.0;
  double ImportanceExponent = 1.0;
  double GlobalOpacity = 1.0;
  bool SmoothAttributes = false;
};

VTK_ABI_NAMESPACE_END
#endif
