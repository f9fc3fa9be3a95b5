// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ParetoFront.h"

#include "Statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <tuple>

namespace pellucid
{
namespace benchmark
{
namespace
{
//------------------------------------------------------------------------------
bool IsFaster(const Cost& a, const Cost& b)
{
  return a.HighTime < b.LowTime;
}

//------------------------------------------------------------------------------
bool IsBetter(const Cost& a, const Cost& b)
{
  return a.Error < b.Error - ErrorTolerance;
}

//------------------------------------------------------------------------------
bool IsKnown(const Cost& cost)
{
  return !std::isnan(cost.LowTime) && !std::isnan(cost.HighTime) && !std::isnan(cost.Error);
}

//------------------------------------------------------------------------------
bool Beats(const Cost& a, const Cost& b)
{
  return IsKnown(a) && !IsFaster(b, a) && !IsBetter(b, a) && (IsFaster(a, b) || IsBetter(a, b));
}

//------------------------------------------------------------------------------
Cost FindCost(const Row& row)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return { row.IsCold ? unknown : row.GetTime(0.25), row.IsCold ? unknown : row.GetTime(0.75),
    row.Error ? row.Error->RootMeanSquare : unknown };
}
}

//------------------------------------------------------------------------------
std::vector<bool> FindParetoFront(const std::vector<Cost>& costs)
{
  std::vector<bool> isOnFront;
  for (const Cost& cost : costs)
  {
    isOnFront.push_back(IsKnown(cost) &&
      std::none_of(
        costs.begin(), costs.end(), [&](const Cost& other) { return Beats(other, cost); }));
  }
  return isOnFront;
}

//------------------------------------------------------------------------------
void MarkFronts(std::vector<Row>& rows)
{
  std::map<std::tuple<std::string, int, int, double, std::string>, std::vector<Row*>> groups;
  for (Row& row : rows)
  {
    if (!row.HasOptimizedOpacities)
    {
      groups[{ row.Scene, row.Width, row.Height, row.Opacity, row.Shape }].push_back(&row);
    }
  }
  for (const auto& [key, group] : groups)
  {
    std::vector<Cost> costs;
    std::transform(group.begin(), group.end(), std::back_inserter(costs),
      [](const Row* row) { return FindCost(*row); });
    const std::vector<bool> isOnFront = FindParetoFront(costs);
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      group[i]->IsOnFront = isOnFront[i];
    }
  }
}
}
}
