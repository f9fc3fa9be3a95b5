// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Why candidates are not in the product, from figures that were measured before.
 */

#ifndef Record_h
#define Record_h

#include <iosfwd> // for the table
#include <string> // for the file name

namespace pellucid
{
namespace benchmark
{
/**
 * Print a Markdown table with one line for each candidate in a file of WriteJson(): on which fronts
 * it is, its times and errors beside the product's over all scenes, sizes and opacities in which
 * both were measured, and its reason (Method::Reason). Throws RenderError where the file cannot be
 * read, is no such file, holds a method that GetMethods() does not, or has no row of the product.
 */
void PrintRecord(const std::string& fileName, std::ostream& stream);
}
}

#endif
