// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkRequirePointIds.h"

#include "vtkPolylines.h"

#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <stdexcept>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
class Surveyor
{
public:
  explicit Surveyor(vtkCellArray* cells)
    : Cells(cells)
  {
    vtkSMPTools::For(0, cells->GetNumberOfConnectivityIds(), *this);
  }

  void Initialize() { this->LocalResult.Local() = vtkPointIdSurvey(); }

  void operator()(vtkIdType first, vtkIdType last)
  {
    vtkPointIdSurvey& result = this->LocalResult.Local();
    vtkPolylines::VisitIds(this->Cells,
      [=, &result](const auto* ids)
      {
        vtkIdType previous = first > 0 ? ids[first - 1] : VTK_ID_MIN;
        for (vtkIdType i = first; i < last; ++i)
        {
          const vtkIdType id = ids[i];
          result.Minimum = std::min(result.Minimum, id);
          result.Maximum = std::max(result.Maximum, id);
          result.IsIncreasing = result.IsIncreasing && previous < id;
          previous = id;
        }
      });
  }

  void Reduce()
  {
    for (const vtkPointIdSurvey& result : this->LocalResult)
    {
      this->Total.Minimum = std::min(this->Total.Minimum, result.Minimum);
      this->Total.Maximum = std::max(this->Total.Maximum, result.Maximum);
      this->Total.IsIncreasing = this->Total.IsIncreasing && result.IsIncreasing;
    }
  }

  vtkPointIdSurvey Total;

private:
  vtkCellArray* Cells;
  vtkSMPThreadLocal<vtkPointIdSurvey> LocalResult;
};

//------------------------------------------------------------------------------
[[noreturn]] void ThrowBadId(vtkCellArray* cells, const char* kind, vtkIdType pointCount)
{
  const vtkPolylines lines(cells);
  vtkIdType position = 0;
  while (lines.GetId(position) >= 0 && lines.GetId(position) < pointCount)
  {
    ++position;
  }
  throw std::out_of_range(std::string(kind) + " " + std::to_string(lines.FindLine(position)) +
    " uses the point " + std::to_string(lines.GetId(position)) +
    ", but the input has the points 0 to " + std::to_string(pointCount - 1) +
    ". Repair what makes this input.");
}
}

//------------------------------------------------------------------------------
vtkPointIdSurvey vtkRequirePointIds(vtkCellArray* cells, const char* kind, vtkIdType pointCount)
{
  const vtkPointIdSurvey survey = Surveyor(cells).Total;
  if (survey.Minimum < 0 || survey.Maximum >= pointCount)
  {
    ThrowBadId(cells, kind, pointCount);
  }
  return survey;
}

//------------------------------------------------------------------------------
void vtkRequirePointIds(vtkDataSet* data)
{
  const vtkIdType pointCount = data->GetNumberOfPoints();
  if (auto* polyData = vtkPolyData::SafeDownCast(data))
  {
    vtkRequirePointIds(polyData->GetVerts(), "Vertex cell", pointCount);
    vtkRequirePointIds(polyData->GetLines(), "Line", pointCount);
    vtkRequirePointIds(polyData->GetPolys(), "Polygon", pointCount);
    vtkRequirePointIds(polyData->GetStrips(), "Triangle strip", pointCount);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data); grid && grid->GetCells())
  {
    vtkRequirePointIds(grid->GetCells(), "Cell", pointCount);
  }
}

VTK_ABI_NAMESPACE_END
