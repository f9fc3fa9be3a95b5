// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ParetoFront.h"

#include <algorithm>
#include <cmath>

namespace pellucid
{
namespace benchmark
{
namespace
{
//------------------------------------------------------------------------------
bool Beats(const Cost& a, const Cost& b)
{
  return a.Time <= b.Time && a.Error <= b.Error && (a.Time < b.Time || a.Error < b.Error);
}
}

//------------------------------------------------------------------------------
std::vector<bool> FindParetoFront(const std::vector<Cost>& costs)
{
  std::vector<bool> isOnFront;
  for (const Cost& cost : costs)
  {
    isOnFront.push_back(!std::isnan(cost.Time) && !std::isnan(cost.Error) &&
      std::none_of(
        costs.begin(), costs.end(), [&](const Cost& other) { return Beats(other, cost); }));
  }
  return isOnFront;
}
}
}
