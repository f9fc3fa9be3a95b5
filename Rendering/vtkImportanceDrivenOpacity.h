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
   * Name of the point array of one component that holds the importance in [0,1]; values outside are
   * clamped, and NaN counts as 0. Default is "Importance", as vtkImportance makes it. Data that
   * lacks it has importance 0, with a warning.
   */
  vtkSetStringMacro(ImportanceArray);
  vtkGetStringMacro(ImportanceArray);
  ///@}

protected:
  vtkImportanceDrivenOpacity();
  ~vtkImportanceDrivenOpacity() override;

private:
  vtkImportanceDrivenOpacity(const vtkImportanceDrivenOpacity&) = delete;
  void operator=(const vtkImportanceDrivenOpacity&) = delete;

  char* ImportanceArray = nullptr;
};

VTK_ABI_NAMESPACE_END
#endif
