// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineSelection.h"

#include "MessageLog.h"
#include "RenderError.h"
#include "RenderOptions.h"
#include "SceneFilter.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTrajectorySelection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkTrajectorySelection> MakeFilter(const SelectionRange& range)
{
  auto filter = vtkSmartPointer<vtkTrajectorySelection>::New();
  filter->SetArrayName(range.Array.c_str());
  if (range.Minimum)
  {
    filter->SetMinimum(range.Minimum->Value);
    filter->SetMinimumIsPercentile(range.Minimum->IsPercentile);
  }
  if (range.Maximum)
  {
    filter->SetMaximum(range.Maximum->Value);
    filter->SetMaximumIsPercentile(range.Maximum->IsPercentile);
  }
  return filter;
}

//------------------------------------------------------------------------------
bool HasPercentile(const SelectionRange& range)
{
  return (range.Minimum && range.Minimum->IsPercentile) ||
    (range.Maximum && range.Maximum->IsPercentile);
}

//------------------------------------------------------------------------------
PartTest PartsWithArray(const std::string& name)
{
  return [name](vtkPolyData* part) { return HasArray(part, name); };
}

//------------------------------------------------------------------------------
// The values of the part on as many points and cells, of which none is a line to select.
vtkSmartPointer<vtkPolyData> TakeValues(vtkPolyData* part)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(part->GetNumberOfCells() + 1);
  offsets->FillValue(0);
  vtkNew<vtkCellArray> emptyCells;
  emptyCells->SetData(offsets, vtkNew<vtkIdTypeArray>());
  auto values = vtkSmartPointer<vtkPolyData>::New();
  values->SetPoints(part->GetPoints());
  values->SetVerts(emptyCells);
  values->GetPointData()->ShallowCopy(part->GetPointData());
  values->GetCellData()->ShallowCopy(part->GetCellData());
  return values;
}

//------------------------------------------------------------------------------
// Replace percentiles by the values that they are in the drawables; without values, which the
// filter warns of, the range by one that selects nothing.
void ResolvePercentiles(SelectionRange& range, std::vector<Drawable> drawables)
{
  for (Drawable& drawable : drawables)
  {
    std::vector<vtkSmartPointer<vtkPolyData>> values;
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      values.push_back(TakeValues(part));
    }
    drawable.Data = JoinParts({ values.begin(), values.end() });
  }
  const auto filter = MakeFilter(range);
  FilterParts(drawables, PartsWithArray(range.Array), filter, "--select");
  const double minimum = filter->GetEffectiveMinimum();
  const double maximum = filter->GetEffectiveMaximum();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool isEmpty = std::isnan(minimum) || std::isnan(maximum);
  range.Minimum = RangeLimit{ isEmpty ? infinity : minimum, false };
  range.Maximum = RangeLimit{ isEmpty ? -infinity : maximum, false };
}
}

//------------------------------------------------------------------------------
void SelectLines(std::vector<Drawable>& drawables, const RenderOptions& options)
{
  auto ranges = options.Selections;
  for (SelectionRange& range : ranges)
  {
    // Percentiles are those of all lines, whatever another range discards.
    if (HasPercentile(range))
    {
      ResolvePercentiles(range, drawables);
    }
  }
  for (const SelectionRange& range : ranges)
  {
    FilterParts(drawables, PartsWithArray(range.Array), MakeFilter(range), "--select");
  }
  const auto lines = std::accumulate(drawables.begin(), drawables.end(), vtkIdType(0),
    [](vtkIdType sum, const Drawable& drawable) { return sum + drawable.GetNumberOfLines(); });
  const bool isEmpty = std::all_of(drawables.begin(), drawables.end(),
    [](const Drawable& drawable) { return drawable.GetNumberOfPoints() == 0; });
  if (isEmpty)
  {
    throw RenderError("--select: leaves nothing to draw; --list-arrays shows the arrays' ranges");
  }
  if (lines == 0 && !ranges.empty())
  {
    MessageLog& log = MessageLog::GetInstance();
    log.AddWarning("--select: leaves no line; --list-arrays shows the arrays' ranges");
    log.PrintWarnings();
  }
}
}
