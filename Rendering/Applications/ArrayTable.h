// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What --list-arrays prints.
 */

#ifndef ArrayTable_h
#define ArrayTable_h

#include "Drawables.h"

#include <ostream> // for the output

namespace pellucid
{
/**
 * Print for each drawable a line "NAME: N points, N lines" and a table with one line for each array
 * of numbers: its name, where it is, its components, the least and the largest of its finite values
 * (of vectors: lengths), its unit, how many of its values are missing, that is, not finite, and
 * whether it was computed. Columns are at least two spaces apart; "-" is nothing. Then, where they
 * apply, a line about vectors, and two about the units of what is computed on a map.
 */
void WriteArrayTable(std::ostream& stream, const std::vector<Drawable>& drawables);
}

#endif
