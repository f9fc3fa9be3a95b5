// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Values out of the text of options; nothing where the text is no such value.
 */

#ifndef OptionText_h
#define OptionText_h

#include "RenderOptions.h"

#include <string_view> // for the text

namespace pellucid
{
/** All of the text as one finite number; one that is too small for a double is 0. */
std::optional<double> ToNumber(std::string_view text);

/** "X,Y,Z" */
std::optional<Vector3> ToVector(std::string_view text);

/** Pixels of a side of a picture, at most. */
constexpr int LargestSide = 65536;

/** "WxH", each 1 to LargestSide. */
std::optional<std::array<int, 2>> ToSize(std::string_view text);

/** "MINIMUM:MAXIMUM", two numbers, the first below the second. */
std::optional<NumberRange> ToRange(std::string_view text);

/** "500", or "5%" with 0 to 100 per cent. */
std::optional<RangeLimit> ToLimit(std::string_view text);

/**
 * "NAME:MINIMUM:MAXIMUM" or "NAME:MINIMUM:MAXIMUM:WEIGHT" with a weight of -1 to 1. What follows
 * the name is read from the right, as far as it is numbers: a name may hold colons, and one that
 * ends in ":" and a number needs the weight.
 */
std::optional<ImportanceTerm> ToImportanceTerm(std::string_view text);

/** "picture", "opacity", "importance", "segments", "length", "first:N" or "layer:N", N from 1. */
std::optional<ViewChoice> ToView(std::string_view text);

/** "NAME:MINIMUM:MAXIMUM", read from the right; an empty limit leaves that side open, not both. */
std::optional<SelectionRange> ToSelectionRange(std::string_view text);
}

#endif
