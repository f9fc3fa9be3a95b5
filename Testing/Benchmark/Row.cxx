// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Row.h"

#include "Statistics.h"

namespace pellucid
{
namespace benchmark
{
//------------------------------------------------------------------------------
double Row::GetTime(double fraction) const
{
  return FindQuantile(this->Milliseconds, fraction);
}
}
}
