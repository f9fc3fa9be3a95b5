// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLagrantoConventions.h"

#include "vtkTrajectorySource.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
// Of a time in hh.mm; with the sign of the time.
double GetMinutes(double time)
{
  return std::round(100.0 * (time - std::trunc(time)));
}

//------------------------------------------------------------------------------
double GetHours(double time)
{
  return std::trunc(time) + GetMinutes(time) / 60.0;
}

//------------------------------------------------------------------------------
// How much the steps between times in sequence differ; 0: not at all.
double GetUnevenness(const std::vector<double>& times)
{
  std::vector<double> steps(times.size());
  std::adjacent_difference(times.begin(), times.end(), steps.begin());
  const auto range =
    std::minmax_element(steps.begin() + std::min<std::size_t>(1, steps.size()), steps.end());
  return steps.size() < 2 ? 0.0 : *range.second - *range.first;
}

//------------------------------------------------------------------------------
bool HaveMinutes(const std::vector<double>& times)
{
  if (std::any_of(
        times.begin(), times.end(), [](double time) { return std::abs(GetMinutes(time)) >= 60.0; }))
  {
    return false;
  }
  constexpr double rounding = 0.005; // times have two digits after the point
  std::vector<double> hours(times.size());
  std::transform(times.begin(), times.end(), hours.begin(), GetHours);
  return GetUnevenness(hours) <= GetUnevenness(times) + rounding;
}
}

//------------------------------------------------------------------------------
std::string vtkLagrantoConventions::GetUnits(const std::string& variable)
{
  if (variable == "lon" || variable == "longitude")
  {
    return "degrees_east";
  }
  if (variable == "lat" || variable == "latitude")
  {
    return "degrees_north";
  }
  return variable == "p" ? "hPa" : variable == "z" ? "m" : "";
}

//------------------------------------------------------------------------------
std::string vtkLagrantoConventions::GetTimeUnits(
  double year, double month, double day, double hour, double minute)
{
  const auto isWithin = [](double value, double minimum, double maximum)
  { return value >= minimum && value <= maximum && value == std::floor(value); };
  if (!isWithin(year, 1, 9999) || !isWithin(month, 1, 12) || !isWithin(day, 1, 31) ||
    !isWithin(hour, 0, 23) || !isWithin(minute, 0, 59))
  {
    return "hours";
  }
  char text[64];
  std::snprintf(text, sizeof(text), "hours since %04.0f-%02.0f-%02.0f %02.0f:%02.0f:00", year,
    month, day, hour, minute);
  return text;
}

//------------------------------------------------------------------------------
std::string vtkLagrantoConventions::ConvertToHours(vtkDoubleArray* times)
{
  if (!HaveMinutes(vtkTrajectorySource::FindTimeSteps(times)))
  {
    return "the times are taken as hours in decimals, not as hh.mm (hours and minutes) as LAGRANTO "
           "writes them: as hh.mm, they would have 60 minutes or more, or less even steps";
  }
  double* begin = times->GetPointer(0);
  std::transform(begin, begin + times->GetNumberOfValues(), begin, GetHours);
  return "";
}

VTK_ABI_NAMESPACE_END
