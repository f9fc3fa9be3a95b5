// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNodeView.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLError.h" // and the OpenGL loader, whose header differs between VTK versions
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTrajectoryNodes.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// A homogeneous point by a transposed matrix.
std::array<double, 3> TransformPoint(const double point[4], const vtkMatrix4x4* transposed)
{
  std::array<double, 4> sum{};
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      sum[j] += point[i] * transposed->GetElement(i, j);
    }
  }
  return { { sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3] } };
}

// Coefficients of the plane whose value at a point of view coordinates is that clip coordinate.
std::array<double, 4> ClipRow(const vtkMatrix4x4* viewToClip, int column)
{
  std::array<double, 4> row;
  for (int i = 0; i < 4; ++i)
  {
    row[i] = viewToClip->GetElement(i, column);
  }
  return row;
}

// From window coordinates to the point of the near plane, transposed.
void ComputePixelToView(
  const std::array<int, 4>& viewport, const vtkMatrix4x4* clipToView, vtkMatrix4x4* pixelToView)
{
  vtkNew<vtkMatrix4x4> pixelToClip;
  for (int i = 0; i < 2; ++i)
  {
    pixelToClip->SetElement(i, i, 2.0 / viewport[2 + i]);
    pixelToClip->SetElement(3, i, -1.0 - 2.0 * viewport[i] / viewport[2 + i]);
  }
  pixelToClip->SetElement(3, 2, -1.0);
  vtkMatrix4x4::Multiply4x4(pixelToClip, clipToView, pixelToView);
}
}

//------------------------------------------------------------------------------
void vtkNodeView::Update(const vtkTrajectoryNodes& nodes, vtkRenderer* renderer, vtkActor* actor)
{
  auto* camera = static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera());
  vtkMatrix4x4* worldToView;
  vtkMatrix4x4* worldToClip;
  vtkMatrix4x4* viewToClip;
  vtkMatrix3x3* normals;
  camera->GetKeyMatrices(renderer, worldToView, normals, viewToClip, worldToClip);
  vtkMatrix4x4* dataToWorld;
  static_cast<vtkOpenGLActor*>(actor)->GetKeyMatrices(dataToWorld, normals);

  vtkNew<vtkMatrix4x4> nodeToData;
  for (int i = 0; i < 3; ++i)
  {
    nodeToData->SetElement(3, i, nodes.GetCenter()[i]);
  }
  vtkMatrix4x4::Multiply4x4(nodeToData, dataToWorld, this->NodeToView);
  vtkMatrix4x4::Multiply4x4(this->NodeToView, worldToView, this->NodeToView);
  this->Origin = { { 0.0f, 0.0f, 0.0f } };
  if (!nodes.GetRemainders().empty())
  {
    const double eye[4] = { 0.0, 0.0, 0.0, 1.0 };
    vtkNew<vtkMatrix4x4> viewToNode;
    vtkMatrix4x4::Invert(this->NodeToView, viewToNode);
    const std::array<double, 3> origin = TransformPoint(eye, viewToNode);
    std::copy(origin.begin(), origin.end(), this->Origin.begin());
  }
  this->WorldToView->DeepCopy(worldToView);
  this->ViewToClip->DeepCopy(viewToClip);
  vtkMatrix4x4::Invert(viewToClip, this->ClipToView);
  static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport.data());
  this->NearPlane = camera->GetClippingRange()[0];
  this->Parallel = camera->GetParallelProjection() != 0;
  this->NearPlaneMeetsNodes = this->MeetsNearPlane(nodes);
}

//------------------------------------------------------------------------------
std::array<std::array<double, 3>, 4> vtkNodeView::GetCorners(double depth) const
{
  std::array<std::array<double, 3>, 4> corners;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double clip[4] = { corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, depth, 1.0 };
    corners[corner] = TransformPoint(clip, this->ClipToView);
  }
  return corners;
}

//------------------------------------------------------------------------------
bool vtkNodeView::MeetsNearPlane(const vtkTrajectoryNodes& nodes) const
{
  vtkBoundingBox nearPlane;
  for (std::array<double, 3>& corner : this->GetCorners(-1.0))
  {
    nearPlane.AddPoint(corner.data());
  }
  vtkBoundingBox trajectories;
  for (int corner = 0; corner < 8; ++corner)
  {
    double node[4] = { 0.0, 0.0, 0.0, 1.0 };
    nodes.GetPointBounds().GetCorner(corner, node);
    vtkMath::Subtract(node, nodes.GetCenter().data(), node);
    trajectories.AddPoint(TransformPoint(node, this->NodeToView).data());
  }
  trajectories.Inflate(nodes.GetMaximumRadius());
  return trajectories.Intersects(nearPlane);
}

//------------------------------------------------------------------------------
std::array<vtkNodeGroups::Plane, 6> vtkNodeView::GetFrustum() const
{
  const std::array<double, 4> w = ClipRow(this->ViewToClip, 3);
  std::array<vtkNodeGroups::Plane, 6> frustum;
  for (int i = 0; i < 6; ++i)
  {
    const std::array<double, 4> row = ClipRow(this->ViewToClip, i / 2);
    vtkNodeGroups::Plane& plane = frustum[i];
    for (int j = 0; j < 4; ++j)
    {
      plane[j] = w[j] + (i % 2 ? row[j] : -row[j]);
    }
    const double norm = std::hypot(plane[0], plane[1], plane[2]);
    for (double& coefficient : plane)
    {
      coefficient = norm > 0.0 ? coefficient / norm : 0.0;
    }
  }
  return frustum;
}

//------------------------------------------------------------------------------
vtkNodeGroups::View vtkNodeView::GetGroupView() const
{
  vtkNodeGroups::View view;
  view.NodeToView = this->NodeToView;
  view.Frustum = this->GetFrustum();
  view.Parallel = this->Parallel;
  const std::array<double, 4> w = ClipRow(this->ViewToClip, 3);
  const double scale = this->Parallel ? w[3] : std::hypot(w[0], w[1], w[2]);
  for (int i = 0; i < 2; ++i)
  {
    const std::array<double, 4> row = ClipRow(this->ViewToClip, i);
    view.PixelsPerUnit = std::max(
      view.PixelsPerUnit, 0.5 * this->Viewport[2 + i] * std::hypot(row[0], row[1], row[2]) / scale);
  }
  for (const std::array<double, 3>& corner : this->GetCorners(0.0))
  {
    view.LargestSlope =
      std::max(view.LargestSlope, std::hypot(corner[0], corner[1]) / std::abs(corner[2]));
  }
  return view;
}

//------------------------------------------------------------------------------
void vtkNodeView::SetShaderParameters(vtkShaderProgram* program) const
{
  const double origin[4] = { this->Origin[0], this->Origin[1], this->Origin[2], 1.0 };
  const std::array<double, 3> originVC = TransformPoint(origin, this->NodeToView);
  vtkNew<vtkMatrix4x4> originToView;
  originToView->DeepCopy(this->NodeToView);
  for (int i = 0; i < 3; ++i)
  {
    originToView->SetElement(3, i, originVC[i]);
  }
  vtkNew<vtkMatrix4x4> pixelToView;
  ComputePixelToView(this->Viewport, this->ClipToView, pixelToView);
  program->SetUniformMatrix("nodeVCMatrix", originToView);
  program->SetUniformMatrix("VCDCMatrix", this->ViewToClip);
  program->SetUniformMatrix("pixelVCMatrix", pixelToView);
  program->SetUniformf("perspective", this->Parallel ? 0.0f : 1.0f);

  const std::array<vtkNodeGroups::Plane, 6> planes = this->GetFrustum();
  float frustum[6][4];
  for (int i = 0; i < 6; ++i)
  {
    std::copy(planes[i].begin(), planes[i].end(), frustum[i]);
  }
  program->SetUniform4fv("frustumVC", 6, frustum);

  if (program->IsUniformUsed("nodeOrigin"))
  {
    program->SetUniform3f("nodeOrigin", this->Origin.data());
  }
  if (program->IsUniformUsed("viewportSize"))
  {
    const float size[2] = { static_cast<float>(this->Viewport[2]),
      static_cast<float>(this->Viewport[3]) };
    program->SetUniform2f("viewportSize", size);
  }
}

VTK_ABI_NAMESPACE_END
