// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Arrays that are computed from lines when an option names them.
 */

#ifndef LineAttributes_h
#define LineAttributes_h

#include "Drawables.h"

namespace pellucid
{
/**
 * Add those attributes of vtkTrajectoryAttributes that importance, selection or colouring name, to
 * the parts with lines that do not have an array of that name. Throw RenderError, which lists the
 * arrays there are, for an array that an option names and no part has, for an attribute that cannot
 * be computed, and as AddAllAttributes() does.
 */
void AddNamedAttributes(std::vector<Drawable>& drawables, const RenderOptions& options);

/** Whether a part has the arrays that an attribute of vtkTrajectoryAttributes is computed from. */
bool CanCompute(vtkPolyData* part, int attribute, const RenderOptions& options);

/**
 * Add all attributes that can be computed. Throw RenderError where the points have no array that
 * the options name as pressure or height, or no time for the window.
 */
void AddAllAttributes(std::vector<Drawable>& drawables, const RenderOptions& options);
}

#endif
