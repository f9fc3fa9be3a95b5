// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkHeatGeodesics.h"

#include "vtkIntrinsicTriangulation.h"
#include "vtkSMPTools.h"
#include "vtkTriangleSurface.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkHeatGeodesics::vtkHeatGeodesics(const vtkTriangleSurface& surface)
{
  const vtkIntrinsicTriangulation triangulation(surface);
  for (const auto& triangle : triangulation.GetTriangles())
  {
    Element element;
    element.Vertices = triangle.Vertices;
    element.Area = vtkIntrinsicTriangulation::ComputeArea(triangle.Lengths);
    element.Time = triangle.MeanLength * triangle.MeanLength;
    // Corner 0 in the origin, corner 1 on the axis.
    const double base = triangle.Lengths[2];
    const auto [x, y] =
      vtkIntrinsicTriangulation::LayOut(base, triangle.Lengths[1], triangle.Lengths[0]);
    element.Gradients << -y, y, 0.0, x - base, -x, base;
    element.Gradients /= 2.0 * element.Area;
    this->Elements.push_back(element);
  }
  this->Factor(surface);
}

//------------------------------------------------------------------------------
void vtkHeatGeodesics::Factor(const vtkTriangleSurface& surface)
{
  const vtkIdType count = surface.GetNumberOfVertices();
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(count);
  Eigen::VectorXd stiffness = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double, Eigen::Index>> flow;
  std::vector<Eigen::Triplet<double, Eigen::Index>> laplacian;
  for (const Element& element : this->Elements)
  {
    const Eigen::Matrix3d local = element.Area * element.Gradients.transpose() * element.Gradients;
    for (int i = 0; i < 3; ++i)
    {
      masses[element.Vertices[i]] += element.Area / 3.0;
      stiffness[element.Vertices[i]] += local(i, i);
      for (int j = 0; j < 3; ++j)
      {
        if (element.Vertices[i] >= element.Vertices[j])
        {
          laplacian.emplace_back(element.Vertices[i], element.Vertices[j], local(i, j));
          flow.emplace_back(element.Vertices[i], element.Vertices[j], element.Time * local(i, j));
        }
      }
    }
  }
  for (vtkIdType vertex = 0; vertex < count; ++vertex)
  {
    // A vertex of no proper triangle has a row of its own.
    const bool isAlone = stiffness[vertex] == 0.0;
    flow.emplace_back(vertex, vertex, isAlone ? 1.0 : masses[vertex]);
    laplacian.emplace_back(vertex, vertex, isAlone ? 1.0 : 0.0);
  }
  for (const auto& component : surface.GetComponents())
  {
    // Poisson's equation leaves a constant open: the first vertex gets 0.
    laplacian.emplace_back(component.front(), component.front(), stiffness[component.front()]);
  }

  vtkSMPTools::For(0, 2, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType system = begin; system < end; ++system)
      {
        const auto& triplets = system == 0 ? flow : laplacian;
        Matrix matrix(count, count);
        matrix.setFromTriplets(triplets.begin(), triplets.end());
        (system == 0 ? this->HeatFlow : this->Poisson).compute(matrix);
      }
    });
}

//------------------------------------------------------------------------------
bool vtkHeatGeodesics::IsFactored() const
{
  const auto isPositive = [](const Eigen::SimplicialLDLT<Matrix>& system)
  { return system.info() == Eigen::Success && (system.vectorD().array() > 0.0).all(); };
  return isPositive(this->HeatFlow) && isPositive(this->Poisson);
}

//------------------------------------------------------------------------------
Eigen::VectorXd vtkHeatGeodesics::Solve(const std::vector<vtkIdType>& sources) const
{
  Eigen::VectorXd heat = Eigen::VectorXd::Zero(this->HeatFlow.rows());
  for (const vtkIdType source : sources)
  {
    heat[source] = 1.0;
  }
  heat = this->HeatFlow.solve(heat);

  Eigen::VectorXd divergence = Eigen::VectorXd::Zero(heat.size());
  for (const Element& element : this->Elements)
  {
    Eigen::Vector3d local(
      heat[element.Vertices[0]], heat[element.Vertices[1]], heat[element.Vertices[2]]);
    // Far from the sources the square of the heat is 0 in double precision.
    const double greatest = local.cwiseAbs().maxCoeff();
    if (greatest > 0.0)
    {
      const Eigen::Vector2d uphill = element.Gradients * (local / greatest);
      const Eigen::Vector3d flux =
        element.Area * element.Gradients.transpose() * -uphill.normalized();
      for (int i = 0; i < 3; ++i)
      {
        divergence[element.Vertices[i]] += flux[i];
      }
    }
  }
  return this->Poisson.solve(divergence);
}

VTK_ABI_NAMESPACE_END
