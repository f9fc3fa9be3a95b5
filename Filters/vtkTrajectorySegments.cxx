// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectorySegments.h"

#include "Private/vtkArrayValues.h"
#include "Private/vtkBatches.h"
#include "Private/vtkPolylines.h"
#include "Private/vtkUnsharedPoints.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrajectorySegments);

namespace
{
// Lines that are worth a batch of their own.
constexpr vtkIdType MinimumBatch = 1024;

//------------------------------------------------------------------------------
// Call visit(point id, length of the line up to that point) along a line, and return its length:
// NaN if a coordinate is missing. Lengths never decrease; adding up block by block keeps the error
// of 10^7 points near that of a thousand.
template <typename Function>
double WalkLine(
  const vtkPolylines& lines, const vtkArrayValues& coordinates, vtkIdType line, Function&& visit)
{
  const vtkIdType begin = lines.GetBegin(line);
  const vtkIdType end = lines.GetEnd(line);
  double length = 0.0;
  for (vtkIdType first = begin; first < end; first += vtkPolylines::BlockSize)
  {
    // With the point before, except at the line's begin, where that is the point itself.
    vtkIdType ids[vtkPolylines::BlockSize + 1];
    const vtkIdType count = std::min(vtkPolylines::BlockSize, end - first);
    lines.CopyIds(first, first + count, ids + 1);
    ids[0] = lines.GetId(std::max(first - 1, begin));
    double x[3][vtkPolylines::BlockSize + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      coordinates.Gather(ids, count + 1, axis, x[axis]);
    }
    double lengthOfBlock = 0.0;
    for (vtkIdType i = 1; i <= count; ++i)
    {
      const double dx = x[0][i] - x[0][i - 1];
      const double dy = x[1][i] - x[1][i - 1];
      const double dz = x[2][i] - x[2][i - 1];
      lengthOfBlock += std::sqrt(dx * dx + dy * dy + dz * dz);
      visit(ids[i], length + lengthOfBlock);
    }
    length += lengthOfBlock;
  }
  return length;
}

//------------------------------------------------------------------------------
// The position of a point between the centres of segments.
struct SegmentPosition
{
  vtkIdType Base = 0;
  float Weight = 0.0F;

  SegmentPosition(double length, double lengthOfLine, vtkIdType segments)
  {
    const double last = static_cast<double>(segments - 1);
    const double position =
      std::clamp(length / lengthOfLine * static_cast<double>(segments) - 0.5, 0.0, last);
    this->Base = static_cast<vtkIdType>(position);
    this->Weight = static_cast<float>(position - static_cast<double>(this->Base));
    if (this->Weight >= 1.0F) // by rounding
    {
      ++this->Base;
      this->Weight = 0.0F;
    }
  }
};

//------------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, vtkIdType count)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  return array;
}

//------------------------------------------------------------------------------
template <typename Array, typename Value>
void Fill(Array* array, Value value)
{
  auto* values = array->GetPointer(0);
  vtkSMPTools::Fill(values, values + array->GetNumberOfValues(), value);
}
}

//------------------------------------------------------------------------------
int vtkTrajectorySegments::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->TotalNumberOfSegments = 0;
  this->UpdateProgress(0.0);
  try
  {
    output->ShallowCopy(vtkUnsharedPoints::Make(input, vtkUnsharedPoints::LINES_AND_VERTICES));
    // An abort empties the output.
    if (this->Divide(output))
    {
      this->UpdateProgress(1.0);
    }
    return 1;
  }
  catch (const std::logic_error& error)
  {
    output->Initialize();
    vtkErrorMacro(<< error.what());
    return 0;
  }
}

//------------------------------------------------------------------------------
bool vtkTrajectorySegments::Divide(vtkPolyData* output)
{
  const vtkPolylines lines(output->GetLines());
  vtkNew<vtkPoints> noPoints;
  vtkPoints* points = output->GetPoints() ? output->GetPoints() : noPoints.Get();
  const vtkArrayValues coordinates(points->GetData());
  const vtkIdType lineCount = lines.GetNumberOfLines();

  std::vector<double> lengths(lineCount);
  const auto measure = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType line = first; line < last; ++line)
    {
      const double length = WalkLine(lines, coordinates, line, [](vtkIdType, double) {});
      lengths[line] = std::isnan(length) ? 0.0 : length;
    }
  };
  if (!vtkBatches(this, 0.0, 0.4).ParallelFor(lineCount, measure, MinimumBatch))
  {
    return false;
  }
  const std::vector<vtkIdType> counts = this->CountSegments(lines, lengths);

  const vtkIdType pointCount = output->GetNumberOfPoints();
  const auto bases = MakeArray<vtkIdTypeArray>("SegmentBase", pointCount);
  const auto weights = MakeArray<vtkFloatArray>("SegmentWeight", pointCount);
  Fill(bases.Get(), vtkIdType(-1));
  Fill(weights.Get(), 0.0F);
  const auto firstSegments = MakeArray<vtkIdTypeArray>("FirstSegment", output->GetNumberOfCells());
  const auto segmentCounts =
    MakeArray<vtkIdTypeArray>("NumberOfSegments", output->GetNumberOfCells());
  Fill(firstSegments.Get(), vtkIdType(-1));
  Fill(segmentCounts.Get(), vtkIdType(0));

  // The cells of a poly data are numbered from the vertices on, then the lines.
  const vtkPolylines vertices(output->GetVerts());
  const vtkIdType vertexCells = vertices.GetNumberOfLines();
  for (vtkIdType cell = 0; cell < vertexCells; ++cell)
  {
    firstSegments->SetValue(cell, vertices.GetBegin(cell));
    segmentCounts->SetValue(cell, vertices.GetEnd(cell) - vertices.GetBegin(cell));
  }
  for (vtkIdType position = 0; position < vertices.GetNumberOfPositions(); ++position)
  {
    bases->SetValue(vertices.GetId(position), position);
  }
  vtkIdType total = vertices.GetNumberOfPositions();
  for (vtkIdType line = 0; line < lineCount; ++line)
  {
    firstSegments->SetValue(vertexCells + line, total);
    segmentCounts->SetValue(vertexCells + line, counts[line]);
    total += counts[line];
  }

  const auto place = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType line = first; line < last; ++line)
    {
      const vtkIdType firstSegment = firstSegments->GetValue(vertexCells + line);
      WalkLine(lines, coordinates, line,
        [&](vtkIdType id, double length)
        {
          if (counts[line] > 1)
          {
            const SegmentPosition position(length, lengths[line], counts[line]);
            bases->SetValue(id, firstSegment + position.Base);
            weights->SetValue(id, position.Weight);
          }
          else
          {
            bases->SetValue(id, firstSegment);
          }
        });
    }
  };
  if (!vtkBatches(this, 0.4, 1.0).ParallelFor(lineCount, place, MinimumBatch))
  {
    return false;
  }

  this->TotalNumberOfSegments = total;
  const auto totals = MakeArray<vtkIdTypeArray>("TotalNumberOfSegments", 1);
  totals->SetValue(0, total);
  output->GetPointData()->AddArray(bases);
  output->GetPointData()->AddArray(weights);
  output->GetCellData()->AddArray(firstSegments);
  output->GetCellData()->AddArray(segmentCounts);
  output->GetFieldData()->AddArray(totals);
  return true;
}

//------------------------------------------------------------------------------
std::vector<vtkIdType> vtkTrajectorySegments::CountSegments(
  const vtkPolylines& lines, const std::vector<double>& lengths) const
{
  const double lengthOfAll = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  const double target = this->SegmentLength > 0.0
    ? this->SegmentLength
    : lengthOfAll / static_cast<double>(this->NumberOfSegments);
  std::vector<vtkIdType> counts(lengths.size());
  double total = 0.0;
  for (std::size_t line = 0; line < lengths.size(); ++line)
  {
    const bool hasPoints = lines.GetBegin(line) < lines.GetEnd(line);
    const double wanted = target > 0.0 ? std::round(lengths[line] / target) : 0.0;
    const double count = hasPoints ? std::max(1.0, wanted) : 0.0;
    counts[line] = static_cast<vtkIdType>(std::min<double>(count, VTK_INT_MAX));
    total += count;
  }
  if (total > VTK_INT_MAX)
  {
    std::ostringstream message;
    message << "Lines of length " << lengthOfAll << " in segments of length " << target << " are "
            << total << " segments, but at most " << VTK_INT_MAX
            << " are possible. Set a greater SegmentLength.";
    throw std::invalid_argument(message.str());
  }
  return counts;
}

//------------------------------------------------------------------------------
void vtkTrajectorySegments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSegments: " << this->NumberOfSegments << "\n";
  os << indent << "SegmentLength: " << this->SegmentLength << "\n";
  os << indent << "TotalNumberOfSegments: " << this->TotalNumberOfSegments << "\n";
}

VTK_ABI_NAMESPACE_END
