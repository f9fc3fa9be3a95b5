// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Row.h"

#include "Statistics.h"

#include <algorithm>
#include <limits>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
double Row::GetMedian() const
{
  return FindMedian(this->Milliseconds);
}

//------------------------------------------------------------------------------
double Row::GetMinimum() const
{
  const auto& times = this->Milliseconds;
  return times.empty() ? NotANumber : *std::min_element(times.begin(), times.end());
}

//------------------------------------------------------------------------------
double Row::GetMaximum() const
{
  const auto& times = this->Milliseconds;
  return times.empty() ? NotANumber : *std::max_element(times.begin(), times.end());
}
}
}
