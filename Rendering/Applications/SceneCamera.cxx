// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneCamera.h"

#include "RenderError.h"
#include "RenderScene.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pellucid
{
namespace
{
constexpr double AzimuthDegrees = 30.0;   // off the axis across the longer horizontal side
constexpr double ElevationDegrees = 25.0; // above the horizon
constexpr double FilledShare = 0.92;      // of the picture's width or height

struct View
{
  Vector3 Direction; // from the scene to the camera, unit length
  Vector3 Up;
};

//------------------------------------------------------------------------------
// With z up; other axes take the places of x, y and z in cyclic order.
View ChooseView(const vtkBoundingBox& box, int upAxis)
{
  const auto toWorld = [upAxis](const Vector3& vector)
  {
    Vector3 world;
    for (int axis = 0; axis < 3; ++axis)
    {
      world[(upAxis + 1 + axis) % 3] = vector[axis];
    }
    return world;
  };
  const auto length = [&box, upAxis](int axis) { return box.GetLength((upAxis + 1 + axis) % 3); };

  const double flat = 1e-3 * box.GetMaxLength();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (length(axis) < flat)
    {
      Vector3 direction = { 0.0, 0.0, 0.0 };
      Vector3 up = { 0.0, 0.0, 0.0 };
      direction[axis] = axis == 1 ? -1.0 : 1.0;
      up[axis == 2 ? 1 : 2] = 1.0;
      return { toWorld(direction), toWorld(up) };
    }
  }
  const bool xAcross = length(0) >= length(1);
  const double azimuth = vtkMath::RadiansFromDegrees(AzimuthDegrees + (xAcross ? -90.0 : 0.0));
  const double elevation = vtkMath::RadiansFromDegrees(ElevationDegrees);
  return { toWorld({ std::cos(elevation) * std::cos(azimuth),
             std::cos(elevation) * std::sin(azimuth), std::sin(elevation) }),
    toWorld({ 0.0, 0.0, 1.0 }) };
}

//------------------------------------------------------------------------------
// Coordinates along three axes of the picture: to the right, up, and towards the camera.
class PictureAxes
{
public:
  explicit PictureAxes(const Vector3& towardsCamera, const Vector3& up)
  {
    this->Axes[2] = towardsCamera;
    vtkMath::Cross(up.data(), towardsCamera.data(), this->Axes[0].data());
    vtkMath::Normalize(this->Axes[0].data());
    vtkMath::Cross(this->Axes[2].data(), this->Axes[0].data(), this->Axes[1].data());
  }

  Vector3 ToPicture(const double world[3]) const
  {
    return { vtkMath::Dot(world, this->Axes[0].data()), vtkMath::Dot(world, this->Axes[1].data()),
      vtkMath::Dot(world, this->Axes[2].data()) };
  }

  Vector3 ToWorld(const Vector3& picture) const
  {
    Vector3 world = { 0.0, 0.0, 0.0 };
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int i = 0; i < 3; ++i)
      {
        world[i] += picture[axis] * this->Axes[axis][i];
      }
    }
    return world;
  }

private:
  std::array<Vector3, 3> Axes;
};

//------------------------------------------------------------------------------
template <typename Visitor>
void VisitPoints(const Scene& scene, const Visitor& visit)
{
  for (const Drawable& drawable : scene.Drawables)
  {
    for (vtkPolyData* leaf : drawable.GetLeaves())
    {
      for (vtkIdType id = 0; id < leaf->GetNumberOfPoints(); ++id)
      {
        double point[3];
        leaf->GetPoint(id, point);
        if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
        {
          visit(point);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// The nearest position of a camera, in coordinates of the picture, from which all points lie in a
// frustum with these tangents of half its angles. Each side plane of the frustum is pushed against
// the points; of the two pairs of planes, the one that needs the larger distance decides.
Vector3 FitPosition(const Scene& scene, const PictureAxes& axes, const double tangents[2])
{
  constexpr double none = std::numeric_limits<double>::lowest();
  double reach[2][2] = { { none, none }, { none, none } };
  VisitPoints(scene,
    [&](const double* point)
    {
      const Vector3 position = axes.ToPicture(point);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double depth = tangents[axis] * position[2];
        reach[axis][0] = std::max(reach[axis][0], depth - position[axis]);
        reach[axis][1] = std::max(reach[axis][1], depth + position[axis]);
      }
    });
  Vector3 camera;
  for (int axis = 0; axis < 2; ++axis)
  {
    camera[axis] = 0.5 * (reach[axis][1] - reach[axis][0]);
  }
  camera[2] = std::max(0.5 * (reach[0][0] + reach[0][1]) / tangents[0],
    0.5 * (reach[1][0] + reach[1][1]) / tangents[1]);
  return camera;
}

//------------------------------------------------------------------------------
void CheckOrientation(const Vector3& position, const Vector3& focalPoint, const Vector3& up)
{
  Vector3 direction;
  vtkMath::Subtract(focalPoint, position, direction);
  if (vtkMath::Normalize(direction.data()) == 0.0)
  {
    throw RenderError("--camera-position: is the focal point; the camera needs a direction");
  }
  Vector3 right;
  vtkMath::Cross(direction.data(), up.data(), right.data());
  if (vtkMath::Norm(right.data()) <= 1e-9 * vtkMath::Norm(up.data()))
  {
    throw RenderError("--view-up: must not be 0,0,0 or the direction in which the camera looks");
  }
}
}

//------------------------------------------------------------------------------
void SetUpCamera(
  vtkRenderer* renderer, const Scene& scene, const RenderOptions& options, double aspect)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkBoundingBox box;
  VisitPoints(scene, [&box](const double* point) { box.AddPoint(point[0], point[1], point[2]); });
  const View view = ChooseView(box, options.UpAxis);
  const PictureAxes axes(view.Direction, view.Up);
  const double tangent =
    FilledShare * std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  const double tangents[2] = { tangent * aspect, tangent };

  Vector3 position = FitPosition(scene, axes, tangents);
  Vector3 focalPoint;
  box.GetCenter(focalPoint.data());
  Vector3 middle = axes.ToPicture(focalPoint.data());
  // One point fits any camera; keep a distance that does not vanish.
  position[2] = std::max(position[2], middle[2] + 1e-3 * std::max(1.0, box.GetDiagonalLength()));
  middle[0] = position[0];
  middle[1] = position[1];

  position = options.CameraPosition.value_or(axes.ToWorld(position));
  focalPoint = options.FocalPoint.value_or(axes.ToWorld(middle));
  const Vector3 up = options.ViewUp.value_or(view.Up);
  CheckOrientation(position, focalPoint, up);
  camera->SetPosition(position.data());
  camera->SetFocalPoint(focalPoint.data());
  camera->SetViewUp(up.data());
  if (options.ParallelScale > 0.0)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(options.ParallelScale);
  }
  renderer->ResetCameraClippingRange();
}
}
