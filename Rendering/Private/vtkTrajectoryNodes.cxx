// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryNodes.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Point = std::array<double, 3>;

// Displacement of a point, in radii, that cannot be seen on a tube 500 pixels wide.
constexpr double VisibleError = 0.001;

Point GetPoint(vtkPolyData* data, vtkIdType id)
{
  Point point;
  data->GetPoint(id, point.data());
  return point;
}

bool IsFinite(const Point& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

double Distance(const Point& a, const Point& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.data(), b.data()));
}

// Calls visit(count, point ids, cell id) for each vertex and each line. A cell of several vertices
// gives one call for each of them.
template <typename Visitor>
void ForEachTrajectory(vtkPolyData* data, Visitor&& visit)
{
  vtkIdType cell = 0;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  const auto vertices = vtk::TakeSmartPointer(data->GetVerts()->NewIterator());
  for (vertices->GoToFirstCell(); !vertices->IsDoneWithTraversal(); vertices->GoToNextCell())
  {
    vertices->GetCurrentCell(count, points);
    for (vtkIdType i = 0; i < count; ++i)
    {
      visit(1, points + i, cell);
    }
    ++cell;
  }
  const auto lines = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    lines->GetCurrentCell(count, points);
    visit(count, points, cell++);
  }
}
}

//------------------------------------------------------------------------------
/** What the automatic radius follows from. */
class vtkTrajectoryNodes::Extent
{
public:
  void Add(vtkPolyData* data, vtkIdType count, const vtkIdType* points)
  {
    Point previous{};
    bool joined = false;
    double length = 0.0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      Point point = GetPoint(data, points[i]);
      const bool finite = IsFinite(point);
      if (finite)
      {
        this->Bounds.AddPoint(point.data());
        length += joined ? Distance(previous, point) : 0.0;
        previous = point;
      }
      joined = finite;
    }
    this->Length += length;
    this->Lines += length > 0.0 ? 1 : 0;
    this->Balls += length > 0.0 ? 0 : 1;
  }

  double GetRadius() const
  {
    const double diagonal = this->Bounds.IsValid() ? this->Bounds.GetDiagonalLength() : 0.0;
    if (diagonal <= 0.0)
    {
      return 1.0;
    }
    // Fractions of the diagonal: few lines shall be seen as tubes, many must not fill the view,
    // none may fall far below a pixel.
    constexpr double thinnest = 0.0004;
    constexpr double thickest = 0.005;
    if (this->Lines == 0)
    {
      const double spacing = std::cbrt(1.0 / static_cast<double>(this->Balls));
      return diagonal * std::clamp(0.1 * spacing, thinnest, 4.0 * thickest);
    }
    const double density = this->Length / diagonal;
    const double radius = diagonal * std::clamp(0.008 / std::cbrt(density), thinnest, thickest);
    const double meanLength = this->Length / static_cast<double>(this->Lines);
    return std::max(std::min(radius, 0.05 * meanLength), thinnest * diagonal);
  }

  vtkBoundingBox Bounds;

private:
  double Length = 0.0;
  vtkIdType Lines = 0;
  vtkIdType Balls = 0;
};

//------------------------------------------------------------------------------
void vtkTrajectoryNodes::Build(
  std::vector<Leaf> leaves, double radius, const std::string& radiusArray)
{
  *this = vtkTrajectoryNodes();
  this->Leaves = std::move(leaves);

  Extent extent;
  for (const Leaf& leaf : this->Leaves)
  {
    ForEachTrajectory(leaf.Data,
      [&](vtkIdType count, const vtkIdType* points, vtkIdType)
      { extent.Add(leaf.Data, count, points); });
  }
  this->Radius = radius > 0.0 ? radius : extent.GetRadius();
  if (extent.Bounds.IsValid())
  {
    extent.Bounds.GetCenter(this->Center.data());
  }

  this->Bounds.resize(this->Leaves.size());
  for (std::size_t i = 0; i < this->Leaves.size(); ++i)
  {
    this->FirstNodes.push_back(this->GetNumberOfNodes());
    const Leaf& leaf = this->Leaves[i];
    vtkDataArray* radii =
      radiusArray.empty() ? nullptr : leaf.Data->GetPointData()->GetArray(radiusArray.c_str());
    if (radii && radii->GetNumberOfComponents() != 1)
    {
      radii = nullptr;
      ++this->NumberOfBadRadiusArrays;
    }
    ForEachTrajectory(leaf.Data,
      [&](vtkIdType count, const vtkIdType* points, vtkIdType cell)
      {
        const vtkIdType first = this->GetNumberOfNodes();
        this->AddCell(i, radii, count, points);
        if (this->GetNumberOfNodes() > first)
        {
          this->Runs.push_back({ first, cell, i });
        }
      });
  }
  this->FirstNodes.push_back(this->GetNumberOfNodes());
  const double rounding = 0.5 * std::numeric_limits<float>::epsilon() *
    (this->PointBounds.IsValid() ? 0.5 * this->PointBounds.GetMaxLength() : 0.0);
  if (rounding > VisibleError * this->MinimumRadius)
  {
    this->ComputeRemainders();
  }
}

//------------------------------------------------------------------------------
// Apart from the rounding of the points itself: side by side, GCC 12 with -O3 makes them 0.
void vtkTrajectoryNodes::ComputeRemainders()
{
  this->Remainders.resize(this->Nodes.size());
  for (std::size_t run = 0; run < this->Runs.size(); ++run)
  {
    vtkPolyData* data = this->Leaves[this->Runs[run].Leaf].Data;
    const vtkIdType end =
      run + 1 < this->Runs.size() ? this->Runs[run + 1].FirstNode : this->GetNumberOfNodes();
    for (vtkIdType node = this->Runs[run].FirstNode; node < end; ++node)
    {
      const Point point = GetPoint(data, this->PointIds[node]);
      for (int c = 0; c < 3; ++c)
      {
        const double exact = point[c] - this->Center[c];
        this->Remainders[node][c] = static_cast<float>(exact - this->Nodes[node][c]);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryNodes::AddCell(
  std::size_t leaf, vtkDataArray* radii, vtkIdType count, const vtkIdType* points)
{
  Point previous{};
  bool joined = false;
  for (vtkIdType i = 0; i < count; ++i)
  {
    Point point = GetPoint(this->Leaves[leaf].Data, points[i]);
    const double radius = std::max(radii ? radii->GetComponent(points[i], 0) : this->Radius, 0.0);
    if (!IsFinite(point) || !std::isfinite(radius))
    {
      ++this->NumberOfInvalidPoints;
      joined = false;
      continue;
    }
    if (joined && point == previous)
    {
      continue;
    }
    if (joined)
    {
      // The sign must survive a radius of 0.
      float& before = this->Nodes.back()[3];
      before = -std::max(before, std::numeric_limits<float>::min());
    }
    this->Nodes.push_back({ { static_cast<float>(point[0] - this->Center[0]),
      static_cast<float>(point[1] - this->Center[1]),
      static_cast<float>(point[2] - this->Center[2]), static_cast<float>(radius) } });
    this->PointIds.push_back(points[i]);
    this->Bounds[leaf].AddBox(vtkBoundingBox(point[0] - radius, point[0] + radius,
      point[1] - radius, point[1] + radius, point[2] - radius, point[2] + radius));
    this->PointBounds.AddPoint(point.data());
    this->MinimumRadius =
      radius > 0.0 ? std::min(this->MinimumRadius, radius) : this->MinimumRadius;
    this->MaximumRadius = std::max(this->MaximumRadius, radius);
    previous = point;
    joined = true;
  }
}

//------------------------------------------------------------------------------
const vtkTrajectoryNodes::Run& vtkTrajectoryNodes::GetRun(vtkIdType node) const
{
  const auto next = std::upper_bound(this->Runs.begin(), this->Runs.end(), node,
    [](vtkIdType value, const Run& run) { return value < run.FirstNode; });
  return *(next - 1);
}

VTK_ABI_NAMESPACE_END
