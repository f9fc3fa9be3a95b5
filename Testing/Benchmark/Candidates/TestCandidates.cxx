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
#include "vtkTransparencyInstaller.h"

#include <functional>

namespace
{
using pellucid::Candidate;

// Of the mixed scene at its size.
constexpr double LargestSilhouettePart = 0.05;

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

// Steps of 8 bits between two pictures that are rounded.
constexpr double Rounding = 1.0;

/// The largest error where compositing leaves out what weighs no more than that.
double GetBound(double transmittance)
{
  return 255.0 * transmittance + Rounding;
}

/// No wrong pixel but those that the pass counts. Stops are wrong by what they leave out, and
/// colours of 8 bits by half a step of opacity for each fragment, and half a step of colour.
bool TestLossy(const Candidate& candidate, SphereScene& scene, vtkCandidatePass* pass)
{
  const bool isStop = candidate.Family.rfind("lists-stop-", 0) == 0;
  const bool isColor = candidate.Family == "lists-color";
  const double tolerance = isStop ? GetBound(pass->GetNegligibleTransmittance())
    : isColor                     ? Rounding + 0.5 + 0.5 * pass->GetLongestList()
                                  : Rounding;
  const ReferenceComparison comparison(scene.Window, scene.Renderer, tolerance);
  const vtkIdType wrong = comparison.GetUnexplainedPixels();
  const vtkIdType allowed = isStop || isColor ? 0 : pass->GetLossyPixels();
  std::cout << candidate.Name << ": " << pass->GetLossyPixels() << " lossy pixels, RMSE "
            << comparison.GetRootMeanSquare() << ", " << wrong << " wrong by more than "
            << tolerance << std::endl;
  return Check(wrong <= allowed, candidate.Name + ": more pixels are wrong than theory allows");
}

bool TestMixedScene(const Candidate& candidate)
{
  SphereScene scene(201, 149, 0, 8, 2);
  AddMixedScene(scene);
  OpenGLDebugOutput debugOutput(scene.Window);
  auto pass = candidate.MakePass();
  SetPass(scene.Renderer, pass);
  scene.Window->Render();
  bool passed =
    Check(pass->GetFragments() > 0 && pass->GetBytes() > 0 && pass->GetLongestList() > 1,
      candidate.Name + ": a figure is missing");
  if (!candidate.IsExact)
  {
    return TestLossy(candidate, scene, pass) && passed;
  }
  passed &=
    ReferenceComparison(scene.Window, scene.Renderer).Passes(candidate.Name, LargestSilhouettePart);
  return Check(pass->GetLossyPixels() == 0, candidate.Name + ": an exact candidate is lossy") &&
    passed;
}

/// As many entries as the longest list has fragments are exact, whatever the order.
template <typename Pass>
bool TestEnoughLayers(const std::string& name)
{
  SphereScene scene(201, 149, 0, 8, 2);
  AddMixedScene(scene);
  vtkNew<Pass> pass;
  SetPass(scene.Renderer, pass);
  const auto longest =
    ReferenceComparison(scene.Window, scene.Renderer).GetLongestList(); // of any picture
  pass->SetLayers(static_cast<int>(longest));
  const ReferenceComparison comparison(scene.Window, scene.Renderer);
  const std::string what = name + " of " + std::to_string(longest);
  bool passed = Check(longest > 4 && longest <= 64, what + ": the scene tests nothing");
  passed &= Check(pass->GetLossyPixels() == 0, what + ": pixels are lossy");
  return comparison.Passes(what, LargestSilhouettePart) && passed;
}

/// The order of layers of one colour does not matter, so that nothing can be lost of them.
bool TestOneColor(const Candidate& candidate)
{
  constexpr int layers = 200;
  constexpr double opacity = 0.02;
  const LayerStack stack(layers, opacity);
  SphereScene scene(3, 3, 0, 0, 0);
  const auto actor = stack.MakeActor(7);
  actor->GetMapper()->ScalarVisibilityOff();
  actor->GetProperty()->SetColor(0.2, 1.0, 0.4);
  scene.Renderer->AddActor(actor);
  LayerStack::SetCamera(scene.Renderer);
  auto pass = candidate.MakePass();
  SetPass(scene.Renderer, pass);
  const Picture shown = Picture::Render(scene.Window);
  const double transmittance = std::pow(1.0 - opacity, layers);
  const double colors[3] = { 0.2 * 255.0, 255.0, 0.4 * 255.0 };
  const double background[3] = { 0.8 * 255.0, 0.6 * 255.0, 255.0 };
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double expected = colors[i] + transmittance * (background[i] - colors[i]);
    largest = std::max(largest, std::abs(shown.GetPixel(1, 1)[i] - expected));
  }
  // Of 8 bits the opacity is 5 / 255.
  const double rounded = std::pow(1.0 - std::round(255.0 * opacity) / 255.0, layers);
  const double bias = candidate.Name == "lists-color-32" ? std::abs(rounded - transmittance) : 0.0;
  const double bound =
    GetBound(std::max(pass->GetNegligibleTransmittance(), bias)); // of what is left out or added
  return Check(largest <= bound,
    candidate.Name + ": layers of one colour are wrong by " + std::to_string(largest) +
      ", expected at most " + std::to_string(bound));
}

/// The colour in the middle of a stack of layers, and what the pass says of it.
bool TestLayers(const std::string& name, vtkCandidatePass* pass, int layers, double opacity,
  bool isLossy, double bound)
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
  passed &= Check(largest <= bound, what + ": the colour is wrong");
  scene.Renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(scene.Window);
  return passed;
}

bool TestExactLayers(const std::string& name, vtkCandidatePass* pass, int layers, double opacity)
{
  return TestLayers(name, pass, layers, opacity, false, Rounding);
}

/// All that layers hide is in doubt, what they let through is not.
bool TestLossyLayers(const std::string& name, vtkCandidatePass* pass, int layers, double opacity)
{
  const double hidden = 1.0 - std::pow(1.0 - opacity, layers);
  return TestLayers(name, pass, layers, opacity, true, GetBound(hidden));
}

/// Lists that are just not too long are exact; longer ones are reported.
bool TestLongLists(bool isContiguous)
{
  bool passed = true;
  for (int sort = vtkCandidateListsPass::SORT_INSERTION;
       sort <= vtkCandidateListsPass::SORT_SELECTION; ++sort)
  {
    vtkNew<vtkCandidateListsPass> pass;
    pass->SetSort(sort);
    pass->SetContiguous(isContiguous);
    const std::string name = (isContiguous ? "array, sort " : "list, sort ") + std::to_string(sort);
    const int length = pass->GetLargestExactList();
    passed &= TestExactLayers(name, pass, length, 1e-3);
    passed &= sort == vtkCandidateListsPass::SORT_SELECTION
      ? TestExactLayers(name, pass, length + 1, 1e-3)
      : TestLossyLayers(name, pass, length + 1, 1e-3);
    passed &= TestLossyLayers(name, pass, 8000, 1e-4);
  }
  return passed;
}

/// Stopping where something can still be seen is reported, and leaves out no more than it says.
bool TestThresholds()
{
  bool passed = true;
  for (int sort = vtkCandidateListsPass::SORT_INSERTION;
       sort <= vtkCandidateListsPass::SORT_SELECTION; ++sort)
  {
    for (const double threshold : { vtkCandidatePass::ExactTransmittance, 1.0 / 255.0, 0.05 })
    {
      vtkNew<vtkCandidateListsPass> pass;
      pass->SetSort(sort);
      pass->SetNegligibleTransmittance(threshold);
      passed &=
        TestLayers("sort " + std::to_string(sort) + ", stop at " + std::to_string(threshold), pass,
          60, 0.2, threshold > vtkCandidatePass::ExactTransmittance, GetBound(threshold));
    }
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
    passed &= TestExactLayers(name, pass, layers, 0.3);
    passed &= TestLossyLayers(name, pass, 40 * layers, 0.05);
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
    passed &= TestExactLayers(name, pass, 64, 0.05);
    passed &= TestExactLayers(name, pass, 1000, 0.005);
  }
  return passed;
}

/// Slices draw less where much is hidden, and tell where that can be seen.
bool TestDepthSlices()
{
  bool passed = true;
  SphereScene whole(200, 150, 0, 0, 1);
  AddLines(whole, MakeLines(300, 60, 3), 0.15, 0.9);
  vtkNew<vtkCandidateKBufferPass> buffer;
  SetPass(whole.Renderer, buffer);
  whole.Window->Render();
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
    const bool isExact = threshold <= vtkCandidatePass::ExactTransmittance;
    const ReferenceComparison comparison(
      scene.Window, scene.Renderer, isExact ? Rounding : GetBound(threshold));
    const std::string name = std::to_string(slices) + " slices to " + std::to_string(threshold);
    std::cout << name << ": " << pass->GetFragments() << " fragments, " << pass->GetLossyPixels()
              << " lossy pixels" << std::endl;
    passed &=
      Check(pass->GetFragments() < 0.95 * buffer->GetFragments(), name + ": nothing was culled");
    passed &= Check(comparison.GetUnexplainedPixels() == 0, name + ": pixels are wrong");
    passed &= Check((pass->GetLossyPixels() == 0) == isExact, name + ": loss is not as expected");
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

/// Three stacks in the same places, drawn in an order that the seed gives.
Picture DrawCoincident(const std::function<void(vtkRenderer*)>& prepare, unsigned int seed)
{
  SphereScene scene(100, 100, 0, 0, 0);
  for (unsigned int i = 0; i < 3; ++i)
  {
    const unsigned int number = (i + seed) % 3;
    const LayerStack stack(4, 0.3 + 0.2 * number);
    scene.Renderer->AddActor(stack.MakeActor(seed + number));
  }
  LayerStack::SetCamera(scene.Renderer);
  prepare(scene.Renderer);
  return Picture::Render(scene.Window);
}

/// Fragments of equal depth are ordered as the product does, to the same bits.
bool TestTies()
{
  const auto install = [](vtkRenderer* renderer) { vtkTransparencyInstaller::Install(renderer); };
  const Picture expected = DrawCoincident(install, 0);
  bool passed = true;
  for (const Candidate& candidate : pellucid::GetCandidates())
  {
    if (!candidate.IsExact)
    {
      continue;
    }
    const auto prepare = [&candidate](vtkRenderer* renderer)
    { SetPass(renderer, candidate.MakePass()); };
    for (const unsigned int seed : { 0, 1, 2, 5 })
    {
      const int difference = DrawCoincident(prepare, seed).GetLargestDifference(expected);
      passed &= Check(difference == 0,
        candidate.Name + ": coincident surfaces differ from the product's by " +
          std::to_string(difference));
    }
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
  bool passed = TestLongLists(false);
  passed &= TestLongLists(true);
  passed &= TestThresholds();
  passed &= TestMultiLayers();
  passed &= TestKBuffers();
  passed &= TestEnoughLayers<vtkCandidateKBufferPass>("k-buffer");
  passed &= TestEnoughLayers<vtkCandidateMultiLayerPass>("merged layers");
  passed &= TestDepthSlices();
  passed &= TestUnordered();
  passed &= TestTies();
  passed &= TestMultisampling();
  passed &= TestTooManyLayers();
  for (const Candidate& candidate : pellucid::GetCandidates())
  {
    passed &= TestOneColor(candidate);
    passed &= TestMixedScene(candidate);
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
