// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectorySegments.h"

#include "Private/vtkArrayValues.h"
#include "Private/vtkBatches.h"
#include "Private/vtkFillOutput.h"
#include "Private/vtkLeafCopies.h"
#include "Private/vtkPolylines.h"
#include "Private/vtkUnsharedPoints.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrajectorySegments);

namespace
{
// Lines that are worth a batch of their own.
constexpr vtkIdType MinimumBatch = 1024;

// Part of the progress that the lengths are.
constexpr double MeasureProgress = 0.4;

// What is aimed at where no number is given.
constexpr double UsualSegments = 20000.0;
constexpr double SegmentsAcrossDiagonal = 128.0;

//------------------------------------------------------------------------------
// Call visit(point id, length of the line up to that point, position) along a line, and return its
// length: NaN if a coordinate is missing. Lengths never decrease; adding up block by block keeps
// the error of 10^7 points near that of a thousand.
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
      const double position[3] = { x[0][i], x[1][i], x[2][i] };
      visit(ids[i], length + lengthOfBlock, position);
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
    if (segments == 1) // the lengths may be 0 or missing
    {
      return;
    }
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
vtkSmartPointer<Array> MakeArray(const char* name, vtkIdType count, typename Array::ValueType value)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfValues(count);
  vtkSMPTools::Fill(array->GetPointer(0), array->GetPointer(0) + count, value);
  return array;
}

//------------------------------------------------------------------------------
const vtkIdType* GetIds(vtkDataSetAttributes* data, const char* name)
{
  return vtkIdTypeArray::SafeDownCast(data->GetArray(name))->GetPointer(0);
}

//------------------------------------------------------------------------------
vtkDataArray* GetCoordinates(vtkPolyData* data)
{
  return data->GetPoints() ? data->GetPoints()->GetData() : nullptr;
}

//------------------------------------------------------------------------------
double CountSegments(double length, double target)
{
  return target > 0.0 ? std::max(1.0, std::round(length / target)) : 1.0;
}

//------------------------------------------------------------------------------
// Throws if there were more segments than an int can number, which is what a shader has.
void CheckTotal(double total, double target)
{
  if (total > VTK_INT_MAX)
  {
    std::ostringstream message;
    message << "Segments of length " << target << " would be " << total << ", but at most "
            << VTK_INT_MAX << " are possible. Set a greater SegmentLength.";
    throw std::invalid_argument(message.str());
  }
}
}

//------------------------------------------------------------------------------
struct vtkTrajectorySegments::Leaf
{
  vtkPolyData* Data; // of the output
  std::vector<double> Lengths;
  vtkBoundingBox Box; // of the lines with a length

  // In double precision, which has no overflow.
  double GetNumberOfSegments(double target) const
  {
    const auto ofVertices =
      static_cast<double>(this->Data->GetVerts()->GetNumberOfConnectivityIds());
    return std::accumulate(this->Lengths.begin(), this->Lengths.end(), ofVertices,
      [target](double total, double length) { return total + CountSegments(length, target); });
  }
};

//------------------------------------------------------------------------------
int vtkTrajectorySegments::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTrajectorySegments::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  this->TotalNumberOfSegments = 0;
  return vtkFillOutput(
    this, output, [&] { return this->Divide(vtkDataObject::GetData(inputVector[0]), output); });
}

//------------------------------------------------------------------------------
bool vtkTrajectorySegments::Divide(vtkDataObject* input, vtkDataObject* output)
{
  std::vector<Leaf> leaves;
  for (const auto& [source, copy] : vtkCopyLeaves(input, output))
  {
    if (auto* lines = vtkPolyData::SafeDownCast(source))
    {
      copy->ShallowCopy(
        vtkUnsharedPoints::Make(lines, vtkUnsharedPoints::LINES_AND_VERTICES, this));
      leaves.push_back({ vtkPolyData::SafeDownCast(copy), {}, {} });
    }
  }
  const auto forEachLeaf = [&](const vtkBatches& batches, auto&& work)
  {
    const double fraction = 1.0 / static_cast<double>(leaves.size());
    for (std::size_t i = 0; i < leaves.size(); ++i)
    {
      const auto done = static_cast<double>(i);
      if (!work(batches.GetPart(done * fraction, (done + 1.0) * fraction), leaves[i]))
      {
        return false;
      }
    }
    return true;
  };

  if (!forEachLeaf(vtkBatches(this, 0.0, MeasureProgress), MeasureLines))
  {
    return false;
  }
  const double target = this->ChooseLength(leaves);
  double total = 0.0;
  for (const Leaf& leaf : leaves)
  {
    total += leaf.GetNumberOfSegments(target);
  }
  CheckTotal(total, target);
  for (const Leaf& leaf : leaves)
  {
    this->TotalNumberOfSegments += NumberSegments(leaf, target);
  }
  return forEachLeaf(vtkBatches(this, MeasureProgress, 1.0), PlacePoints);
}

//------------------------------------------------------------------------------
bool vtkTrajectorySegments::MeasureLines(const vtkBatches& batches, Leaf& leaf)
{
  const vtkPolylines lines(leaf.Data->GetLines());
  const vtkArrayValues coordinates(GetCoordinates(leaf.Data));
  leaf.Lengths.resize(lines.GetNumberOfLines());
  vtkSMPThreadLocal<vtkBoundingBox> boxes;
  const auto measure = [&](vtkIdType first, vtkIdType last)
  {
    vtkBoundingBox& box = boxes.Local();
    for (vtkIdType line = first; line < last; ++line)
    {
      vtkBoundingBox boxOfLine;
      const double length = WalkLine(lines, coordinates, line,
        [&boxOfLine](vtkIdType, double, const double* x) { boxOfLine.AddPoint(x[0], x[1], x[2]); });
      if (length > 0.0)
      {
        leaf.Lengths[line] = length;
        box.AddBox(boxOfLine);
      }
    }
  };
  const bool isComplete = batches.ParallelFor(lines.GetNumberOfLines(), measure, MinimumBatch);
  for (const vtkBoundingBox& box : boxes)
  {
    leaf.Box.AddBox(box);
  }
  return isComplete;
}

//------------------------------------------------------------------------------
// World units; 0 without lines.
double vtkTrajectorySegments::ChooseLength(const std::vector<Leaf>& leaves) const
{
  if (this->SegmentLength > 0.0)
  {
    return this->SegmentLength;
  }
  std::vector<double> lengths;
  vtkBoundingBox box;
  for (const Leaf& leaf : leaves)
  {
    lengths.insert(lengths.end(), leaf.Lengths.begin(), leaf.Lengths.end());
    box.AddBox(leaf.Box);
  }
  // In another order of the lines, the sum would be rounded to another one.
  vtkSMPTools::Sort(lengths.begin(), lengths.end());
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.0);
  if (this->NumberOfSegments > 0)
  {
    return length / static_cast<double>(this->NumberOfSegments);
  }
  return length == 0.0
    ? 0.0
    : std::max(length / UsualSegments, box.GetDiagonalLength() / SegmentsAcrossDiagonal);
}

//------------------------------------------------------------------------------
vtkIdType vtkTrajectorySegments::NumberSegments(const Leaf& leaf, double target)
{
  const vtkIdType cellCount = leaf.Data->GetNumberOfCells();
  const auto firsts = MakeArray<vtkIdTypeArray>("FirstSegment", cellCount, -1);
  const auto counts = MakeArray<vtkIdTypeArray>("NumberOfSegments", cellCount, 0);
  // The cells of a poly data are numbered from the vertices on, then the lines.
  vtkIdType cell = 0;
  vtkIdType total = 0;
  const auto number = [&](vtkIdType count)
  {
    firsts->SetValue(cell, total);
    counts->SetValue(cell, count);
    total += count;
    ++cell;
  };
  const vtkPolylines vertices(leaf.Data->GetVerts());
  for (vtkIdType i = 0; i < vertices.GetNumberOfLines(); ++i)
  {
    number(vertices.GetEnd(i) - vertices.GetBegin(i));
  }
  const vtkPolylines lines(leaf.Data->GetLines());
  for (vtkIdType line = 0; line < lines.GetNumberOfLines(); ++line)
  {
    const bool hasPoints = lines.GetBegin(line) < lines.GetEnd(line);
    number(hasPoints ? static_cast<vtkIdType>(CountSegments(leaf.Lengths[line], target)) : 0);
  }

  const auto totals = MakeArray<vtkIdTypeArray>("TotalNumberOfSegments", 1, total);
  leaf.Data->GetCellData()->AddArray(firsts);
  leaf.Data->GetCellData()->AddArray(counts);
  leaf.Data->GetFieldData()->AddArray(totals);
  return total;
}

//------------------------------------------------------------------------------
bool vtkTrajectorySegments::PlacePoints(const vtkBatches& batches, const Leaf& leaf)
{
  const auto bases =
    MakeArray<vtkIdTypeArray>("SegmentBase", leaf.Data->GetNumberOfPoints(), vtkIdType(-1));
  const auto weights =
    MakeArray<vtkFloatArray>("SegmentWeight", leaf.Data->GetNumberOfPoints(), 0.0F);
  leaf.Data->GetPointData()->AddArray(bases);
  leaf.Data->GetPointData()->AddArray(weights);

  const vtkPolylines vertices(leaf.Data->GetVerts());
  for (vtkIdType position = 0; position < vertices.GetNumberOfPositions(); ++position)
  {
    bases->SetValue(vertices.GetId(position), position);
  }

  const vtkPolylines lines(leaf.Data->GetLines());
  const vtkArrayValues coordinates(GetCoordinates(leaf.Data));
  const vtkIdType firstCell = vertices.GetNumberOfLines();
  const vtkIdType* firsts = GetIds(leaf.Data->GetCellData(), "FirstSegment") + firstCell;
  const vtkIdType* counts = GetIds(leaf.Data->GetCellData(), "NumberOfSegments") + firstCell;
  const auto place = [&](vtkIdType first, vtkIdType last)
  {
    for (vtkIdType line = first; line < last; ++line)
    {
      WalkLine(lines, coordinates, line,
        [&](vtkIdType id, double length, const double*)
        {
          const SegmentPosition position(length, leaf.Lengths[line], counts[line]);
          bases->SetValue(id, firsts[line] + position.Base);
          weights->SetValue(id, position.Weight);
        });
    }
  };
  return batches.ParallelFor(lines.GetNumberOfLines(), place, MinimumBatch);
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
