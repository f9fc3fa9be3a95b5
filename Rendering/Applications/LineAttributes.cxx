// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "LineAttributes.h"

#include "RenderError.h"
#include "RenderOptions.h"
#include "SceneArrays.h"
#include "SceneFilter.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTrajectoryAttributes.h"

#include <utility>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
bool HasPointArray(vtkPolyData* part, const std::string& name)
{
  return !name.empty() && part->GetPointData()->GetArray(name.c_str());
}

//------------------------------------------------------------------------------
// Velocities are computed where the filter finds the time of the points.
bool HasTime(vtkPolyData* part)
{
  return CanCompute(part, vtkTrajectoryAttributes::VELOCITY, RenderOptions());
}

//------------------------------------------------------------------------------
bool NeedsTimeOfWindow(const std::string& name, const RenderOptions& options)
{
  return options.TimeWindow > 0.0 &&
    vtkTrajectoryAttributes::GetAttributeIndex(name.c_str()) ==
    vtkTrajectoryAttributes::TOTAL_PRESSURE_DIFFERENCE;
}

//------------------------------------------------------------------------------
// Add one attribute to the parts with lines that lack it, if it can be computed there. A chosen
// pressure or height is for the parts that have it.
void AddAttribute(
  std::vector<Drawable>& drawables, const std::string& name, const RenderOptions& options)
{
  for (Drawable& drawable : drawables)
  {
    if (!FindArray(drawable, name))
    {
      drawable.Computed.insert(name);
    }
  }
  const bool needsTime = NeedsTimeOfWindow(name, options);
  for (const bool hasPressure : { true, false })
  {
    for (const bool hasHeight : { true, false })
    {
      vtkNew<vtkTrajectoryAttributes> filter;
      filter->SetAllAttributeStatuses(vtkTrajectoryAttributes::OFF);
      filter->SetAttributeStatus(name.c_str(), vtkTrajectoryAttributes::AUTOMATIC);
      filter->SetPressureArray(hasPressure ? options.Pressure.c_str() : nullptr);
      filter->SetHeightArray(hasHeight ? options.Height.c_str() : nullptr);
      filter->SetUpAxis(options.UpAxis);
      filter->SetTimeWindow(options.TimeWindow);
      const auto lacksAttribute = [&](vtkPolyData* part)
      {
        return part->GetNumberOfLines() > 0 && !HasArray(part, name) &&
          HasPointArray(part, options.Pressure) == hasPressure &&
          HasPointArray(part, options.Height) == hasHeight && (!needsTime || HasTime(part));
      };
      FilterParts(drawables, lacksAttribute, filter, name);
    }
  }
}

//------------------------------------------------------------------------------
void AddAttributes(std::vector<Drawable>& drawables, const RenderOptions& options)
{
  for (int i = 0; i < vtkTrajectoryAttributes::GetNumberOfAttributes(); ++i)
  {
    AddAttribute(drawables, vtkTrajectoryAttributes::GetAttributeName(i), options);
  }
}

//------------------------------------------------------------------------------
// Options and the arrays that they name; Importance is no array yet.
std::vector<std::pair<std::string, std::string>> GetNamedArrays(const RenderOptions& options)
{
  std::vector<std::pair<std::string, std::string>> named;
  if (!options.ColorBy.empty() &&
    (options.ColorBy != ImportanceArray || options.Importance.empty()))
  {
    named.emplace_back("--color-by", options.ColorBy); // importance may come from it
  }
  for (const ImportanceTerm& term : options.Importance)
  {
    named.emplace_back("--importance", term.Array);
  }
  for (const SelectionRange& range : options.Selections)
  {
    named.emplace_back("--select", range.Array);
  }
  return named;
}

//------------------------------------------------------------------------------
// What an attribute is computed from; empty for the name of another array.
std::string GetNeeds(const std::string& name, const RenderOptions& options)
{
  switch (vtkTrajectoryAttributes::GetAttributeIndex(name.c_str()))
  {
    case -1:
      return "";
    case vtkTrajectoryAttributes::TOTAL_PRESSURE_DIFFERENCE:
    case vtkTrajectoryAttributes::SEGMENT_PRESSURE_DIFFERENCE:
      return std::string("lines with pressure, which --pressure names") +
        (NeedsTimeOfWindow(name, options) ? ", and with time, for --time-window" : "");
    case vtkTrajectoryAttributes::VELOCITY:
      return "lines with time";
    default:
      return "lines";
  }
}

//------------------------------------------------------------------------------
[[noreturn]] void Refuse(const std::string& option, const std::string& reason,
  std::vector<Drawable> drawables, const RenderOptions& options)
{
  AddAttributes(drawables, options);
  throw RenderError(option + ": " + reason + "; there are " + ListArrays(drawables));
}

//------------------------------------------------------------------------------
// The options that say what attributes are computed from.
void CheckRoles(const std::vector<Drawable>& drawables, const RenderOptions& options)
{
  for (const auto& [option, name] :
    { std::pair("--pressure", options.Pressure), { "--height", options.Height } })
  {
    const auto hasArray = [&array = name](vtkPolyData* part) { return HasPointArray(part, array); };
    if (!name.empty() && !AnyPart(drawables, hasArray))
    {
      Refuse(
        option, "there is no array '" + name + "' with numbers of the points", drawables, options);
    }
  }
  if (options.TimeWindow > 0.0 && !AnyPart(drawables, HasTime))
  {
    Refuse("--time-window",
      "needs the time of the points, in an array named time or IntegrationTime", drawables,
      options);
  }
}
}

//------------------------------------------------------------------------------
bool CanCompute(vtkPolyData* part, int attribute, const RenderOptions& options)
{
  // The filter adds what it can compute, also of no points.
  vtkNew<vtkPolyData> noPoints;
  noPoints->GetPointData()->CopyStructure(part->GetPointData());
  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(noPoints);
  filter->SetAllAttributeStatuses(vtkTrajectoryAttributes::OFF);
  filter->SetAttributeStatus(attribute, vtkTrajectoryAttributes::AUTOMATIC);
  if (HasPointArray(part, options.Pressure))
  {
    filter->SetPressureArray(options.Pressure.c_str());
  }
  filter->Update();
  return HasArray(filter->GetOutput(), vtkTrajectoryAttributes::GetAttributeName(attribute));
}

//------------------------------------------------------------------------------
void AddAllAttributes(std::vector<Drawable>& drawables, const RenderOptions& options)
{
  CheckRoles(drawables, options);
  AddAttributes(drawables, options);
}

//------------------------------------------------------------------------------
void AddNamedAttributes(std::vector<Drawable>& drawables, const RenderOptions& options)
{
  CheckRoles(drawables, options);
  for (const auto& [option, name] : GetNamedArrays(options))
  {
    if (vtkTrajectoryAttributes::GetAttributeIndex(name.c_str()) >= 0)
    {
      AddAttribute(drawables, name, options);
    }
    const auto hasArray = [&array = name](vtkPolyData* part) { return HasArray(part, array); };
    if (!AnyPart(drawables, hasArray))
    {
      const std::string needs = GetNeeds(name, options);
      Refuse(option,
        needs.empty() ? "there is no array '" + name + "' with numbers"
                      : name + " is computed from " + needs,
        drawables, options);
    }
  }
}
}
