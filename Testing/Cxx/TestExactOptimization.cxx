// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures with optimised opacities, of lines, points and surfaces with parameters of their own,
// are those of the double-precision reference.
#include "HelixScene.h"

#include "vtkFloatArray.h"
#include "vtkOpacityOptimization.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectorySegments.h"

#include <functional>

namespace
{
//------------------------------------------------------------------------------
void AddImportance(vtkPolyData* data, const std::function<double(const double*)>& importance)
{
  vtkNew<vtkFloatArray> array;
  array->SetName("Importance");
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    array->InsertNextValue(static_cast<float>(importance(data->GetPoint(point))));
  }
  data->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSegmentedLines(int segments)
{
  auto lines = MakeLines(40, 60, 1);
  AddImportance(lines, [](const double* p) { return 0.5 + 0.6 * std::sin(2.0 * p[0] + p[1]); });
  vtkNew<vtkTrajectorySegments> divider;
  divider->SetInputData(lines);
  divider->SetNumberOfSegments(segments);
  divider->Update();
  return divider->GetPolyDataOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSegmentedSphere(double radius, double importance)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  sphere->Update();
  AddImportance(sphere->GetOutput(), [importance](const double*) { return importance; });
  vtkNew<vtkSurfaceSegments> divider;
  divider->SetInputConnection(sphere->GetOutputPort());
  divider->SetNumberOfSegments(100);
  divider->Update();
  return divider->GetOutput();
}

//------------------------------------------------------------------------------
void Optimize(vtkActor* actor, double q, double r, double lambda, int steps, bool selfOcclusion)
{
  vtkNew<vtkOpacityOptimization> optimization;
  optimization->SetOcclusionWeight(q);
  optimization->SetClutterWeight(r);
  optimization->SetEmphasis(lambda);
  optimization->SetSmoothingIterations(steps);
  optimization->SetSelfOcclusion(selfOcclusion);
  vtkOpacityOptimization::Attach(actor, optimization);
}

//------------------------------------------------------------------------------
template <typename Mapper>
vtkActor* AddSurface(SphereScene& scene, vtkPolyData* data, double opacity)
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.3, 0.5, 0.9);
  actor->GetProperty()->SetOpacity(opacity);
  scene.Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
bool TestLines()
{
  bool success = true;
  for (const int steps : { 0, 5, 40 })
  {
    SphereScene scene(300, 300, 0, 0, 0);
    vtkActor* lines = AddLines(scene, MakeSegmentedLines(600), 0.04, 1.0);
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
template <typename Mapper>
bool TestMixture(const std::string& name)
{
  SphereScene scene(300, 300, 0, 0, 0);
  Optimize(AddLines(scene, MakeSegmentedLines(500), 0.04, 1.0), 20.0, 10.0, 2.0, 4, false);
  Optimize(AddSurface<Mapper>(scene, MakeSegmentedSphere(1.6, 0.1), 0.9), 5.0, 0.0, 1.0, 2, false);
  Optimize(AddSurface<Mapper>(scene, MakeSegmentedSphere(0.7, 0.6), 1.0), 50.0, 3.0, 4.0, 0, true);
  AddSurface<Mapper>(scene, MakeSegmentedSphere(1.2, 1.0), 0.2); // takes no part
  return Compare(scene, name);
}
}

//------------------------------------------------------------------------------
int TestExactOptimization(int, char*[])
{
  bool success = TestLines();
  success &= TestUndivided();
  success &= TestMixture<vtkPolyDataMapper>("surfaces of VTK's mapper among lines");
  success &= TestMixture<vtkTrajectoryMapper>("surfaces among lines");
  return success ? EXIT_SUCCESS : EXIT_FAILURE;
}
