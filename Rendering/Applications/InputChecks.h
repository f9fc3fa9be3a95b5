// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What VTK's readers do not check.
 */

#ifndef InputChecks_h
#define InputChecks_h

#include <string> // for the name

class vtkDataObject;

namespace pellucid
{
/**
 * Throw RenderError unless the name is that of a folder, or of a file that can be opened and holds
 * something.
 */
void CheckReadable(const std::string& fileName);

/** Throw RenderError if the name is that of a folder. */
void CheckNoFolder(const std::string& fileName);

/** Whether the file is as long as binary STL with the number of triangles that it states. */
bool IsBinaryStl(const std::string& fileName);

/** Throw RenderError if a binary STL file ends in the middle of a triangle. */
void CheckStlLength(const std::string& fileName);

/**
 * Throw RenderError, which begins with `name`, if the data is of a kind that is not drawn, holds no
 * points, or has cells that refer to points that do not exist.
 */
void CheckData(vtkDataObject* data, const std::string& name);
}

#endif
