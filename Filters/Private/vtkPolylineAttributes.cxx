// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPolylineAttributes.h"

#include "vtkVectorAngle.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();
constexpr double LargestFloat = std::numeric_limits<float>::max();

//------------------------------------------------------------------------------
std::optional<vtkArrayValues> MakeValues(vtkDataArray* array)
{
  return array ? std::make_optional<vtkArrayValues>(array) : std::nullopt;
}

//------------------------------------------------------------------------------
// Keeps NaN.
float ToFloat(double value)
{
  return static_cast<float>(std::min(std::max(value, -LargestFloat), LargestFloat));
}

//------------------------------------------------------------------------------
double ComputeCurvature(double angle, double lengthBefore, double lengthAfter)
{
  return angle > 0.0 ? 2.0 * angle / (lengthBefore + lengthAfter) : angle;
}

//------------------------------------------------------------------------------
double ComputeVelocity(double length, double timeStep)
{
  const double withoutTime = length > 0.0 ? LargestFloat : length;
  return timeStep == 0.0 ? withoutTime : length / std::abs(timeStep);
}
}

//------------------------------------------------------------------------------
// Points 1 ... Size of a line, with one more at either side: beyond an end of the line its values
// are missing, but those of the point itself if that is the whole line, so that its segment has no
// length. Segment i goes from point i to point i + 1.
struct vtkPolylineAttributes::Block
{
  static constexpr vtkIdType Capacity = vtkPolylines::BlockSize + 2;
  using Values = double[Capacity];

  Block(const vtkPolylines& lines, vtkIdType line, vtkIdType first, vtkIdType last)
    : Size(last - first)
    , IsAlone(lines.GetEnd(line) - lines.GetBegin(line) == 1)
    , HasBefore(first > lines.GetBegin(line))
    , HasAfter(last < lines.GetEnd(line))
  {
    lines.CopyIds(first - this->HasBefore, last + this->HasAfter, this->Ids + 1 - this->HasBefore);
    this->Ids[0] = this->HasBefore ? this->Ids[0] : this->Ids[1];
    this->Ids[this->Size + 1] = this->Ids[this->Size + (this->HasAfter ? 1 : 0)];
  }

  void Gather(const vtkArrayValues& array, int component, Values& values) const
  {
    array.Gather(this->Ids, this->Size + 2, component, values);
    if (!this->HasBefore && !this->IsAlone)
    {
      values[0] = Missing;
    }
    if (!this->HasAfter && !this->IsAlone)
    {
      values[this->Size + 1] = Missing;
    }
  }

  // Store the value of each segment at the point where it begins, and at a line's last point that
  // of its last segment.
  void StoreSegments(const double* values, float* output) const
  {
    this->StorePoints(values, output);
    if (!this->HasAfter && !this->IsAlone)
    {
      output[this->Ids[this->Size]] = ToFloat(values[this->Size - 1]);
    }
  }

  void StorePoints(const double* values, float* output) const
  {
    for (vtkIdType i = 1; i <= this->Size; ++i)
    {
      output[this->Ids[i]] = ToFloat(values[i]);
    }
  }

  vtkIdType Size;
  bool IsAlone;
  bool HasBefore;
  bool HasAfter;
  vtkIdType Ids[Capacity];
  Values Coordinates[3];
  Values Steps[3];
  Values Lengths;
};

//------------------------------------------------------------------------------
struct vtkPolylineAttributes::Segment
{
  double Step[3] = { Missing, Missing, Missing };
  double Length = Missing;
};

//------------------------------------------------------------------------------
vtkPolylineAttributes::vtkPolylineAttributes(const vtkPolylines& lines, vtkDataArray* coordinates,
  int upAxis, vtkDataArray* pressure, vtkDataArray* height, vtkDataArray* time)
  : Lines(lines)
  , UpAxis(upAxis)
  , Coordinates(coordinates)
  , Pressure(MakeValues(pressure))
  , Height(MakeValues(height))
  , Time(MakeValues(time))
{
}

//------------------------------------------------------------------------------
bool vtkPolylineAttributes::Compute(vtkIdType first, vtkIdType last) const
{
  bool needsRepair = false;
  this->Lines.ForEachPart(first, last,
    [&](vtkIdType line, vtkIdType partFirst, vtkIdType partLast)
    {
      for (vtkIdType i = partFirst; i < partLast; i += vtkPolylines::BlockSize)
      {
        const vtkIdType blockLast = std::min(i + vtkPolylines::BlockSize, partLast);
        needsRepair |= this->ComputeBlock(line, i, blockLast);
      }
    });
  return needsRepair;
}

//------------------------------------------------------------------------------
bool vtkPolylineAttributes::ComputeBlock(vtkIdType line, vtkIdType first, vtkIdType last) const
{
  Block block(this->Lines, line, first, last);
  for (int axis = 0; axis < 3; ++axis)
  {
    block.Gather(this->Coordinates, axis, block.Coordinates[axis]);
    for (vtkIdType i = 0; i <= block.Size; ++i)
    {
      block.Steps[axis][i] = block.Coordinates[axis][i + 1] - block.Coordinates[axis][i];
    }
  }
  for (vtkIdType i = 0; i <= block.Size; ++i)
  {
    const double x = block.Steps[0][i];
    const double y = block.Steps[1][i];
    const double z = block.Steps[2][i];
    block.Lengths[i] = std::sqrt(x * x + y * y + z * z);
  }
  this->ComputeSegments(block);
  this->ComputeTurning(block);
  return !block.IsAlone &&
    std::find(block.Lengths, block.Lengths + block.Size + 1, 0.0) != block.Lengths + block.Size + 1;
}

//------------------------------------------------------------------------------
void vtkPolylineAttributes::ComputeSegments(const Block& block) const
{
  using Attributes = vtkTrajectoryAttributes;
  Block::Values values;
  Block::Values results;
  const auto compute = [&](float* output, auto&& value)
  {
    for (vtkIdType i = 0; i <= block.Size; ++i)
    {
      results[i] = value(i);
    }
    block.StoreSegments(results, output);
  };
  if (float* output = this->Outputs[Attributes::SEGMENT_LENGTH])
  {
    block.StoreSegments(block.Lengths, output);
  }
  if (float* output = this->Outputs[Attributes::SEGMENT_PRESSURE_DIFFERENCE])
  {
    block.Gather(*this->Pressure, 0, values);
    compute(output, [&](vtkIdType i) { return values[i] - values[i + 1]; });
  }
  if (float* output = this->Outputs[Attributes::SEGMENT_HEIGHT_DIFFERENCE])
  {
    if (this->Height)
    {
      block.Gather(*this->Height, 0, values);
      compute(output, [&](vtkIdType i) { return values[i + 1] - values[i]; });
    }
    else
    {
      block.StoreSegments(block.Steps[this->UpAxis], output);
    }
  }
  if (float* output = this->Outputs[Attributes::VELOCITY])
  {
    block.Gather(*this->Time, 0, values);
    compute(output,
      [&](vtkIdType i) { return ComputeVelocity(block.Lengths[i], values[i + 1] - values[i]); });
  }
  if (float* output = this->Outputs[Attributes::ANGLE_OF_ASCENT])
  {
    const double* rise = block.Steps[this->UpAxis];
    const double* a = block.Steps[(this->UpAxis + 1) % 3];
    const double* b = block.Steps[(this->UpAxis + 2) % 3];
    compute(output,
      [=](vtkIdType i)
      {
        return vtkMath::DegreesFromRadians(
          vtkFastAtan2(rise[i], std::sqrt(a[i] * a[i] + b[i] * b[i])));
      });
  }
}

//------------------------------------------------------------------------------
void vtkPolylineAttributes::ComputeTurning(const Block& block) const
{
  float* angleOutput = this->Outputs[vtkTrajectoryAttributes::TURNING_ANGLE];
  float* curvatureOutput = this->Outputs[vtkTrajectoryAttributes::CURVATURE];
  if (!angleOutput && !curvatureOutput)
  {
    return;
  }
  const auto& x = block.Steps[0];
  const auto& y = block.Steps[1];
  const auto& z = block.Steps[2];
  Block::Values angles;
  for (vtkIdType i = 1; i <= block.Size; ++i)
  {
    const double angle = vtkVectorAngle(x[i - 1], y[i - 1], z[i - 1], x[i], y[i], z[i]);
    // Where a line ends the angle is 0, unless the point itself is missing.
    const double sum = block.Coordinates[0][i] + block.Coordinates[1][i] + block.Coordinates[2][i];
    angles[i] = std::isnan(angle) ? sum - sum : angle;
  }
  Block::Values results;
  if (angleOutput)
  {
    for (vtkIdType i = 1; i <= block.Size; ++i)
    {
      results[i] = vtkMath::DegreesFromRadians(angles[i]);
    }
    block.StorePoints(results, angleOutput);
  }
  if (curvatureOutput)
  {
    for (vtkIdType i = 1; i <= block.Size; ++i)
    {
      results[i] = ComputeCurvature(angles[i], block.Lengths[i - 1], block.Lengths[i]);
    }
    block.StorePoints(results, curvatureOutput);
  }
}

//------------------------------------------------------------------------------
void vtkPolylineAttributes::Repair(vtkIdType first, vtkIdType last) const
{
  this->Lines.ForEachPart(first, last,
    [this](vtkIdType line, vtkIdType partFirst, vtkIdType partLast)
    { this->RepairLine(line, partFirst, partLast); });
}

//------------------------------------------------------------------------------
void vtkPolylineAttributes::RepairLine(vtkIdType line, vtkIdType first, vtkIdType last) const
{
  const auto hasNoLength = [&](vtkIdType position)
  { return this->GetSegment(line, position).Length == 0.0; };

  vtkIdType position = first;
  // A group that begins before `first` is not ours.
  while (position < last && hasNoLength(position - 1))
  {
    ++position;
  }
  for (; position < last; ++position)
  {
    const vtkIdType groupFirst = position;
    while (hasNoLength(position))
    {
      ++position;
    }
    if (position == groupFirst)
    {
      continue;
    }
    const Segment before = this->GetSegment(line, groupFirst - 1);
    const Segment after = this->GetSegment(line, position);
    const double* a = before.Step;
    const double* b = after.Step;
    double angle = vtkVectorAngle(a[0], a[1], a[2], b[0], b[1], b[2]);
    angle = std::isnan(angle) ? 0.0 : angle;
    const double curvature = ComputeCurvature(angle, before.Length, after.Length);
    for (vtkIdType i = groupFirst; i <= position; ++i)
    {
      const vtkIdType id = this->Lines.GetId(i);
      if (float* angles = this->Outputs[vtkTrajectoryAttributes::TURNING_ANGLE])
      {
        angles[id] = ToFloat(vtkMath::DegreesFromRadians(angle));
      }
      if (float* curvatures = this->Outputs[vtkTrajectoryAttributes::CURVATURE])
      {
        curvatures[id] = ToFloat(curvature);
      }
    }
  }
}

//------------------------------------------------------------------------------
// From the point at a position to the next; missing where the line does not have both.
vtkPolylineAttributes::Segment vtkPolylineAttributes::GetSegment(
  vtkIdType line, vtkIdType position) const
{
  Segment segment;
  if (position >= this->Lines.GetBegin(line) && position + 1 < this->Lines.GetEnd(line))
  {
    vtkIdType ids[2];
    this->Lines.CopyIds(position, position + 2, ids);
    for (int axis = 0; axis < 3; ++axis)
    {
      double ends[2];
      this->Coordinates.Gather(ids, 2, axis, ends);
      segment.Step[axis] = ends[1] - ends[0];
    }
    const double* step = segment.Step;
    segment.Length = std::sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
  }
  return segment;
}

VTK_ABI_NAMESPACE_END
