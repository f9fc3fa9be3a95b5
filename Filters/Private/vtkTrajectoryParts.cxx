// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryParts.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkFindTrajectories(vtkPolyData* data)
{
  const vtkIdType firstCell = data->GetNumberOfVerts();
  const vtkIdType lineCount = data->GetNumberOfLines();
  vtkDataArray* ids = data->GetCellData()->GetArray("TrajectoryId");
  const bool isGood = ids && ids->GetNumberOfComponents() == 1 &&
    ids->GetNumberOfTuples() >= data->GetNumberOfCells();
  std::vector<vtkIdType> firstLines;
  for (vtkIdType line = 0; line < lineCount; ++line)
  {
    const vtkIdType cell = firstCell + line;
    if (line == 0 || !isGood || ids->GetComponent(cell, 0) != ids->GetComponent(cell - 1, 0))
    {
      firstLines.push_back(line);
    }
  }
  firstLines.push_back(lineCount);
  return firstLines;
}

VTK_ABI_NAMESPACE_END
