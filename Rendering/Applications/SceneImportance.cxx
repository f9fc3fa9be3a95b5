// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneImportance.h"

#include "Coloring.h"
#include "LineAttributes.h"
#include "RenderError.h"
#include "RenderOptions.h"
#include "SceneFilter.h"

#include "vtkIdTypeArray.h"
#include "vtkImportance.h"
#include "vtkNew.h"
#include "vtkTrajectoryAttributes.h"

#include <algorithm>

namespace pellucid
{
namespace
{
// Half of the values are context; a few outliers do not set the scale.
constexpr RangeLimit LeastImportant = { 50.0, true };
constexpr RangeLimit MostImportant = { 99.0, true };

constexpr const char* TrajectoryIds = "TrajectoryId"; // of our readers: names, no quantities

//------------------------------------------------------------------------------
// The array whose greater values are likely to be what someone looks for.
std::string ChooseArray(const std::vector<Drawable>& drawables, const RenderOptions& options)
{
  if (!options.ColorBy.empty() && options.ColorBy != ImportanceArray)
  {
    return options.ColorBy;
  }
  const auto canCompute = [&](int attribute)
  {
    return AnyPart(drawables,
      [&](vtkPolyData* part)
      { return part->GetNumberOfLines() > 0 && CanCompute(part, attribute, options); });
  };
  const bool isTraced = std::any_of(drawables.begin(), drawables.end(),
    [](const Drawable& drawable) { return !drawable.Speed.empty(); });
  if (!isTraced && canCompute(vtkTrajectoryAttributes::TOTAL_PRESSURE_DIFFERENCE))
  {
    return vtkTrajectoryAttributes::GetAttributeName(
      vtkTrajectoryAttributes::TOTAL_PRESSURE_DIFFERENCE);
  }
  const std::string name = ChooseColorArray(drawables);
  if (!name.empty() && name != TrajectoryIds)
  {
    return name;
  }
  return canCompute(vtkTrajectoryAttributes::CURVATURE)
    ? vtkTrajectoryAttributes::GetAttributeName(vtkTrajectoryAttributes::CURVATURE)
    : "";
}

//------------------------------------------------------------------------------
// Drawables of parts that all have importance, or all lack it.
std::vector<Drawable> Divide(
  const std::vector<Drawable>& drawables, const PartTest& hasAll, bool isFactor)
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
        result.back().IsFaded = hasImportance && isFactor;
      }
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
void ChooseImportance(const std::vector<Drawable>& drawables, RenderOptions& options)
{
  if (!options.Importance.empty() || options.Opacities.Rule == OpacityRule::Factor)
  {
    return;
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
}

//------------------------------------------------------------------------------
std::vector<long long> AddImportance(std::vector<Drawable>& drawables, const RenderOptions& options)
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
  drawables = Divide(drawables, hasAll, options.Opacities.Rule == OpacityRule::Factor);

  vtkNew<vtkImportance> filter;
  for (const ImportanceTerm& term : options.Importance)
  {
    filter->AddCriterion(term.Array.c_str(), term.Minimum.Value, term.Maximum.Value, term.Weight,
      term.Minimum.IsPercentile, term.Maximum.IsPercentile);
  }
  filter->SetExponent(options.Exponent);
  FilterParts(drawables, hasAll, filter, "--importance");
  const auto* counts = filter->GetHistogram()->GetPointer(0);
  return { counts, counts + filter->GetHistogram()->GetNumberOfTuples() };
}
}
