// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGeographicLines.h"

#include "vtkTrajectoryLines.h"

#include "vtkIdTypeArray.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double Circle = 360.0;

// Positions that are beyond a pole by no more than rounding are good.
constexpr double GreatestLatitude = 90.001;

// A hundred turns: numbers far beyond any longitude are damage, or missing values without a mark.
constexpr double GreatestLongitude = 100.0 * Circle;

constexpr double ReferencePressure = 1000.0; // hPa

//------------------------------------------------------------------------------
// The way from one longitude to another, the shorter one: at most half a circle. Without rounding,
// and without overflow.
double Turn(double from, double to)
{
  return std::remainder(std::remainder(to, Circle) - std::remainder(from, Circle), Circle);
}

//------------------------------------------------------------------------------
// The two products cannot overflow, unlike the difference.
double Blend(double a, double b, double fraction)
{
  // What has no part in it may be missing.
  return fraction == 0.0 ? a : fraction == 1.0 ? b : (1.0 - fraction) * a + fraction * b;
}
}

//------------------------------------------------------------------------------
double vtkGeographicLines::VerticalAxis::operator()(double value) const
{
  // Logarithms one by one: quotients and products could overflow.
  const double height = this->LogPressure
    ? std::log(ReferencePressure) - std::log(this->Unit) - std::log(value)
    : this->Unit * value;
  return this->Scale * height;
}

//------------------------------------------------------------------------------
vtkGeographicLines::vtkGeographicLines(const vtkTrajectorySource& source,
  const Coordinates& coordinates, const Map& map, const VerticalAxis& verticalAxis)
  : Source(coordinates)
  , Projection(map)
  , Axis(verticalAxis)
{
  const bool isDouble = coordinates.Longitude.IsDouble() || coordinates.Latitude.IsDouble() ||
    coordinates.Vertical.IsDouble();
  this->Points->SetDataType(isDouble ? VTK_DOUBLE : VTK_FLOAT);
  for (vtkIdType trajectory = 0; trajectory < source.GetNumberOfTrajectories(); ++trajectory)
  {
    this->AddTrajectory(trajectory, source.GetNumberOfSamples(trajectory));
  }
  this->Points->Squeeze();
}

//------------------------------------------------------------------------------
bool vtkGeographicLines::IsValid(vtkIdType trajectory, vtkIdType sample)
{
  const double longitude = this->Source.Longitude.Get(trajectory, sample);
  const double latitude = this->Source.Latitude.Get(trajectory, sample);
  const double vertical = this->Source.Vertical.Get(trajectory, sample);
  if (!std::isfinite(longitude) || !std::isfinite(latitude) || !std::isfinite(vertical))
  {
    return false;
  }
  // The height of a pressure of 0 or less is not finite either.
  const bool isValid = std::abs(longitude) <= GreatestLongitude &&
    std::abs(latitude) <= GreatestLatitude &&
    std::abs(this->Axis(vertical)) <= std::numeric_limits<float>::max();
  this->NumberOfInvalidSamples += isValid ? 0 : 1;
  return isValid;
}

//------------------------------------------------------------------------------
vtkVector3d vtkGeographicLines::GetPosition(vtkIdType trajectory, vtkIdType sample) const
{
  return { this->Source.Longitude.Get(trajectory, sample),
    this->Source.Latitude.Get(trajectory, sample),
    this->Axis(this->Source.Vertical.Get(trajectory, sample)) };
}

//------------------------------------------------------------------------------
// The eastern edge of the map for a positive side, else the western one.
double vtkGeographicLines::GetEdge(double side) const
{
  return this->Projection.CentralLongitude + std::copysign(0.5 * Circle, side);
}

//------------------------------------------------------------------------------
void vtkGeographicLines::BeginLine(vtkIdType trajectory, vtkIdType sample)
{
  this->Lines.push_back({ trajectory, sample, sample, this->Points->GetNumberOfPoints() });
}

//------------------------------------------------------------------------------
void vtkGeographicLines::AddTrajectory(vtkIdType trajectory, vtkIdType numberOfSamples)
{
  const double center = this->Projection.CentralLongitude;
  bool isFirst = true;
  bool isGap = true;
  vtkVector3d last;
  for (vtkIdType sample = 0; sample < numberOfSamples; ++sample)
  {
    if (!this->IsValid(trajectory, sample))
    {
      isGap = true;
      continue;
    }
    vtkVector3d position = this->GetPosition(trajectory, sample);
    if (!isFirst)
    {
      position[0] = last[0] + Turn(last[0], position[0]);
    }
    if (isGap)
    {
      this->BeginLine(trajectory, sample);
    }
    if (this->Projection.IsCut && std::abs(position[0] - center) > 0.5 * Circle)
    {
      if (!isGap)
      {
        this->CutLine(last, position);
      }
      position[0] = center + Turn(center, position[0]);
    }
    this->Points->InsertNextPoint(position.GetData());
    this->Lines.back().EndSample = sample + 1;
    last = position;
    isFirst = false;
    isGap = false;
  }
}

//------------------------------------------------------------------------------
// End the last line on the edge of the map between two positions, and begin one on the other edge.
void vtkGeographicLines::CutLine(const vtkVector3d& inside, const vtkVector3d& outside)
{
  const double side = outside[0] - this->Projection.CentralLongitude;
  const double edge = this->GetEdge(side);
  const double fraction = (edge - inside[0]) / (outside[0] - inside[0]);
  const double y = Blend(inside[1], outside[1], fraction);
  const double z = Blend(inside[2], outside[2], fraction);
  Line& line = this->Lines.back();
  if (fraction > 0.0)
  {
    line.Tail = fraction;
    this->Points->InsertNextPoint(edge, y, z);
  }
  this->BeginLine(line.Trajectory, line.EndSample);
  this->Lines.back().Head = 1.0 - fraction;
  this->Points->InsertNextPoint(this->GetEdge(-side), y, z);
}

//------------------------------------------------------------------------------
template <typename Visitor>
void vtkGeographicLines::ForEachPoint(Visitor&& visit) const
{
  vtkSMPTools::For(0, this->GetNumberOfLines(),
    [this, &visit](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Line& line = this->Lines[i];
        vtkIdType point = line.FirstPoint;
        if (line.Head != Line::NoPoint)
        {
          visit(line, point++, line.FirstSample, line.FirstSample - 1, line.Head);
        }
        for (vtkIdType sample = line.FirstSample; sample < line.EndSample; ++sample)
        {
          visit(line, point++, sample, sample, 0.0);
        }
        if (line.Tail != Line::NoPoint)
        {
          visit(line, point, line.EndSample - 1, line.EndSample, line.Tail);
        }
      }
    });
}

//------------------------------------------------------------------------------
void vtkGeographicLines::MakeGeometry(vtkPolyData* output) const
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> ids;
  offsets->SetNumberOfValues(this->GetNumberOfLines() + 1);
  ids->SetNumberOfValues(this->GetNumberOfLines());
  for (vtkIdType line = 0; line < this->GetNumberOfLines(); ++line)
  {
    offsets->SetValue(line, this->Lines[line].FirstPoint);
    ids->SetValue(line, this->Lines[line].Trajectory);
  }
  offsets->SetValue(this->GetNumberOfLines(), this->Points->GetNumberOfPoints());

  vtkTrajectoryLines::SetLines(output, this->Points, offsets, ids);
}

//------------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<vtkDataArray> vtkGeographicLines::GatherPoints(
  Array* values, const vtkTrajectorySource::Samples& samples, bool isAngle) const
{
  using Value = typename Array::ValueType;
  const auto result = vtkSmartPointer<Array>::New();
  result->SetNumberOfValues(this->Points->GetNumberOfPoints());
  const Value* source = values->GetPointer(0);
  Value* target = result->GetPointer(0);
  const auto gather =
    [&](const Line& line, vtkIdType point, vtkIdType sample, vtkIdType neighbour, double fraction)
  {
    const Value value = source[samples.GetIndex(line.Trajectory, sample)];
    if (fraction == 0.0)
    {
      target[point] = value;
      return;
    }
    const Value other = source[samples.GetIndex(line.Trajectory, neighbour)];
    target[point] = static_cast<Value>(
      isAngle ? value + fraction * Turn(value, other) : Blend(value, other, fraction));
  };
  this->ForEachPoint(gather);
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkGeographicLines::MakePointArray(
  const vtkTrajectorySource::Samples& samples, bool isAngle) const
{
  auto* doubles = vtkDoubleArray::SafeDownCast(samples.GetValues());
  return doubles
    ? this->GatherPoints(doubles, samples, isAngle)
    : this->GatherPoints(vtkFloatArray::SafeDownCast(samples.GetValues()), samples, isAngle);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkGeographicLines::MakeCellArray(
  const vtkTrajectorySource::Samples& samples) const
{
  auto result = vtk::TakeSmartPointer(samples.GetValues()->NewInstance());
  result->SetNumberOfTuples(this->GetNumberOfLines());
  for (vtkIdType line = 0; line < this->GetNumberOfLines(); ++line)
  {
    result->SetTuple1(line, samples.Get(this->Lines[line].Trajectory, 0));
  }
  return result;
}

VTK_ABI_NAMESPACE_END
