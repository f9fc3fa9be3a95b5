// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Reading the files that pellucid-render is given.
 */

#ifndef InputReader_h
#define InputReader_h

#include "vtkDataObject.h"
#include "vtkSmartPointer.h"

#include <string> // for names
#include <vector> // for the list

namespace pellucid
{
struct RenderOptions;

struct Input
{
  std::string Name; // of the file, or of the first of two
  vtkSmartPointer<vtkDataObject> Data;
  bool IsMap = false; // x and y are degrees of longitude and latitude
};

/**
 * Read the files of the options in their order; a PLOT3D grid and its solution are one input. Throw
 * RenderError for a file that is missing, of no known kind, damaged, or empty.
 */
std::vector<Input> ReadInputs(const RenderOptions& options);
}

#endif
