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
double FindMedian(std::vector<double> values)
{
  return FindQuantile(std::move(values), 0.5);
}

//------------------------------------------------------------------------------
double FindQuantile(std::vector<double> values, double p)
{
  if (values.empty())
  {
    return NotANumber;
  }
  std::sort(values.begin(), values.end());
  const double place = p * (values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - below) * (values[above] - values[below]);
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
