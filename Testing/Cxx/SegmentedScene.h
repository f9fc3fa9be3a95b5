// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SegmentedScene_h
#define SegmentedScene_h

#include "HelixScene.h"

#include "vtkFloatArray.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectorySegments.h"

#include <functional>

using ImportanceFunction = std::function<double(const double* point)>;

inline void AddImportance(
  vtkPolyData* data, const ImportanceFunction& importance, const char* name = "Importance")
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    array->InsertNextValue(static_cast<float>(importance(data->GetPoint(point))));
  }
  data->GetPointData()->AddArray(array);
}

/** Importance that varies along lines and over surfaces. */
inline double Wave(const double* point)
{
  return 0.5 + 0.6 * std::sin(2.0 * point[0] + point[1]);
}

/** Lines and balls, divided into segments. */
inline vtkSmartPointer<vtkPolyData> DivideLines(vtkPolyData* data, int segments)
{
  vtkNew<vtkTrajectorySegments> divider;
  divider->SetInputData(data);
  divider->SetNumberOfSegments(segments);
  divider->Update();
  return divider->GetPolyDataOutput();
}

/**
 * Helices, divided into segments. They have no balls: a ball and the cap of its line have the same
 * depths, and which of their segments hides the other would be a matter of rounding.
 */
inline vtkSmartPointer<vtkPolyData> MakeSegmentedLines(int lines, int segments)
{
  auto data = MakeLines(lines, 60, 1);
  data->SetVerts(nullptr);
  AddImportance(data, Wave);
  return DivideLines(data, segments);
}

/** A sphere of 100 segments. */
inline vtkSmartPointer<vtkPolyData> MakeSegmentedSphere(
  double radius, const ImportanceFunction& importance)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  sphere->Update();
  AddImportance(sphere->GetOutput(), importance);
  vtkNew<vtkSurfaceSegments> divider;
  divider->SetInputConnection(sphere->GetOutputPort());
  divider->SetNumberOfSegments(100);
  divider->Update();
  return divider->GetOutput();
}

inline vtkSmartPointer<vtkPolyData> MakeSegmentedSphere(double radius, double importance)
{
  return MakeSegmentedSphere(radius, [importance](const double*) { return importance; });
}

inline void Optimize(
  vtkActor* actor, double q, double r, double lambda, int steps, bool selfOcclusion)
{
  vtkNew<vtkOpacityOptimization> optimization;
  optimization->SetOcclusionWeight(q);
  optimization->SetClutterWeight(r);
  optimization->SetEmphasis(lambda);
  optimization->SetSmoothingIterations(steps);
  optimization->SetSelfOcclusion(selfOcclusion);
  vtkOpacityOptimization::Attach(actor, optimization);
}

inline vtkOcclusionAvoidance* Avoid(vtkActor* actor, int mode, bool smoothAttributes)
{
  vtkNew<vtkOcclusionAvoidance> avoidance;
  avoidance->SetMode(mode);
  avoidance->SetSmoothAttributes(smoothAttributes);
  vtkOcclusionAvoidance::Attach(actor, avoidance);
  return avoidance;
}

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

#endif
