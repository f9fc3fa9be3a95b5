// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Opacity factors from a point array: pictures as the reference draws them, as VTK draws the same
// opacities given in other ways, nothing where they are 0, no cost without them.
#include "HelixScene.h"
#include "LastShaders.h"

#include "vtkElevationFilter.h"
#include "vtkExactTransparencyPass.h"
#include "vtkHardwareSelector.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkTestErrorObserver.h"

#include <functional>
#include <limits>
#include <sstream>

namespace
{
using Factor = std::function<double(vtkIdType)>;

vtkSmartPointer<vtkDoubleArray> MakeFactors(vtkPolyData* data, const Factor& factor)
{
  auto factors = vtkSmartPointer<vtkDoubleArray>::New();
  factors->SetName("Factor");
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    factors->InsertNextValue(factor(i));
  }
  return factors;
}

/** From 1 to 1e-4 and back, all along the points. */
double Wave(vtkIdType point)
{
  return std::pow(10.0, -2.0 + 2.0 * std::cos(0.17 * point));
}

/** Lines, balls, a fan of quads that cross them, and a strip; with the factors. */
vtkSmartPointer<vtkPolyData> MakeData(int lines, const Factor& factor)
{
  vtkSmartPointer<vtkPolyData> data = MakeLines(lines, 50, 0);
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkCellArray> strips;
  const auto addPoint = [&data](double x, double y, double z)
  {
    data->GetPointData()->GetScalars()->InsertNextTuple1(std::sin(3.0 * x + y));
    data->GetPointData()->GetArray("Radius")->InsertNextTuple1(0.05);
    return data->GetPoints()->InsertNextPoint(x, y, z);
  };
  for (int i = 0; i < 6; ++i)
  {
    const double x = 0.5 * i - 1.4;
    vtkIdType ids[] = { addPoint(x, -1.3, 0.3), addPoint(x + 0.4, -1.2, -0.7),
      addPoint(x + 0.5, 0.2, 0.1), addPoint(x + 0.1, 0.1, 0.6) };
    polygons->InsertNextCell(4, ids);
  }
  strips->InsertNextCell(12);
  for (int i = 0; i < 12; ++i)
  {
    strips->InsertCellPoint(addPoint(0.25 * i - 1.4, i % 2 ? 1.3 : 0.6, 0.4 * std::sin(i)));
  }
  data->SetPolys(polygons);
  data->SetStrips(strips);
  data->GetPointData()->AddArray(MakeFactors(data, factor));
  return data;
}

struct OpacityScene : SphereScene
{
  explicit OpacityScene(vtkDataObject* data, double opacity = 1.0, int opaqueSpheres = 1)
    : SphereScene(320, 240, 0, 0, opaqueSpheres)
  {
    this->Mapper->SetInputDataObject(data);
    this->Mapper->SetRadius(0.04);
    this->Mapper->SetScalarRange(-1.0, 1.0);
    this->Mapper->SetOpacityArray("Factor");
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->SetOpacity(opacity);
    this->Renderer->AddActor(this->Actor);
  }

  Picture RenderExact()
  {
    vtkTransparencyInstaller::Install(this->Renderer);
    return Picture::Render(this->Window);
  }

  vtkNew<vtkTrajectoryMapper> Mapper;
  vtkNew<vtkActor> Actor;
};

/** Coincident balls and quads, one behind the other, of which each one hides 1e-4 of the rest. */
vtkSmartPointer<vtkPolyData> MakeLayers()
{
  constexpr int layers = 2000;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> balls;
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i < layers; ++i)
  {
    const double z = 2.0 * i / layers - 1.0;
    balls->InsertNextCell({ points->InsertNextPoint(-0.7, 0.0, z) });
    quads->InsertNextCell(
      { points->InsertNextPoint(0.0, -1.0, z), points->InsertNextPoint(1.5, -0.8, z),
        points->InsertNextPoint(1.4, 0.9, z), points->InsertNextPoint(0.1, 1.0, z) });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(balls);
  data->SetPolys(quads);
  data->GetPointData()->AddArray(MakeFactors(data, [](vtkIdType) { return 1e-4; }));
  return data;
}

vtkSmartPointer<vtkLookupTable> MakeTable()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(256);
  table->SetAlphaRange(0.1, 1.0);
  table->SetRange(-1.0, 1.0);
  table->Build();
  return table;
}

bool TestAgainstReference()
{
  const std::pair<const char*, std::function<void(OpacityScene&)>> scenes[] = {
    { "factors", [](OpacityScene&) {} },
    { "factors and opacity of the property",
      [](OpacityScene& s) { s.Actor->GetProperty()->SetOpacity(0.6); } },
    { "factors and the plain colour", [](OpacityScene& s) { s.Mapper->ScalarVisibilityOff(); } },
    { "factors and opacities of the table",
      [](OpacityScene& s) { s.Mapper->SetLookupTable(MakeTable()); } },
    { "factors and interpolated scalars",
      [](OpacityScene& s)
      {
        s.Mapper->SetLookupTable(MakeTable());
        s.Mapper->InterpolateScalarsBeforeMappingOn();
      } },
    { "factors and radii", [](OpacityScene& s) { s.Mapper->SetRadiusArray("Radius"); } },
    { "factors and clipping planes",
      [](OpacityScene& s)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.0, 0.0, 0.2);
        plane->SetNormal(0.4, -0.3, -1.0);
        s.Mapper->AddClippingPlane(plane);
        s.Mapper->SetRadius(0.12);
      } },
    { "layers of 1e-4",
      [](OpacityScene& s)
      {
        s.Mapper->SetInputData(MakeLayers());
        s.Mapper->SetRadius(0.6);
        s.Window->SetSize(80, 60);
      } },
    { "factors out of range",
      [](OpacityScene& s)
      {
        const double nan = vtkMath::Nan();
        const double infinity = std::numeric_limits<double>::infinity();
        s.Mapper->SetInputData(MakeData(20,
          [=](vtkIdType i)
          {
            const double values[] = { 0.3, nan, 0.5, -2.0, 0.1, 7.0, -infinity, infinity };
            return values[i / 3 % 8];
          }));
      } },
    { "a block without factors",
      [](OpacityScene& s)
      {
        vtkNew<vtkMultiBlockDataSet> blocks;
        const auto plain = MakeData(4, Wave);
        plain->GetPointData()->RemoveArray("Factor");
        blocks->SetBlock(0, plain);
        blocks->SetBlock(2, MakeData(12, Wave));
        s.Mapper->SetInputDataObject(blocks);
      } },
  };
  bool passed = true;
  for (const auto& [name, prepare] : scenes)
  {
    OpacityScene scene(MakeData(25, Wave));
    prepare(scene);
    passed &= Compare(scene, name);
  }
  return passed;
}

// In all ways of VTK to blend: the alpha of direct colours, and the same as factors.
bool TestAsAlphaOfColors()
{
  const auto getAlpha = [](vtkIdType i) { return 40 + 37 * i % 200; };
  const auto data = MakeData(20, [&](vtkIdType i) { return getAlpha(i) / 255.0; });
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> withAlpha;
  withAlpha->SetName("WithAlpha");
  withAlpha->SetNumberOfComponents(4);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double red = 29 * i % 256;
    colors->InsertNextTuple3(red, 255.0 - red, 90.0);
    withAlpha->InsertNextTuple4(red, 255.0 - red, 90.0, getAlpha(i));
  }
  data->GetPointData()->AddArray(colors);
  data->GetPointData()->AddArray(withAlpha);

  const std::pair<const char*, std::function<void(OpacityScene&)>> ways[] = {
    { "exact", [](OpacityScene& s) { vtkTransparencyInstaller::Install(s.Renderer); } },
    { "VTK's weighted blending", [](OpacityScene&) {} },
    { "VTK's depth peeling",
      [](OpacityScene& s)
      {
        s.Renderer->UseDepthPeelingOn();
        s.Renderer->SetMaximumNumberOfPeels(100);
      } },
  };
  bool passed = true;
  for (const auto& [name, prepare] : ways)
  {
    OpacityScene scene(data);
    OpenGLDebugOutput debugOutput(scene.Window);
    prepare(scene);
    scene.Mapper->SetScalarModeToUsePointFieldData();
    scene.Mapper->SelectColorArray("WithAlpha");
    scene.Mapper->SetOpacityArray(nullptr);
    const Picture expected = Picture::Render(scene.Window);
    scene.Mapper->SelectColorArray("Colors");
    const Picture opaque = Picture::Render(scene.Window);
    scene.Mapper->SetOpacityArray("Factor");
    const Picture shown = Picture::Render(scene.Window);
    passed &= Check(shown.GetLargestDifference(expected) <= 1,
      std::string(name) + ": factors are not as the alpha of colours");
    passed &= Check(
      shown.GetLargestDifference(opaque) > 50, std::string(name) + ": factors make no difference");
  }
  return passed;
}

vtkIdType CountFragments(OpacityScene& scene)
{
  return vtkTransparencyInstaller::GetPass(scene.Renderer)->GetStatistics()->GetFragments();
}

bool IsSelected(OpacityScene& scene)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 319, 239);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  return selection->GetNumberOfNodes() > 0;
}

vtkSmartPointer<vtkCellArray> KeepCells(vtkCellArray* cells, vtkIdType count)
{
  auto kept = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> points;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    cells->GetCellAtId(cell, points);
    kept->InsertNextCell(points);
  }
  return kept;
}

// Lines, balls and polygons of factor 0 leave no fragment, and cannot be selected.
bool TestZeroDrawsNothing()
{
  const vtkIdType ofTenLines = 10 * 50;
  OpacityScene scene(MakeData(20, [=](vtkIdType i) { return i < ofTenLines ? 0.7 : 0.0; }), 1.0, 0);
  OpenGLDebugOutput debugOutput(scene.Window);
  const Picture half = scene.RenderExact();
  const vtkIdType fragments = CountFragments(scene);
  bool passed = Check(fragments > 1000 && IsSelected(scene), "ten lines are not drawn");
  const auto lines = MakeLines(20, 50, 0);
  lines->SetVerts(KeepCells(lines->GetVerts(), 10));
  lines->SetLines(KeepCells(lines->GetLines(), 10));
  scene.Mapper->SetInputData(lines);
  scene.Actor->GetProperty()->SetOpacity(0.7);
  passed &= Check(
    Picture::Render(scene.Window).GetLargestDifference(half) <= 1, "lines of factor 0 are seen");
  passed &= Check(CountFragments(scene) == fragments, "lines of factor 0 have fragments");

  scene.Mapper->SetInputData(MakeData(20, [](vtkIdType) { return 0.0; }));
  const Picture nothing = Picture::Render(scene.Window);
  passed &= Check(CountFragments(scene) == 0, "factors of 0 have fragments");
  passed &= Check(!IsSelected(scene), "what cannot be seen is selected");
  scene.Actor->VisibilityOff();
  passed &= Check(Picture::Render(scene.Window) == nothing, "factors of 0 are seen");
  return passed;
}

bool TestChanges()
{
  const vtkSmartPointer<vtkPolyData> data = MakeData(15, Wave);
  auto other = MakeFactors(data, [](vtkIdType i) { return i % 7 / 7.0; });
  other->SetName("Other");
  data->GetPointData()->AddArray(other);
  OpacityScene scene(data);
  const Picture factors = scene.RenderExact();
  scene.Mapper->SetOpacityArray("Other");
  const Picture others = Picture::Render(scene.Window);
  bool passed = Check(others.GetLargestDifference(factors) > 20, "another array does not show");
  scene.Mapper->SetOpacityArray("Factor");
  passed &= Check(Picture::Render(scene.Window) == factors, "the first array does not come back");

  // The point moves in memory only, so it stays in the picture as long as nodes are not made again.
  double point[3];
  data->GetPoint(20, point);
  data->GetPoints()->SetPoint(20, 0.0, 0.0, 1.5);
  vtkDataArray* array = data->GetPointData()->GetArray("Factor");
  array->ShallowCopy(other);
  array->SetName("Factor");
  array->Modified();
  passed &= Check(Picture::Render(scene.Window) == others, "changed values do not show");
  data->Modified();
  passed &=
    Check(Picture::Render(scene.Window).GetLargestDifference(others) > 20, "changed data stays");
  data->GetPoints()->SetPoint(20, point);
  data->GetPoints()->Modified();
  passed &= Check(Picture::Render(scene.Window) == others, "changed points stay");

  data->GetPointData()->RemoveArray("Factor");
  passed &= Check(!scene.Actor->HasTranslucentPolygonalGeometry(), "translucent without array");
  const Picture removed = Picture::Render(scene.Window);
  scene.Mapper->SetOpacityArray(nullptr);
  passed &= Check(Picture::Render(scene.Window) == removed, "a missing array is not as none");
  return passed;
}

// A filter that passes points and cells on and makes new factors each time.
bool TestFilter()
{
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputData(MakeData(10, Wave));
  elevation->SetLowPoint(-1.5, 0.0, 0.0);
  const auto prepare = [&elevation](OpacityScene& scene)
  {
    scene.Mapper->SetInputConnection(elevation->GetOutputPort());
    scene.Mapper->ScalarVisibilityOff();
    scene.Mapper->SetOpacityArray("Elevation");
  };
  OpacityScene scene(nullptr);
  prepare(scene);
  elevation->SetHighPoint(3.0, 0.0, 0.0);
  const Picture before = scene.RenderExact();
  elevation->SetHighPoint(1.0, 1.0, 0.0);
  const Picture after = Picture::Render(scene.Window);
  OpacityScene fresh(nullptr);
  prepare(fresh);
  bool passed = Check(after.GetLargestDifference(before) > 20, "new factors do not show");
  passed &= Check(fresh.RenderExact() == after, "new factors are not as in a new scene");
  return passed;
}

bool TestVectorsAsFactors()
{
  const vtkSmartPointer<vtkPolyData> data = MakeData(5, Wave);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(data->GetNumberOfPoints());
  vectors->Fill(0.5);
  data->GetPointData()->AddArray(vectors);
  OpacityScene scene(data);
  scene.Mapper->SetOpacityArray(nullptr);
  const Picture expected = scene.RenderExact();
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::WarningEvent, observer);
  scene.Mapper->SetOpacityArray("Vectors");
  bool passed = Check(Picture::Render(scene.Window) == expected, "vectors change the opacity");
  passed &= Check(
    observer->GetWarning() && observer->GetWarningMessage().find("'Vectors'") != std::string::npos,
    "no warning names the opacity array");
  observer->Clear();
  Picture::Render(scene.Window);
  passed &= Check(!observer->GetWarning(), "the warning is repeated");
  return passed;
}

bool TestIsTranslucent()
{
  OpacityScene scene(MakeData(2, [](vtkIdType) { return 1.0; }));
  bool passed = Check(scene.Actor->HasOpaqueGeometry(), "factors of 1 are not opaque");
  scene.Mapper->SetInputData(MakeData(2, [](vtkIdType i) { return i == 30 ? 0.99 : 1.0; }));
  passed &=
    Check(scene.Actor->HasTranslucentPolygonalGeometry() && !scene.Actor->HasOpaqueGeometry(),
      "a factor below 1 is not translucent");
  vtkNew<vtkTrajectoryMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  std::ostringstream printed;
  copy->Print(printed);
  passed &= Check(copy->HasTranslucentPolygonalGeometry() &&
      printed.str().find("OpacityArray: Factor") != std::string::npos,
    "a copy lacks the array");
  return passed;
}

bool TestNoCostWithoutArray()
{
  const vtkSmartPointer<vtkPolyData> data = MakeLines(3, 20, 0);
  data->GetPointData()->AddArray(MakeFactors(data, [](vtkIdType) { return 1.0; }));
  OpacityScene scene(data, 1.0, 0);
  scene.Mapper->SetOpacityArray(nullptr);
  const std::string without = GetLastShaders(scene.Renderer);
  scene.Mapper->SetOpacityArray("Factor");
  const std::string with = GetLastShaders(scene.Renderer);
  scene.Mapper->SetOpacityArray("Missing");
  const std::string missing = GetLastShaders(scene.Renderer);
  bool passed = Check(without.find("coneShape") != std::string::npos, "no shaders of cones");
  passed &= Check(with.find("nodeOpacities") != std::string::npos, "shaders without factors");
  passed &= Check(without.find("nodeOpacities") == std::string::npos && missing == without,
    "shaders of a scene without array are not the same as before");
  return passed;
}
}

int TestTrajectoryMapperOpacity(int, char*[])
{
  bool passed = TestAgainstReference();
  passed &= TestAsAlphaOfColors();
  passed &= TestZeroDrawsNothing();
  passed &= TestChanges();
  passed &= TestFilter();
  passed &= TestVectorsAsFactors();
  passed &= TestIsTranslucent();
  passed &= TestNoCostWithoutArray();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
