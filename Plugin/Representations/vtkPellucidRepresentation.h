// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPellucidRepresentation
 * @brief   ParaView's representation "Pellucid": trajectories as tubes, transparency exact.
 *
 * Lines are drawn as tubes and vertices as spheres by vtkTrajectoryMapper, polygons as always.
 * Colouring, opacity, lighting, blocks, selection and delivery of data are those of the superclass.
 *
 * A render view that shows at least one visible representation of this kind draws all its
 * translucent geometry exactly, that of other representations too: its renderer is installed by
 * vtkTransparencyInstaller when the first of them becomes visible, and given back to ParaView when
 * the last one is hidden or removed.
 *
 * @sa vtkTrajectoryMapper vtkTransparencyInstaller
 */

#ifndef vtkPellucidRepresentation_h
#define vtkPellucidRepresentation_h

#include "vtkGeometryRepresentationWithFaces.h"
#include "vtkPellucidRepresentationsModule.h" // for the export macro
#include "vtkWeakPointer.h"                   // for the view

VTK_ABI_NAMESPACE_BEGIN

class vtkPVRenderView;

class VTKPELLUCIDREPRESENTATIONS_EXPORT vtkPellucidRepresentation
  : public vtkGeometryRepresentationWithFaces
{
public:
  static vtkPellucidRepresentation* New();
  vtkTypeMacro(vtkPellucidRepresentation, vtkGeometryRepresentationWithFaces);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Radius of tubes and spheres in world units, >= 0; 0 (default): chosen from the extent of the
   * data and the number of lines. */
  void SetRadius(double radius);

  /** Point array with one component that holds the radius in world units; empty (default): the
   * constant Radius. */
  void SetRadiusArray(const char* name);

  void SetVisibility(bool visible) override;

protected:
  vtkPellucidRepresentation();
  ~vtkPellucidRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkPellucidRepresentation(const vtkPellucidRepresentation&) = delete;
  void operator=(const vtkPellucidRepresentation&) = delete;

  // Whether the view shows another representation of this kind.
  void UpdateTransparency();

  vtkWeakPointer<vtkPVRenderView> View;
};

VTK_ABI_NAMESPACE_END
#endif
