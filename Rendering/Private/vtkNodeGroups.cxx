// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNodeGroups.h"

#include "vtkMath.h"
#include "vtkTrajectoryNodes.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Point = std::array<double, 3>;

Point GetPoint(const vtkTrajectoryNodes& nodes, vtkIdType i)
{
  const vtkTrajectoryNodes::Node& node = nodes.GetNodes()[i];
  Point point{ { node[0], node[1], node[2] } };
  if (!nodes.GetRemainders().empty())
  {
    const vtkTrajectoryNodes::Node& remainder = nodes.GetRemainders()[i];
    for (int c = 0; c < 3; ++c)
    {
      point[c] += remainder[c];
    }
  }
  return point;
}

// A bound of the length that unit vectors get; exact where a matrix turns and scales evenly.
double GetLargestStretch(const vtkMatrix4x4* transposed)
{
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    double sum = 0.0;
    for (int j = 0; j < 3; ++j)
    {
      double product = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        product += transposed->GetElement(i, k) * transposed->GetElement(j, k);
      }
      sum += std::abs(product);
    }
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest);
}

Point ToView(const double point[3], const vtkMatrix4x4* transposed)
{
  Point view;
  for (int i = 0; i < 3; ++i)
  {
    view[i] = transposed->GetElement(3, i);
    for (int j = 0; j < 3; ++j)
    {
      view[i] += point[j] * transposed->GetElement(j, i);
    }
  }
  return view;
}
}

//------------------------------------------------------------------------------
void vtkNodeGroups::Build(const vtkTrajectoryNodes& nodes)
{
  const std::vector<vtkTrajectoryNodes::Node>& all = nodes.GetNodes();
  const auto count = static_cast<vtkIdType>(all.size());
  this->Groups.assign((count + GroupSize - 1) / GroupSize, Group());
  this->Shapes.assign(this->Groups.size(), Shape::Quad);
  for (vtkIdType i = 0; i < count; ++i)
  {
    Group& group = this->Groups[i / GroupSize];
    Point point = GetPoint(nodes, i);
    double radius = std::abs(all[i][3]);
    group.Points.AddPoint(point.data());
    if (all[i][3] < 0.0f && i + 1 < count)
    {
      Point next = GetPoint(nodes, i + 1);
      group.Points.AddPoint(next.data());
      const double length = std::sqrt(vtkMath::Distance2BetweenPoints(point.data(), next.data()));
      radius = std::max<double>(radius, std::abs(all[i + 1][3]));
      group.LongestSegment = std::max(group.LongestSegment, length);
      group.LargestAspect = std::max(group.LargestAspect, length / radius);
    }
    group.LargestRadius = std::max(group.LargestRadius, radius);
  }
}

//------------------------------------------------------------------------------
void vtkNodeGroups::Update(const View& view)
{
  const double stretch = GetLargestStretch(view.NodeToView);
  std::transform(this->Groups.begin(), this->Groups.end(), this->Shapes.begin(),
    [&](const Group& group) { return ChooseShape(group, view, stretch); });
  if (view.HasOneShape)
  {
    const bool areSprites = std::all_of(
      this->Shapes.begin(), this->Shapes.end(), [](Shape shape) { return shape == Shape::Sprite; });
    this->Shapes.assign(this->Shapes.size(), areSprites ? Shape::Sprite : Shape::Quad);
  }
}

//------------------------------------------------------------------------------
vtkNodeGroups::Shape vtkNodeGroups::ChooseShape(
  const Group& group, const View& view, double stretch)
{
  vtkBoundingBox box;
  std::array<double, 6> heights;
  heights.fill(VTK_DOUBLE_MIN);
  double farthest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double node[3];
    group.Points.GetCorner(corner, node);
    Point point = ToView(node, view.NodeToView);
    box.AddPoint(point.data());
    farthest = std::max(farthest, vtkMath::Norm(point.data()));
    for (int i = 0; i < 6; ++i)
    {
      const Plane& plane = view.Frustum[i];
      heights[i] = std::max(heights[i], vtkMath::Dot(plane.data(), point.data()) + plane[3]);
    }
  }
  // The single precision of the shader may move what touches the view.
  const double reach = 1.001 * group.LargestRadius + 1e-5 * farthest;
  if (*std::min_element(heights.begin(), heights.end()) < -reach)
  {
    return Shape::None;
  }
  const double half = 0.5 * stretch * group.LongestSegment + group.LargestRadius;
  const double nearest = -box.GetMaxPoint()[2] - reach;
  const double width = view.Parallel
    ? 2.0 * half * view.PixelsPerUnit
    : 2.0 * half * view.PixelsPerUnit * (1.0 + view.LargestSlope) / (nearest - half);
  const double largest = stretch * group.LargestAspect <= 1.0 ? LargestSprite : LargestLongSprite;
  const bool small = width <= largest && (view.Parallel || nearest > 2.0 * half);
  return small && view.HasSprites ? Shape::Sprite : Shape::Quad;
}

//------------------------------------------------------------------------------
bool vtkNodeGroups::Has(Shape shape) const
{
  return std::find(this->Shapes.begin(), this->Shapes.end(), shape) != this->Shapes.end();
}

VTK_ABI_NAMESPACE_END
