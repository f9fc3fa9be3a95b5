// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Nodes outside the view are not drawn, small segments are sprites, others quads, and each node has
// one shape.
#include "vtkNodeGroups.h"

#include "ReferenceTesting.h"
#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTrajectoryNodes.h"

#include <cmath>
#include <map>

namespace
{
using Shape = vtkNodeGroups::Shape;

constexpr vtkIdType PointsPerLine = 3000;

// A line of 3 units, and 300 times as long another one a long way aside.
vtkTrajectoryNodes MakeNodes(double radius)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const double scale : { 0.001, 0.3 })
  {
    lines->InsertNextCell(PointsPerLine);
    for (vtkIdType i = 0; i < PointsPerLine; ++i)
    {
      const double x = scale * (static_cast<double>(i) - 0.5 * PointsPerLine);
      lines->InsertCellPoint(points->InsertNextPoint(x, scale > 0.1 ? 100.0 : 0.0, 0.0));
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  vtkTrajectoryNodes nodes;
  vtkTrajectoryNodes::Leaf leaf;
  leaf.Data = data;
  nodes.Build({ leaf }, radius, "");
  return nodes;
}

// Along -z, 90 degrees wide, of 200 x 200 pixels; the eye at (x, y, z).
struct Eye
{
  Eye(const vtkTrajectoryNodes& nodes, double x, double y, double z, double scale)
  {
    const std::array<double, 3> eye{ { x, y, z } };
    for (int i = 0; i < 3; ++i)
    {
      this->Matrix->SetElement(i, i, scale);
      this->Matrix->SetElement(3, i, scale * nodes.GetCenter()[i] - eye[i]);
    }
    const double half = std::sqrt(0.5);
    this->View.NodeToView = this->Matrix;
    this->View.Frustum = { { { { half, 0.0, -half, 0.0 } }, { { -half, 0.0, -half, 0.0 } },
      { { 0.0, half, -half, 0.0 } }, { { 0.0, -half, -half, 0.0 } }, { { 0.0, 0.0, -1.0, -0.01 } },
      { { 0.0, 0.0, 1.0, 1e4 } } } };
    this->View.PixelsPerUnit = 100.0;
    this->View.LargestSlope = std::sqrt(2.0);
  }

  vtkNew<vtkMatrix4x4> Matrix;
  vtkNodeGroups::View View;
};

// Number of nodes of each shape in [first, last); -1 where one is drawn twice or out of order.
std::map<Shape, vtkIdType> Count(const vtkNodeGroups& groups, vtkIdType first, vtkIdType last)
{
  std::map<Shape, vtkIdType> counts;
  for (const Shape shape : { Shape::None, Shape::Sprite, Shape::Quad })
  {
    vtkIdType end = first;
    groups.ForEach(shape, first, last,
      [&](vtkIdType begin, vtkIdType stop)
      {
        const bool isInOrder = end <= begin && begin < stop && stop <= last;
        counts[shape] = isInOrder && counts[shape] >= 0 ? counts[shape] + stop - begin : -1;
        end = stop;
      });
  }
  return counts;
}

void TestShapes(Checks& checks)
{
  const vtkTrajectoryNodes nodes = MakeNodes(0.01);
  vtkNodeGroups groups;
  groups.Build(nodes);
  const vtkIdType all = nodes.GetNumberOfNodes();
  const auto count = [&](const Eye& eye)
  {
    groups.Update(eye.View);
    return Count(groups, 0, all);
  };

  std::map<Shape, vtkIdType> shapes = count(Eye(nodes, 0.0, 0.0, 2.0, 1.0));
  // A group may reach from one line to the other.
  checks.True(
    "a small line before the eye is not of sprites", shapes[Shape::Sprite] >= PointsPerLine / 2);
  checks.True("a line aside of the view is drawn", shapes[Shape::None] > 0);
  checks.True("small segments are quads", shapes[Shape::Quad] <= PointsPerLine / 2);

  shapes = count(Eye(nodes, 0.0, 0.0, 0.05, 1.0));
  checks.True("a line near the eye is of sprites", shapes[Shape::Sprite] == 0);
  checks.True("a line near the eye is not of quads", shapes[Shape::Quad] > 0);

  shapes = count(Eye(nodes, 0.0, 100.0, 2.0, 1.0));
  checks.True("long segments are sprites", shapes[Shape::Quad] > 0 && shapes[Shape::Sprite] == 0);

  shapes = count(Eye(nodes, 0.0, 0.0, -2.0, 1.0));
  checks.True("what lies behind the eye is drawn", shapes[Shape::None] == all);

  shapes = count(Eye(nodes, 0.0, 0.0, 2.0, 100.0));
  checks.True("the scale of the matrix does not count", shapes[Shape::Sprite] == 0);

  Eye eye(nodes, 0.0, 0.0, 2.0, 1.0);
  eye.View.HasSprites = false;
  checks.True("sprites where there are none", count(eye)[Shape::Sprite] == 0);
  checks.True("quads are not found", groups.Has(Shape::Quad) && !groups.Has(Shape::Sprite));

  eye.View.HasSprites = true;
  eye.View.HasOneShape = true;
  checks.True("nodes have more than one shape", count(eye)[Shape::Quad] == all);
  eye.View.HasOneShape = false;
  eye.View.Parallel = true;
  eye.View.PixelsPerUnit = 400.0;
  checks.True("parallel, 8 pixels wide, no sprites", count(eye)[Shape::Sprite] > 0);
  eye.View.PixelsPerUnit = 800.0;
  checks.True("parallel, 16 pixels wide and short, no sprites", count(eye)[Shape::Sprite] > 0);
  eye.View.PixelsPerUnit = 1700.0;
  checks.True("parallel, 35 pixels wide, sprites", count(eye)[Shape::Sprite] == 0);
}

void TestRanges(Checks& checks)
{
  const vtkTrajectoryNodes nodes = MakeNodes(0.01);
  vtkNodeGroups groups;
  groups.Build(nodes);
  groups.Update(Eye(nodes, 0.0, 0.0, 2.0, 1.0).View);
  for (const auto& [first, last] : std::map<vtkIdType, vtkIdType>{
         { 0, 0 }, { 5, 6 }, { 1000, 1025 }, { 1023, 5000 }, { 0, nodes.GetNumberOfNodes() } })
  {
    vtkIdType sum = 0;
    for (const auto& [shape, count] : Count(groups, first, last))
    {
      checks.True("nodes are drawn twice, or out of order", count >= 0);
      sum += count;
    }
    checks.True("nodes from " + std::to_string(first) + " to " + std::to_string(last) + ": " +
        std::to_string(sum) + " have a shape",
      sum == last - first);
  }
}
}

//------------------------------------------------------------------------------
int TestNodeGroups(int, char*[])
{
  Checks checks;
  TestShapes(checks);
  TestRanges(checks);
  return checks.Result();
}
