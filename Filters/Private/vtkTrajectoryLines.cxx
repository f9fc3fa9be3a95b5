// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryLines.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkTrajectoryLines::SetGeometry(
  vtkPolyData* output, vtkPoints* points, vtkIdTypeArray* offsets)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(points->GetNumberOfPoints());
  vtkIdType* first = connectivity->GetPointer(0);
  std::iota(first, first + connectivity->GetNumberOfValues(), vtkIdType(0));
  vtkNew<vtkCellArray> lines;
  lines->SetData(offsets, connectivity);
  output->SetPoints(points);
  output->SetLines(lines);
}

//------------------------------------------------------------------------------
void vtkTrajectoryLines::SetLines(
  vtkPolyData* output, vtkPoints* points, vtkIdTypeArray* offsets, vtkIdTypeArray* ids)
{
  SetGeometry(output, points, offsets);
  ids->SetName(IdName);
  output->GetCellData()->AddArray(ids);
}

VTK_ABI_NAMESPACE_END
