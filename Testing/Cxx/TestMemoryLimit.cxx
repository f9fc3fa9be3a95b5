// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// A memory limit divides the frame into tiles without changing a bit, holds the lists within the
// limit, and is exceeded, with a warning, only by the list of a single pixel.
#include "FrameStages.h"
#include "LayerStack.h"
#include "SegmentedScene.h"

#include "vtkExactTransparencyPass.h"
#include "vtkTestErrorObserver.h"
#include "vtkTimerLog.h"
#include "vtkTransparencyInstaller.h"

namespace
{
bool TestSameBits(int samples)
{
  const std::string name = std::to_string(samples) + " samples: ";
  SphereScene scene(401, 299, samples, 40, 3);
  OpenGLDebugOutput debugOutput(scene.Window);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  vtkTransparencyStatistics* statistics = pass->GetStatistics();
  const Picture unlimited = Picture::Render(scene.Window);
  const vtkIdType fragments = statistics->GetFragments();
  bool passed = Check(statistics->GetTiles() == 1, name + "one tile without need for more");

  pass->SetMemoryLimit(1);
  const Picture limited = Picture::Render(scene.Window);
  passed &= Check(statistics->GetTiles() > 1, name + "several tiles");
  passed &= Check(statistics->GetFragments() == fragments, name + "the same fragments");
  passed &= Check(limited == unlimited, name + "tiles change bits");
  const vtkIdType copies = 401 * 299 * 8 * std::max(1, samples);
  passed &= Check(statistics->GetBufferBytes() - copies <= 1024 * 1024,
    name + "the lists take " + std::to_string(statistics->GetBufferBytes() - copies) + " bytes");

  const int tiles = statistics->GetTiles();
  passed &=
    Check(Picture::Render(scene.Window) == unlimited, name + "a second frame has other bits");
  passed &= Check(statistics->GetTiles() == tiles && statistics->GetGatherPasses() == tiles,
    name + "the second frame begins with the tiles of the first");
  pass->SetMemoryLimit(1024);
  passed &= Check(Picture::Render(scene.Window) == unlimited, name + "without limit again");
  passed &= Check(statistics->GetTiles() == 1, name + "one tile again");
  return passed;
}

// 70,000 nodes do not fit into 1 MiB, and one pixel cannot be divided.
bool TestOnePixel()
{
  const int layers = 70000;
  const LayerStack stack(layers, 1e-4);
  SphereScene scene(2, 1, 0, 0, 0);
  scene.Renderer->AddActor(stack.MakeActor(1));
  LayerStack::SetCamera(scene.Renderer);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  const Picture unlimited = Picture::Render(scene.Window);
  vtkNew<vtkTest::ErrorObserver> observer;
  pass->AddObserver(vtkCommand::WarningEvent, observer);
  pass->SetMemoryLimit(1);
  bool passed = Check(Picture::Render(scene.Window) == unlimited, "a long list in a small limit");
  passed &= Check(observer->GetWarning() &&
      observer->GetWarningMessage().find("memory limit of 1 MiB") != std::string::npos,
    "no warning that the limit is exceeded");
  observer->Clear();
  Picture::Render(scene.Window);
  passed &= Check(!observer->GetWarning(), "the warning is repeated");
  return passed;
}

// A stage is one event of VTK's timer log, also when it runs in several tiles.
bool TestTimerLog()
{
  SphereScene scene(401, 299, 0, 40, 3);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  pass->SetMemoryLimit(1);
  scene.Window->Render();
  vtkTimerLog::ResetLog();
  scene.Window->Render();
  std::vector<std::pair<std::string, double>> logged;
  const std::string prefix = "Pellucid ";
  for (int event = 0; event < vtkTimerLog::GetNumberOfEvents(); ++event)
  {
    const std::string name = vtkTimerLog::GetEventString(event);
    if (name.compare(0, prefix.size(), prefix) == 0)
    {
      logged.emplace_back(name.substr(prefix.size()), vtkTimerLog::GetEventWallTime(event) * 1e3);
    }
  }
  vtkTransparencyStatistics* statistics = pass->GetStatistics();
  bool passed = Check(statistics->GetTiles() > 1 && statistics->GetNumberOfStages() > 3 &&
      static_cast<int>(logged.size()) == statistics->GetNumberOfStages(),
    std::to_string(logged.size()) + " stages in the timer log");
  for (const auto& [stage, milliseconds] : logged)
  {
    passed &= Check(milliseconds > 0.0 &&
        std::abs(milliseconds / statistics->GetStageMilliseconds(stage) - 1.0) < 1e-9,
      stage + " took " + std::to_string(milliseconds) + " ms in the timer log");
  }
  return passed;
}

// Importance makes nodes larger.
bool TestLaterImportance()
{
  SphereScene scene(401, 299, 0, 40, 0);
  OpenGLDebugOutput debugOutput(scene.Window);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  const auto render = [&]
  {
    Picture::Render(scene.Window);
    return pass->GetStatistics()->GetBufferBytes() - 401 * 299 * 8;
  };
  const vtkIdType bytesPerMiB = 1024 * 1024;
  const int limit = static_cast<int>(render() / bytesPerMiB) + 1;
  pass->SetMemoryLimit(limit);
  bool passed = Check(render() <= limit * bytesPerMiB && pass->GetStatistics()->GetTiles() == 1,
    "all in the limit, without importance");
  Optimize(AddSurface<vtkPolyDataMapper>(scene, MakeSegmentedSphere(0.5, Wave), 0.9), 400.0, 50.0,
    2.0, 5, false);
  const vtkIdType bytes = render();
  const vtkIdType tables = bytesPerMiB / 2; // of the segments
  passed &= Check(bytes <= limit * bytesPerMiB + tables && RanStage(pass, "solve"),
    "lists with importance take " + std::to_string(bytes) + " bytes of " + std::to_string(limit) +
      " MiB");
  return passed;
}
}

int TestMemoryLimit(int, char*[])
{
  bool passed = TestSameBits(0);
  passed &= TestSameBits(4);
  passed &= TestOnePixel();
  passed &= TestTimerLog();
  passed &= TestLaterImportance();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
