// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Which of several choices no other one beats.
 */

#ifndef ParetoFront_h
#define ParetoFront_h

#include "Row.h"

#include <vector> // for choices

namespace pellucid
{
namespace benchmark
{
/** What a choice costs; less is better. The time is an interval: two that overlap count as equal.
 */
struct Cost
{
  double LowTime = 0.0;
  double HighTime = 0.0;
  double Error = 0.0;
};

/** Errors (RMSE) that differ by no more, in steps of 8 bits, count as equal. */
constexpr double ErrorTolerance = 0.01;

/**
 * For each choice whether it is on the Pareto front: no other one is faster and no worse, or better
 * and no slower. Equal choices stand or fall together; one with a NaN is not on the front, and
 * beats nobody.
 */
std::vector<bool> FindParetoFront(const std::vector<Cost>& costs);

/**
 * Mark the fronts of the methods for each scene, size, opacity and shape, with times from the lower
 * to the upper quartile. Optimised opacities make another picture, which is no choice.
 */
void MarkFronts(std::vector<Row>& rows);
}
}

#endif
