// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkLeafCopies.h
 * @brief   The first step of a filter that adds to, or thins out, any data set or composite data.
 *
 * Private to the module.
 */

#ifndef vtkLeafCopies_h
#define vtkLeafCopies_h

#include "vtkABINamespace.h"

#include <utility> // for std::pair
#include <vector>  // for the leaves

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkDataSet;

/**
 * Make `output`, of the class of `input`, a shallow copy of it whose leaves, too, are shallow
 * copies: they can be changed without changing the input. Returns the data sets among them, each as
 * {leaf of the input, its copy}.
 */
std::vector<std::pair<vtkDataSet*, vtkDataSet*>> vtkCopyLeaves(
  vtkDataObject* input, vtkDataObject* output);

VTK_ABI_NAMESPACE_END
#endif
