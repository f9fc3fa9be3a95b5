// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneImportance.h"

#include "RenderError.h"
#include "RenderOptions.h"
#include "SceneFilter.h"

#include "vtkIdTypeArray.h"
#include "vtkImportance.h"
#include "vtkNew.h"

#include <algorithm>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
// Drawables of parts that all have importance, or all lack it.
std::vector<Drawable> Divide(const std::vector<Drawable>& drawables, const PartTest& hasAll)
{
  std::vector<Drawable> result;
  for (const Drawable& drawable : drawables)
  {
    auto parts = drawable.GetLeaves();
    const auto middle = std::stable_partition(parts.begin(), parts.end(), hasAll);
    for (const bool isImportance : { true, false })
    {
      const std::vector<vtkDataSet*> some(
        isImportance ? parts.begin() : middle, isImportance ? middle : parts.end());
      if (!some.empty())
      {
        result.push_back(drawable);
        result.back().Data = JoinParts(some);
        result.back().HasImportance = isImportance;
      }
    }
  }
  return result;
}
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
  drawables = Divide(drawables, hasAll);

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
