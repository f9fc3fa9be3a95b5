// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The segments that opacities are optimised for.
 */

#ifndef SceneSegments_h
#define SceneSegments_h

#include "Drawables.h"

#include <vector> // for the drawables

namespace pellucid
{
/**
 * Divide what has importance into segments: lines and points by vtkTrajectorySegments, all lines
 * into about 20000, of at least 1/128 of the diagonal of their bounds; each surface by
 * vtkSurfaceSegments with its default number, 400. Surfaces become parts of their own.
 */
void AddSegments(std::vector<Drawable>& drawables);
}

#endif
