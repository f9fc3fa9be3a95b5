// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Which of several choices no other one beats.
 */

#ifndef ParetoFront_h
#define ParetoFront_h

#include <vector> // for choices

namespace pellucid
{
namespace benchmark
{
/** What a choice costs; less is better. */
struct Cost
{
  double Time = 0.0;
  double Error = 0.0;
};

/**
 * For each choice whether it is on the Pareto front: no other one has at most its time and at most
 * its error, and less of either. Equal choices stand or fall together; one with a NaN is not on the
 * front, and beats nobody.
 */
std::vector<bool> FindParetoFront(const std::vector<Cost>& costs);
}
}

#endif
