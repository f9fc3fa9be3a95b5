// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkUnsharedPoints.h"

#include "vtkPolylines.h"

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
// The ids of a connectivity: their range, and whether each is greater than the one before.
class IdSurvey
{
public:
  explicit IdSurvey(vtkCellArray* cells)
    : Cells(cells)
  {
    vtkSMPTools::For(0, cells->GetNumberOfConnectivityIds(), *this);
  }

  void Initialize() { this->LocalResult.Local() = Result(); }

  void operator()(vtkIdType first, vtkIdType last)
  {
    Result& result = this->LocalResult.Local();
    vtkPolylines::VisitIds(this->Cells,
      [=, &result](const auto* ids)
      {
        vtkIdType previous = first > 0 ? ids[first - 1] : VTK_ID_MIN;
        for (vtkIdType i = first; i < last; ++i)
        {
          const vtkIdType id = ids[i];
          result.Minimum = std::min(result.Minimum, id);
          result.Maximum = std::max(result.Maximum, id);
          result.Increasing = result.Increasing && previous < id;
          previous = id;
        }
      });
  }

  void Reduce()
  {
    for (const Result& result : this->LocalResult)
    {
      this->Total.Minimum = std::min(this->Total.Minimum, result.Minimum);
      this->Total.Maximum = std::max(this->Total.Maximum, result.Maximum);
      this->Total.Increasing = this->Total.Increasing && result.Increasing;
    }
  }

  struct Result
  {
    vtkIdType Minimum = VTK_ID_MAX;
    vtkIdType Maximum = VTK_ID_MIN;
    bool Increasing = true;
  };
  Result Total;

private:
  vtkCellArray* Cells;
  vtkSMPThreadLocal<Result> LocalResult;
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
  const IdSurvey::Result ofLines = IdSurvey(input->GetLines()).Total;
  const IdSurvey::Result ofVertices = IdSurvey(vertices).Total;

  const vtkIdType pointCount = input->GetNumberOfPoints();
  if (ofLines.Minimum < 0 || ofLines.Maximum >= pointCount)
  {
    ThrowBadId(input->GetLines(), "Line", pointCount);
  }
  if (ofVertices.Minimum < 0 || ofVertices.Maximum >= pointCount)
  {
    ThrowBadId(vertices, "Vertex cell", pointCount);
  }
  const bool apart = ofLines.Maximum < ofVertices.Minimum || ofVertices.Maximum < ofLines.Minimum;
  if (ofLines.Increasing && ofVertices.Increasing && apart)
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
