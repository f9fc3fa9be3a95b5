// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneImportance.h"

#include "CellKinds.h"
#include "Coloring.h"
#include "LineAttributes.h"
#include "MessageLog.h"
#include "PlainText.h"
#include "RenderError.h"
#include "SceneFilter.h"

#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImportance.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTrajectoryAttributes.h"

#include <algorithm>
#include <sstream>

namespace pellucid
{
namespace
{
// Half of the values are context; a few outliers do not set the scale.
constexpr RangeLimit LeastImportant = { 50.0, true };
constexpr RangeLimit MostImportant = { 99.0, true };

constexpr const char* TrajectoryIds = "TrajectoryId"; // of our readers: names, no quantities

//------------------------------------------------------------------------------
// The array that would colour what has cells of that kind; empty if there is none.
std::string ChooseArrayOf(const std::vector<Drawable>& drawables, int kind)
{
  for (Drawable drawable : drawables)
  {
    std::vector<vtkDataSet*> parts;
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      if (GetKinds(part) & kind)
      {
        parts.push_back(part);
      }
    }
    drawable.Data = JoinParts(parts);
    const std::string name = ChooseColorArray({ drawable });
    if (!name.empty() && name != TrajectoryIds)
    {
      return name;
    }
  }
  return "";
}

//------------------------------------------------------------------------------
// The array whose greater values are likely to be what someone looks for.
std::string ChooseArray(const std::vector<Drawable>& drawables, const RenderOptions& options)
{
  const auto canCompute = [&](int attribute)
  {
    return AnyPart(drawables,
      [&](vtkPolyData* part)
      { return part->GetNumberOfLines() > 0 && CanCompute(part, attribute, options); });
  };
  const auto traced = std::find_if(drawables.begin(), drawables.end(),
    [](const Drawable& drawable) { return !drawable.Speed.empty(); });
  if (traced != drawables.end())
  {
    return traced->Speed;
  }
  if (canCompute(vtkTrajectoryAttributes::TOTAL_PRESSURE_DIFFERENCE))
  {
    return vtkTrajectoryAttributes::GetAttributeName(
      vtkTrajectoryAttributes::TOTAL_PRESSURE_DIFFERENCE);
  }
  if (!options.ColorBy.empty() && options.ColorBy != ImportanceArray)
  {
    return options.ColorBy;
  }
  for (const int kind : { Lines, Vertices, Surfaces })
  {
    const std::string name = ChooseArrayOf(drawables, kind);
    if (!name.empty())
    {
      return name;
    }
  }
  return canCompute(vtkTrajectoryAttributes::CURVATURE)
    ? vtkTrajectoryAttributes::GetAttributeName(vtkTrajectoryAttributes::CURVATURE)
    : "";
}

//------------------------------------------------------------------------------
// Drawables of parts that all have importance, which is a factor, or all lack it.
std::vector<Drawable> Divide(const std::vector<Drawable>& drawables, const PartTest& hasAll)
{
  std::vector<Drawable> result;
  for (const Drawable& drawable : drawables)
  {
    auto parts = drawable.GetLeaves();
    const auto middle = std::stable_partition(parts.begin(), parts.end(), hasAll);
    for (const bool hasImportance : { true, false })
    {
      const std::vector<vtkDataSet*> some(
        hasImportance ? parts.begin() : middle, hasImportance ? middle : parts.end());
      if (!some.empty())
      {
        result.push_back(drawable);
        result.back().Data = JoinParts(some);
        result.back().HasImportance = hasImportance;
        result.back().IsFaded = hasImportance;
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> WithoutImportance(vtkPolyData* part)
{
  vtkNew<vtkFloatArray> zeros;
  zeros->SetName(ImportanceArray);
  zeros->SetNumberOfTuples(part->GetNumberOfPoints());
  zeros->FillValue(0.0F);
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(part);
  copy->GetPointData()->AddArray(zeros);
  return copy;
}

//------------------------------------------------------------------------------
// Let all parts take part: those that lack an array are unimportant.
void Complete(std::vector<Drawable>& drawables, const PartTest& hasAll)
{
  for (Drawable& drawable : drawables)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> parts;
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      parts.push_back(hasAll(part) ? vtkSmartPointer<vtkPolyData>(part) : WithoutImportance(part));
    }
    drawable.Data = JoinParts({ parts.begin(), parts.end() });
    drawable.HasImportance = true;
  }
}

//------------------------------------------------------------------------------
// Least and greatest; the first above the second where there are no points.
NumberRange GetImportanceRange(const std::vector<Drawable>& drawables)
{
  NumberRange range = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (const Drawable& drawable : drawables)
  {
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      if (part->GetNumberOfPoints() > 0)
      {
        const double* own = part->GetPointData()->GetArray(ImportanceArray)->GetRange();
        range = { std::min(range[0], own[0]), std::max(range[1], own[1]) };
      }
    }
  }
  return range;
}

//------------------------------------------------------------------------------
void WarnOfEvenImportance(const std::vector<Drawable>& drawables, const RenderOptions& options)
{
  const NumberRange range = GetImportanceRange(drawables);
  if (range[0] == range[1])
  {
    const bool optimizes = options.Opacities.Rule == OpacityRule::Optimization;
    MessageLog& log = MessageLog::GetInstance();
    log.Clear();
    log.AddWarning(std::string(optimizes ? "--optimize" : "--avoid") + ": importance is " +
      ToText(static_cast<float>(range[0])) +
      " everywhere, so that nothing fades in favour of anything else; --list-arrays shows the "
      "ranges");
    log.PrintWarnings();
  }
}
}

//------------------------------------------------------------------------------
bool ChooseImportance(const std::vector<Drawable>& drawables, RenderOptions& options)
{
  if (!options.Importance.empty() || options.Opacities.Rule == OpacityRule::Factor)
  {
    return false;
  }
  const std::string name = ChooseArray(drawables, options);
  if (name.empty())
  {
    throw RenderError(
      "--importance: no input has an array of numbers that could tell what is important; without "
      "one, lines are needed");
  }
  options.Importance = { { name, LeastImportant, MostImportant } };
  options.ColorBy = options.ColorBy.empty() ? name : options.ColorBy;
  return true;
}

//------------------------------------------------------------------------------
std::string DescribeChoice(const ImportanceTerm& found)
{
  std::ostringstream text;
  text << "Importance: " << MakePrintable(found.Array) << ", from " << found.Minimum.Value << " ("
       << LeastImportant.Value << " %) to " << found.Maximum.Value << " (" << MostImportant.Value
       << " %)";
  return text.str();
}

//------------------------------------------------------------------------------
FoundImportance AddImportance(std::vector<Drawable>& drawables, const RenderOptions& options)
{
  if (options.Importance.empty())
  {
    return {};
  }
  const PartTest hasAll = [&options](vtkPolyData* part)
  {
    return std::all_of(options.Importance.begin(), options.Importance.end(),
      [part](const ImportanceTerm& term) { return HasArray(part, term.Array); });
  };
  if (!AnyPart(drawables, hasAll))
  {
    throw RenderError("--importance: no input has all of the arrays; name arrays of one input");
  }

  vtkNew<vtkImportance> filter;
  for (const ImportanceTerm& term : options.Importance)
  {
    filter->AddCriterion(term.Array.c_str(), term.Minimum.Value, term.Maximum.Value, term.Weight,
      term.Minimum.IsPercentile, term.Maximum.IsPercentile);
  }
  filter->SetExponent(options.Exponent);
  FilterParts(drawables, hasAll, filter, "--importance");
  if (options.Opacities.Rule == OpacityRule::Factor)
  {
    drawables = Divide(drawables, hasAll);
  }
  else
  {
    Complete(drawables, hasAll);
    WarnOfEvenImportance(drawables, options);
  }

  FoundImportance found;
  for (const ImportanceTerm& term : options.Importance)
  {
    const int index = static_cast<int>(found.Terms.size());
    found.Terms.push_back({ term.Array, { filter->GetEffectiveMinimum(index) },
      { filter->GetEffectiveMaximum(index) }, term.Weight });
  }
  const auto* counts = filter->GetHistogram()->GetPointer(0);
  found.Histogram.assign(counts, counts + filter->GetHistogram()->GetNumberOfTuples());
  return found;
}
}
