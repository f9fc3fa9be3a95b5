// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Files that are written again whenever there is more to say.
 */

#ifndef ResultFile_h
#define ResultFile_h

#include <functional> // for what writes
#include <string>     // for names

namespace pellucid
{
namespace benchmark
{
/** Throw RenderError unless a file of that name can be replaced; leaves no file behind. */
void CheckReplaceable(const std::string& fileName);

/**
 * Whoever reads the file, and whenever this process ends, finds the old or the new one as a whole.
 * `write` is called with the name of another file, of the same suffix, which then takes the place
 * of this one. Throws RenderError where that fails, and what `write` throws.
 */
void ReplaceFile(
  const std::string& fileName, const std::function<void(const std::string& newName)>& write);
}
}

#endif
