// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What importance is made from, the array Importance, and its histogram.
 */

#ifndef SceneImportance_h
#define SceneImportance_h

#include "Drawables.h"
#include "RenderOptions.h"

#include <string> // for texts
#include <vector> // for lists

namespace pellucid
{
/** What an importance came to. */
struct FoundImportance
{
  std::vector<ImportanceTerm> Terms; // with numbers for percentiles, NaN of no finite value
  std::vector<long long> Histogram;  // points in bins of equal width from 0 to 1
};

/**
 * Where opacities are to follow from importance and the options give none, make it from one array,
 * from its 50th to its 99th percentile, which colours too, by default: the speed of traced lines;
 * TotalPressureDifference, where lines have pressure; the one that the options colour by; the
 * active or first one of lines, of points, of surfaces; Curvature. Among several inputs the first
 * counts. Whether one was chosen so; throw RenderError if there is none to choose.
 */
bool ChooseImportance(const std::vector<Drawable>& drawables, RenderOptions& options);

/** One line about the array that was chosen, given what it came to. */
std::string DescribeChoice(const ImportanceTerm& found);

/**
 * Give the parts that have all arrays of the options' importance the point array Importance. Where
 * it is a factor on the opacity, parts that lack one become drawables of their own; where other
 * rules make opacities of it, they get the importance 0, and a warning tells if all importance is
 * the same. What the arrays came to, and the histogram of the parts that have them; both are empty
 * without importance. Throw RenderError if no part has all arrays.
 */
FoundImportance AddImportance(std::vector<Drawable>& drawables, const RenderOptions& options);
}

#endif
