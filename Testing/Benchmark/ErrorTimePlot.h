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
 * Methods of one family are joined by a line; gold discs, with a line through them, are the Pareto
 * front. Rows without an error are left out. Draws off screen; throws RenderError where that fails.
 */
vtkSmartPointer<vtkImageData> DrawErrorTimePlot(const std::vector<Row>& rows);
}
}

#endif
