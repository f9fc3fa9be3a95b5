// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Measurement.h"

#include "PictureWindow.h"
#include "Statistics.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkCandidatePass.h"
#include "vtkExactTransparencyPass.h"
#include "vtkReferenceRenderer.h"
#include "vtkRenderer.h"
#include "vtkTransparencyInstaller.h"

#include <map>
#include <memory>

namespace pellucid
{
namespace benchmark
{
namespace
{
// Pixels, to either side of an edge of a surface, that may show any side of it. OpenGL places
// vertices on a grid of 1/256 pixel or finer.
constexpr double EdgeWidth = 1.0 / 256.0;

using Stages = std::vector<std::pair<std::string, double>>;

//------------------------------------------------------------------------------
// What a renderer should show in its first view; methods that draw the same form share it.
struct Expectation
{
  ExpectedPicture Picture;
  vtkIdType Fragments;
  vtkIdType LongestList;
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkReferenceRenderer> DrawReference(
  vtkRenderer* renderer, const std::array<int, 2>& size)
{
  auto reference = vtkSmartPointer<vtkReferenceRenderer>::New();
  reference->SetRenderer(renderer);
  reference->SetSize(size[0], size[1]);
  reference->Update();
  return reference;
}

//------------------------------------------------------------------------------
// A point in one corner of a square is beyond every straight edge that is nearer to its middle than
// its sides.
Expectation FindExpectation(vtkRenderer* renderer, const std::array<int, 2>& size)
{
  const auto reference = DrawReference(renderer, size);
  Expectation expectation{ ExpectedPicture(reference->GetImage()),
    reference->GetNumberOfFragments(), reference->GetLongestList() };
  vtkCamera* camera = renderer->GetActiveCamera();
  for (const double x : { -EdgeWidth, EdgeWidth })
  {
    for (const double y : { -EdgeWidth, EdgeWidth })
    {
      camera->SetWindowCenter(2.0 * x / size[0], 2.0 * y / size[1]);
      expectation.Picture.AddDisplaced(DrawReference(renderer, size)->GetImage());
    }
  }
  camera->SetWindowCenter(0.0, 0.0);
  return expectation;
}

//------------------------------------------------------------------------------
Stages GetStages(vtkTransparencyStatistics* statistics)
{
  Stages stages;
  for (int i = 0; i < statistics->GetNumberOfStages(); ++i)
  {
    stages.emplace_back(statistics->GetStageName(i), statistics->GetStageMilliseconds(i));
  }
  return stages;
}

//------------------------------------------------------------------------------
// Each stage's median over the frames in which it ran, in the order of their first run.
Stages FindMedians(const std::vector<Stages>& frames)
{
  std::vector<std::string> names;
  std::map<std::string, std::vector<double>> times;
  for (const Stages& frame : frames)
  {
    for (const auto& [name, milliseconds] : frame)
    {
      if (times[name].empty())
      {
        names.push_back(name);
      }
      times[name].push_back(milliseconds);
    }
  }
  Stages medians;
  for (const std::string& name : names)
  {
    medians.emplace_back(name, FindMedian(times[name]));
  }
  return medians;
}

//------------------------------------------------------------------------------
// A method at work on a scene, in a window that it shares with others.
class Contestant
{
public:
  Contestant(
    PictureWindow& window, Scene& scene, const Method& method, const MeasurementSettings& settings)
    : Window(window)
    , Settings(settings)
  {
    this->Renderer->DrawOff();
    window.AddRenderer(this->Renderer);
    scene.AddTo(this->Renderer, method.Form, settings.Opacity);
    method.Prepare(this->Renderer);
    this->Result.Scene = scene.GetName();
    this->Result.Method = method.Name;
    this->Result.Family = method.Family;
    this->Result.Parameter = method.Parameter;
    this->Result.Shape = method.GetShape(scene);
    this->Result.Width = settings.Size[0];
    this->Result.Height = settings.Size[1];
    this->Result.Opacity = settings.Opacity;
    this->Result.Segments = scene.GetNumberOfSegments();
    this->Result.HasOptimizedOpacities = method.HasOptimizedOpacities();
  }

  /** Draw the first view, and compare it unless nothing is expected. */
  void DrawFirst(const Expectation* expectation)
  {
    const double milliseconds = this->Draw();
    if (milliseconds >= 1000.0 * this->Settings.Budget)
    {
      this->Record(milliseconds);
    }
    if (vtkTransparencyStatistics* statistics = this->GetStatistics())
    {
      this->Result.Fragments = statistics->GetFragments();
      this->Result.LongestList = statistics->GetLongestList();
      this->Result.Bytes = statistics->GetBufferBytes();
    }
    else if (expectation)
    {
      this->Result.Fragments = expectation->Fragments;
      this->Result.LongestList = expectation->LongestList;
    }
    if (expectation)
    {
      this->Result.Error = FindPictureError(this->Window.Grab(false), expectation->Picture);
    }
  }

  /** Draw and time the next view, unless the budget is spent. */
  void DrawNext()
  {
    this->Renderer->GetActiveCamera()->Azimuth(1.0);
    this->Renderer->ResetCameraClippingRange();
    if (this->Result.Milliseconds.empty() || this->Spent < 1000.0 * this->Settings.Budget)
    {
      this->Record(this->Draw());
    }
  }

  vtkRenderer* GetRenderer() { return this->Renderer; }

  Row GetResult() const
  {
    Row result = this->Result;
    result.Stages = FindMedians(this->FrameStages);
    return result;
  }

private:
  double Draw()
  {
    this->Renderer->DrawOn();
    const double milliseconds = this->Window.Render();
    this->Renderer->DrawOff();
    return milliseconds;
  }

  void Record(double milliseconds)
  {
    this->Spent += milliseconds;
    this->Result.Milliseconds.push_back(milliseconds);
    if (vtkTransparencyStatistics* statistics = this->GetStatistics())
    {
      this->FrameStages.push_back(GetStages(statistics));
    }
  }

  vtkTransparencyStatistics* GetStatistics()
  {
    if (vtkExactTransparencyPass* pass = vtkTransparencyInstaller::GetPass(this->Renderer))
    {
      return pass->GetStatistics();
    }
    auto* camera = vtkCameraPass::SafeDownCast(this->Renderer->GetPass());
    auto* candidate = vtkCandidatePass::SafeDownCast(camera ? camera->GetDelegatePass() : nullptr);
    return candidate ? candidate->GetStatistics() : nullptr;
  }

  PictureWindow& Window;
  const MeasurementSettings& Settings;
  vtkNew<vtkRenderer> Renderer;
  Row Result;
  std::vector<Stages> FrameStages;
  double Spent = 0.0; // milliseconds
};
}

//------------------------------------------------------------------------------
std::vector<Row> Measure(
  Scene& scene, const std::vector<Method>& methods, const MeasurementSettings& settings)
{
  PictureWindow window(settings.Size);
  std::vector<std::unique_ptr<Contestant>> contestants;
  for (const Method& method : methods)
  {
    contestants.push_back(std::make_unique<Contestant>(window, scene, method, settings));
  }
  std::map<Geometry, Expectation> expectations;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const Expectation* expectation = nullptr;
    if (settings.FindsErrors)
    {
      const Geometry form = scene.HasPolygons() ? Geometry::Triangles : methods[i].Form;
      auto found = expectations.find(form);
      if (found == expectations.end())
      {
        vtkRenderer* renderer = contestants[i]->GetRenderer();
        found = expectations.emplace(form, FindExpectation(renderer, settings.Size)).first;
      }
      expectation = &found->second;
    }
    contestants[i]->DrawFirst(expectation);
  }
  for (int frame = 0; frame < settings.Frames; ++frame)
  {
    for (const auto& contestant : contestants)
    {
      contestant->DrawNext();
    }
  }
  std::vector<Row> rows;
  for (const auto& contestant : contestants)
  {
    rows.push_back(contestant->GetResult());
  }
  return rows;
}
}
}
