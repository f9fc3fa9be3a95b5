// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces and glyphs of VTK's own mappers are drawn as the double-precision reference draws them.
#include "LayerStack.h"
#include "OpenGLDebugOutput.h"
#include "ReferenceComparison.h"
#include "SphereScene.h"

#include "vtkTransparencyInstaller.h"

namespace
{
bool Compare(SphereScene& scene, const std::string& name)
{
  OpenGLDebugOutput debugOutput(scene.Window);
  vtkTransparencyInstaller::Install(scene.Renderer);
  // Creates the light and the window before the reference looks at the scene.
  scene.Window->Render();
  return ReferenceComparison(scene.Window, scene.Renderer).Passes(name);
}

bool TestSpheres(int width, int height, const std::string& name)
{
  SphereScene scene(width, height, 0, 20, 4);
  return Compare(scene, name);
}

bool TestParallelProjection()
{
  SphereScene scene(300, 200, 0, 20, 4);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(1.8);
  scene.Renderer->GetActiveCamera()->Azimuth(30);
  return Compare(scene, "spheres in parallel projection");
}

bool TestLargeCoordinates()
{
  SphereScene scene(300, 200, 0, 12, 2);
  vtkCollectionSimpleIterator cookie;
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal(cookie);
  while (vtkActor* actor = actors->GetNextActor(cookie))
  {
    actor->SetPosition(6.4e6, -6.4e6, 6.4e6);
  }
  scene.Renderer->ResetCamera(6.4e6 - 2, 6.4e6 + 2, -6.4e6 - 2, -6.4e6 + 2, 6.4e6 - 2, 6.4e6 + 2);
  return Compare(scene, "spheres at 6.4e6");
}

bool TestCoincidentSurfaces()
{
  SphereScene scene(200, 200, 0, 0, 0);
  for (int i = 0; i < 3; ++i)
  {
    const LayerStack stack(4, 0.3 + 0.2 * i);
    scene.Renderer->AddActor(stack.MakeActor(i));
  }
  LayerStack::SetCamera(scene.Renderer);
  return Compare(scene, "coincident surfaces");
}

// A depth buffer of integers rounds the depth that a fragment has.
bool TestCoatedSphere()
{
  SphereScene scene(200, 150, 0, 0, 0);
  scene.AddCoatedSphere();
  return Compare(scene, "a translucent sphere where an opaque one is");
}

bool TestGlyphs()
{
  SphereScene scene(300, 300, 0, 3, 2);
  scene.AddGlyphs();
  return Compare(scene, "glyphs among spheres");
}

bool TestManyLayers()
{
  bool passed = true;
  for (const auto& [layers, opacity] : { std::pair<int, double>{ 64, 0.05 }, { 1000, 1e-4 },
         { 1000, 0.01 }, { 3000, 1e-3 }, { 100000, 1e-5 } })
  {
    const LayerStack stack(layers, opacity);
    SphereScene scene(3, 3, 0, 0, 0);
    scene.Renderer->AddActor(stack.MakeActor(5));
    LayerStack::SetCamera(scene.Renderer);
    passed &= Compare(scene, std::to_string(layers) + " layers");
  }
  return passed;
}
}

int TestExactSurfaces(int, char*[])
{
  bool passed = TestSpheres(301, 199, "spheres, odd viewport");
  passed &= TestSpheres(1, 1, "spheres in one pixel");
  passed &= TestParallelProjection();
  passed &= TestLargeCoordinates();
  passed &= TestCoincidentSurfaces();
  passed &= TestCoatedSphere();
  passed &= TestGlyphs();
  passed &= TestManyLayers();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
