// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Candidates that are exact by design show what the reference shows, of lines, surfaces and points
// with opaque objects among them. Where a candidate is not exact it says so.
#include "Candidates.h"
#include "HelixScene.h"
#include "LayerStack.h"

#include "vtkCameraPass.h"
#include "vtkCandidateDepthSlicesPass.h"
#include "vtkCandidateKBufferPass.h"
#include "vtkCandidateListsPass.h"
#include "vtkCandidateMultiLayerPass.h"
#include "vtkTestErrorObserver.h"

namespace
{
using pellucid::Candidate;

void SetPass(vtkRenderer* renderer, vtkCandidatePass* pass)
{
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(pass);
  renderer->SetPass(camera);
}

void AddMixedScene(SphereScene& scene)
{
  AddLines(scene, MakeLines(12, 60, 3), 0.04, 0.3);
  scene.AddGlyphs();
}

bool TestMixedScene(const Candidate& candidate)
{
  SphereScene scene(201, 149, 0, 8, 2);
  AddMixedScene(scene);
  OpenGLDebugOutput debugOutput(scene.Window);
  auto pass = candidate.MakePass();
  SetPass(scene.Renderer, pass);
  scene.Window->Render();
  const ReferenceComparison comparison(scene.Window, scene.Renderer);
  std::cout << pass->GetLossyPixels() << " lossy pixels; ";
  if (!candidate.IsExact)
  {
    std::cout << candidate.Name << ": RMSE " << comparison.GetRootMeanSquare() << ", "
              << comparison.GetUnexplainedPixels() << " pixels differ" << std::endl;
    return Check(pass->GetLossyPixels() > 0 || comparison.GetUnexplainedPixels() == 0,
      candidate.Name + ": pixels are wrong, but none is lossy");
  }
  bool passed = comparison.Passes(candidate.Name, 0.05);
  passed &= Check(pass->GetLossyPixels() == 0, candidate.Name + ": an exact candidate is lossy");
  passed &= Check(pass->GetFragments() > 0 && pass->GetBytes() > 0 && pass->GetLongestList() > 4,
    candidate.Name + ": a figure is missing");
  return passed;
}

/// The colour in the middle of a stack of layers, and what the pass says of it.
bool TestLayers(
  const std::string& name, vtkCandidatePass* pass, int layers, double opacity, bool isLossy)
{
  const LayerStack stack(layers, opacity);
  SphereScene scene(3, 3, 0, 0, 0);
  scene.Renderer->AddActor(stack.MakeActor(5));
  LayerStack::SetCamera(scene.Renderer);
  SetPass(scene.Renderer, pass);
  const Picture shown = Picture::Render(scene.Window);
  const auto expected = stack.GetColor({ 0.8 * 255.0, 0.6 * 255.0, 255.0 });
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    largest = std::max(largest, std::abs(shown.GetPixel(1, 1)[i] - expected[i]));
  }
  const std::string what = name + " of " + std::to_string(layers) + " layers";
  std::cout << what << ": error " << largest << ", " << pass->GetLossyPixels() << " lossy pixels"
            << std::endl;
  bool passed = Check(pass->GetFragments() == 9 * layers, what + ": fragments were not counted");
  passed &=
    Check(isLossy == (pass->GetLossyPixels() == 9), what + ": loss is not what was expected");
  passed &= Check(isLossy || largest <= 1.0, what + ": the colour is wrong");
  scene.Renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(scene.Window);
  return passed;
}

/// Lists that are just not too long are exact; longer ones are reported.
bool TestLongLists()
{
  bool passed = true;
  for (int sort = vtkCandidateListsPass::SORT_INSERTION;
       sort <= vtkCandidateListsPass::SORT_SELECTION; ++sort)
  {
    vtkNew<vtkCandidateListsPass> pass;
    pass->SetSort(sort);
    const std::string name = "sort " + std::to_string(sort);
    const int length = pass->GetLargestExactList();
    passed &= TestLayers(name, pass, length, 1e-3, false);
    passed &=
      TestLayers(name, pass, length + 1, 1e-3, sort != vtkCandidateListsPass::SORT_SELECTION);
    passed &= TestLayers(name, pass, 8000, 1e-4, true);
  }
  return passed;
}

/// Stopping where something can still be seen is reported.
bool TestThresholds()
{
  bool passed = true;
  for (const double threshold : { vtkCandidatePass::ExactTransmittance, 1.0 / 255.0, 0.05 })
  {
    vtkNew<vtkCandidateListsPass> pass;
    pass->SetNegligibleTransmittance(threshold);
    passed &= TestLayers("stop at " + std::to_string(threshold), pass, 60, 0.2,
      threshold > vtkCandidatePass::ExactTransmittance);
  }
  return passed;
}

/// Layers are exact up to their number, whatever the order; beyond, unsorted, they say what is
/// lost.
bool TestMultiLayers()
{
  bool passed = true;
  for (const int layers : { 1, 4, 16 })
  {
    vtkNew<vtkCandidateMultiLayerPass> pass;
    pass->SetLayers(layers);
    const std::string name = std::to_string(layers) + " merged layers";
    passed &= TestLayers(name, pass, layers, 0.3, false);
    passed &= TestLayers(name, pass, 40 * layers, 0.05, true);
  }
  return passed;
}

/// Sorted squares need but one entry.
bool TestKBuffers()
{
  bool passed = true;
  for (const int layers : { 1, 4, 64 })
  {
    vtkNew<vtkCandidateKBufferPass> pass;
    pass->SetLayers(layers);
    const std::string name = "k-buffer of " + std::to_string(layers);
    passed &= TestLayers(name, pass, 64, 0.05, false);
    passed &= TestLayers(name, pass, 1000, 0.005, false);
  }
  return passed;
}

/// Slices draw less where much is hidden, and tell where that can be seen.
bool TestDepthSlices()
{
  bool passed = true;
  vtkIdType allFragments = 0;
  for (const auto& [slices, threshold] :
    { std::pair<int, double>{ 1, vtkCandidatePass::ExactTransmittance },
      { 10, vtkCandidatePass::ExactTransmittance }, { 10, 0.05 } })
  {
    SphereScene scene(200, 150, 0, 0, 1);
    AddLines(scene, MakeLines(300, 60, 3), 0.15, 0.9);
    vtkNew<vtkCandidateDepthSlicesPass> pass;
    pass->SetLayers(16);
    pass->SetSlices(slices);
    pass->SetNegligibleTransmittance(threshold);
    SetPass(scene.Renderer, pass);
    scene.Window->Render();
    const ReferenceComparison comparison(scene.Window, scene.Renderer);
    const std::string name = std::to_string(slices) + " slices to " + std::to_string(threshold);
    std::cout << name << ": " << pass->GetFragments() << " fragments, " << pass->GetLossyPixels()
              << " lossy pixels" << std::endl;
    allFragments = slices == 1 ? pass->GetFragments() : allFragments;
    passed &= Check(
      slices == 1 || pass->GetFragments() < 0.95 * allFragments, name + ": nothing was culled");
    passed &= threshold < 0.01 ? Check(pass->GetLossyPixels() == 0, name + ": pixels are lossy") &&
        comparison.Passes(name, 0.05)
                               : Check(pass->GetLossyPixels() > 0, name + ": no pixel is lossy");
  }
  return passed;
}

/// A renderer that draws the fragments of one pixel at the same time is refused.
bool TestUnordered()
{
  using Pass = vtkCandidateLayersPass;
  bool passed = Check(Pass::GetReasonUnordered("llvmpipe (LLVM 15)", false).empty() &&
      Pass::GetReasonUnordered("NVIDIA", true).empty(),
    "a renderer that keeps the order is refused");
  passed &=
    Check(Pass::GetReasonUnordered("NVIDIA", false).find("found \"NVIDIA\"") != std::string::npos,
      "a renderer without order is not refused");
  return passed;
}

bool TestTies()
{
  bool passed = true;
  for (const Candidate& candidate : pellucid::GetCandidates())
  {
    if (candidate.Name.rfind("lists-", 0) != 0 || !candidate.IsExact)
    {
      continue;
    }
    SphereScene scene(100, 100, 0, 0, 0);
    for (int i = 0; i < 3; ++i)
    {
      const LayerStack stack(4, 0.3 + 0.2 * i);
      scene.Renderer->AddActor(stack.MakeActor(i));
    }
    LayerStack::SetCamera(scene.Renderer);
    auto pass = candidate.MakePass();
    SetPass(scene.Renderer, pass);
    scene.Window->Render();
    passed &= ReferenceComparison(scene.Window, scene.Renderer)
                .Passes(candidate.Name + ", coincident surfaces");
  }
  return passed;
}

/// The pass says why it draws the opaque scene alone, and all pixels are lossy.
bool Refuses(SphereScene& scene, vtkCandidatePass* pass, const std::string& reason)
{
  SetPass(scene.Renderer, pass);
  vtkNew<vtkTest::ErrorObserver> observer;
  pass->AddObserver(vtkCommand::ErrorEvent, observer);
  scene.Window->Render();
  const int* size = scene.Window->GetSize();
  bool passed = Check(observer->CheckErrorMessage(reason) == 0, "not refused: " + reason);
  passed &= Check(pass->GetLossyPixels() == size[0] * size[1], "not lossy: " + reason);
  return passed;
}

bool TestMultisampling()
{
  SphereScene scene(30, 30, 4, 3, 0);
  vtkNew<vtkCandidateListsPass> pass;
  return Refuses(scene, pass, "use vtkRenderWindow::SetMultiSamples(0)");
}

bool TestTooManyLayers()
{
  SphereScene scene(900, 900, 0, 1, 0);
  scene.Window->Render();
  if (vtkCandidateBuffers::GetLargestBytes() >= 900 * 900 * 64 * 8)
  {
    return true;
  }
  vtkNew<vtkCandidateMultiLayerPass> pass;
  pass->SetLayers(64);
  return Refuses(scene, pass, "OpenGL has no room for a buffer of");
}
}

int TestCandidates(int, char*[])
{
  bool passed = TestLongLists();
  passed &= TestThresholds();
  passed &= TestMultiLayers();
  passed &= TestKBuffers();
  passed &= TestDepthSlices();
  passed &= TestUnordered();
  passed &= TestTies();
  passed &= TestMultisampling();
  passed &= TestTooManyLayers();
  for (const Candidate& candidate : pellucid::GetCandidates())
  {
    passed &= TestMixedScene(candidate);
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
