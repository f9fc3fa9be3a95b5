// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Opacities follow those of the view exponentially in time, whatever the frame rate, and arrive.
#include "FrameStages.h"
#include "LayerStack.h"
#include "ReferenceTesting.h"
#include "SegmentedScene.h"

#include "vtkImageData.h"
#include "vtkPlaneSource.h"
#include "vtkTexture.h"

#include <limits>

namespace
{
constexpr double FadeTime = 2.0;
constexpr double Weight = 2000.0;

/** Lines and a surface with one set of parameters, at a time. */
class Scene : public SphereScene
{
public:
  explicit Scene(double fadeTime)
    : SphereScene(120, 90, 0, 0, 0)
  {
    this->Lines = AddLines(*this, MakeSegmentedLines(12, 100), 0.06, 1.0);
    this->Surface = AddSurface<vtkPolyDataMapper>(*this, MakeSegmentedSphere(1.3, Wave), 1.0);
    for (vtkActor* actor : { this->Lines, this->Surface })
    {
      vtkOpacityOptimization::Attach(actor, this->Optimization);
    }
    this->Optimization->SetOcclusionWeight(1.0);
    this->Optimization->SetClutterWeight(0.0);
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
    this->Pass->SetFadeTime(fadeTime);
  }

  /// A frame at that time.
  Picture Render(double time)
  {
    this->Pass->SetFrameTime(time);
    return Picture::Render(this->Window);
  }

  bool IsFading() const { return this->Pass->GetStatistics()->GetFading(); }

  std::vector<double> GetOpacities()
  {
    std::vector<double> opacities;
    for (vtkActor* actor : { this->Lines, this->Surface })
    {
      const auto found = this->Pass->GetOptimizedOpacities(actor);
      for (vtkIdType i = 0; found && i < found->GetNumberOfValues(); ++i)
      {
        opacities.push_back(found->GetValue(i));
      }
    }
    return opacities;
  }

  vtkActor* Lines;
  vtkActor* Surface;
  vtkNew<vtkOpacityOptimization> Optimization;
  vtkExactTransparencyPass* Pass;
};

//------------------------------------------------------------------------------
// Largest difference from what lies that part of the way before the aim; what either of the ends
// has not seen is at its aim.
double GetLargestError(const std::vector<double>& found, const std::vector<double>& start,
  const std::vector<double>& aim, double part)
{
  double largest = found.size() == aim.size() && start.size() == aim.size() ? 0.0 : 2.0;
  for (std::size_t i = 0; i < found.size() && largest < 2.0; ++i)
  {
    const bool fades = start[i] >= 0.0 && aim[i] >= 0.0;
    const double expected = fades ? aim[i] + part * (start[i] - aim[i]) : aim[i];
    largest = std::max(largest, std::abs(found[i] - expected));
  }
  return largest;
}

//------------------------------------------------------------------------------
void TestChangedWeight(Checks& checks, int framesPerSecond)
{
  const std::string name = std::to_string(framesPerSecond) + " frames per second: ";
  Scene still(0.0);
  const Picture first = still.Render(0.0);
  const std::vector<double> start = still.GetOpacities();
  still.Optimization->SetOcclusionWeight(Weight);
  const Picture last = still.Render(0.0);
  const std::vector<double> aim = still.GetOpacities();
  checks.True(name + "the weight matters", GetLargestError(start, aim, aim, 0.0) > 0.5);

  Scene scene(FadeTime);
  OpenGLDebugOutput debugOutput(scene.Window);
  checks.True(name + "the first frame fades", scene.Render(100.0) == first && !scene.IsFading());
  checks.True(name + "an unchanged view fades", scene.Render(101.0) == first && !scene.IsFading());
  scene.Optimization->SetOcclusionWeight(Weight);
  checks.True(name + "the change jumps", scene.Render(102.0) == first && scene.IsFading());
  checks.True(name + GetStages(scene.Pass), RanStage(scene.Pass, "solve"));
  for (int frame = 1; frame <= framesPerSecond; ++frame)
  {
    const double seconds = static_cast<double>(frame) / framesPerSecond;
    scene.Render(102.0 + seconds);
    checks.Near(name + "after " + std::to_string(seconds) + " s",
      GetLargestError(scene.GetOpacities(), start, aim, std::exp(-seconds / FadeTime)), 0.0, 1e-5);
    checks.True(name + GetStages(scene.Pass), GetStages(scene.Pass) == "opaque copy fade resolve ");
  }
  scene.Render(102.0 + 6.0 * FadeTime);
  checks.True(name + "ends early", scene.IsFading());
  checks.True(name + "other bytes at the end", scene.Render(102.0 + 8.0 * FadeTime) == last);
  checks.True(name + "does not end", !scene.IsFading());
  checks.Near(name + "the end", GetLargestError(scene.GetOpacities(), aim, aim, 0.0), 0.0, 0.0);
  scene.Optimization->SetOcclusionWeight(1.0);
  scene.Render(200.0);
  scene.Optimization->SetOcclusionWeight(Weight);
  scene.Render(0.0);
  checks.True(name + "a film that begins again", scene.Render(8.0 * FadeTime) == last);
  checks.True(name + "after the end",
    scene.Render(150.0) == last && GetStages(scene.Pass) == UnchangedStages);
}

//------------------------------------------------------------------------------
// Segments that come into view have their aim at once.
void TestMovedView(Checks& checks)
{
  const auto center = [](Scene& scene, double x)
  { scene.Renderer->GetActiveCamera()->SetWindowCenter(x, 0.0); };
  Scene still(0.0);
  center(still, 0.0);
  still.Render(0.0);
  const std::vector<double> aim = still.GetOpacities();
  Scene scene(FadeTime);
  center(scene, 1.0);
  scene.Render(0.0);
  const std::vector<double> start = scene.GetOpacities();
  center(scene, 0.0);
  scene.Render(1.0);
  int arrivals = 0;
  for (std::size_t i = 0; i < aim.size(); ++i)
  {
    arrivals += start[i] < 0.0 && aim[i] >= 0.0 ? 1 : 0;
  }
  checks.True("nothing comes into view", arrivals > 5);
  checks.Near("moved", GetLargestError(scene.GetOpacities(), start, aim, 1.0), 0.0, 0.0);
  scene.Render(2.0);
  checks.Near("after the move",
    GetLargestError(scene.GetOpacities(), start, aim, std::exp(-1.0 / FadeTime)), 0.0, 1e-5);
}

//------------------------------------------------------------------------------
// A fade goes on where actors leave the view and come back.
void TestCulledActor(Checks& checks)
{
  Scene still(0.0);
  still.Render(0.0);
  const std::vector<double> start = still.GetOpacities();
  still.Optimization->SetOcclusionWeight(Weight);
  const Picture last = still.Render(0.0);
  const std::vector<double> aim = still.GetOpacities();
  still.Surface->SetPosition(100.0, 0.0, 0.0);
  still.Render(0.0);
  const std::vector<double> aimAlone = still.GetOpacities();

  Scene scene(FadeTime);
  OpenGLDebugOutput debugOutput(scene.Window);
  scene.Render(0.0);
  scene.Optimization->SetOcclusionWeight(Weight);
  scene.Render(1.0);
  scene.Surface->SetPosition(100.0, 0.0, 0.0);
  scene.Render(2.0);
  // Of lines that are seen in all frames.
  const auto compare = [&](const std::string& name, const std::vector<double>& expected)
  {
    const std::vector<double> found = scene.GetOpacities();
    int seen = 0;
    for (std::size_t i = 0; i < 100; ++i)
    {
      if (start[i] >= 0.0 && aim[i] >= 0.0 && aimAlone[i] >= 0.0)
      {
        checks.Near(name + std::to_string(i), found.at(i), expected[i], 1e-5);
        ++seen;
      }
    }
    checks.True(name + "nothing is seen", seen > 50 && scene.IsFading());
  };
  const double part = std::exp(-1.0 / FadeTime);
  std::vector<double> expected = start;
  const auto follow = [&](const std::vector<double>& target)
  {
    for (std::size_t i = 0; i < 100; ++i)
    {
      expected[i] = target[i] + part * (expected[i] - target[i]);
    }
  };
  follow(aim);
  compare("out of view, segment ", expected);
  scene.Surface->SetPosition(0.0, 0.0, 0.0);
  scene.Render(3.0);
  follow(aimAlone);
  compare("back in view, segment ", expected);
  checks.True("the end after both", scene.Render(100.0) == last && !scene.IsFading());
}

//------------------------------------------------------------------------------
// Scenes that are gathered and solved in every frame.
void TestUncertainScene(Checks& checks)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 12, 180);
  Scene scene(FadeTime);
  Scene still(0.0);
  for (Scene* textured : { &scene, &still })
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    textured->AddSphere(3, 1.0)->SetTexture(texture);
  }
  still.Optimization->SetOcclusionWeight(Weight);
  const Picture last = still.Render(0.0);
  OpenGLDebugOutput debugOutput(scene.Window);
  scene.Render(0.0);
  scene.Optimization->SetOcclusionWeight(Weight);
  scene.Render(1.0);
  Picture picture;
  double time = 1.0;
  do
  {
    time += 0.3 * FadeTime;
    picture = scene.Render(time);
    checks.True("a textured scene: " + GetStages(scene.Pass), RanStage(scene.Pass, "gather"));
  } while (scene.IsFading() && time < 20.0 * FadeTime);
  checks.True("a textured scene fades until " + std::to_string(time), time < 1.0 + 8.5 * FadeTime);
  checks.True("a textured scene: the end", picture == last);
}

//------------------------------------------------------------------------------
// Times that are no time of a film are those of the clock; what is no number does no harm.
void TestOddTimes(Checks& checks)
{
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const auto& [time, fadeTime] :
    std::vector<std::pair<double, double>>{
      { notANumber, FadeTime }, { -5.0, FadeTime }, { infinity, FadeTime }, { 9.0, notANumber } })
  {
    const std::string name =
      "time " + std::to_string(time) + ", fade time " + std::to_string(fadeTime) + ": ";
    Scene scene(FadeTime);
    scene.Render(0.0);
    scene.Pass->SetFadeTime(fadeTime);
    for (const double weight : { Weight, 1.0, Weight })
    {
      scene.Optimization->SetOcclusionWeight(weight);
      scene.Render(time);
      scene.Render(time);
      const std::vector<double> found = scene.GetOpacities();
      checks.True(name + "not an opacity",
        std::all_of(found.begin(), found.end(),
          [](double opacity) { return opacity == -1.0 || (opacity >= 0.0 && opacity <= 1.0); }));
    }
  }
  // The clock is far ahead of the film.
  Scene scene(FadeTime);
  scene.Render(0.0);
  scene.Optimization->SetOcclusionWeight(Weight);
  scene.Render(1.0);
  scene.Render(notANumber);
  checks.True("NaN is not the clock", !scene.IsFading());
}

//------------------------------------------------------------------------------
// Corners of surfaces: with one faded layer before an important one, colours follow as opacities
// do.
void TestSurface(Checks& checks)
{
  SphereScene scene(120, 90, 0, 0, 0);
  vtkNew<vtkOpacityOptimization> optimization;
  for (const double z : { 0.0, 1.0 })
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-3.0, -3.0, z);
    plane->SetPoint1(3.0, -3.0, z);
    plane->SetPoint2(-3.0, 3.0, z);
    plane->SetResolution(20, 20);
    plane->Update();
    AddImportance(plane->GetOutput(), [z](const double* p) { return z > 0.0 ? Wave(p) : 1.0; });
    vtkNew<vtkSurfaceSegments> divider;
    divider->SetInputConnection(plane->GetOutputPort());
    divider->SetNumberOfSegments(40);
    divider->Update();
    vtkActor* actor = AddSurface<vtkPolyDataMapper>(scene, divider->GetOutput(), 1.0);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(z, 0.0, 1.0 - z);
    vtkOpacityOptimization::Attach(actor, optimization);
  }
  LayerStack::SetCamera(scene.Renderer);
  scene.Renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 2.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5, 3.0);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  const auto render = [&](double time)
  {
    pass->SetFrameTime(time);
    return Picture::Render(scene.Window);
  };
  pass->SetFadeTime(FadeTime);
  const Picture start = render(0.0);
  optimization->SetOcclusionWeight(0.5);
  render(0.0);
  const Picture middle = render(1.5);
  const Picture end = render(8.0 * FadeTime);
  checks.True("the surface fades", start.GetLargestDifference(end) > 100);
  double largest = 0.0;
  for (std::size_t i = 0; i < middle.Rgba.size(); ++i)
  {
    const double expected = end.Rgba[i] + std::exp(-1.5 / FadeTime) * (start.Rgba[i] - end.Rgba[i]);
    largest = std::max(largest, std::abs(middle.Rgba[i] - expected));
  }
  checks.Near("colours of the surface", largest, 0.0, 1.01);
}

//------------------------------------------------------------------------------
// Whatever ends the fade, or the scene that fades, the picture is that of the new scene.
void TestInterruptions(Checks& checks)
{
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> interruptions = {
    { "no fade time", [](Scene& s) { s.Pass->SetFadeTime(0.0); } },
    { "an actor less", [](Scene& s) { s.Renderer->RemoveActor(s.Lines); } },
    { "an actor more",
      [](Scene& s)
      { Optimize(AddLines(s, MakeSegmentedLines(2, 9), 0.1, 1.0), 9, 9, 1, 0, true); } },
    { "other data",
      [](Scene& s)
      {
        vtkPolyDataMapper::SafeDownCast(s.Lines->GetMapper())
          ->SetInputData(MakeSegmentedLines(12, 140));
      } },
    { "a lost context", [](Scene& s) { s.Window->Finalize(); } },
    { "freed memory", [](Scene& s) { s.Pass->FreeGraphicsMemory(); } },
  };
  for (const auto& [name, interrupt] : interruptions)
  {
    Scene scene(FadeTime);
    scene.Render(0.0);
    scene.Optimization->SetOcclusionWeight(Weight);
    scene.Render(1.0);
    scene.Render(1.5);
    interrupt(scene);
    const Picture picture = scene.Render(2.0);
    checks.True(name + ": fades on", !scene.IsFading());
    Scene fresh(0.0);
    fresh.Optimization->SetOcclusionWeight(Weight);
    interrupt(fresh);
    checks.True(name + ": not the fresh picture", picture == fresh.Render(0.0));
    checks.True(name + ": the next frame differs", scene.Render(2.5) == picture);
  }
}
}

//------------------------------------------------------------------------------
int TestFading(int, char*[])
{
  Checks checks;
  TestChangedWeight(checks, 1);
  TestChangedWeight(checks, 10);
  TestMovedView(checks);
  TestCulledActor(checks);
  TestUncertainScene(checks);
  TestOddTimes(checks);
  TestSurface(checks);
  TestInterruptions(checks);
  return checks.Result();
}
