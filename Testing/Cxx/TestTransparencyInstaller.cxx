// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The installer leaves a renderer's passes as it found them, does nothing where nothing is
// translucent, and steps aside for selections and for passes that it does not know.
#include "OpenGLDebugOutput.h"
#include "Picture.h"
#include "SphereScene.h"

#include "vtkCameraPass.h"
#include "vtkDefaultPass.h"
#include "vtkExactTransparencyPass.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLightsPass.h"
#include "vtkOpaquePass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSelection.h"
#include "vtkSequencePass.h"
#include "vtkTestErrorObserver.h"
#include "vtkToneMappingPass.h"
#include "vtkTransparencyInstaller.h"

namespace
{
/** A pass that holds another one, of a class that the installer does not know. */
class HolderPass : public vtkRenderPass
{
public:
  static HolderPass* New() { VTK_STANDARD_NEW_BODY(HolderPass); }
  vtkTypeMacro(HolderPass, vtkRenderPass);

  void Render(const vtkRenderState* state) override
  {
    this->Held->Render(state);
    this->NumberOfRenderedProps = this->Held->GetNumberOfRenderedProps();
  }

  vtkSmartPointer<vtkRenderPass> Held;

  static vtkRenderPass* GetHeld(vtkRenderPass* pass)
  {
    return HolderPass::SafeDownCast(pass)->Held;
  }
  static void SetHeld(vtkRenderPass* pass, vtkRenderPass* held)
  {
    HolderPass::SafeDownCast(pass)->Held = held;
  }
  static vtkRenderPass* GetNone(vtkRenderPass*) { return nullptr; }
};

class HolderSubclass : public HolderPass
{
public:
  static HolderSubclass* New() { VTK_STANDARD_NEW_BODY(HolderSubclass); }
  vtkTypeMacro(HolderSubclass, HolderPass);
};

//------------------------------------------------------------------------------
bool TestOpaqueScene()
{
  SphereScene scene(200, 150, 0, 0, 5);
  OpenGLDebugOutput debugOutput(scene.Window);
  const Picture stock = Picture::Render(scene.Window);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  bool passed = Check(Picture::Render(scene.Window) == stock, "an opaque scene has other bits");
  passed &= Check(pass->GetStatistics()->GetNumberOfStages() == 0, "an opaque scene ran a stage");
  passed &= Check(pass->GetStatistics()->GetBufferBytes() == 0, "an opaque scene took memory");
  return passed;
}

bool TestChains()
{
  SphereScene scene(200, 150, 0, 8, 1);
  OpenGLDebugOutput debugOutput(scene.Window);
  const Picture stock = Picture::Render(scene.Window);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  bool passed = Check(
    vtkTransparencyInstaller::Install(scene.Renderer) == pass, "a second call makes a second pass");
  const Picture exact = Picture::Render(scene.Window);
  passed &= Check(!(exact == stock), "the exact picture is the stock one");

  vtkNew<vtkCameraPass> camera;
  vtkNew<vtkDefaultPass> standard;
  camera->SetDelegatePass(standard);
  scene.Renderer->SetPass(camera);
  passed &= Check(Picture::Render(scene.Window) == exact, "behind a camera pass");
  passed &= Check(camera->GetDelegatePass() == standard, "the chain is not as it was");

  vtkNew<vtkToneMappingPass> toneMapping;
  toneMapping->SetDelegatePass(camera);
  scene.Renderer->SetPass(toneMapping);
  pass->GetStatistics()->Reset();
  Picture::Render(scene.Window);
  passed &= Check(pass->GetStatistics()->GetFragments() > 0, "behind an image processing pass");
  passed &= Check(scene.Renderer->GetPass() == toneMapping, "the first pass is not as it was");
  toneMapping->ReleaseGraphicsResources(scene.Window);

  vtkNew<vtkSSAAPass> supersampling;
  vtkNew<vtkRenderStepsPass> steps;
  supersampling->SetDelegatePass(steps);
  scene.Renderer->SetPass(supersampling);
  pass->GetStatistics()->Reset();
  Picture::Render(scene.Window);
  passed &= Check(pass->GetStatistics()->GetFragments() > 0, "behind supersampling");
  passed &= Check(supersampling->GetDelegatePass() == steps, "the steps are not as they were");
  supersampling->ReleaseGraphicsResources(scene.Window);

  vtkNew<vtkSequencePass> sequence;
  vtkNew<vtkRenderPassCollection> passes;
  sequence->SetPasses(passes);
  camera->SetDelegatePass(sequence);
  scene.Renderer->SetPass(camera);
  passes->AddItem(steps);
  passed &= Check(Picture::Render(scene.Window) == exact, "behind a sequence of one pass");
  passed &= Check(passes->GetLastRenderPass() == steps, "the sequence is not as it was");
  passes->RemoveAllItems();
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  auto* installer =
    vtkObject::SafeDownCast(scene.Renderer->GetInformation()->Get(vtkTransparencyInstaller::KEY()));
  vtkNew<vtkTest::ErrorObserver> observer;
  installer->AddObserver(vtkCommand::WarningEvent, observer);
  pass->GetStatistics()->Reset();
  Picture::Render(scene.Window);
  passed &= Check(pass->GetStatistics()->GetFragments() == 0, "an unknown leaf was replaced");
  passed &= Check(observer->GetWarning() &&
      observer->GetWarningMessage().find("vtkSequencePass") != std::string::npos,
    "no warning names the unknown leaf");

  scene.Renderer->SetPass(nullptr);
  vtkTransparencyInstaller::Uninstall(scene.Renderer);
  passed &= Check(!vtkTransparencyInstaller::GetPass(scene.Renderer), "a pass after Uninstall");
  passed &= Check(!scene.Renderer->GetPass(), "Uninstall leaves a pass in the renderer");
  passed &= Check(Picture::Render(scene.Window) == stock, "after Uninstall");
  return passed;
}

bool TestAddedHolder()
{
  SphereScene scene(200, 150, 0, 8, 1);
  OpenGLDebugOutput debugOutput(scene.Window);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  const Picture exact = Picture::Render(scene.Window);
  vtkNew<vtkCameraPass> camera;
  vtkNew<HolderSubclass> holder;
  vtkNew<vtkDefaultPass> standard;
  holder->Held = standard;
  camera->SetDelegatePass(holder);
  scene.Renderer->SetPass(camera);
  const auto isExact = [&]
  {
    pass->GetStatistics()->Reset();
    const Picture picture = Picture::Render(scene.Window);
    return pass->GetStatistics()->GetFragments() > 0 && picture == exact;
  };
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkObject::SafeDownCast(scene.Renderer->GetInformation()->Get(vtkTransparencyInstaller::KEY()))
    ->AddObserver(vtkCommand::WarningEvent, observer);
  bool passed = Check(!isExact(), "a class of holders is known before it is added");
  passed &= Check(observer->GetWarningMessage().find("HolderSubclass") != std::string::npos,
    "no warning names the unknown class");
  vtkTransparencyInstaller::AddHolder("HolderPass", HolderPass::GetHeld, HolderPass::SetHeld);
  passed &= Check(isExact(), "behind a subclass of a holder that was added");
  passed &= Check(holder->Held.Get() == standard, "the holder is not as it was");
  vtkTransparencyInstaller::AddHolder("HolderSubclass", HolderPass::GetNone, HolderPass::SetHeld);
  passed &= Check(!isExact(), "what was added for the base class counts");
  vtkTransparencyInstaller::AddHolder("HolderSubclass", HolderPass::GetHeld, HolderPass::SetHeld);
  passed &= Check(isExact(), "what was added again does not count");
  return passed;
}

bool TestSelection()
{
  SphereScene scene(200, 150, 0, 6, 2);
  vtkTransparencyInstaller::Install(scene.Renderer);
  Picture::Render(scene.Window);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 199, 149);
  const auto exact = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  vtkTransparencyInstaller::Uninstall(scene.Renderer);
  const auto stock = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  bool passed = Check(exact->GetNumberOfNodes() > 1, "nothing was selected");
  passed &= Check(
    exact->GetNumberOfNodes() == stock->GetNumberOfNodes(), "the selection is not the stock one");
  return passed;
}

bool TestNoRenderer()
{
  vtkTransparencyInstaller::Uninstall(nullptr);
  return Check(!vtkTransparencyInstaller::GetPass(nullptr), "a pass without a renderer");
}

// Several renderers in one window, one of them in a layer above, each with its own pass.
bool TestSeveralRenderers()
{
  SphereScene left(300, 150, 0, 6, 1);
  SphereScene alone(150, 150, 0, 6, 1);
  vtkTransparencyInstaller::Install(alone.Renderer);
  const Picture expected = Picture::Render(alone.Window);

  left.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  vtkNew<vtkRenderer> right;
  right->SetViewport(0.5, 0.0, 1.0, 1.0);
  right->SetBackground(left.Renderer->GetBackground());
  right->SetActiveCamera(left.Renderer->GetActiveCamera());
  vtkCollectionSimpleIterator cookie;
  vtkActorCollection* actors = left.Renderer->GetActors();
  actors->InitTraversal(cookie);
  while (vtkActor* actor = actors->GetNextActor(cookie))
  {
    right->AddActor(actor);
  }
  left.Window->AddRenderer(right);
  vtkTransparencyInstaller::Install(left.Renderer);
  vtkTransparencyInstaller::Install(right);
  const Picture both = Picture::Render(left.Window);
  bool same = true;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 150; ++x)
    {
      same &= std::equal(expected.GetPixel(x, y), expected.GetPixel(x, y) + 3, both.GetPixel(x, y));
      same &=
        std::equal(expected.GetPixel(x, y), expected.GetPixel(x, y) + 3, both.GetPixel(x + 150, y));
    }
  }
  return Check(same, "two renderers in a window differ from one alone");
}
}

int TestTransparencyInstaller(int, char*[])
{
  bool passed = TestOpaqueScene();
  passed &= TestChains();
  passed &= TestAddedHolder();
  passed &= TestSelection();
  passed &= TestNoRenderer();
  passed &= TestSeveralRenderers();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
