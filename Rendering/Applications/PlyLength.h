// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Whether a PLY file is as long as its header says.
 */

#ifndef PlyLength_h
#define PlyLength_h

#include <string> // for the name

namespace pellucid
{
/**
 * Throw RenderError if a PLY file, in binary or text form, ends before its last element: VTK fills
 * up with what is in memory. Headers that VTK refuses itself pass.
 */
void CheckPlyLength(const std::string& fileName);
}

#endif
