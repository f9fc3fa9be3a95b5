// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures with opacities that follow from importance, of lines, points and surfaces with
// parameters of their own, are those of the double-precision reference.
#include "SegmentedScene.h"

namespace
{
//------------------------------------------------------------------------------
bool TestLines()
{
  bool success = true;
  for (const int steps : { 0, 5, 40 })
  {
    SphereScene scene(300, 300, 0, 0, 0);
    vtkActor* lines = AddLines(scene, MakeSegmentedLines(40, 600), 0.04, 1.0);
    Optimize(lines, 50.0, 100.0, 3.0, steps, steps == 5);
    success &= Compare(scene, "lines, " + std::to_string(steps) + " steps");
  }
  return success;
}

//------------------------------------------------------------------------------
// All lines together are one segment where the data do not say more.
bool TestUndivided()
{
  SphereScene scene(300, 300, 0, 0, 0);
  auto data = MakeLines(20, 40, 2);
  AddImportance(data, [](const double* p) { return p[0]; });
  Optimize(AddLines(scene, data, 0.05, 0.8), 1.0, 2.0, 1.5, 3, false);
  return Compare(scene, "lines without segments");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSegmentedBalls()
{
  auto data = MakeLines(80, 60, 2);
  data->SetLines(nullptr);
  AddImportance(data, Wave);
  return DivideLines(data, 30);
}

//------------------------------------------------------------------------------
template <typename Mapper>
bool TestMixture(const std::string& name)
{
  SphereScene scene(300, 300, 0, 0, 0);
  Optimize(AddLines(scene, MakeSegmentedLines(40, 500), 0.04, 1.0), 20.0, 10.0, 2.0, 4, false);
  Optimize(AddLines(scene, MakeSegmentedBalls(), 0.1, 0.9), 30.0, 20.0, 1.0, 2, false);
  Optimize(AddSurface<Mapper>(scene, MakeSegmentedSphere(1.6, 0.1), 0.9), 5.0, 0.0, 1.0, 2, false);
  Optimize(AddSurface<Mapper>(scene, MakeSegmentedSphere(0.7, 0.6), 1.0), 50.0, 3.0, 4.0, 0, true);
  AddSurface<Mapper>(scene, MakeSegmentedSphere(1.2, 1.0), 0.2); // takes no part
  return Compare(scene, name);
}

//------------------------------------------------------------------------------
// Between points of importance 1 nothing is missing to it, whatever the exponent.
bool TestFullImportance()
{
  SphereScene scene(300, 300, 0, 0, 0);
  Optimize(AddSurface<vtkPolyDataMapper>(scene, MakeSegmentedSphere(1.2, 1.0), 0.6), 50.0, 50.0,
    0.01, 0, true);
  const auto lines = MakeLines(12, 40, 2);
  AddImportance(lines, [](const double*) { return 1.0; });
  Optimize(AddLines(scene, DivideLines(lines, 100), 0.05, 0.6), 1e38, 1e38, 1.0, 0, true);
  Optimize(AddSurface<vtkPolyDataMapper>(scene, MakeSegmentedSphere(0.5, 0.5), 0.6), 1.0, 1.0, 1.0,
    0, false);
  return Compare(scene, "full importance");
}

//------------------------------------------------------------------------------
// The smoothed depth of a flat surface is its own depth, and nothing of it is in front.
bool TestAvoidanceOfFlatSurface()
{
  bool success = true;
  for (const bool isParallel : { false, true })
  {
    SphereScene scene(300, 300, 0, 0, 0);
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-1.0, -1.0, -1.0);
    plane->SetPoint1(1.0, -1.0, 0.3);
    plane->SetPoint2(-1.0, 1.0, 0.5);
    plane->SetResolution(7, 7);
    plane->Update();
    AddImportance(plane->GetOutput(), [](const double* p) { return std::sin(9.0 * p[0] + p[1]); });
    vtkActor* actor = AddSurface<vtkPolyDataMapper>(scene, plane->GetOutput(), 0.7);
    Avoid(actor, vtkOcclusionAvoidance::PENALTY, true);
    scene.Renderer->GetActiveCamera()->SetParallelProjection(isParallel);
    success &= Compare(scene, "avoidance of a flat surface");
  }
  return success;
}

//------------------------------------------------------------------------------
// A segment whose one ball contains the other has no direction.
bool TestAvoidanceOfShortSegments()
{
  SphereScene scene(300, 300, 0, 0, 0);
  const auto lines = MakeLines(30, 200, 2);
  vtkDataArray* radii = lines->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < radii->GetNumberOfTuples(); ++i)
  {
    radii->SetTuple1(i, i % 3 == 0 ? 0.1 : 0.02);
  }
  AddImportance(lines, [](const double*) { return 0.6; });
  vtkActor* actor = AddLines(scene, lines, 0.05, 0.5);
  vtkTrajectoryMapper::SafeDownCast(actor->GetMapper())->SetRadiusArray("Radius");
  Avoid(actor, vtkOcclusionAvoidance::WEIGHTING, false);
  return Compare(scene, "avoidance of short segments");
}
}

//------------------------------------------------------------------------------
int TestExactOptimization(int, char*[])
{
  bool success = TestLines();
  success &= TestUndivided();
  success &= TestMixture<vtkPolyDataMapper>("surfaces of VTK's mapper among lines");
  success &= TestMixture<vtkTrajectoryMapper>("surfaces among lines");
  success &= TestFullImportance();
  success &= TestAvoidanceOfFlatSurface();
  success &= TestAvoidanceOfShortSegments();
  return success ? EXIT_SUCCESS : EXIT_FAILURE;
}
