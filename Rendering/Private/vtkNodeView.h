// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNodeView
 * @brief   How a camera sees the nodes of trajectories: what leads from them to pixels.
 *
 * In double precision down to the eye, where the large numbers of coordinates far from the origin
 * cancel before they are rounded. Matrices are transposed, as VTK's key matrices are.
 */

#ifndef vtkNodeView_h
#define vtkNodeView_h

#include "vtkMatrix4x4.h" // for camera and actor
#include "vtkNew.h"
#include "vtkNodeGroups.h"

#include <array>

VTK_ABI_NAMESPACE_BEGIN

class vtkActor;
class vtkRenderer;
class vtkShaderProgram;
class vtkTrajectoryNodes;

class vtkNodeView
{
public:
  /** Take the renderer's camera, the place of the actor, and the viewport of OpenGL: render passes
   * may draw to something of another size than the renderer's. */
  void Update(const vtkTrajectoryNodes& nodes, vtkRenderer* renderer, vtkActor* actor);

  /** Whether the near plane may cut a tube or ball open. */
  bool MayCutOpen() const { return this->NearPlaneMeetsNodes; }

  /** What the shapes of groups follow from. */
  vtkNodeGroups::View GetGroupView() const;

  /** Hand all to glsl/vtkRoundedConeVS.glsl and the fragment shader behind it. */
  void SetShaderParameters(vtkShaderProgram* program) const;

  vtkMatrix4x4* GetWorldToView() const { return this->WorldToView; }

  /** Distance of the near plane. */
  double GetNearPlane() const { return this->NearPlane; }

private:
  /** The viewport's corners at a depth of clip coordinates, -1 to 1, in view coordinates. */
  std::array<std::array<double, 3>, 4> GetCorners(double depth) const;

  /** Whether the near plane's part of the view meets the nodes' bounding box, in view coordinates.
   */
  bool MeetsNearPlane(const vtkTrajectoryNodes& nodes) const;

  std::array<vtkNodeGroups::Plane, 6> GetFrustum() const;

  vtkNew<vtkMatrix4x4> WorldToView;
  vtkNew<vtkMatrix4x4> NodeToView;
  vtkNew<vtkMatrix4x4> ViewToClip;
  vtkNew<vtkMatrix4x4> ClipToView;
  std::array<float, 3> Origin{ { 0.0f, 0.0f, 0.0f } }; ///< near the eye, for nodes with remainders
  std::array<int, 4> Viewport{ { 0, 0, 1, 1 } };
  double NearPlane = 0.0;
  bool NearPlaneMeetsNodes = false;
  bool Parallel = false;
};

VTK_ABI_NAMESPACE_END
#endif
