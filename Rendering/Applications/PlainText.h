// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Numbers and names as text for a terminal.
 */

#ifndef PlainText_h
#define PlainText_h

#include <string>      // for the result
#include <string_view> // for the text

namespace pellucid
{
/**
 * The shortest text that gives the number back in its precision; with an exponent only below 1e-4
 * and from 1e15 on.
 */
std::string ToText(double value);
std::string ToText(float value);

/**
 * The text with a question mark for each byte that is no part of a printable character in UTF-8, so
 * that no control sequence of an untrusted file reaches the terminal.
 */
std::string MakePrintable(std::string_view text);
}

#endif
