// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkRequirePointIds.h
 * @brief   Refuse cells whose point ids would be read beyond the ends of the point data.
 *
 * Private to the module. VTK's own readers and filters do not check this.
 */

#ifndef vtkRequirePointIds_h
#define vtkRequirePointIds_h

#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkCellArray;
class vtkDataSet;

/** What one pass over the point ids of cells tells about them. */
struct vtkPointIdSurvey
{
  vtkIdType Minimum = VTK_ID_MAX;
  vtkIdType Maximum = VTK_ID_MIN;
  bool IsIncreasing = true; // each id is greater than the one before, over all cells
};

/**
 * Throws std::out_of_range, with a message for the user, if one of the cells uses a point that is
 * none of 0, ..., pointCount - 1. `kind` begins the message, as in "Line". Parallel.
 */
vtkPointIdSurvey vtkRequirePointIds(vtkCellArray* cells, const char* kind, vtkIdType pointCount);

/** The same for all cells of a poly data or unstructured grid; the ids of other data sets follow
 * from their dimensions. */
void vtkRequirePointIds(vtkDataSet* data);

VTK_ABI_NAMESPACE_END
#endif
