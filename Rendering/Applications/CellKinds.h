// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Some of the cells of a poly data, with their values.
 */

#ifndef CellKinds_h
#define CellKinds_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace pellucid
{
/** Bits. */
enum CellKinds
{
  Vertices = 1,
  Lines = 2,
  Surfaces = 4 // polygons and strips
};

/** The kinds that the part has cells of. */
int GetKinds(vtkPolyData* part);

/** The part with its cells of these kinds and their cell data; all points stay. */
vtkSmartPointer<vtkPolyData> KeepCells(vtkPolyData* part, int kinds);
}

#endif
