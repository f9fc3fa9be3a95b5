// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectorySource.h"

#include <algorithm>
#include <cmath>
#include <iterator>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
std::size_t vtkTrajectorySource::FindPressure() const
{
  return this->FindAny({ "air_pressure" }, { "pressure", "p", "P", "air_pressure", "plev" });
}

//------------------------------------------------------------------------------
std::size_t vtkTrajectorySource::FindHeight() const
{
  return this->FindAny({ "altitude", "height", "geopotential_height" },
    { "height", "z", "altitude", "alt", "geopotential_height" });
}

//------------------------------------------------------------------------------
std::size_t vtkTrajectorySource::FindAny(
  const std::vector<std::string>& standardNames, const std::vector<std::string>& names) const
{
  for (const std::string& standardName : standardNames)
  {
    for (std::size_t i = 0; i < this->Variables.size(); ++i)
    {
      if (!this->Variables[i].PerTrajectory && this->Variables[i].StandardName == standardName)
      {
        return i;
      }
    }
  }
  for (const std::string& name : names)
  {
    const std::size_t found = this->Find(name);
    if (found != None)
    {
      return found;
    }
  }
  return None;
}

//------------------------------------------------------------------------------
std::size_t vtkTrajectorySource::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Variables.begin(), this->Variables.end(),
    [&name](const Variable& variable) { return !variable.PerTrajectory && variable.Name == name; });
  return found == this->Variables.end() ? None : found - this->Variables.begin();
}

//------------------------------------------------------------------------------
std::string vtkTrajectorySource::ListVariables() const
{
  std::string list;
  for (const Variable& variable : this->Variables)
  {
    if (!variable.PerTrajectory)
    {
      list += (list.empty() ? "" : ", ") + variable.Name;
    }
  }
  return list;
}

//------------------------------------------------------------------------------
std::vector<double> vtkTrajectorySource::FindTimeSteps(vtkDoubleArray* times)
{
  const double* begin = times->GetPointer(0);
  std::vector<double> steps;
  std::copy_if(begin, begin + times->GetNumberOfValues(), std::back_inserter(steps),
    [](double time) { return std::isfinite(time); });
  std::sort(steps.begin(), steps.end());
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

VTK_ABI_NAMESPACE_END
