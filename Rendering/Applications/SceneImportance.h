// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What importance is made from, the array Importance, and its histogram.
 */

#ifndef SceneImportance_h
#define SceneImportance_h

#include "Drawables.h"

#include <vector> // for the histogram

namespace pellucid
{
struct RenderOptions;

/**
 * Where opacities are to follow from importance and the options give none, make it from one array,
 * from its 50th to its 99th percentile, which colours too: the one that the options colour by; the
 * speed of traced lines; TotalPressureDifference; the one that colours by default; Curvature.
 * Throw RenderError if there is none.
 */
void ChooseImportance(const std::vector<Drawable>& drawables, RenderOptions& options);

/**
 * Give the parts that have all arrays of the options' importance the point array Importance; parts
 * that lack one become drawables of their own. The points in bins of equal width from 0 to 1;
 * empty without importance. Throw RenderError if no part has all arrays.
 */
std::vector<long long> AddImportance(
  std::vector<Drawable>& drawables, const RenderOptions& options);
}

#endif
