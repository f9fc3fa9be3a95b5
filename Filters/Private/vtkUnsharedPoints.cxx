// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkUnsharedPoints.h"

#include "vtkPolylines.h"
#include "vtkRequirePointIds.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <numeric>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
// Gives a new id to every use of a point but the first.
class Copies
{
public:
  explicit Copies(vtkIdType pointCount)
    : PointCount(pointCount)
    , IsUsed(pointCount, false)
  {
  }

  vtkSmartPointer<vtkCellArray> Renumber(vtkCellArray* cells)
  {
    auto renumbered = vtkSmartPointer<vtkCellArray>::New();
    renumbered->DeepCopy(cells);
    renumbered->ConvertToDefaultStorage(); // the new ids may be too great for 32 bits
    vtkPolylines::VisitIds(renumbered,
      [&](auto* ids)
      {
        std::for_each(ids, ids + renumbered->GetNumberOfConnectivityIds(),
          [this](auto& id) { id = this->Use(id); });
      });
    return renumbered;
  }

  // The points that were copied, in the order of the copies.
  const std::vector<vtkIdType>& GetSources() const { return this->Sources; }

private:
  vtkIdType Use(vtkIdType point)
  {
    if (!this->IsUsed[point])
    {
      this->IsUsed[point] = true;
      return point;
    }
    this->Sources.push_back(point);
    return this->PointCount + static_cast<vtkIdType>(this->Sources.size()) - 1;
  }

  vtkIdType PointCount;
  std::vector<bool> IsUsed;
  std::vector<vtkIdType> Sources;
};

//------------------------------------------------------------------------------
void AppendCopies(vtkPolyData* input, const std::vector<vtkIdType>& sources, vtkPolyData* output)
{
  const vtkIdType pointCount = input->GetNumberOfPoints();
  const vtkIdType total = pointCount + static_cast<vtkIdType>(sources.size());
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(total);
  to->SetNumberOfIds(total);
  std::iota(to->GetPointer(0), to->GetPointer(0) + total, 0);
  std::iota(from->GetPointer(0), from->GetPointer(0) + pointCount, 0);
  std::copy(sources.begin(), sources.end(), from->GetPointer(0) + pointCount);

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(total);
  input->GetPoints()->GetPoints(from, points);
  output->SetPoints(points);

  vtkPointData* pointData = output->GetPointData();
  pointData->Initialize();
  pointData->CopyAllOn();
  pointData->CopyAllocate(input->GetPointData(), total);
  pointData->SetNumberOfTuples(total);
  pointData->CopyData(input->GetPointData(), from, to);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkUnsharedPoints::Make(vtkPolyData* input, Cells cells)
{
  vtkNew<vtkCellArray> none;
  vtkCellArray* vertices = cells == LINES_AND_VERTICES ? input->GetVerts() : none.Get();
  const vtkIdType pointCount = input->GetNumberOfPoints();
  const vtkPointIdSurvey ofLines = vtkRequirePointIds(input->GetLines(), "Line", pointCount);
  const vtkPointIdSurvey ofVertices = vtkRequirePointIds(vertices, "Vertex cell", pointCount);
  const bool apart = ofLines.Maximum < ofVertices.Minimum || ofVertices.Maximum < ofLines.Minimum;
  if (ofLines.IsIncreasing && ofVertices.IsIncreasing && apart)
  {
    return input;
  }

  Copies copies(pointCount);
  const auto newLines = copies.Renumber(input->GetLines());
  const auto newVertices = copies.Renumber(vertices);
  if (copies.GetSources().empty())
  {
    return input;
  }
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(input);
  output->SetLines(newLines);
  if (cells == LINES_AND_VERTICES)
  {
    output->SetVerts(newVertices);
  }
  AppendCopies(input, copies.GetSources(), output);
  return output;
}

VTK_ABI_NAMESPACE_END
