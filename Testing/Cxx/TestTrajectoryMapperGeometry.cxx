// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The depth of every pixel of vtkTrajectoryMapper against a search in double precision.

#include "TrajectoryReference.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkTrajectoryMapper.h"

#include <cstdlib>
#include <string>

namespace
{
using Vector = TrajectoryReference::Vector;
using Point = std::array<double, 4>; // coordinates and radius
using Lines = std::vector<std::vector<Point>>;

struct Scene
{
  std::string Name;
  Lines Data;
  Vector Eye;
  Vector Focus{ { 0, 0, 0 } };
  double ViewAngle = 30.0;
  double ParallelScale = 0.0; // 0: perspective
  Vector ActorScale{ { 1, 1, 1 } };
  Vector Offset{ { 0, 0, 0 } };     // of data and camera
  Vector ClipNormal{ { 0, 0, 0 } }; // of a plane through the origin; 0: none
  double Near = 0.0;                // 0: as the renderer finds it
  double Tolerance = 1e-6;          // of the depth
};

bool Check(const Scene& scene)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("radius");
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> vertices;
  for (const auto& line : scene.Data)
  {
    vtkCellArray* cells = line.size() == 1 ? vertices : lines;
    cells->InsertNextCell(static_cast<vtkIdType>(line.size()));
    for (const Point& p : line)
    {
      cells->InsertCellPoint(points->InsertNextPoint(
        p[0] + scene.Offset[0], p[1] + scene.Offset[1], p[2] + scene.Offset[2]));
      radii->InsertNextValue(p[3]);
    }
  }
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->GetPointData()->AddArray(radii);

  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadiusArray("radius");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetScale(scene.ActorScale[0], scene.ActorScale[1], scene.ActorScale[2]);
  vtkNew<vtkPlaneCollection> clips;
  if (TrajectoryReference::Length(scene.ClipNormal) > 0.0)
  {
    vtkNew<vtkPlane> plane;
    plane->SetNormal(scene.ClipNormal.data());
    clips->AddItem(plane);
    mapper->SetClippingPlanes(clips);
  }

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(120, 90);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vector eye = TrajectoryReference::Combine(scene.Eye, 1.0, scene.Offset);
  const Vector focus = TrajectoryReference::Combine(scene.Focus, 1.0, scene.Offset);
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focus.data());
  camera->SetViewAngle(scene.ViewAngle);
  const Vector view = TrajectoryReference::Combine(focus, -1.0, eye);
  if (std::abs(view[1]) > 0.99 * TrajectoryReference::Length(view))
  {
    camera->SetViewUp(0, 0, 1);
  }
  if (scene.ParallelScale > 0.0)
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(scene.ParallelScale);
  }
  renderer->ResetCameraClippingRange();
  if (scene.Near > 0.0)
  {
    camera->SetClippingRange(scene.Near, 1000.0 * scene.Near);
  }
  window->Render();

  const auto segments = TrajectoryReference::GetSegments(data, 0.0, radii, actor->GetMatrix());
  const auto result =
    TrajectoryReference::Compare(window, renderer, segments, scene.Tolerance, clips);
  std::cout << scene.Name << ": " << result.Hits << " pixels hit, " << result.Doubtful
            << " doubtful, " << result.Wrong << " wrong\n";
  return result.Hits > 0 && result.Wrong == 0 && result.Doubtful < 120 * 90 / 2;
}
}

int TestTrajectoryMapperGeometry(int, char*[])
{
  const Lines crossing = { { { { -2, 0, 0, 0.3 } }, { { 2, 0.5, 0.5, 0.3 } } },
    { { { 0, -2, 0.2, 0.4 } }, { { 0.3, 2, -0.2, 0.4 } } } };
  const Lines growing = { { { { -2, -0.5, 0, 0.1 } }, { { 2, 0.5, 1, 0.9 } } } };
  const Lines shrinking = { { { { -2, -0.5, 0, 0.9 } }, { { 2, 0.5, 1, 0.1 } } } };
  const Lines pointed = { { { { -2, -0.5, 0, 1.5 } }, { { 2, 0.5, 1, 0.0 } } } };
  const Lines swallowed = { { { { 0, 0, 0, 1.0 } }, { { 0.3, 0.2, 0.1, 0.4 } } },
    { { { 2, 0, 0, 0.2 } }, { { 2.1, 0.2, 0.1, 0.8 } } } };
  const Lines bent = { { { { -2, -1, 0, 0.3 } }, { { -1, 1, 0.5, 0.3 } }, { { 0, -1, 0, 0.3 } },
    { { 0.3, -0.8, 0, 0.3 } }, { { 1.5, 1, -1, 0.2 } }, { { 1.4, -1, -1, 0.4 } },
    { { 2.5, 0, 1, 0.3 } } } };
  const Lines back = { { { { -2, 0, 0, 0.3 } }, { { 1, 0, 0, 0.3 } }, { { -2, 0, 0, 0.3 } } },
    { { { -2, 1, 0, 0.2 } }, { { 1, 1, 0, 0.2 } }, { { -1, 1.01, 0, 0.2 } } } };
  const Lines balls = { { { { -1, 0, 0, 0.5 } } }, { { { 1, 0.5, 1, 0.9 } } },
    { { { 0, -1, 0, 0.3 } }, { { 0, -1, 0, 0.3 } } },
    { { { -2, -1, 0, 0.2 } }, { { -2, -1, 0, 0.2 } }, { { -1, -1, 0, 0.2 } } } };
  const Lines thin = { { { { -200, 0, -100, 0.02 } }, { { 200, 0.5, 100, 0.02 } } } };
  Lines aroundEarth = bent;
  for (auto& line : aroundEarth)
  {
    for (Point& point : line)
    {
      point[0] += 6.4e6;
    }
  }
  aroundEarth.push_back({ { { -6.4e6, 6.4e6, -6.4e6, 0.3 } }, { { -6.4e6, 6.4e6, -6.3e6, 0.3 } } });
  Lines coil(1);
  for (int i = 0; i < 60; ++i)
  {
    coil[0].push_back({ { std::cos(0.2 * i), std::sin(0.2 * i), 0.05 * i, 0.25 + 0.001 * i } });
  }
  const Vector inCoil{ { coil[0][10][0], coil[0][10][1], coil[0][10][2] } };
  const Vector alongCoil{ { coil[0][14][0], coil[0][14][1], coil[0][14][2] } };

  std::vector<Scene> scenes = {
    { "crossing tubes", crossing, { { 1, 2, 10 } } },
    { "radius growing", growing, { { 1, 2, 10 } } },
    { "radius shrinking", shrinking, { { 1, 2, 10 } } },
    { "radius growing, from its thin end", growing, { { -6, -3, -2 } } },
    { "radius growing, from its thick end", growing, { { 6, 3, 4 } } },
    { "radius down to 0", pointed, { { 1, 2, 10 } } },
    { "radius down to 0, from the point", pointed, { { 8, 2, 3 } } },
    { "one ball in the other", swallowed, { { 3, 2, 8 } } },
    { "sharp bends", bent, { { 1, 2, 10 } } },
    { "sharp bends from the side", bent, { { 9, -3, 1 } } },
    { "line turning back", back, { { 1, 3, 10 } } },
    { "vertices and short lines", balls, { { 1, 2, 8 } } },
    { "coil", coil, { { 1, -6, 4 } }, { { 0, 0, 1.5 } } },
    { "wide view angle", bent, { { 0.5, 0, 1.5 } }, { { 0, 0, 0 } }, 120.0 },
    { "eye between the ends of a long line", thin, { { 0, 0, 0.1 } }, { { 1, 0, 0.4 } }, 90.0 },
    { "long thin line", thin, { { 3, 4, 12 } } },
    { "down the axis", { { { { 0, 0, -3, 0.5 } }, { { 0, 0, 2, 0.5 } } } }, { { 0, 0, 8 } } },
    { "down a cone's axis", { { { { 0, 0, -3, 1.5 } }, { { 0, 0, 2, 0.5 } } } }, { { 0, 0, 8 } } },
    { "nearly down the axis", { { { { 0, 0, -3, 0.5 } }, { { 0, 1e-5, 2, 0.5 } } } },
      { { 0, 0, 8 } } },
    { "eye in a tube", { { { { -3, 0, 0, 0.5 } }, { { 3, 0, 0, 0.5 } } } }, { { 0, 0.1, 0.2 } },
      { { 1, 0.3, 0.1 } }, 60.0, 0.0, { { 1, 1, 1 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } }, 0.01 },
    { "eye in a cap", { { { { -3, 0, 0, 0.5 } }, { { 3, 0, 0, 0.5 } } } }, { { 3.2, 0.1, 0.2 } },
      { { 4, 0.3, 0.1 } }, 60.0, 0.0, { { 1, 1, 1 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } }, 0.01 },
    { "eye in the middle of a ball", { { { { 0, 0, 0, 1 } } } }, { { 0, 0, 0 } },
      { { 1, 0.3, 0.1 } }, 60.0, 0.0, { { 1, 1, 1 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } }, 0.01 },
    { "eye in a coil", coil, inCoil, alongCoil, 70.0, 0.0, { { 1, 1, 1 } }, { { 0, 0, 0 } },
      { { 0, 0, 0 } }, 0.01 },
    { "near plane through a coil", coil, { { 1, -3, 2 } }, { { 0, 0, 1.5 } }, 40.0, 0.0,
      { { 1, 1, 1 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } }, 2.5 },
    { "stretched axes", bent, { { 4, 8, 40 } }, { { 0, 0, 0 } }, 30.0, 0.0, { { 3, 1, 5 } } },
    { "coordinates of 6.4e6", bent, { { 1, 2, 10 } }, { { 0, 0, 0 } }, 30.0, 0.0, { { 1, 1, 1 } },
      { { 6.4e6, -6.4e6, 6.4e6 } } },
    { "coordinates around the earth", aroundEarth, { { 6.4e6 + 1, 2, 10 } }, { { 6.4e6, 0, 0 } },
      30.0, 0.0, { { 1, 1, 1 } }, { { 0, 0, 0 } }, { { 0, 0, 0 } }, 1.0 },
    { "clipping plane", bent, { { 1, 2, 10 } }, { { 0, 0, 0 } }, 30.0, 0.0, { { 1, 1, 1 } },
      { { 0, 0, 0 } }, { { 0, 0.3, -1 } } },
    { "telephoto", bent, { { 100, 200, 100000 } }, { { 0, 0, 0 } }, 0.004, 0.0, { { 1, 1, 1 } },
      { { 0, 0, 0 } }, { { 0, 0, 0 } }, 0.0, 1e-4 },
  };
  const std::size_t perspectives = scenes.size();
  for (std::size_t i = 0; i < perspectives; ++i)
  {
    Scene parallel = scenes[i];
    if (parallel.Near == 0.0)
    {
      parallel.Name += ", parallel";
      parallel.ParallelScale = parallel.ActorScale[0] * 3.0;
      scenes.push_back(parallel);
    }
  }
  bool right = true;
  for (const Scene& scene : scenes)
  {
    right = Check(scene) && right;
  }
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
