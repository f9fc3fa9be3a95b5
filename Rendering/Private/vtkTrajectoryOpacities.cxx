// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryOpacities.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
float GetFactor(vtkDataArray* array, vtkIdType point)
{
  const double value = array->GetComponent(point, 0);
  return std::isnan(value) ? 1.0f : static_cast<float>(std::clamp(value, 0.0, 1.0));
}
}

//------------------------------------------------------------------------------
vtkDataArray* vtkTrajectoryOpacities::FindArray(vtkPolyData* data) const
{
  return this->Name.empty() ? nullptr : data->GetPointData()->GetArray(this->Name.c_str());
}

//------------------------------------------------------------------------------
bool vtkTrajectoryOpacities::IsBad(vtkPolyData* data) const
{
  vtkDataArray* array = this->FindArray(data);
  return array &&
    (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() < data->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
vtkDataArray* vtkTrajectoryOpacities::FindGoodArray(vtkPolyData* data) const
{
  return this->IsBad(data) ? nullptr : this->FindArray(data);
}

//------------------------------------------------------------------------------
std::vector<vtkMTimeType> vtkTrajectoryOpacities::GetTimes(
  const std::vector<vtkTrajectoryNodes::Leaf>& leaves) const
{
  std::vector<vtkMTimeType> times;
  for (const auto& leaf : leaves)
  {
    vtkDataArray* array = this->FindArray(leaf.Data);
    times.push_back(array ? array->GetMTime() : 0);
  }
  return times;
}

//------------------------------------------------------------------------------
bool vtkTrajectoryOpacities::IsTranslucent(vtkPolyData* data) const
{
  vtkDataArray* array = this->FindGoodArray(data);
  return array && array->GetRange(0)[0] < 1.0; // kept by the array until it changes
}

//------------------------------------------------------------------------------
std::vector<float> vtkTrajectoryOpacities::GetNodeFactors(const vtkTrajectoryNodes& nodes) const
{
  std::vector<float> factors;
  const auto& runs = nodes.GetRuns();
  for (std::size_t run = 0; run < runs.size(); ++run)
  {
    vtkDataArray* array = this->FindGoodArray(nodes.GetLeaves()[runs[run].Leaf].Data);
    if (!array)
    {
      continue;
    }
    factors.resize(nodes.GetNodes().size(), 1.0f);
    const vtkIdType end =
      run + 1 < runs.size() ? runs[run + 1].FirstNode : nodes.GetNumberOfNodes();
    for (vtkIdType node = runs[run].FirstNode; node < end; ++node)
    {
      factors[node] = GetFactor(array, nodes.GetPointIds()[node]);
    }
  }
  return factors;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkTrajectoryOpacities::GetPointFactors(vtkPolyData* data) const
{
  vtkDataArray* array = this->FindGoodArray(data);
  if (!array)
  {
    return nullptr;
  }
  auto factors = vtkSmartPointer<vtkFloatArray>::New();
  factors->SetNumberOfValues(data->GetNumberOfPoints());
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    factors->SetValue(point, GetFactor(array, point));
  }
  return factors;
}

VTK_ABI_NAMESPACE_END
