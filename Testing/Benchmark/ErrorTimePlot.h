// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The picture that tells which method to choose.
 */

#ifndef ErrorTimePlot_h
#define ErrorTimePlot_h

#include "Row.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <vector> // for rows

namespace pellucid
{
namespace benchmark
{
/**
 * Error (RMSE) over time (median), both logarithmic, one panel for each scene, size and opacity.
 * A line joins the methods of a family that a parameter orders. Pale discs, with a line through
 * them, are the Pareto fronts, one for each shape; names stand beside the product and the fastest
 * of those that are as good. Rows without an error are left out. Draws off screen; throws
 * RenderError where that fails.
 */
vtkSmartPointer<vtkImageData> DrawErrorTimePlot(const std::vector<Row>& rows);
}
}

#endif
