// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of vtkTrajectoryAttributes: closed forms, exact angles from 1e-6 radian to 180
 * degrees, and random lines, with coincident and missing points and in all lengths, against the
 * definitions written down plainly.
 */

#include "ReferenceTesting.h"
#include "TrajectoryTesting.h"

#include "vtkCellData.h"
#include "vtkMath.h"
#include "vtkTrajectoryAttributes.h"

#include <algorithm>
#include <cmath>

namespace
{
using Attributes = vtkTrajectoryAttributes;

vtkSmartPointer<vtkPolyData> Compute(vtkPolyData* input, int upAxis = Attributes::Z)
{
  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(input);
  filter->SetUpAxis(upAxis);
  filter->Update();
  return filter->GetOutput();
}

double GetValue(vtkPolyData* data, int attribute, vtkIdType id)
{
  const char* name = Attributes::GetAttributeName(attribute);
  const bool ofPoints = Attributes::GetAttributeAssociation(attribute) == vtkDataObject::POINT;
  return (ofPoints ? data->GetPointData()->GetArray(name) : data->GetCellData()->GetArray(name))
    ->GetTuple1(id);
}

//------------------------------------------------------------------------------
void TestCircleAndHelix(Checks& checks)
{
  const int count = 36;
  const double radius = 100.0;
  const double center = 6.4e6; // the radius of the earth in metres
  Trajectory circle;
  for (int i = 0; i <= count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    circle.push_back(
      { center + radius * std::cos(angle), center + radius * std::sin(angle), center });
  }
  const auto ofCircle = Compute(MakeTrajectories({ circle }));
  const double step = 2.0 * vtkMath::Pi() / count;
  const double chord = 2.0 * radius * std::sin(step / 2.0);
  for (vtkIdType i = 1; i < count; ++i)
  {
    checks.Near("circle, turning", GetValue(ofCircle, Attributes::TURNING_ANGLE, i), 10.0, 1e-5);
    checks.Near(
      "circle, curvature", GetValue(ofCircle, Attributes::CURVATURE, i), step / chord, 1e-8);
    checks.Near("circle, length", GetValue(ofCircle, Attributes::SEGMENT_LENGTH, i), chord, 1e-5);
    checks.Near("circle, ascent", GetValue(ofCircle, Attributes::ANGLE_OF_ASCENT, i), 0.0, 0.0);
  }
  checks.Near("circle, curvature", step / chord, 1.0 / radius, 2e-5);
  for (const vtkIdType end : { 0, count })
  {
    checks.Near("circle, end", GetValue(ofCircle, Attributes::TURNING_ANGLE, end), 0.0, 0.0);
    checks.Near("circle, end", GetValue(ofCircle, Attributes::CURVATURE, end), 0.0, 0.0);
  }

  const double a = 2.0;
  const double b = 0.5;
  for (int up = 0; up < 3; ++up)
  {
    Trajectory helix(1000);
    for (std::size_t i = 0; i < helix.size(); ++i)
    {
      const double t = 1e-3 * static_cast<double>(i);
      helix[i][up] = b * t;
      helix[i][(up + 1) % 3] = a * std::cos(t);
      helix[i][(up + 2) % 3] = a * std::sin(t);
    }
    const auto ofHelix = Compute(MakeTrajectories({ helix }), up);
    const double ascent = vtkMath::DegreesFromRadians(std::atan2(b, a));
    for (vtkIdType i = 1; i < 999; i += 100)
    {
      checks.Near(
        "helix, curvature", GetValue(ofHelix, Attributes::CURVATURE, i), a / (a * a + b * b), 1e-6);
      checks.Near("helix, ascent", GetValue(ofHelix, Attributes::ANGLE_OF_ASCENT, i), ascent, 1e-5);
      checks.Near("helix, height", GetValue(ofHelix, Attributes::SEGMENT_HEIGHT_DIFFERENCE, i),
        b * 1e-3, 1e-9);
    }
  }
}

//------------------------------------------------------------------------------
// Turning angle and angle of ascent are as exact as their arrays, for angles and lengths of every
// size.
void TestExactAngles(Checks& checks, double scale)
{
  std::vector<double> angles = { 1e-6, 1e-5, 1e-3, 0.1, vtkMath::Pi() - 1e-6, vtkMath::Pi() };
  for (double angle = 0.01; angle < vtkMath::Pi(); angle += 0.01)
  {
    angles.push_back(angle);
    angles.push_back(-angle);
  }
  std::vector<Trajectory> bends;
  for (const double angle : angles)
  {
    const TrajectoryPoint end = { std::cos(angle), std::sin(angle) * 0.6, std::sin(angle) * 0.8 };
    bends.push_back({ { -3.0 * scale, 0.0, 0.0 }, { 0.0, 0.0, 0.0 },
      { scale * end[0], scale * end[1], scale * end[2] } });
  }
  const auto result = Compute(MakeTrajectories(bends));
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    const auto middle = static_cast<vtkIdType>(3 * i + 1);
    const double turning = vtkMath::DegreesFromRadians(std::abs(angles[i]));
    checks.Near("exact turning angle",
      GetValue(result, Attributes::TURNING_ANGLE, middle) / turning, 1.0, 2e-7);
    const TrajectoryPoint& end = bends[i][2];
    const double ascent =
      vtkMath::DegreesFromRadians(std::atan2(end[2], std::hypot(end[0], end[1])));
    checks.Near("exact angle of ascent",
      GetValue(result, Attributes::ANGLE_OF_ASCENT, middle) / ascent, 1.0, 2e-7);
  }
}

//------------------------------------------------------------------------------
void TestSpecialLines(Checks& checks)
{
  const auto result = Compute(MakeTrajectories({
    { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, 3 }, { 0, 0, 0 } },                // 0 to 3: up and back
    { { 7, 7, 7 } },                                                       // 4: one point
    { { 0, 0, 0 }, { 3, 0, -4 } },                                         // 5, 6
    { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } },                             // 7 to 9: one place
    {}, { { 1e300, 0, 0 }, { -1e300, 0, 0 }, { 1e300, 1e300, 1 } },        // 10 to 12
    { { 0, 0, 0 }, { 1e-200, 0, 0 }, { 1e-200, 2e-155, 0 }, { 1, 0, 0 } }, // 13 to 16
  }));
  const std::vector<std::pair<int, std::vector<double>>> expected = {
    { Attributes::SEGMENT_HEIGHT_DIFFERENCE, { 1, 2, -3, -3, 0, -4, -4, 0, 0, 0 } },
    { Attributes::TURNING_ANGLE, { 0, 0, 180, 0, 0, 0, 0, 0, 0, 0 } },
    { Attributes::CURVATURE, { 0, 0, vtkMath::Pi() / 2.5, 0, 0, 0, 0, 0, 0, 0 } },
    { Attributes::SEGMENT_LENGTH, { 1, 2, 3, 3, 0, 5, 5, 0, 0, 0 } },
    { Attributes::ANGLE_OF_ASCENT, { 90, 90, -90, -90, 0, -53.130102354, -53.130102354, 0, 0, 0 } },
  };
  for (const auto& [attribute, values] : expected)
  {
    const std::string name = Attributes::GetAttributeName(attribute);
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      checks.Near(name + " of point " + std::to_string(i),
        GetValue(result, attribute, static_cast<vtkIdType>(i)), values[i], 5e-6);
    }
    for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    {
      checks.True(name + " is finite", std::isfinite(GetValue(result, attribute, i)));
    }
  }
  checks.True("no pressure, no time: no array that needs them",
    !result->GetPointData()->HasArray("Velocity") &&
      !result->GetCellData()->HasArray("TotalPressureDifference"));
}

//------------------------------------------------------------------------------
// The definitions, one line after another, without thought of speed.
struct PlainLine
{
  Trajectory Points;
  std::vector<double> Pressure;
  std::vector<double> Time;

  int Size() const { return static_cast<int>(this->Points.size()); }

  bool IsMissing(int i) const
  {
    const TrajectoryPoint& p = this->Points[i];
    return !std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]);
  }

  TrajectoryPoint Step(int i) const
  {
    TrajectoryPoint step;
    for (int axis = 0; axis < 3; ++axis)
    {
      step[axis] = this->IsMissing(i) || this->IsMissing(i + 1)
        ? MissingValue
        : this->Points[i + 1][axis] - this->Points[i][axis];
    }
    return step;
  }

  double Length(int i) const { return vtkMath::Norm(this->Step(i).data()); }

  double OfSegment(int attribute, int point, int upAxis) const
  {
    const int i = std::min(point, this->Size() - 2);
    const TrajectoryPoint step = this->Step(i);
    switch (attribute)
    {
      case Attributes::SEGMENT_PRESSURE_DIFFERENCE:
        return this->Pressure[i] - this->Pressure[i + 1];
      case Attributes::SEGMENT_HEIGHT_DIFFERENCE:
        return std::isfinite(this->Points[i][upAxis]) && std::isfinite(this->Points[i + 1][upAxis])
          ? this->Points[i + 1][upAxis] - this->Points[i][upAxis]
          : MissingValue;
      case Attributes::SEGMENT_LENGTH:
        return this->Length(i);
      case Attributes::VELOCITY:
      {
        const double timeStep = std::abs(this->Time[i + 1] - this->Time[i]);
        const double still =
          this->Length(i) > 0.0 ? std::numeric_limits<float>::max() : this->Length(i);
        return timeStep == 0.0 ? still : this->Length(i) / timeStep;
      }
      default:
      {
        const double horizontal = std::hypot(step[(upAxis + 1) % 3], step[(upAxis + 2) % 3]);
        return vtkMath::DegreesFromRadians(std::atan2(step[upAxis], horizontal));
      }
    }
  }

  double OfPoint(int attribute, int point) const
  {
    if (this->IsMissing(point))
    {
      return MissingValue;
    }
    int before = point - 1;
    while (before >= 0 && this->Length(before) == 0.0)
    {
      --before;
    }
    int after = point;
    while (after + 1 < this->Size() && this->Length(after) == 0.0)
    {
      ++after;
    }
    if (before < 0 || after + 1 >= this->Size() || this->IsMissing(before) ||
      this->IsMissing(after + 1))
    {
      return 0.0;
    }
    const double angle =
      vtkMath::AngleBetweenVectors(this->Step(before).data(), this->Step(after).data());
    return attribute == Attributes::TURNING_ANGLE
      ? vtkMath::DegreesFromRadians(angle)
      : angle / (0.5 * (this->Length(before) + this->Length(after)));
  }

  double Range(double window) const
  {
    double range = MissingValue;
    for (int i = 0; i < this->Size(); ++i)
    {
      for (int j = 0; j < this->Size(); ++j)
      {
        if (window <= 0.0 || std::abs(this->Time[i] - this->Time[j]) <= window)
        {
          range = std::fmax(range, this->Pressure[i] - this->Pressure[j]);
        }
      }
    }
    return range;
  }
};

//------------------------------------------------------------------------------
// Lengths around those of the blocks that threads share out; times that rise, fall or do neither.
std::vector<PlainLine> MakeRandomLines()
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<PlainLine> lines;
  for (const int size : { 2, 3, 100, 511, 512, 513, 514, 1024, 1500, 5, 700 })
  {
    PlainLine line;
    line.Points = MakeRandomWalk(size, random);
    const int kind = static_cast<int>(lines.size() % 3);
    for (int i = 0; i < size; ++i)
    {
      line.Pressure.push_back(uniform(random) < 0.05 ? MissingValue : 1000.0 * uniform(random));
      const double step = std::floor(3.0 * uniform(random));
      const double last = i > 0 ? line.Time.back() : 0.0;
      line.Time.push_back(kind == 0 ? last + step : kind == 1 ? last - step : 100.0 * step);
    }
    lines.push_back(line);
  }
  // A group of coincident points over several blocks.
  Trajectory& rest = lines[8].Points;
  std::fill(rest.begin() + 300, rest.begin() + 1300, TrajectoryPoint{ 1.0, 2.0, 3.0 });
  lines[10].Pressure.assign(700, MissingValue);
  return lines;
}

//------------------------------------------------------------------------------
void TestRandomLines(Checks& checks)
{
  const std::vector<PlainLine> lines = MakeRandomLines();
  std::vector<Trajectory> points;
  std::vector<double> pressure;
  std::vector<double> time;
  for (const PlainLine& line : lines)
  {
    points.push_back(line.Points);
    pressure.insert(pressure.end(), line.Pressure.begin(), line.Pressure.end());
    time.insert(time.end(), line.Time.begin(), line.Time.end());
  }
  const auto data = MakeTrajectories(points);
  AddPointArray(data, "P", pressure);
  AddPointArray(data, "Time", time);
  for (const int up : { 0, 1, 2 })
  {
    const auto result = Compute(data, up);
    for (int attribute = Attributes::SEGMENT_PRESSURE_DIFFERENCE;
         attribute < Attributes::NUMBER_OF_ATTRIBUTES; ++attribute)
    {
      const bool isTurning =
        attribute == Attributes::TURNING_ANGLE || attribute == Attributes::CURVATURE;
      vtkIdType id = 0;
      int wrong = 0;
      for (const PlainLine& line : lines)
      {
        for (int i = 0; i < line.Size(); ++i, ++id)
        {
          const double expected =
            isTurning ? line.OfPoint(attribute, i) : line.OfSegment(attribute, i, up);
          const double found = GetValue(result, attribute, id);
          wrong += std::isnan(expected)
            ? !std::isnan(found)
            : !(std::abs(found - expected) <= 3e-7 * std::abs(expected));
        }
      }
      checks.Near(
        std::string("wrong values of ") + Attributes::GetAttributeName(attribute), wrong, 0, 0);
    }
  }

  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(data);
  for (const double window : { 0.0, 0.5, 1.0, 7.0, 100.0, 1e6 })
  {
    filter->SetTimeWindow(window);
    filter->Update();
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
      const double found = GetValue(
        filter->GetOutput(), Attributes::TOTAL_PRESSURE_DIFFERENCE, static_cast<vtkIdType>(i));
      const double expected = lines[i].Range(window);
      checks.True(
        "pressure difference in " + std::to_string(window) + " of line " + std::to_string(i),
        std::isnan(expected) ? std::isnan(found) : std::abs(found - expected) < 1e-4);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestTrajectoryAttributes(int, char*[])
{
  Checks checks;
  TestCircleAndHelix(checks);
  for (const double scale : { 1.0, 1e-150, 1e-90, 1e-60, 1e70 })
  {
    TestExactAngles(checks, scale);
  }
  TestSpecialLines(checks);
  TestRandomLines(checks);
  return checks.Result();
}
