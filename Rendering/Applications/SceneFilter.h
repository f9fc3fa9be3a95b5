// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Filters that work on the parts of several drawables as one.
 */

#ifndef SceneFilter_h
#define SceneFilter_h

#include "Drawables.h"

#include <functional> // for the choice of parts
#include <string>     // for messages

class vtkAlgorithm;

namespace pellucid
{
using PartTest = std::function<bool(vtkPolyData*)>;

/** Whether any part passes the test. */
bool AnyPart(const std::vector<Drawable>& drawables, const PartTest& test);

/**
 * Replace the parts that pass the test by what the filter makes of them; it gets them as the blocks
 * of one data set, so that its percentiles are those of all. Print the filter's warnings. Throw
 * RenderError, beginning with `title`, for its first error.
 */
void FilterParts(std::vector<Drawable>& drawables, const PartTest& takesPart, vtkAlgorithm* filter,
  const std::string& title);

/** Whether the points or the cells have an array of numbers of that name. */
bool HasArray(vtkPolyData* part, const std::string& name);
}

#endif
