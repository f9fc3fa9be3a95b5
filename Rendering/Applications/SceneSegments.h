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
 * Divide everything into segments, as many as the filters choose: all lines and points by one
 * vtkTrajectorySegments, each surface by vtkSurfaceSegments. Surfaces become drawables of their
 * own.
 */
void AddSegments(std::vector<Drawable>& drawables);
}

#endif
