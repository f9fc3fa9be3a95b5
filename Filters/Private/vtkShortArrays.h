// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkShortArrays.h
 * @brief   Arrays that do not have a tuple for each point or cell.
 *
 * Private to the module. VTK carries them along, but they cannot be copied point by point.
 */

#ifndef vtkShortArrays_h
#define vtkShortArrays_h

#include "vtkType.h"

#include <set>    // for names
#include <string> // for names

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSetAttributes;

/** Remove the arrays of fewer than `count` tuples and add their names to `removed`. */
void vtkRemoveShortArrays(
  vtkDataSetAttributes* attributes, vtkIdType count, std::set<std::string>& removed);

/** A warning for the user that the arrays of these names have been removed. */
std::string vtkDescribeShortArrays(const std::set<std::string>& removed);

VTK_ABI_NAMESPACE_END
#endif
