// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Geodesic distances by the heat method against closed forms: great circles on a sphere, straight
 * lines in a plane with borders, helices on a cylinder; obtuse triangles, triangles turned round,
 * several sources, and what cannot be factored.
 */

#include "ReferenceTesting.h"
#include "SurfaceMeshes.h"

#include "vtkHeatGeodesics.h"
#include "vtkTriangleSurface.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace
{
using Measure = std::function<double(const vtkVector3d&, const vtkVector3d&)>;

double MeasureStraight(const vtkVector3d& a, const vtkVector3d& b)
{
  return (b - a).Norm();
}

double MeasureOnCylinder(const vtkVector3d& a, const vtkVector3d& b)
{
  const double angle = MeasureAngle({ a[0], a[1], 0.0 }, { b[0], b[1], 0.0 });
  return std::hypot(angle, b[2] - a[2]);
}

/** Mean and greatest error of the distances from the mesh's point `source`, as parts of the
 * greatest distance, are at most these. */
void ExpectErrors(Checks& checks, const std::string& what, const Mesh& mesh, vtkIdType source,
  const Measure& exact, double mostMean, double mostGreatest)
{
  const vtkTriangleSurface surface(MakePoints(mesh), mesh.Corners);
  const vtkHeatGeodesics geodesics(surface);
  checks.True(what + ": is factored", geodesics.IsFactored());
  const auto potential = geodesics.Solve({ source });
  double sum = 0.0;
  double greatest = 0.0;
  double extent = 0.0;
  const vtkIdType count = surface.GetNumberOfVertices();
  for (vtkIdType vertex = 0; vertex < count; ++vertex)
  {
    const double distance = exact(mesh.Points[source], mesh.Points[vertex]);
    const double found = (potential[vertex] - potential[source]) * surface.GetUnit();
    sum += std::abs(found - distance);
    greatest = std::max(greatest, std::abs(found - distance));
    extent = std::max(extent, distance);
  }
  checks.Near(what + ": mean error", sum / static_cast<double>(count) / extent, 0.0, mostMean);
  checks.Near(what + ": greatest error", greatest / extent, 0.0, mostGreatest);
}

void TestSources(Checks& checks)
{
  // Two points of a plane: each vertex has the distance from the nearer one.
  const Mesh mesh = MakePlane(61, 61);
  const vtkTriangleSurface surface(MakePoints(mesh), mesh.Corners);
  const vtkIdType left = 30 * 61 + 15;
  const vtkIdType right = 30 * 61 + 45;
  const auto potential = vtkHeatGeodesics(surface).Solve({ left, right });
  for (const vtkIdType offset : { 0, 5, 10, 5 * 61, -10 * 61 })
  {
    const double distance = (mesh.Points[left + offset] - mesh.Points[left]).Norm();
    checks.Near("two sources, left",
      (potential[left + offset] - potential[left]) * surface.GetUnit(), distance, 0.01);
    checks.Near("two sources, right",
      (potential[right - offset] - potential[right]) * surface.GetUnit(), distance, 0.01);
  }
}
}

int TestHeatGeodesics(int, char*[])
{
  Checks checks;
  ExpectErrors(checks, "sphere of 8192 triangles", MakeSphere(5), 0, MeasureAngle, 0.005, 0.011);
  ExpectErrors(checks, "sphere of 512 triangles", MakeSphere(3), 0, MeasureAngle, 0.017, 0.035);
  const Mesh plane = MakePlane(101, 101);
  ExpectErrors(checks, "plane, from its centre", plane, 5100, MeasureStraight, 0.007, 0.021);
  ExpectErrors(checks, "plane, from a corner", plane, 0, MeasureStraight, 0.011, 0.025);
  ExpectErrors(
    checks, "cylinder", MakeCylinder(128, 64), 128 * 32, MeasureOnCylinder, 0.008, 0.031);

  // Where angles are obtuse, the edges' own Laplacian is off by a third of the extent.
  ExpectErrors(checks, "oblong", MakePlane(201, 26), 2713, MeasureStraight, 0.012, 0.045);
  ExpectErrors(checks, "sheared", MakePlane(101, 101, 3.0), 5100, MeasureStraight, 0.007, 0.012);
  Mesh noisy = MakePlane(101, 101, 0.0, 0.45);
  ExpectErrors(checks, "noisy", noisy, 5100, MeasureStraight, 0.005, 0.015);
  for (std::size_t i = 0; i < noisy.Corners.size(); i += 9)
  {
    std::swap(noisy.Corners[i], noisy.Corners[i + 1]);
  }
  ExpectErrors(checks, "noisy, some turned", noisy, 5100, MeasureStraight, 0.005, 0.015);

  TestSources(checks);

  const Mesh infinite{
    { { 0, 0, 0 }, { 1, 0, 0 }, { 0, std::numeric_limits<double>::infinity(), 0 } }, { 0, 1, 2 }
  };
  const vtkTriangleSurface surface(MakePoints(infinite), infinite.Corners);
  checks.True("infinite triangle is not factored", !vtkHeatGeodesics(surface).IsFactored());
  return checks.Result();
}
