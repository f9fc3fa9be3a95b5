// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkReferenceRenderer on scenes with a known result: stacks of up to 100,000 translucent layers,
 * depths in perspective, meshes whose edges run through pixel centres, any order of props and
 * number of threads giving the same bits, transparent backgrounds, what it cannot draw, and what it
 * does not use.
 */

#include "ReferenceTesting.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkExactTransparencyPass.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkReferenceRenderer.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkTable.h"
#include "vtkTrajectoryMapper.h"
#include "vtkVariant.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
/** A camera at z = 10 that looks down on [-1, 1] x [-1, 1] from z = 9 to z = -9 without
 * perspective. */
void UseParallelCamera(vtkRenderer* renderer)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.0);
  camera->SetPosition(0, 0, 10);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetClippingRange(1, 19);
}

/** Squares of side 8 across the z axis, at `layers` heights between -5 and 5. */
vtkSmartPointer<vtkActor> MakeStack(int layers, double opacity)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> squares;
  for (int i = 0; i < layers; ++i)
  {
    const double z = 10.0 * (i + 0.5) / layers - 5.0;
    const vtkIdType first = points->InsertNextPoint(-4, -4, z);
    points->InsertNextPoint(4, -4, z);
    points->InsertNextPoint(4, 4, z);
    points->InsertNextPoint(-4, 4, z);
    squares->InsertNextCell({ first, first + 1, first + 2, first + 3 });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(squares);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(opacity);
  actor->GetProperty()->SetColor(1.0, 0.5, 0.25);
  actor->GetProperty()->LightingOff();
  return actor;
}

void TestStack(Checks& checks, int layers, double opacity)
{
  vtkNew<vtkRenderer> renderer;
  UseParallelCamera(renderer);
  renderer->SetBackground(0.0, 0.0, 1.0);
  renderer->AddActor(MakeStack(layers, opacity));
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(3, 1);
  reference->TransparentBackgroundOn();
  reference->Update();
  const double alpha = -std::expm1(layers * std::log1p(-opacity));
  const auto* pixel = static_cast<double*>(reference->GetImage()->GetScalarPointer(1, 0, 0));
  const std::string name = std::to_string(layers) + " squares";
  checks.Near(name + ", red", pixel[0], alpha, 1e-11);
  checks.Near(name + ", green", pixel[1], 0.5 * alpha, 1e-11);
  checks.Near(name + ", blue over the background", pixel[2], 0.25 * alpha + (1 - alpha), 1e-11);
  checks.Near(name + ", alpha", pixel[3], alpha, 1e-11);
  checks.Near(name + ", fragments", reference->GetNumberOfFragments(), 3.0 * layers, 0);
  checks.Near(name + ", longest list", reference->GetLongestList(), layers, 0);
}

void TestDepths(Checks& checks, double nearDistance, double farDistance, int visible)
{
  vtkNew<vtkRenderer> renderer;
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 10);
  camera->SetFocalPoint(0, 0, 0);
  camera->SetViewAngle(30);
  camera->SetClippingRange(nearDistance, farDistance);
  renderer->AddActor(MakeStack(5, 0.5)); // at distances 14, 12, 10, 8 and 6
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(7, 5);
  reference->Update();
  vtkNew<vtkTable> fragments;
  reference->GetPixelFragments(2, 1, fragments);
  checks.Near("fragments within the clipping range", fragments->GetNumberOfRows(), visible, 0);
  for (int i = 0; i < fragments->GetNumberOfRows(); ++i)
  {
    const double distance = 6.0 + 2.0 * i;
    const double depth =
      farDistance * (distance - nearDistance) / (distance * (farDistance - nearDistance));
    checks.Near("depth", fragments->GetValueByName(i, "Depth").ToDouble(), depth, 1e-14);
    checks.Near("alpha", fragments->GetValueByName(i, "Alpha").ToDouble(), 0.5, 0);
  }
  reference->GetPixelFragments(7, 0, fragments);
  checks.Near("outside the image", fragments->GetNumberOfRows(), 0, 0);
}

/** A mesh of 8 x 8 squares, divided into triangles, over 8 x 8 or 9 x 9 pixels: edges and corners,
 * or diagonals, run exactly through pixel centres. */
void TestSharedEdges(Checks& checks)
{
  for (const int size : { 8, 9, 16, 17 })
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-1.25, -1.25, 0);
    plane->SetPoint1(1.25, -1.25, 0);
    plane->SetPoint2(-1.25, 1.25, 0);
    plane->SetResolution(10, 10);
    plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(0.5);
    vtkNew<vtkRenderer> renderer;
    UseParallelCamera(renderer);
    renderer->AddActor(actor);
    vtkNew<vtkReferenceRenderer> reference;
    reference->SetRenderer(renderer);
    reference->SetSize(size, size);
    reference->Update();
    checks.Near("mesh, longest list", reference->GetLongestList(), 1, 0);
    checks.Near("mesh, fragments", reference->GetNumberOfFragments(), size * size, 0);
  }
}

std::vector<vtkSmartPointer<vtkActor>> MakeSpheres()
{
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (int i = 0; i < 12; ++i)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.1 * (i % 4), 0.1 * (i / 4), 0.05 * i);
    sphere->SetRadius(0.5);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    // Two of them coincide, and differ in colour only.
    actor->SetPosition(i == 11 ? -0.1 : 0.0, 0.0, i == 11 ? -0.05 : 0.0);
    actor->GetProperty()->SetOpacity(i % 5 == 0 ? 1.0 : 0.2);
    actor->GetProperty()->SetColor(i / 12.0, 0.5, 1.0 - i / 12.0);
    actors.push_back(actor);
  }
  return actors;
}

void TestSameBits(Checks& checks)
{
  std::vector<double> first;
  auto actors = MakeSpheres();
  for (int run = 0; run < 6; ++run)
  {
    vtkNew<vtkRenderer> renderer;
    UseParallelCamera(renderer);
    for (const auto& actor : actors)
    {
      renderer->AddActor(actor);
    }
    vtkNew<vtkReferenceRenderer> reference;
    reference->SetRenderer(renderer);
    reference->SetSize(63, 41);
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config{ run % 2 + 1 }, [&reference] { reference->Update(); });
    const auto* values = static_cast<double*>(reference->GetImage()->GetScalarPointer());
    const std::vector<double> image(values, values + 4 * 63 * 41);
    checks.True("same bits in any order, with any number of threads", run == 0 || image == first);
    checks.True("several layers", reference->GetLongestList() > 3);
    first = image;
    std::rotate(actors.begin(), actors.begin() + 5, actors.end());
  }
}

void TestBackground(Checks& checks)
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.2, 0.3, 0.4);
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(1, 1);
  reference->Update();
  const auto* pixel = static_cast<double*>(reference->GetImage()->GetScalarPointer());
  checks.Near("empty scene, colour", pixel[1], 0.3, 0);
  checks.Near("empty scene, alpha", pixel[3], 1, 0);
  checks.Near("empty scene, fragments", reference->GetNumberOfFragments(), 0, 0);
  reference->TransparentBackgroundOn();
  reference->Update();
  pixel = static_cast<double*>(reference->GetImage()->GetScalarPointer());
  checks.Near("transparent background, alpha", pixel[3], 0, 0);
}

// Of two squares that are 3.6e-7 of the depth apart, one at each of three places.
void TestOrderChanges(Checks& checks)
{
  vtkNew<vtkRenderer> renderer;
  UseParallelCamera(renderer);
  for (const double height : { 0.0, 6.5e-6 })
  {
    vtkSmartPointer<vtkActor> square = MakeStack(1, 0.5);
    square->SetPosition(0.0, 0.0, height);
    square->GetProperty()->SetColor(height > 0.0 ? 1.0 : 0.0, 0.5, height > 0.0 ? 0.0 : 1.0);
    renderer->AddActor(square);
  }
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(2, 1);
  reference->Update();
  vtkImageData* changes = reference->GetOrderChanges();
  checks.True("not asked for", changes->GetNumberOfPoints() == 0);
  reference->ComputeOrderChangesOn();
  const double expected[6] = { -0.25, 0.0, 0.0, 0.0, 0.0, 0.25 };
  for (const int view : { vtkExactTransparencyPass::VIEW_PICTURE,
         vtkExactTransparencyPass::VIEW_LENGTH, vtkExactTransparencyPass::VIEW_LAYER })
  {
    reference->SetView(view);
    reference->Update();
    for (int i = 0; i < 6; ++i)
    {
      checks.Near("view " + std::to_string(view) + ", change " + std::to_string(i),
        changes->GetScalarComponentAsDouble(1, 0, 0, i), expected[i], 1e-12);
    }
  }
  reference->ComputeOrderChangesOff();
  reference->Update();
  checks.True("no longer asked for", changes->GetNumberOfPoints() == 0);
}

void TestOmissions(Checks& checks)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, std::numeric_limits<double>::quiet_NaN(), 0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->SetPolys(polygons);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkActor> wireframe;
  wireframe->SetMapper(mapper);
  wireframe->GetProperty()->SetRepresentationToWireframe();
  vtkNew<vtkRenderer> renderer;
  UseParallelCamera(renderer);
  renderer->AddActor(actor);
  renderer->AddActor(wireframe);
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(4, 4);
  vtkObject::GlobalWarningDisplayOff();
  reference->Update();
  vtkObject::GlobalWarningDisplayOn();
  const std::string omissions = reference->GetOmissions();
  for (const char* part : { "1 x wireframe", "1 x vertex or line", "1 x cell or point" })
  {
    checks.True("omissions name \"" + std::string(part) + "\": " + omissions,
      omissions.find(part) != std::string::npos);
  }
  const auto* values = static_cast<double*>(reference->GetImage()->GetScalarPointer());
  checks.True("no NaN in the image",
    std::none_of(values, values + 4 * 16, [](double value) { return std::isnan(value); }));
}

/** As in vtkTrajectoryMapper, an opacity array that lacks values is not used. */
void TestShortOpacityArray(Checks& checks)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(5, 5, 0);
  points->InsertNextPoint(0, 0, 0);
  vtkNew<vtkCellArray> balls;
  balls->InsertNextCell({ 0 });
  balls->InsertNextCell({ 1 });
  vtkNew<vtkFloatArray> factors;
  factors->SetName("Factor");
  factors->SetNumberOfValues(2);
  factors->FillValue(0.0f);
  factors->SetNumberOfValues(1); // what is behind stays allocated
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(balls);
  data->GetPointData()->AddArray(factors);
  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetRadius(0.5);
  mapper->SetOpacityArray("Factor");
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.25);
  vtkNew<vtkRenderer> renderer;
  UseParallelCamera(renderer);
  renderer->AddActor(actor);
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(1, 1);
  reference->TransparentBackgroundOn();
  reference->Update();
  const auto* pixel = static_cast<double*>(reference->GetImage()->GetScalarPointer());
  checks.Near("short opacity array, alpha", pixel[3], 0.25, 1e-12);
}

void TestErrors(Checks& checks)
{
  vtkObject::GlobalWarningDisplayOff();
  vtkNew<vtkReferenceRenderer> reference;
  reference->Update();
  checks.Near("no renderer, no image", reference->GetImage()->GetNumberOfPoints(), 0, 0);
  vtkNew<vtkRenderer> renderer;
  reference->SetRenderer(renderer);
  reference->SetSize(0, 5);
  reference->Update();
  checks.Near("no size, no image", reference->GetImage()->GetNumberOfPoints(), 0, 0);
  vtkObject::GlobalWarningDisplayOn();
}
}

int TestReferenceRenderer(int, char*[])
{
  Checks checks;
  TestStack(checks, 1, 0.3);
  TestStack(checks, 64, 0.1);
  TestStack(checks, 500, 0.0019);
  TestStack(checks, 100000, 1e-4);
  TestDepths(checks, 2.0, 13.0, 4);
  TestDepths(checks, 1e-3, 1e6, 5);
  TestSharedEdges(checks);
  TestSameBits(checks);
  TestBackground(checks);
  TestOrderChanges(checks);
  TestOmissions(checks);
  TestShortOpacityArray(checks);
  TestErrors(checks);
  return checks.Result();
}
