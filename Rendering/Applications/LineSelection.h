// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   --select: whole lines leave the scene.
 */

#ifndef LineSelection_h
#define LineSelection_h

#include "Drawables.h"

namespace pellucid
{
/**
 * Leave the lines that have a value in each of the ranges; lines of parts without the array stay.
 * Throw RenderError if nothing is left to draw, and warn if no line is.
 */
void SelectLines(std::vector<Drawable>& drawables, const RenderOptions& options);
}

#endif
