// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLagrantoConventions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
// Of a time in hh.mm; with the sign of the time.
double GetMinutes(double time)
{
  return std::round(100.0 * (time - std::trunc(time)));
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
void vtkLagrantoConventions::ConvertToHours(double* times, std::size_t count)
{
  if (std::any_of(
        times, times + count, [](double time) { return std::abs(GetMinutes(time)) >= 60.0; }))
  {
    return;
  }
  std::transform(times, times + count, times,
    [](double time) { return std::trunc(time) + GetMinutes(time) / 60.0; });
}

VTK_ABI_NAMESPACE_END
