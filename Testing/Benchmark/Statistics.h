// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What many measured numbers come to.
 */

#ifndef Statistics_h
#define Statistics_h

#include <vector> // for numbers

namespace pellucid
{
namespace benchmark
{
/**
 * The number that the fraction, in [0,1], of all numbers is below: linear between the two nearest
 * (R. J. Hyndman, Y. Fan, Sample Quantiles in Statistical Packages, 1996, definition 7); NaN of
 * none.
 */
double FindQuantile(std::vector<double> values, double fraction);

/** The middle one, or the mean of the two in the middle; NaN of none. */
double FindMedian(std::vector<double> values);

/**
 * The b of the power law y = a x^b that fits best, in the sense of least squares of the logarithms.
 * Pairs with a number that is not positive do not count. NaN where fewer than two different x are
 * left.
 */
double FitExponent(const std::vector<double>& x, const std::vector<double>& y);
}
}

#endif
