// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Row.h"

#include "ParetoFront.h"
#include "Statistics.h"

#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
double Row::GetTime(double fraction) const
{
  return FindQuantile(this->Milliseconds, fraction);
}

//------------------------------------------------------------------------------
void MarkFronts(std::vector<Row>& rows)
{
  std::map<std::tuple<std::string, int, int, double>, std::vector<Row*>> groups;
  for (Row& row : rows)
  {
    if (!row.HasOptimizedOpacities)
    {
      groups[{ row.Scene, row.Width, row.Height, row.Opacity }].push_back(&row);
    }
  }
  for (const auto& [key, group] : groups)
  {
    std::vector<Cost> costs;
    for (const Row* row : group)
    {
      const double error = row->Error ? row->Error->RootMeanSquare : NotANumber;
      costs.push_back({ row->IsCold ? NotANumber : row->GetMedian(), std::round(100.0 * error) });
    }
    const std::vector<bool> isOnFront = FindParetoFront(costs);
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      group[i]->IsOnFront = isOnFront[i];
    }
  }
}
}
}
