// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTriangleSurface.h"

#include "vtkPoints.h"

#include <algorithm>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
vtkVector3d GetPoint(vtkPoints* points, vtkIdType id)
{
  vtkVector3d point;
  points->GetPoint(id, point.GetData());
  return point;
}

//------------------------------------------------------------------------------
bool IsBefore(const vtkVector3d& a, const vtkVector3d& b)
{
  return std::lexicographical_compare(a.GetData(), a.GetData() + 3, b.GetData(), b.GetData() + 3);
}

//------------------------------------------------------------------------------
// Disjoint sets of vertices; the least vertex of a set stands for it.
class DisjointSets
{
public:
  explicit DisjointSets(vtkIdType count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  vtkIdType Find(vtkIdType vertex)
  {
    while (this->Parents[vertex] != vertex)
    {
      this->Parents[vertex] = this->Parents[this->Parents[vertex]];
      vertex = this->Parents[vertex];
    }
    return vertex;
  }

  void Unite(vtkIdType a, vtkIdType b)
  {
    const auto roots = std::minmax({ this->Find(a), this->Find(b) });
    this->Parents[roots.second] = roots.first;
  }

private:
  std::vector<vtkIdType> Parents;
};
}

//------------------------------------------------------------------------------
vtkTriangleSurface::vtkTriangleSurface(vtkPoints* points, const std::vector<vtkIdType>& corners)
  : Triangles(corners.size() / 3)
{
  this->MergePoints(points, corners);
  this->Normalize();
  this->FindComponents();
  this->ComputeAreasAndNormals();
}

//------------------------------------------------------------------------------
void vtkTriangleSurface::MergePoints(vtkPoints* points, const std::vector<vtkIdType>& corners)
{
  std::vector<vtkIdType> used(corners);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());

  // Equal points become neighbours, the one of lowest id first.
  std::vector<vtkIdType> byPlace(used);
  std::stable_sort(byPlace.begin(), byPlace.end(),
    [points](vtkIdType a, vtkIdType b)
    { return IsBefore(GetPoint(points, a), GetPoint(points, b)); });
  std::vector<vtkIdType> first(points->GetNumberOfPoints(), -1);
  for (std::size_t i = 0; i < byPlace.size(); ++i)
  {
    const bool same =
      i > 0 && !IsBefore(GetPoint(points, byPlace[i - 1]), GetPoint(points, byPlace[i]));
    first[byPlace[i]] = same ? first[byPlace[i - 1]] : byPlace[i];
  }

  std::vector<vtkIdType> vertexOfPoint(points->GetNumberOfPoints(), -1);
  for (const vtkIdType point : used)
  {
    if (first[point] == point)
    {
      vertexOfPoint[point] = this->GetNumberOfVertices();
      this->Positions.push_back(GetPoint(points, point));
    }
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    this->Triangles[i / 3][i % 3] = vertexOfPoint[first[corners[i]]];
  }
}

//------------------------------------------------------------------------------
void vtkTriangleSurface::Normalize()
{
  // Halves, because a difference of the greatest numbers would overflow.
  vtkVector3d low(VTK_DOUBLE_MAX);
  vtkVector3d high(-VTK_DOUBLE_MAX);
  for (const auto& position : this->Positions)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], 0.5 * position[axis]);
      high[axis] = std::max(high[axis], 0.5 * position[axis]);
    }
  }
  const vtkVector3d halfSize = high - low;
  const double unit = *std::max_element(halfSize.GetData(), halfSize.GetData() + 3);
  this->Unit = unit > 0.0 ? unit : 1.0;
  for (auto& position : this->Positions)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = (position[axis] - (low[axis] + high[axis])) / this->Unit;
    }
  }
}

//------------------------------------------------------------------------------
void vtkTriangleSurface::FindComponents()
{
  DisjointSets sets(this->GetNumberOfVertices());
  for (const auto& triangle : this->Triangles)
  {
    sets.Unite(triangle[0], triangle[1]);
    sets.Unite(triangle[0], triangle[2]);
  }
  std::vector<std::size_t> componentOfRoot(this->GetNumberOfVertices());
  for (vtkIdType vertex = 0; vertex < this->GetNumberOfVertices(); ++vertex)
  {
    const vtkIdType root = sets.Find(vertex);
    if (root == vertex)
    {
      componentOfRoot[root] = this->Components.size();
      this->Components.emplace_back();
    }
    this->Components[componentOfRoot[root]].push_back(vertex);
  }
}

//------------------------------------------------------------------------------
void vtkTriangleSurface::ComputeAreasAndNormals()
{
  this->VertexAreas.assign(this->GetNumberOfVertices(), 0.0);
  this->Normals.assign(this->GetNumberOfVertices(), vtkVector3d(0.0));
  for (const auto& triangle : this->Triangles)
  {
    const auto& origin = this->Positions[triangle[0]];
    const vtkVector3d normal =
      (this->Positions[triangle[1]] - origin).Cross(this->Positions[triangle[2]] - origin);
    for (const vtkIdType vertex : triangle)
    {
      this->VertexAreas[vertex] += normal.Norm() / 6.0;
      this->Normals[vertex] = this->Normals[vertex] + normal;
    }
  }
  for (vtkVector3d& normal : this->Normals)
  {
    normal.Normalize();
  }
}

//------------------------------------------------------------------------------
double vtkTriangleSurface::GetArea() const
{
  return std::accumulate(this->VertexAreas.begin(), this->VertexAreas.end(), 0.0);
}

VTK_ABI_NAMESPACE_END
