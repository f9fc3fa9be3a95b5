// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkTrajectoryParts.h
 * @brief   Which lines are parts of one trajectory.
 *
 * Private to the module. Readers split a trajectory at gaps and at the edges of a map.
 */

#ifndef vtkTrajectoryParts_h
#define vtkTrajectoryParts_h

#include "vtkType.h"

#include <vector> // for the lines

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

/**
 * The first line of each trajectory and, after the last one, the number of lines. Successive lines
 * with the same value of the cell array "TrajectoryId" are one trajectory; where there is no such
 * array, of one component and a value for each cell, each line is one.
 */
std::vector<vtkIdType> vtkFindTrajectories(vtkPolyData* data);

VTK_ABI_NAMESPACE_END
#endif
