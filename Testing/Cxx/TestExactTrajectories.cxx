// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Translucent trajectories, alone and among surfaces, glyphs and opaque objects, are drawn as the
// double-precision reference draws them, with the same bits on every run and in any order.
#include "HelixScene.h"
#include "Picture.h"

#include "vtkLookupTable.h"
#include "vtkPlane.h"

namespace
{
bool TestCrossingTubes()
{
  bool passed = true;
  for (const double opacity : { 1e-4, 0.01, 0.3, 0.9 })
  {
    SphereScene scene(320, 240, 0, 0, 0);
    AddLines(scene, MakeLines(30, 60, 0), 0.04, opacity);
    passed &= Compare(scene, "crossing tubes of opacity " + std::to_string(opacity));
  }
  return passed;
}

bool TestRadiiFromArray()
{
  SphereScene scene(320, 240, 0, 0, 2);
  vtkActor* actor = AddLines(scene, MakeLines(20, 60, 0), 0.04, 0.4);
  vtkTrajectoryMapper::SafeDownCast(actor->GetMapper())->SetRadiusArray("Radius");
  return Compare(scene, "radii from an array");
}

bool TestMixedScene()
{
  SphereScene scene(321, 241, 0, 6, 3);
  AddLines(scene, MakeLines(25, 50, 0), 0.03, 0.5);
  scene.AddGlyphs();
  return Compare(scene, "trajectories and balls among spheres, glyphs and opaque spheres");
}

// Along each line the opacity goes from 0 to 1.
bool TestOpacityOfTheTable()
{
  SphereScene scene(320, 240, 0, 2, 1);
  vtkActor* actor = AddLines(scene, MakeLines(25, 50, 0), 0.05, 1.0);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(256);
  table->SetAlphaRange(0.0, 1.0);
  table->SetRange(-1.0, 1.0);
  table->Build();
  actor->GetMapper()->SetLookupTable(table);
  return Compare(scene, "opacity of the table");
}

bool TestParallelProjection()
{
  SphereScene scene(320, 240, 0, 4, 1);
  AddLines(scene, MakeLines(25, 50, 0), 0.03, 0.5);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(2.0);
  scene.Renderer->GetActiveCamera()->Elevation(40);
  scene.Renderer->ResetCameraClippingRange();
  return Compare(scene, "trajectories in parallel projection");
}

bool TestEyeInsideATube()
{
  SphereScene scene(320, 240, 0, 0, 0);
  AddLines(scene, MakeLines(6, 80, 0), 0.15, 0.4);
  double eye[3];
  vtkActor* actor = scene.Renderer->GetActors()->GetLastActor();
  vtkPolyData* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  data->GetPoint(40, eye);
  double ahead[3];
  data->GetPoint(44, ahead);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(eye);
  camera->SetFocalPoint(ahead);
  camera->SetClippingRange(0.01, 10.0);
  return Compare(scene, "eye inside a tube");
}

// Joints nearly in every pixel: some hits lie within rounding of a joint plane.
bool TestDenseJoints()
{
  SphereScene scene(1000, 400, 0, 0, 0);
  AddLines(scene, MakeLines(1, 800, 0), 0.15, 0.4);
  scene.Renderer->ResetCamera();
  scene.Renderer->GetActiveCamera()->Zoom(2.0);
  bool passed = true;
  for (int view = 0; view < 8; ++view)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(3.0);
    passed &= Compare(scene, "dense joints, view " + std::to_string(view));
  }
  return passed;
}

// Tubes thinner than a pixel, of segments shorter than a pixel, have no gaps at their joints.
bool TestThinTubes()
{
  SphereScene scene(200, 150, 0, 0, 0);
  AddLines(scene, MakeLines(60, 600, 0), 0.008, 0.4);
  bool passed = true;
  for (int view = 0; view < 4; ++view)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(3.0);
    passed &= Compare(scene, "thin tubes, view " + std::to_string(view));
  }
  return passed;
}

vtkSmartPointer<vtkPolyData> MakeBalls(int count)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-2.0, 2.0);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (int i = 0; i < count; ++i)
  {
    const double x = place(random);
    const double y = place(random);
    vertices->InsertNextCell({ points->InsertNextPoint(x, y, place(random)) });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  return data;
}

// Small segments are point sprites, near ones quads, and some of both lie across the edges of the
// view.
bool TestSprites()
{
  bool passed = true;
  for (const bool parallel : { false, true })
  {
    for (const double angle : { 30.0, 110.0 })
    {
      SphereScene scene(260, 200, 0, 0, 0);
      AddLines(scene, MakeLines(80, 120, 0), 0.015, 0.4);
      AddLines(scene, MakeBalls(2000), 0.025, 0.4);
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetParallelProjection(parallel);
      camera->SetParallelScale(0.02 * angle);
      camera->SetViewAngle(angle);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      camera->SetPosition(0.5, 0.3, 200.0 / angle - 1.5);
      camera->SetWindowCenter(0.4, -0.3);
      scene.Renderer->ResetCameraClippingRange();
      passed &= Compare(scene,
        std::string("sprites, ") + (parallel ? "parallel, " : "perspective, ") +
          std::to_string(angle));
    }
  }
  return passed;
}

// Applications that share the context may rely on it.
bool TestPointSizeStays()
{
  bool passed = true;
  SphereScene scene(160, 120, 0, 0, 0);
  AddLines(scene, MakeLines(10, 60, 0), 0.01, 0.4);
  vtkTransparencyInstaller::Install(scene.Renderer);
  scene.Window->Render();
  for (const bool isEnabled : { true, false })
  {
    scene.Renderer->GetActiveCamera()->Azimuth(1.0);
    scene.Window->MakeCurrent();
    (isEnabled ? glEnable : glDisable)(GL_PROGRAM_POINT_SIZE);
    scene.Window->Render();
    passed &= Check((glIsEnabled(GL_PROGRAM_POINT_SIZE) == GL_TRUE) == isEnabled,
      std::string("GL_PROGRAM_POINT_SIZE is not as it was: ") + (isEnabled ? "on" : "off"));
  }
  return passed;
}

// Sprites and blocks of pixels do not care where in the window the viewport lies, nor that it is no
// multiple of them.
bool TestViewportInsideTheWindow()
{
  const int width = 203;
  const int height = 149;
  const auto render = [&](int x, int y)
  {
    SphereScene scene(width + 2 * x, height + 2 * y, 0, 3, 0);
    AddLines(scene, MakeLines(60, 200, 0), 0.01, 0.4);
    const double w = width + 2 * x;
    const double h = height + 2 * y;
    scene.Renderer->SetViewport(x / w, y / h, (x + width) / w, (y + height) / h);
    scene.Renderer->ResetCamera(-1.5, 1.5, -1.0, 1.0, -1.0, 1.0);
    vtkTransparencyInstaller::Install(scene.Renderer);
    scene.Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    scene.Window->GetRGBACharPixelData(x, y, x + width - 1, y + height - 1, 0, pixels);
    return Picture{ width, height,
      { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() } };
  };
  // Positions in the window are rounded otherwise.
  return Check(render(0, 0).GetLargestDifference(render(37, 21)) <= 1,
    "another picture where the viewport does not begin in a corner");
}

/** A line that turns nearly back, on whose joint plane its two tubes meet in a seam above the x
 * axis. */
vtkSmartPointer<vtkPolyData> MakeHairpin()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(2.0, 0.4, 0.0);
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(2.0, -0.4, 0.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1, 2 });
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

// A tenth of a radius at the seam: rays cross the joint plane outside the tubes and enter one of
// them just behind it.
bool TestSeamOfASharpBend()
{
  bool passed = true;
  for (const bool parallel : { false, true })
  {
    for (const double aside : { -0.1, 0.0, 0.1 })
    {
      SphereScene scene(200, 150, 0, 0, 0);
      AddLines(scene, MakeHairpin(), 0.1, 0.5);
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetFocalPoint(0.25, 0.0, 0.087);
      camera->SetPosition(0.25 - 4.0, aside * 5.0, 0.087 + 3.0);
      camera->SetViewUp(0, 0, 1);
      camera->SetViewAngle(0.12);
      camera->SetParallelProjection(parallel);
      camera->SetParallelScale(0.005);
      scene.Renderer->ResetCameraClippingRange();
      passed &= Compare(scene,
        std::string("seam of a sharp bend, ") + (parallel ? "parallel, " : "perspective, ") +
          std::to_string(aside));
    }
  }
  return passed;
}

bool TestClippingPlanes()
{
  SphereScene scene(320, 240, 0, 0, 0);
  vtkActor* actor = AddLines(scene, MakeLines(12, 200, 0), 0.15, 0.4);
  vtkNew<vtkPlane> across;
  across->SetNormal(0.4, -0.3, -1.0);
  actor->GetMapper()->AddClippingPlane(across);
  vtkNew<vtkPlane> aside;
  aside->SetOrigin(-0.3, 0.0, 0.0);
  aside->SetNormal(1.0, 0.2, 0.1);
  actor->GetMapper()->AddClippingPlane(aside);
  bool passed = Compare(scene, "tubes cut open by two planes");
  vtkTrajectoryMapper::SafeDownCast(actor->GetMapper())->SetRadiusArray("Radius");
  passed &= Compare(scene, "radii from an array, cut open by two planes");
  return passed;
}

bool TestLargeCoordinates()
{
  SphereScene scene(320, 240, 0, 0, 0);
  vtkSmartPointer<vtkPolyData> data = MakeLines(20, 60, 0);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    data->GetPoints()->SetPoint(i, 6.4e6 + point[0], 6.4e6 + point[1], -6.4e6 + point[2]);
  }
  data->GetPoints()->Modified();
  AddLines(scene, data, 0.04, 0.4);
  scene.Renderer->ResetCamera(6.4e6 - 2, 6.4e6 + 2, 6.4e6 - 2, 6.4e6 + 2, -6.4e6 - 2, -6.4e6 + 2);
  return Compare(scene, "trajectories at 6.4e6");
}

// Single precision does not tell the points of either end apart.
bool TestLargeExtent()
{
  SphereScene scene(320, 240, 0, 0, 0);
  vtkSmartPointer<vtkPolyData> data = MakeLines(20, 60, 0);
  const vtkIdType count = data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    const double far = i < count / 2 ? -6.4e6 : 6.4e6;
    data->GetPoints()->SetPoint(i, far + point[0], far + point[1], far + point[2]);
  }
  data->GetPoints()->Modified();
  AddLines(scene, data, 0.01, 0.4);
  scene.Renderer->ResetCamera(6.4e6 - 2, 6.4e6 + 2, 6.4e6 - 2, 6.4e6 + 2, 6.4e6 - 2, 6.4e6 + 2);
  scene.Renderer->GetActiveCamera()->Zoom(4.0);
  return Compare(scene, "trajectories at -6.4e6 and 6.4e6");
}

bool TestOnePixel()
{
  SphereScene scene(1, 1, 0, 4, 0);
  AddLines(scene, MakeLines(20, 60, 0), 0.04, 0.4);
  return Compare(scene, "trajectories in one pixel");
}

bool TestSameBits()
{
  const auto render = [](unsigned int seed, bool spheresFirst)
  {
    SphereScene scene(320, 240, 0, spheresFirst ? 5 : 0, spheresFirst ? 1 : 0);
    AddLines(scene, MakeLines(40, 50, seed), 0.05, 0.4);
    if (!spheresFirst)
    {
      scene.AddSphere(3, 1.0);
      for (int i = 4; i >= 0; --i)
      {
        scene.AddSphere(i, 0.1 + 0.05 * (i % 8));
      }
    }
    vtkTransparencyInstaller::Install(scene.Renderer);
    return Picture::Render(scene.Window);
  };
  const Picture first = render(0, true);
  bool passed = true;
  for (int run = 0; run < 10; ++run)
  {
    passed &= Check(render(0, true) == first, "run " + std::to_string(run) + " has other bits");
  }
  for (unsigned int seed = 1; seed < 5; ++seed)
  {
    passed &= Check(render(seed, seed % 2 == 0) == first,
      "draw order " + std::to_string(seed) + " has other bits");
  }
  return passed;
}
}

int TestExactTrajectories(int, char*[])
{
  bool passed = TestCrossingTubes();
  passed &= TestRadiiFromArray();
  passed &= TestMixedScene();
  passed &= TestOpacityOfTheTable();
  passed &= TestParallelProjection();
  passed &= TestEyeInsideATube();
  passed &= TestDenseJoints();
  passed &= TestThinTubes();
  passed &= TestSprites();
  passed &= TestPointSizeStays();
  passed &= TestViewportInsideTheWindow();
  passed &= TestSeamOfASharpBend();
  passed &= TestClippingPlanes();
  passed &= TestLargeCoordinates();
  passed &= TestLargeExtent();
  passed &= TestOnePixel();
  passed &= TestSameBits();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
