// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   --importance: the array Importance, and its histogram.
 */

#ifndef SceneImportance_h
#define SceneImportance_h

#include "Drawables.h"

#include <vector> // for the histogram

namespace pellucid
{
/**
 * Give the parts that have all arrays of the options' importance the point array Importance; parts
 * that lack one become drawables of their own. The points in bins of equal width from 0 to 1;
 * empty without importance. Throw RenderError if no part has all arrays.
 */
std::vector<long long> AddImportance(
  std::vector<Drawable>& drawables, const RenderOptions& options);
}

#endif
