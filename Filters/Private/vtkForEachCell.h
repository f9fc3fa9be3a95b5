// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkForEachCell.h
 * @brief   The point ids of consecutive cells.
 *
 * Private to the module.
 */

#ifndef vtkForEachCell_h
#define vtkForEachCell_h

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm> // for std::clamp

VTK_ABI_NAMESPACE_BEGIN

/** Call `function(cell, count, points)` for the cells [begin, end), from any thread. */
template <typename Function>
void vtkForEachCell(vtkCellArray* cells, vtkIdType begin, vtkIdType end, Function&& function)
{
  vtkNew<vtkIdList> ids;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    cells->GetCellAtId(cell, count, points, ids);
    function(cell, count, points);
  }
}

/**
 * The same for the cells of a data set, from one thread. Of vtkPolyData the cell arrays are read
 * one after the other, which is the order of its cell data: GetCellPoints() would build a table of
 * cells.
 */
template <typename Function>
void vtkForEachCell(vtkDataSet* data, vtkIdType begin, vtkIdType end, Function&& function)
{
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    vtkIdType first = 0;
    for (vtkCellArray* cells :
      { polyData->GetVerts(), polyData->GetLines(), polyData->GetPolys(), polyData->GetStrips() })
    {
      const vtkIdType cellCount = cells->GetNumberOfCells();
      vtkForEachCell(cells, std::clamp<vtkIdType>(begin - first, 0, cellCount),
        std::clamp<vtkIdType>(end - first, 0, cellCount),
        [&function, first](vtkIdType cell, vtkIdType pointCount, const vtkIdType* ids)
        { function(first + cell, pointCount, ids); });
      first += cellCount;
    }
    return;
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    data->GetCellPoints(cell, count, points, ids);
    function(cell, count, points);
  }
}

VTK_ABI_NAMESPACE_END
#endif
