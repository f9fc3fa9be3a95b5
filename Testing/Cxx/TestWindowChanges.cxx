// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The pass follows its renderer through what applications do to windows: other sample counts, a
// lost and re-created context, a move to another window, collapsed viewports, deletion in any
// order.
#include "LayerStack.h"
#include "OpenGLDebugOutput.h"
#include "Picture.h"
#include "SphereScene.h"

#include "vtkBillboardTextActor3D.h"
#include "vtkExactTransparencyPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkTextProperty.h"
#include "vtkTransparencyInstaller.h"

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

Picture RenderFresh(int samples)
{
  SphereScene scene(Width, Height, samples, 8, 1);
  vtkTransparencyInstaller::Install(scene.Renderer);
  return Picture::Render(scene.Window);
}

// More samples need more room for the notes on long lists.
bool TestSampleCount()
{
  const LayerStack stack(2500, 1e-3);
  SphereScene scene(24, 24, 0, 0, 0);
  scene.Renderer->AddActor(stack.MakeActor(1));
  LayerStack::SetCamera(scene.Renderer);
  vtkTransparencyInstaller::Install(scene.Renderer);
  const Picture plain = Picture::Render(scene.Window);
  scene.Window->SetMultiSamples(4);
  return Check(Picture::Render(scene.Window) == plain, "other bits with more samples");
}

// Supersampling has depths of floating point, which are not rounded.
bool TestDepthFormat()
{
  SphereScene scene(Width, Height, 0, 0, 0);
  scene.AddCoatedSphere();
  OpenGLDebugOutput debugOutput(scene.Window);
  vtkTransparencyInstaller::Install(scene.Renderer);
  vtkNew<vtkSSAAPass> supersampling;
  vtkNew<vtkRenderStepsPass> steps;
  supersampling->SetDelegatePass(steps);
  scene.Renderer->SetPass(supersampling);
  const Picture smooth = Picture::Render(scene.Window);
  bool passed =
    Check(smooth.GetPixel(Width / 2, Height / 2)[0] < 200, "supersampling shows no translucency");
  supersampling->ReleaseGraphicsResources(scene.Window);
  scene.Renderer->SetPass(nullptr);
  const Picture after = Picture::Render(scene.Window);
  SphereScene fresh(Width, Height, 0, 0, 0);
  fresh.AddCoatedSphere();
  vtkTransparencyInstaller::Install(fresh.Renderer);
  passed &= Check(Picture::Render(fresh.Window) == after, "after another depth format");
  return passed;
}

bool TestLostContext()
{
  SphereScene scene(Width, Height, 0, 8, 1);
  scene.Renderer->SetUseFXAA(true);
  vtkTransparencyInstaller::Install(scene.Renderer);
  const Picture first = Picture::Render(scene.Window);
  scene.Window->Finalize();
  bool passed = Check(Picture::Render(scene.Window) == first, "other bits after a lost context");
  scene.Renderer->SetFXAAOptions(nullptr);
  Picture::Render(scene.Window);
  return passed;
}

bool TestMovedRenderer()
{
  const Picture expected = RenderFresh(0);
  SphereScene scene(Width, Height, 0, 8, 1);
  vtkTransparencyInstaller::Install(scene.Renderer);
  Picture::Render(scene.Window);
  vtkNew<vtkRenderWindow> other;
  other->SetMultiSamples(0);
  other->SetSize(Width, Height);
  other->OffScreenRenderingOn();
  scene.Window->RemoveRenderer(scene.Renderer);
  other->AddRenderer(scene.Renderer);
  bool passed = Check(Picture::Render(other) == expected, "the first frame in another window");
  passed &= Check(Picture::Render(other) == expected, "the second frame in another window");
  other->RemoveRenderer(scene.Renderer);
  scene.Window->AddRenderer(scene.Renderer);
  passed &= Check(Picture::Render(scene.Window) == expected, "back in the first window");
  return passed;
}

bool TestCollapsedViewport()
{
  SphereScene scene(Width, Height, 0, 8, 1);
  OpenGLDebugOutput debugOutput(scene.Window);
  vtkTransparencyInstaller::Install(scene.Renderer);
  const Picture expected = Picture::Render(scene.Window);
  scene.Renderer->SetViewport(0.5, 0.0, 0.5, 1.0);
  scene.Window->Render();
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 0.001);
  scene.Window->Render();
  scene.Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  return Check(Picture::Render(scene.Window) == expected, "after a collapsed viewport");
}

bool TestWithoutWindow()
{
  vtkNew<vtkRenderer> renderer;
  vtkTransparencyInstaller::Install(renderer);
  vtkTransparencyInstaller::Uninstall(renderer);
  return Check(!vtkTransparencyInstaller::GetPass(renderer), "installed without a window");
}

// A label learns only in the opaque pass that it is translucent.
bool TestLabelInTheFirstFrame()
{
  const auto makeScene = [](SphereScene& scene)
  {
    vtkNew<vtkBillboardTextActor3D> label;
    label->SetInput("label");
    label->GetTextProperty()->SetFontSize(20);
    label->GetTextProperty()->SetColor(0.0, 0.0, 0.0);
    scene.Renderer->AddActor(label);
    vtkTransparencyInstaller::Install(scene.Renderer);
  };
  SphereScene scene(Width, Height, 0, 4, 0);
  makeScene(scene);
  const Picture first = Picture::Render(scene.Window);
  return Check(Picture::Render(scene.Window) == first, "the first frame lacks the label");
}

// Mappers hold the pass, so it can outlive its renderer; its memory must not.
bool TestMemoryEndsWithTheRenderer()
{
  SphereScene scene(Width, Height, 0, 8, 1);
  vtkSmartPointer<vtkExactTransparencyPass> pass =
    vtkTransparencyInstaller::Install(scene.Renderer);
  Picture::Render(scene.Window);
  bool passed = Check(pass->GetStatistics()->GetBufferBytes() > 0, "no memory in use");
  vtkTransparencyInstaller::Uninstall(scene.Renderer);
  passed &= Check(pass->GetStatistics()->GetBufferBytes() == 0, "memory in use after Uninstall");
  return passed;
}

// Parts of an application do not disturb one another.
bool TestOwners()
{
  SphereScene scene(Width, Height, 0, 8, 1);
  vtkNew<vtkObject> part;
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  bool passed = Check(
    vtkTransparencyInstaller::Install(scene.Renderer, part) == pass, "another owner, another pass");
  vtkTransparencyInstaller::Uninstall(scene.Renderer, part);
  vtkTransparencyInstaller::Uninstall(scene.Renderer, part);
  passed &= Check(vtkTransparencyInstaller::GetPass(scene.Renderer) == pass, "an owner is lost");
  vtkTransparencyInstaller::Uninstall(scene.Renderer);
  passed &= Check(!vtkTransparencyInstaller::GetPass(scene.Renderer), "an owner is left");
  return passed;
}

// A frame does not modify the renderer, which applications may watch.
bool TestFramesModifyNothing()
{
  SphereScene scene(Width, Height, 0, 8, 1);
  vtkTransparencyInstaller::Install(scene.Renderer);
  Picture::Render(scene.Window);
  const vtkMTimeType before = scene.Renderer->GetMTime();
  Picture::Render(scene.Window);
  bool passed = Check(scene.Renderer->GetMTime() == before, "a frame modifies the renderer");
  const int rendered =
    vtkTransparencyInstaller::GetPass(scene.Renderer)->GetNumberOfRenderedProps();
  passed &= Check(rendered == 9, std::to_string(rendered) + " props rendered");
  return passed;
}
}

int TestWindowChanges(int, char*[])
{
  bool passed = TestSampleCount();
  passed &= TestDepthFormat();
  passed &= TestLostContext();
  passed &= TestMovedRenderer();
  passed &= TestCollapsedViewport();
  passed &= TestWithoutWindow();
  passed &= TestLabelInTheFirstFrame();
  passed &= TestMemoryEndsWithTheRenderer();
  passed &= TestOwners();
  passed &= TestFramesModifyNothing();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
