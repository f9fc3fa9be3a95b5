// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImportanceDrivenOpacity
 * @brief   How the opacity of an actor follows from what is important in the view.
 *
 * The parameters of one way to fade what hides more important things, in a renderer that a
 * vtkExactTransparencyPass draws. Attach() gives them to an actor; several actors may share them,
 * and each actor may have its own, of any kind. The opacity found multiplies the one that colour
 * map, property and opacity array give. An actor without parameters keeps its opacity, and counts
 * as unimportant.
 *
 * @par Reference
 * None: an interface; those of its subclasses.
 *
 * @sa vtkOpacityOptimization vtkOcclusionAvoidance vtkImportance vtkExactTransparencyPass
 */

#ifndef vtkImportanceDrivenOpacity_h
#define vtkImportanceDrivenOpacity_h

#include "vtkObject.h"
#include "vtkPellucidRenderingModule.h" // for the export macro

VTK_ABI_NAMESPACE_BEGIN

class vtkActor;
class vtkInformationObjectBaseKey;
class vtkProp;

class VTKPELLUCIDRENDERING_EXPORT vtkImportanceDrivenOpacity : public vtkObject
{
public:
  vtkTypeMacro(vtkImportanceDrivenOpacity, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Find the opacities of an actor so from the next frame on; null ends it. The actor is drawn as a
   * translucent one for that time: vtkActor::SetForceTranslucent() is set to on, and to off when it
   * ends. Parts of a vtkAssembly cannot have it: VTK gives them the keys of the assembly.
   */
  static void Attach(vtkActor* actor, vtkImportanceDrivenOpacity* parameters);

  /** The parameters of an actor; null where it has none. */
  static vtkImportanceDrivenOpacity* Get(vtkProp* prop);

  /** Where the parameters live: in vtkProp::GetPropertyKeys(). */
  static vtkInformationObjectBaseKey* KEY();

  ///@{
  /**
   * Name of the point array of one component that importance follows from, over ImportanceRange.
   * Default is "Importance", as vtkImportance makes it. Data that lacks it has importance 0, with a
   * warning.
   */
  vtkSetStringMacro(ImportanceArray);
  vtkGetStringMacro(ImportanceArray);
  ///@}

  ///@{
  /**
   * The values of the importance array that mean importance 0 and 1; between them it changes
   * linearly, outside it is moved to the nearer end. Default is (0, 1). The first may be the
   * greater one: then small values are important. Where both are equal, importance is 1 from that
   * value on, else 0. NaN in the data counts as 0. While an end of the range is NaN or infinite,
   * nothing is important.
   *
   * Importance is found at the points and interpolated between them. A change takes one frame,
   * which draws the actor anew without running its pipeline. Surfaces hold values and range in
   * single precision: a range should be no narrower than 1e-4 of the values in it.
   */
  vtkSetVector2Macro(ImportanceRange, double);
  vtkGetVector2Macro(ImportanceRange, double);
  ///@}

protected:
  vtkImportanceDrivenOpacity();
  ~vtkImportanceDrivenOpacity() override;

private:
  vtkImportanceDrivenOpacity(const vtkImportanceDrivenOpacity&) = delete;
  void operator=(const vtkImportanceDrivenOpacity&) = delete;

  char* ImportanceArray = nullptr;
  double ImportanceRange[2] = { 0.0, 1.0 };
};

VTK_ABI_NAMESPACE_END
#endif
