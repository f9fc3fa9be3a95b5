// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneCamera.h"

#include "RenderOptions.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace pellucid
{
namespace
{
constexpr double AzimuthDegrees = 30.0;   // off the axis across the longer horizontal side
constexpr double ElevationDegrees = 25.0; // above the horizon
constexpr double FilledShare = 0.94;      // of the picture's width or height

struct View
{
  Vector3 Direction; // from the scene to the camera, unit length
  Vector3 Up;
};

//------------------------------------------------------------------------------
View ChooseView(const vtkBoundingBox& box)
{
  const double flat = 1e-3 * box.GetMaxLength();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (box.GetLength(axis) < flat)
    {
      View view{ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 } };
      view.Direction[axis] = axis == 1 ? -1.0 : 1.0;
      view.Up[axis == 2 ? 1 : 2] = 1.0;
      return view;
    }
  }
  const bool xAcross = box.GetLength(0) >= box.GetLength(1);
  const double azimuth = vtkMath::RadiansFromDegrees(AzimuthDegrees + (xAcross ? -90.0 : 0.0));
  const double elevation = vtkMath::RadiansFromDegrees(ElevationDegrees);
  return { { std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
             std::sin(elevation) },
    { 0.0, 0.0, 1.0 } };
}

//------------------------------------------------------------------------------
// Greatest distance of the box's corners from the middle of the picture, 1 being its edge.
double GetExtentInPicture(vtkCamera* camera, const vtkBoundingBox& box, double aspect)
{
  vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  double extent = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double position[4] = { 0.0, 0.0, 0.0, 1.0 };
    box.GetCorner(corner, position);
    matrix->MultiplyPoint(position, position);
    extent = std::max(
      { extent, std::abs(position[0] / position[3]), std::abs(position[1] / position[3]) });
  }
  return extent;
}

//------------------------------------------------------------------------------
// Move the camera along its view direction until the box fills the picture.
void Approach(vtkCamera* camera, const vtkBoundingBox& box, double aspect)
{
  // A dolly changes the perspective, so that a step does not reach the goal at once.
  constexpr int steps = 8;
  for (int step = 0; step < steps; ++step)
  {
    const double extent = GetExtentInPicture(camera, box, aspect);
    if (extent > 0.0)
    {
      camera->Dolly(std::clamp(FilledShare / extent, 0.5, 2.0));
    }
  }
}
}

//------------------------------------------------------------------------------
void SetUpCamera(vtkRenderer* renderer, const RenderOptions& options, double aspect)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkBoundingBox box(renderer->ComputeVisiblePropBounds());
  if (!box.IsValid())
  {
    return;
  }

  const View view = ChooseView(box);
  Vector3 center;
  box.GetCenter(center.data());
  const Vector3 focalPoint = options.FocalPoint.value_or(center);
  Vector3 position;
  for (int i = 0; i < 3; ++i)
  {
    position[i] = focalPoint[i] + 2.0 * box.GetDiagonalLength() * view.Direction[i];
  }
  camera->SetFocalPoint(focalPoint.data());
  camera->SetPosition(options.CameraPosition.value_or(position).data());
  camera->SetViewUp(options.ViewUp.value_or(view.Up).data());
  if (options.ParallelScale > 0.0)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(options.ParallelScale);
  }
  else if (!options.CameraPosition)
  {
    Approach(camera, box, aspect);
  }
  renderer->ResetCameraClippingRange();
}
}
