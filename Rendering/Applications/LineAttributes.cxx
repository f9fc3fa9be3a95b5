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

#include <algorithm>
#include <utility>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
bool HasPressure(vtkPolyData* part, const std::string& name)
{
  return !name.empty() && part->GetPointData()->GetArray(name.c_str());
}

//------------------------------------------------------------------------------
// Add one attribute to the parts with lines that lack it, if it can be computed there. A chosen
// pressure is for the parts that have it.
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
  for (const bool hasPressure : { true, false })
  {
    vtkNew<vtkTrajectoryAttributes> filter;
    filter->SetAllAttributeStatuses(vtkTrajectoryAttributes::OFF);
    filter->SetAttributeStatus(name.c_str(), vtkTrajectoryAttributes::AUTOMATIC);
    filter->SetPressureArray(hasPressure ? options.Pressure.c_str() : nullptr);
    filter->SetUpAxis(options.UpAxis);
    filter->SetTimeWindow(options.TimeWindow);
    const auto lacksAttribute = [&](vtkPolyData* part)
    {
      return part->GetNumberOfLines() > 0 && !HasArray(part, name) &&
        HasPressure(part, options.Pressure) == hasPressure;
    };
    FilterParts(drawables, lacksAttribute, filter, name);
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
  for (const ImportanceTerm& term : options.Importance)
  {
    named.emplace_back("--importance", term.Array);
  }
  for (const SelectionRange& range : options.Selections)
  {
    named.emplace_back("--select", range.Array);
  }
  if (!options.ColorBy.empty() &&
    (options.ColorBy != ImportanceArray || options.Importance.empty()))
  {
    named.emplace_back("--color-by", options.ColorBy);
  }
  return named;
}

//------------------------------------------------------------------------------
bool IsThere(const std::vector<Drawable>& drawables, const std::string& name)
{
  return std::any_of(drawables.begin(), drawables.end(),
    [&name](const Drawable& drawable) { return FindArray(drawable, name).has_value(); });
}

//------------------------------------------------------------------------------
// What an attribute is computed from; empty for the name of another array.
std::string GetNeeds(const std::string& name)
{
  switch (vtkTrajectoryAttributes::GetAttributeIndex(name.c_str()))
  {
    case -1:
      return "";
    case vtkTrajectoryAttributes::TOTAL_PRESSURE_DIFFERENCE:
    case vtkTrajectoryAttributes::SEGMENT_PRESSURE_DIFFERENCE:
      return "lines with pressure, which --pressure names";
    case vtkTrajectoryAttributes::VELOCITY:
      return "lines with time";
    default:
      return "lines";
  }
}

//------------------------------------------------------------------------------
[[noreturn]] void Refuse(const std::string& option, const std::string& name,
  std::vector<Drawable> drawables, const RenderOptions& options)
{
  AddAttributes(drawables, options);
  const std::string needs = GetNeeds(name);
  const std::string reason = needs.empty() ? "there is no array '" + name + "' with numbers"
                                           : name + " is computed from " + needs;
  throw RenderError(option + ": " + reason + "; there are " + ListArrays(drawables));
}

//------------------------------------------------------------------------------
void CheckPressure(const std::vector<Drawable>& drawables, const RenderOptions& options)
{
  if (!options.Pressure.empty() && !IsThere(drawables, options.Pressure))
  {
    Refuse("--pressure", options.Pressure, drawables, options);
  }
}
}

//------------------------------------------------------------------------------
void AddAllAttributes(std::vector<Drawable>& drawables, const RenderOptions& options)
{
  CheckPressure(drawables, options);
  AddAttributes(drawables, options);
}

//------------------------------------------------------------------------------
void AddNamedAttributes(std::vector<Drawable>& drawables, const RenderOptions& options)
{
  CheckPressure(drawables, options);
  for (const auto& [option, name] : GetNamedArrays(options))
  {
    if (vtkTrajectoryAttributes::GetAttributeIndex(name.c_str()) >= 0)
    {
      AddAttribute(drawables, name, options);
    }
    if (!IsThere(drawables, name))
    {
      Refuse(option, name, drawables, options);
    }
  }
}
}
