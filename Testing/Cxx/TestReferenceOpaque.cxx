// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The reference against VTK's own OpenGL picture of scenes without depth complexity: lighting,
 * colours, normals, glyphs, clipping and cameras agree to 1 of 255 except at edges, where
 * rasterisation in single precision may decide otherwise about a pixel.
 */

#include "ReferenceComparison.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkAssembly.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkConeSource.h"
#include "vtkElevationFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"

#include <functional>

namespace
{
constexpr int Width = 321;
constexpr int Height = 240;

/** The actor of a test scene: a coarse sphere with a strong highlight. */
struct Scene
{
  Scene()
  {
    this->Sphere->SetThetaResolution(24);
    this->Sphere->SetPhiResolution(17);
    this->Sphere->SetRadius(1.5);
    this->Mapper->SetInputConnection(this->Sphere->GetOutputPort());
    this->Actor->SetMapper(this->Mapper);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetColor(0.8, 0.5, 0.3);
    property->SetAmbient(0.1);
    property->SetSpecular(0.4);
    property->SetSpecularPower(20.0);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0.1, 0.2, 0.4);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
  }

  vtkProperty* Property() { return this->Actor->GetProperty(); }

  void ColorByHeight(bool interpolate)
  {
    vtkNew<vtkElevationFilter> height;
    height->SetInputConnection(this->Sphere->GetOutputPort());
    height->SetLowPoint(0, 0, -1.5);
    height->SetHighPoint(0, 0, 1.5);
    this->Mapper->SetInputConnection(height->GetOutputPort());
    this->Mapper->SetInterpolateScalarsBeforeMapping(interpolate);
  }

  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

void AddSpotLight(Scene& scene)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(1);
  light->SetPosition(2.0, 1.0, 4.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetConeAngle(18.0);
  light->SetExponent(2.0);
  light->SetAttenuationValues(0.5, 0.05, 0.02);
  light->SetDiffuseColor(1.0, 0.9, 0.7);
  scene.Renderer->AddLight(light);
}

void AddGlyphs(Scene& scene, double opacity)
{
  vtkNew<vtkArrowSource> arrow;
  scene.Sphere->SetThetaResolution(8);
  scene.Sphere->SetPhiResolution(6);
  vtkNew<vtkElevationFilter> height;
  height->SetInputConnection(scene.Sphere->GetOutputPort());
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(height->GetOutputPort());
  mapper->SetSourceConnection(arrow->GetOutputPort());
  mapper->SetOrientationArray("Normals");
  mapper->SetScaleArray("Elevation");
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleFactor(0.8);
  scene.Actor->SetMapper(mapper);
  scene.Property()->SetOpacity(opacity);
}

void AddOneTranslucentGlyph(Scene& scene)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.1, 0.2, 0.0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetSourceConnection(scene.Sphere->GetOutputPort());
  scene.Actor->SetMapper(mapper);
  scene.Property()->SetOpacity(0.6);
  scene.Property()->BackfaceCullingOn();
}

void ColorCells(Scene& scene)
{
  scene.Sphere->Update();
  vtkNew<vtkPolyData> data;
  data->ShallowCopy(scene.Sphere->GetOutput());
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < data->GetNumberOfCells(); ++i)
  {
    const unsigned char color[3] = { static_cast<unsigned char>(i * 37 % 256),
      static_cast<unsigned char>(i * 91 % 256), static_cast<unsigned char>(i * 13 % 256) };
    colors->InsertNextTypedTuple(color);
  }
  data->GetCellData()->SetScalars(colors);
  scene.Mapper->SetInputData(data);
}

void UseCellNormals(Scene& scene)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(scene.Sphere->GetOutputPort());
  normals->ComputePointNormalsOff();
  normals->ComputeCellNormalsOn();
  scene.Mapper->SetInputConnection(normals->GetOutputPort());
  scene.Property()->SetInterpolationToFlat();
}

void OpenSphere(Scene& scene)
{
  scene.Sphere->SetEndTheta(220.0);
  vtkNew<vtkProperty> inside;
  inside->SetColor(0.2, 0.9, 0.4);
  inside->SetSpecular(0.2);
  scene.Actor->SetBackfaceProperty(inside);
}

void ClipSphere(Scene& scene)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.1, 0.2, 0.3);
  plane->SetNormal(1.0, -0.5, -0.8);
  scene.Mapper->AddClippingPlane(plane);
}

void UseComposite(Scene& scene)
{
  scene.Sphere->Update();
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(4.0);
  cone->SetResolution(9);
  cone->Update();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, scene.Sphere->GetOutput());
  blocks->SetBlock(1, cone->GetOutput());
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  scene.Actor->SetMapper(mapper);
}

void UseStrips(Scene& scene)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(scene.Sphere->GetOutputPort());
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(triangles->GetOutputPort());
  scene.Mapper->SetInputConnection(strips->GetOutputPort());
  scene.Property()->BackfaceCullingOn();
}

void UseAssembly(Scene& scene)
{
  vtkNew<vtkAssembly> assembly;
  scene.Renderer->RemoveActor(scene.Actor);
  assembly->AddPart(scene.Actor);
  scene.Actor->SetScale(1.0, 0.5, 0.7);
  scene.Actor->RotateZ(30.0);
  assembly->RotateX(50.0);
  assembly->SetPosition(0.3, -0.2, 0.5);
  scene.Renderer->AddActor(assembly);
}

void UseLightKit(Scene& scene)
{
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(scene.Renderer);
}
}

int TestReferenceOpaque(int, char*[])
{
  const std::pair<const char*, std::function<void(Scene&)>> scenes[] = {
    { "headlight", [](Scene&) {} },
    { "flat interpolation", [](Scene& s) { s.Property()->SetInterpolationToFlat(); } },
    { "parallel flat interpolation",
      [](Scene& s)
      {
        s.Property()->SetInterpolationToFlat();
        s.Renderer->GetActiveCamera()->ParallelProjectionOn();
      } },
    { "parallel projection",
      [](Scene& s)
      {
        s.Renderer->GetActiveCamera()->ParallelProjectionOn();
        UseLightKit(s);
      } },
    { "cell normals", UseCellNormals },
    { "light kit", UseLightKit },
    { "spot light", AddSpotLight },
    { "no lighting", [](Scene& s) { s.Property()->LightingOff(); } },
    { "no lights", [](Scene& s) { s.Renderer->AutomaticLightCreationOff(); } },
    { "glyphs", [](Scene& s) { AddGlyphs(s, 1.0); } },
    { "one translucent glyph", AddOneTranslucentGlyph },
    { "colours of points", [](Scene& s) { s.ColorByHeight(false); } },
    { "colours from a texture", [](Scene& s) { s.ColorByHeight(true); } },
    { "colours of cells", ColorCells },
    { "back-face property", OpenSphere },
    { "clipping plane", ClipSphere },
    { "composite data", UseComposite },
    { "strips, back faces culled", UseStrips },
    { "front faces culled", [](Scene& s) { s.Property()->FrontfaceCullingOn(); } },
    { "assembly, scaled", UseAssembly },
    { "gradient background",
      [](Scene& s)
      {
        s.Renderer->GradientBackgroundOn();
        s.Renderer->SetBackground2(0.9, 0.8, 0.3);
        s.Actor->VisibilityOff();
      } },
    { "far from the origin",
      [](Scene& s)
      {
        s.Actor->SetPosition(6.4e6, -3.2e6, 1e5);
        s.Property()->SetInterpolationToFlat();
      } },
    { "near plane cuts", [](Scene&) {} },
  };
  bool passed = true;
  for (const auto& [name, prepare] : scenes)
  {
    Scene scene;
    prepare(scene);
    scene.Renderer->ResetCamera();
    scene.Renderer->GetActiveCamera()->Azimuth(25.0);
    scene.Renderer->GetActiveCamera()->Elevation(15.0);
    scene.Renderer->ResetCameraClippingRange();
    if (std::string(name) == "near plane cuts")
    {
      const double distance = scene.Renderer->GetActiveCamera()->GetDistance();
      scene.Renderer->GetActiveCamera()->SetClippingRange(distance - 0.9, distance + 0.2);
    }
    // VTK blends into 8 bit, and makes gradients between colours of 8 bit, thus rounds twice.
    const bool roundsTwice =
      scene.Property()->GetOpacity() < 1.0 || scene.Renderer->GetGradientBackground();
    const double tolerance = roundsTwice ? 2.0 : 1.0;
    passed &= ReferenceComparison(scene.Window, scene.Renderer, tolerance).Passes(name);
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
