// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// A ball of vtkTrajectoryMapper looks like VTK's finely tessellated sphere under all kinds of
// lights and materials, opaque, and translucent by plain, weighted and dual-depth-peeled blending.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkLight.h"
#include "vtkLightKit.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTrajectoryMapper.h"
#include "vtkUnsignedCharArray.h"

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace
{
constexpr int Size = 150;

struct Look
{
  std::string Name;
  std::function<void(vtkRenderer*, vtkProperty*)> Apply;
};

vtkSmartPointer<vtkUnsignedCharArray> Render(vtkPolyDataMapper* mapper, const Look& look)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.7, 0.5);
  actor->GetProperty()->SetAmbient(0.1);
  actor->GetProperty()->SetDiffuse(0.8);
  actor->GetProperty()->SetSpecular(0.4);
  actor->GetProperty()->SetSpecularPower(15);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.1, 0.2, 0.3);
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(2, 3, 6);
  camera->SetFocalPoint(0.2, 0.1, 0);
  look.Apply(renderer, actor->GetProperty());
  renderer->ResetCameraClippingRange();
  window->Render();
  auto pixels = vtkSmartPointer<vtkUnsignedCharArray>::New();
  window->GetPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
  return pixels;
}

vtkLight* AddLight(vtkRenderer* renderer, int type)
{
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkLight> light;
  light->SetLightType(type);
  light->SetPosition(4, 3, 2);
  light->SetFocalPoint(0, 0, 0);
  light->SetColor(0.9, 0.8, 1.0);
  renderer->AddLight(light);
  return light;
}
}

int TestTrajectoryMapperLighting(int, char*[])
{
  vtkNew<vtkPolyData> ball;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  ball->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  ball->SetVerts(vertices);
  vtkNew<vtkTrajectoryMapper> balls;
  balls->SetInputData(ball);
  balls->SetRadius(1.0);
  vtkNew<vtkSphereSource> source;
  source->SetRadius(1.0);
  source->SetPhiResolution(400);
  source->SetThetaResolution(400);
  vtkNew<vtkPolyDataMapper> mesh;
  mesh->SetInputConnection(source->GetOutputPort());

  const Look looks[] = {
    { "headlight", [](vtkRenderer*, vtkProperty*) {} },
    { "no lighting", [](vtkRenderer*, vtkProperty* p) { p->LightingOff(); } },
    { "scene light",
      [](vtkRenderer* r, vtkProperty*) { AddLight(r, VTK_LIGHT_TYPE_SCENE_LIGHT); } },
    { "camera light",
      [](vtkRenderer* r, vtkProperty*) { AddLight(r, VTK_LIGHT_TYPE_CAMERA_LIGHT); } },
    { "spot light",
      [](vtkRenderer* r, vtkProperty*)
      {
        vtkLight* light = AddLight(r, VTK_LIGHT_TYPE_SCENE_LIGHT);
        light->PositionalOn();
        light->SetConeAngle(9);
        light->SetAttenuationValues(0.5, 0.1, 0.02);
      } },
    { "light kit",
      [](vtkRenderer* r, vtkProperty*)
      {
        vtkNew<vtkLightKit> kit;
        kit->AddLightsToRenderer(r);
      } },
    { "physically based",
      [](vtkRenderer* r, vtkProperty* p)
      {
        AddLight(r, VTK_LIGHT_TYPE_SCENE_LIGHT);
        p->SetInterpolationToPBR();
        p->SetMetallic(0.3);
        p->SetRoughness(0.4);
      } },
    { "coated",
      [](vtkRenderer* r, vtkProperty* p)
      {
        AddLight(r, VTK_LIGHT_TYPE_SCENE_LIGHT);
        p->SetInterpolationToPBR();
        p->SetCoatStrength(0.8);
        p->SetCoatRoughness(0.2);
      } },
    { "parallel projection",
      [](vtkRenderer* r, vtkProperty*)
      {
        AddLight(r, VTK_LIGHT_TYPE_SCENE_LIGHT);
        r->GetActiveCamera()->ParallelProjectionOn();
        r->GetActiveCamera()->SetParallelScale(1.5);
      } },
    // Balls have no back: with culling VTK's sphere makes one fragment, too.
    { "translucent",
      [](vtkRenderer*, vtkProperty* p)
      {
        p->SetOpacity(0.6);
        p->BackfaceCullingOn();
      } },
    { "depth peeling",
      [](vtkRenderer* r, vtkProperty* p)
      {
        p->SetOpacity(0.6);
        p->BackfaceCullingOn();
        r->UseDepthPeelingOn();
        r->SetOcclusionRatio(0.0);
      } },
  };
  bool right = true;
  for (const Look& look : looks)
  {
    const auto expected = Render(mesh, look);
    const auto found = Render(balls, look);
    int different = 0;
    int covered = 0;
    for (vtkIdType i = 0; i < Size * Size; ++i)
    {
      int difference = 0;
      bool background = true;
      for (int c = 0; c < 3; ++c)
      {
        difference = std::max(
          difference, std::abs(expected->GetValue(3 * i + c) - found->GetValue(3 * i + c)));
        background = background && expected->GetValue(3 * i + c) == expected->GetValue(c);
      }
      covered += !background;
      different += difference > 3;
    }
    // the outline, where the mesh is a polygon
    const bool same = covered > 1000 && different < covered / 50;
    std::cout << look.Name << ": " << different << " of " << covered << " pixels differ\n";
    right = right && same;
  }
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
