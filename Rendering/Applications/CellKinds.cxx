// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CellKinds.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"

#include <tuple>

namespace pellucid
{
//------------------------------------------------------------------------------
int GetKinds(vtkPolyData* part)
{
  return (part->GetNumberOfVerts() > 0 ? Vertices : 0) |
    (part->GetNumberOfLines() > 0 ? Lines : 0) |
    (part->GetNumberOfPolys() + part->GetNumberOfStrips() > 0 ? Surfaces : 0);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> KeepCells(vtkPolyData* part, int kinds)
{
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  rest->SetPoints(part->GetPoints());
  rest->GetPointData()->ShallowCopy(part->GetPointData());
  rest->GetFieldData()->ShallowCopy(part->GetFieldData());
  vtkCellData* cells = rest->GetCellData();
  cells->CopyAllOn();
  cells->CopyAllocate(part->GetCellData(), part->GetNumberOfCells());
  // The tuples of the cell data are in the order of the kinds.
  vtkIdType first = 0;
  vtkIdType kept = 0;
  for (const auto& [kind, array, set] :
    { std::tuple(Vertices, part->GetVerts(), &vtkPolyData::SetVerts),
      { Lines, part->GetLines(), &vtkPolyData::SetLines },
      { Surfaces, part->GetPolys(), &vtkPolyData::SetPolys },
      { Surfaces, part->GetStrips(), &vtkPolyData::SetStrips } })
  {
    const vtkIdType count = array->GetNumberOfCells();
    if (kinds & kind)
    {
      (rest->*set)(array);
      cells->CopyData(part->GetCellData(), kept, count, first);
      kept += count;
    }
    first += count;
  }
  return rest;
}
}
