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
 * own. An actor without a vtkOpacityOptimization keeps its opacity, and counts as unimportant. The
 * optimised opacity multiplies the one that colour map and property give.
 *
 * Each segment of a line or patch of a surface takes the least opacity of its fragments; these are
 * smoothed along lines and surfaces and interpolated between the middles of the segments (section
 * 5 there). Data that has passed vtkTrajectorySegments or vtkSurfaceSegments brings its segments;
 * other lines and surfaces are one segment each, and each vertex is one.
 *
 * Where all actors that take part have one and the same importance, nothing is to be preferred to
 * anything else, and nothing fades.
 *
 * The opacities do not depend on the distance of the camera beyond the sampling by pixels.
 *
 * @sa vtkExactTransparencyPass vtkImportance vtkTrajectorySegments
 */

#ifndef vtkOpacityOptimization_h
#define vtkOpacityOptimization_h

#include "vtkObject.h"
#include "vtkPellucidRenderingModule.h" // for the export macro

VTK_ABI_NAMESPACE_BEGIN

class vtkActor;
class vtkInformationObjectBaseKey;
class vtkProp;

class VTKPELLUCIDRENDERING_EXPORT vtkOpacityOptimization : public vtkObject
{
public:
  static vtkOpacityOptimization* New();
  vtkTypeMacro(vtkOpacityOptimization, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Optimise the opacities of an actor from the next frame on, with these parameters; null ends it.
   * Several actors may share the parameters. The actor is drawn as a translucent one for that time
   * (vtkActor::ForceTranslucentOn()).
   */
  static void Attach(vtkActor* actor, vtkOpacityOptimization* optimization);

  /** The parameters of an actor; null where it takes no part. */
  static vtkOpacityOptimization* Get(vtkProp* prop);

  /** Where the parameters live: in vtkProp::GetPropertyKeys(). */
  static vtkInformationObjectBaseKey* KEY();

  ///@{
  /**
   * Name of the point array of one component that holds the importance in [0,1]; values outside are
   * clamped, and NaN counts as 0. Default is "Importance", as vtkImportance makes it. Data that
   * lacks it has importance 0, with a warning.
   */
  vtkSetStringMacro(ImportanceArray);
  vtkGetStringMacro(ImportanceArray);
  ///@}

  ///@{
  /**
   * q, at least 0: fades what lies in front of something important. Default is 50. Published
   * settings are 50 to 1000.
   */
  vtkSetClampMacro(OcclusionWeight, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(OcclusionWeight, double);
  ///@}

  ///@{
  /**
   * r, at least 0: fades what clutters the background of something important. Default is 100.
   * Published settings are 10 to 400.
   */
  vtkSetClampMacro(ClutterWeight, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ClutterWeight, double);
  ///@}

  ///@{
  /**
   * lambda, in [0.01, 100]: the greater it is, the more of what is of medium importance stays.
   * Default is 3. Published settings are 2 to 4.
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
  vtkOpacityOptimization();
  ~vtkOpacityOptimization() override;

private:
  vtkOpacityOptimization(const vtkOpacityOptimization&) = delete;
  void operator=(const vtkOpacityOptimization&) = delete;

  char* ImportanceArray = nullptr;
  double OcclusionWeight = 50.0;
  double ClutterWeight = 100.0;
  double Emphasis = 3.0;
  int SmoothingIterations = 5;
  bool SelfOcclusion = false;
};

VTK_ABI_NAMESPACE_END
#endif
