// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
double FindQuantile(std::vector<double> values, double fraction)
{
  if (values.empty())
  {
    return NotANumber;
  }
  std::sort(values.begin(), values.end());
  const double place = fraction * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto above = std::min(below + 1, values.size() - 1);
  const double part = place - static_cast<double>(below);
  return (1.0 - part) * values[below] + part * values[above];
}

//------------------------------------------------------------------------------
double FindMedian(std::vector<double> values)
{
  return FindQuantile(std::move(values), 0.5);
}

//------------------------------------------------------------------------------
double FitExponent(const std::vector<double>& x, const std::vector<double>& y)
{
  double count = 0.0;
  double sumX = 0.0;
  double sumY = 0.0;
  double sumXX = 0.0;
  double sumXY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    if (x[i] > 0.0 && y[i] > 0.0)
    {
      const double logX = std::log(x[i]);
      const double logY = std::log(y[i]);
      count += 1.0;
      sumX += logX;
      sumY += logY;
      sumXX += logX * logX;
      sumXY += logX * logY;
    }
  }
  const double spread = count * sumXX - sumX * sumX;
  return spread > 1e-9 * sumXX ? (count * sumXY - sumX * sumY) / spread : NotANumber;
}
}
}
