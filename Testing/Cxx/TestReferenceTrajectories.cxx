// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The reference against the picture that vtkTrajectoryMapper's shaders make of opaque trajectories:
 * both follow the same definition, but share no code. They agree to 1 of 255 away from edges, and
 * decide differently about few pixels at edges.
 */

#include "ReferenceComparison.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkReferenceRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTrajectoryMapper.h"

#include <cmath>
#include <functional>

namespace
{
/** Helices of `points` points each, with a radius and a scalar for each point, and some vertices.
 */
vtkSmartPointer<vtkPolyData> MakeHelices(int lines, int points)
{
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkCellArray> vertices;
  for (int line = 0; line < lines; ++line)
  {
    cells->InsertNextCell(points);
    for (int i = 0; i < points; ++i)
    {
      const double t = static_cast<double>(i) / (points - 1);
      const double angle = 9.0 * t + 2.4 * line;
      const double reach = 0.6 + 0.13 * (line % 7);
      cells->InsertCellPoint(positions->InsertNextPoint(
        reach * std::cos(angle), reach * std::sin(angle), 3.0 * t - 1.5 + 0.01 * line));
      radii->InsertNextValue(0.05 + 0.04 * std::sin(40.0 * t));
      heights->InsertNextValue(t);
    }
    vertices->InsertNextCell({ positions->GetNumberOfPoints() - 1 });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(positions);
  data->SetLines(cells);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->SetScalars(heights);
  return data;
}

/** Lines along which balls contain others: large in small, small in large, and both. */
vtkSmartPointer<vtkPolyData> MakeContainedBalls()
{
  const double values[][3] = { { -1.5, 0.5, 0 }, { -1.3, 0.2, 1 }, { -0.5, 0.2, 0 },
    { -0.4, 0.5, 1 }, { 0.8, 0.6, 0 }, { 1.0, 0.3, 1 }, { 1.1, 0.7, 0.5 } };
  const vtkIdType ends[] = { 0, 2, 4, 7 };
  vtkNew<vtkPoints> positions;
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  vtkNew<vtkDoubleArray> scalars;
  vtkNew<vtkCellArray> cells;
  for (int line = 0; line < 3; ++line)
  {
    cells->InsertNextCell(static_cast<int>(ends[line + 1] - ends[line]));
    for (vtkIdType i = ends[line]; i < ends[line + 1]; ++i)
    {
      cells->InsertCellPoint(positions->InsertNextPoint(values[i][0], 0.0, 0.1 * values[i][0]));
      radii->InsertNextValue(values[i][1]);
      scalars->InsertNextValue(values[i][2]);
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(positions);
  data->SetLines(cells);
  data->GetPointData()->AddArray(radii);
  data->GetPointData()->SetScalars(scalars);
  return data;
}

struct Scene
{
  Scene()
  {
    this->Mapper->SetInputData(MakeHelices(5, 60));
    this->Mapper->SetRadius(0.08);
    this->Mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->SetColor(0.8, 0.5, 0.3);
    this->Actor->GetProperty()->SetSpecular(0.3);
    this->Actor->GetProperty()->SetSpecularPower(15.0);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Renderer->ResetCamera();
    this->Camera()->Azimuth(25.0);
    this->Camera()->Elevation(65.0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(321, 240);
    this->Window->AddRenderer(this->Renderer);
  }

  vtkCamera* Camera() { return this->Renderer->GetActiveCamera(); }

  vtkNew<vtkTrajectoryMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void LookFromInside(Scene& scene)
{
  scene.Mapper->SetRadius(0.3);
  double point[3];
  scene.Mapper->GetInput()->GetPoint(20, point);
  double ahead[3];
  scene.Mapper->GetInput()->GetPoint(22, ahead);
  scene.Camera()->SetPosition(point);
  scene.Camera()->SetFocalPoint(ahead);
  scene.Camera()->SetViewAngle(60.0);
}

void Clip(Scene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.05, 0.1, 0.2);
  plane->SetNormal(1.0, -0.5, -0.8);
  scene.Mapper->AddClippingPlane(plane);
}
}

int TestReferenceTrajectories(int, char*[])
{
  const std::pair<const char*, std::function<void(Scene&)>> scenes[] = {
    { "tubes", [](Scene&) {} },
    { "radii from an array", [](Scene& s) { s.Mapper->SetRadiusArray("Radius"); } },
    { "automatic radius", [](Scene& s) { s.Mapper->SetRadius(0.0); } },
    { "parallel projection", [](Scene& s) { s.Camera()->ParallelProjectionOn(); } },
    { "colours of points", [](Scene& s) { s.Mapper->ScalarVisibilityOn(); } },
    { "colours from a texture",
      [](Scene& s)
      {
        s.Mapper->ScalarVisibilityOn();
        s.Mapper->InterpolateScalarsBeforeMappingOn();
      } },
    { "light kit",
      [](Scene& s)
      {
        vtkNew<vtkLightKit> kit;
        kit->AddLightsToRenderer(s.Renderer);
      } },
    { "scaled actor",
      [](Scene& s)
      {
        s.Actor->SetScale(1.0, 0.6, 1.5);
        s.Actor->RotateX(20.0);
      } },
    { "far from the origin",
      [](Scene& s)
      {
        s.Actor->SetPosition(6.4e6, -3.2e6, 1e5);
        const double* position = s.Camera()->GetPosition();
        s.Camera()->SetPosition(position[0] + 6.4e6, position[1] - 3.2e6, position[2] + 1e5);
        const double* focus = s.Camera()->GetFocalPoint();
        s.Camera()->SetFocalPoint(focus[0] + 6.4e6, focus[1] - 3.2e6, focus[2] + 1e5);
      } },
    { "balls in balls",
      [](Scene& s)
      {
        s.Mapper->SetInputData(MakeContainedBalls());
        s.Mapper->SetRadiusArray("Radius");
        s.Mapper->ScalarVisibilityOn();
      } },
    { "clipping plane", Clip },
    { "eye inside a tube", LookFromInside },
  };
  bool passed = true;
  for (const auto& [name, prepare] : scenes)
  {
    Scene scene;
    prepare(scene);
    scene.Renderer->ResetCameraClippingRange();
    passed &= ReferenceComparison(scene.Window, scene.Renderer).Passes(name);
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
