// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Measurement.h"

#include "BufferMemory.h"
#include "Expectation.h"
#include "PictureWindow.h"
#include "PlainText.h"
#include "Statistics.h"

#include "vtkCamera.h"
#include "vtkCameraPass.h"
#include "vtkCandidatePass.h"
#include "vtkExactTransparencyPass.h"
#include "vtkRenderer.h"
#include "vtkTransparencyInstaller.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>

namespace pellucid
{
namespace benchmark
{
namespace
{
// Budgets that the first frame may take for another one to follow it.
constexpr double BudgetsOfColdFrame = 4.0;

using Stages = std::vector<std::pair<std::string, double>>;

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
// What is known before anything is drawn.
Row MakeRow(const Scene& scene, const Method& method, const MeasurementSettings& settings)
{
  Row row;
  row.Scene = scene.GetName();
  row.Method = method.Name;
  row.Family = method.Family;
  row.Parameter = method.Parameter;
  row.Shape = method.GetShape(scene);
  row.Width = settings.Size[0];
  row.Height = settings.Size[1];
  row.Opacity = settings.Opacity;
  row.Segments = scene.GetNumberOfSegments();
  row.HasOptimizedOpacities = method.HasOptimizedOpacities();
  return row;
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
    , Result(MakeRow(scene, method, settings))
  {
    this->Renderer->DrawOff();
    window.AddRenderer(this->Renderer);
    scene.AddTo(this->Renderer, method.Form, settings.Opacity);
    method.Prepare(this->Renderer);
  }

  /** Draw the first view, and compare it if a picture is expected. */
  void DrawFirst(const Expectation* expectation)
  {
    const double milliseconds = this->Draw();
    if (milliseconds > 1000.0 * BudgetsOfColdFrame * this->Settings.Budget)
    {
      this->Result.IsCold = true;
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
    if (expectation && expectation->Picture)
    {
      this->Result.Error = FindPictureError(this->Window.Grab(false), *expectation->Picture);
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

  bool HasStatistics() { return this->GetStatistics() != nullptr; }

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
  std::vector<Stages> FrameStages; // of the frames that are timed
  double Spent = 0.0;              // milliseconds
};

//------------------------------------------------------------------------------
// Methods that share a scene, and what is expected of them.
class Contest
{
public:
  Contest(Scene& scene, const MeasurementSettings& settings)
    : Shown(scene)
    , Settings(settings)
  {
  }

  /** In one window, frame by frame in turn. */
  std::vector<Row> MeasureInTurn(const std::vector<Method>& methods)
  {
    PictureWindow window(this->Settings.Size);
    std::vector<std::unique_ptr<Contestant>> contestants;
    for (const Method& method : methods)
    {
      contestants.push_back(
        std::make_unique<Contestant>(window, this->Shown, method, this->Settings));
      contestants.back()->DrawFirst(this->Expect(*contestants.back(), method.Form));
    }
    for (int frame = 0; frame < this->Settings.Frames; ++frame)
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
      rows.back().IsInterleaved = contestants.size() > 1;
    }
    if (rows.size() == 1)
    {
      rows.front().BufferBytes = FindBufferBytes();
    }
    return rows;
  }

  /** Each in a window of its own, with no data of the others in memory. */
  std::vector<Row> MeasureOneByOne(const std::vector<Method>& methods)
  {
    std::vector<Row> rows;
    for (const Method& method : methods)
    {
      this->Shown.ReleaseOtherForms(method.Form);
      rows.push_back(this->MeasureInTurn({ method }).front());
    }
    return rows;
  }

private:
  /** Nothing where it is not asked for, and the method counts its fragments itself. */
  const Expectation* Expect(Contestant& contestant, Geometry form)
  {
    if (this->Shown.HasPolygons())
    {
      form = Geometry::Triangles;
    }
    const bool draws =
      this->Settings.FindsErrors && this->Shown.EstimateBytes(form, true) <= this->Settings.Memory;
    if (!draws && contestant.HasStatistics())
    {
      return nullptr;
    }
    auto found = this->Expectations.find(form);
    if (found == this->Expectations.end())
    {
      const auto& size = this->Settings.Size;
      found = this->Expectations
                .emplace(form,
                  draws ? DrawExpectation(contestant.GetRenderer(), size)
                        : CountFragments(this->Shown, form, this->Settings.Opacity, size))
                .first;
    }
    return &found->second;
  }

  Scene& Shown;
  const MeasurementSettings& Settings;
  std::map<Geometry, Expectation> Expectations;
};

//------------------------------------------------------------------------------
std::string DescribeBytes(double bytes)
{
  const double unit = bytes < 1e9 ? 1e6 : 1e9;
  return ToText(std::ceil(10.0 * bytes / unit) / 10.0) + (bytes < 1e9 ? " MB" : " GB");
}

//------------------------------------------------------------------------------
std::string DescribeSkipped(const std::string& what, double needed, double allowed)
{
  return what + " would need about " + DescribeBytes(needed) + " of memory; --memory allows " +
    DescribeBytes(allowed);
}
}

//------------------------------------------------------------------------------
std::vector<Row> Measure(
  Scene& scene, const std::vector<Method>& methods, const MeasurementSettings& settings)
{
  const auto fits = [&scene, &settings](const Method& method)
  { return scene.EstimateBytes(method.Form, false) <= settings.Memory; };
  std::vector<Method> fitting;
  std::copy_if(methods.begin(), methods.end(), std::back_inserter(fitting), fits);
  Contest contest(scene, settings);
  const auto measured = scene.GetNumberOfSegments() <= settings.InterleavedSegments
    ? contest.MeasureInTurn(fitting)
    : contest.MeasureOneByOne(fitting);

  std::vector<Row> rows;
  auto next = measured.begin();
  for (const Method& method : methods)
  {
    const bool wasMeasured = fits(method);
    rows.push_back(wasMeasured ? *next++ : MakeRow(scene, method, settings));
    const double needed = scene.EstimateBytes(method.Form, wasMeasured && settings.FindsErrors);
    if (needed > settings.Memory)
    {
      rows.back().Skipped =
        DescribeSkipped(wasMeasured ? "the reference" : "the method", needed, settings.Memory);
    }
  }
  return rows;
}
}
}
