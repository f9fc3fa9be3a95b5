// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    SurfaceMeshes.h
 * @brief   Triangle meshes of known shapes.
 */

#ifndef SurfaceMeshes_h
#define SurfaceMeshes_h

#include "vtkCellArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVector.h"
#include "vtkVectorOperators.h"

#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

/** Three corners for each triangle. */
struct Mesh
{
  std::vector<vtkVector3d> Points;
  std::vector<vtkIdType> Corners;
};

/** Between two directions, in radian: on the unit sphere, the length of the great circle. */
inline double MeasureAngle(const vtkVector3d& a, const vtkVector3d& b)
{
  return std::atan2(a.Cross(b).Norm(), a.Dot(b));
}

inline vtkSmartPointer<vtkPoints> MakePoints(const Mesh& mesh)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const auto& point : mesh.Points)
  {
    points->InsertNextPoint(point.GetData());
  }
  return points;
}

inline vtkSmartPointer<vtkPolyData> MakePolyData(const Mesh& mesh)
{
  vtkNew<vtkCellArray> polys;
  for (std::size_t i = 0; i < mesh.Corners.size(); i += 3)
  {
    polys->InsertNextCell(3, mesh.Corners.data() + i);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(MakePoints(mesh));
  data->SetPolys(polys);
  return data;
}

/** The second mesh beside the first. */
inline Mesh Join(Mesh first, const Mesh& second)
{
  const auto offset = static_cast<vtkIdType>(first.Points.size());
  first.Points.insert(first.Points.end(), second.Points.begin(), second.Points.end());
  for (const vtkIdType corner : second.Corners)
  {
    first.Corners.push_back(corner + offset);
  }
  return first;
}

inline Mesh Transform(Mesh mesh, double factor, const vtkVector3d& shift)
{
  for (auto& point : mesh.Points)
  {
    point = factor * point + shift;
  }
  return mesh;
}

/** Columns x rows cells of two triangles each, on a lattice of points. */
inline void AddCells(Mesh& mesh, int columns, int rows, int stride, bool closed)
{
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const int next = closed ? (column + 1) % stride : column + 1;
      const vtkIdType a = row * stride + column;
      const vtkIdType b = row * stride + next;
      mesh.Corners.insert(mesh.Corners.end(), { a, b, b + stride, a, b + stride, a + stride });
    }
  }
}

/** The unit square, or with a shear a parallelogram; inner points moved at random by up to `noise`
 * of a cell. */
inline Mesh MakePlane(int width, int height, double shear = 0.0, double noise = 0.0)
{
  Mesh mesh;
  std::mt19937 random(1);
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const double part = noise *
        (row > 0 && row < height - 1 && column > 0 && column < width - 1 ? 1.0 : 0.0) /
        static_cast<double>(std::mt19937::max());
      const double x = column + part * (2.0 * static_cast<double>(random()) - std::mt19937::max());
      const double y = row + part * (2.0 * static_cast<double>(random()) - std::mt19937::max());
      mesh.Points.emplace_back(x / (width - 1) + shear * y / (height - 1), y / (height - 1), 0.0);
    }
  }
  AddCells(mesh, width - 1, height - 1, width, false);
  return mesh;
}

/** Radius 1, from z = 0 to 2 pi, open at the ends. */
inline Mesh MakeCylinder(int around, int rows)
{
  Mesh mesh;
  for (int row = 0; row <= rows; ++row)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / around;
      mesh.Points.emplace_back(std::cos(angle), std::sin(angle), 2.0 * vtkMath::Pi() * row / rows);
    }
  }
  AddCells(mesh, around, rows, around, true);
  return mesh;
}

/** The unit sphere: an octahedron, its triangles divided into four again and again. */
inline Mesh MakeSphere(int divisions)
{
  Mesh mesh;
  mesh.Points = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
  mesh.Corners = { 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5 };
  for (int division = 0; division < divisions; ++division)
  {
    std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> middles;
    const auto divide = [&](vtkIdType a, vtkIdType b)
    {
      const auto found =
        middles.emplace(std::minmax(a, b), static_cast<vtkIdType>(mesh.Points.size()));
      if (found.second)
      {
        mesh.Points.push_back((mesh.Points[a] + mesh.Points[b]).Normalized());
      }
      return found.first->second;
    };
    std::vector<vtkIdType> corners;
    for (std::size_t i = 0; i < mesh.Corners.size(); i += 3)
    {
      const vtkIdType a = mesh.Corners[i];
      const vtkIdType b = mesh.Corners[i + 1];
      const vtkIdType c = mesh.Corners[i + 2];
      const vtkIdType ab = divide(a, b);
      const vtkIdType bc = divide(b, c);
      const vtkIdType ca = divide(c, a);
      corners.insert(corners.end(), { a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca });
    }
    mesh.Corners = corners;
  }
  return mesh;
}

#endif
