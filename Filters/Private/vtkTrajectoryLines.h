// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   The geometry that the readers of trajectories have in common: points in sequence.
 *
 * Private to the module.
 */

#ifndef vtkTrajectoryLines_h
#define vtkTrajectoryLines_h

#include "vtkABINamespace.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkIdTypeArray;
class vtkPoints;
class vtkPolyData;

namespace vtkTrajectoryLines
{
/** The name of the cell array that holds the number of each line's trajectory in the file, from 0.
 */
constexpr const char* IdName = "TrajectoryId";

/** Make polylines: line i has the points from offset i up to offset i + 1. Not their ids. */
void SetGeometry(vtkPolyData* output, vtkPoints* points, vtkIdTypeArray* offsets);

/** The same, and the cell array IdName. */
void SetLines(vtkPolyData* output, vtkPoints* points, vtkIdTypeArray* offsets, vtkIdTypeArray* ids);
}

VTK_ABI_NAMESPACE_END
#endif
