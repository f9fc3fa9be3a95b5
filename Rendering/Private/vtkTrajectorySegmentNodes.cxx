// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectorySegmentNodes.h"

#include "vtkDataArray.h"
#include "vtkOptimizedScene.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cstring>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
int ToBits(double value)
{
  // Comparisons with NaN are false: it becomes 0.
  const auto number = static_cast<float>(value > 0.0 ? std::min(value, 1.0) : 0.0);
  int bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  return bits;
}

/** The arrays of one leaf; null where it lacks them. */
struct LeafArrays
{
  LeafArrays(vtkPolyData* data, const std::string& importanceArray)
    : Importance(data->GetPointData()->GetArray(importanceArray.c_str()))
    , Base(data->GetPointData()->GetArray("SegmentBase"))
    , Weight(data->GetPointData()->GetArray("SegmentWeight"))
  {
    if (this->Importance && this->Importance->GetNumberOfComponents() != 1)
    {
      this->Importance = nullptr;
    }
    if (!vtkOptimizedScene::HasLineSegments(data))
    {
      this->Base = nullptr;
      this->Weight = nullptr;
    }
  }

  vtkTrajectorySegmentNodes::Node Get(
    vtkIdType point, const pellucid::ImportanceRange<double>& range, int firstSegment) const
  {
    const double base = this->Base ? std::max(this->Base->GetComponent(point, 0), 0.0) : 0.0;
    return { { ToBits(this->Importance ? range.Map(this->Importance->GetComponent(point, 0)) : 0.0),
      firstSegment + static_cast<int>(base),
      ToBits(this->Weight ? this->Weight->GetComponent(point, 0) : 0.0), 0 } };
  }

  vtkDataArray* Importance;
  vtkDataArray* Base;
  vtkDataArray* Weight;
};
}

//------------------------------------------------------------------------------
std::vector<vtkMTimeType> vtkTrajectorySegmentNodes::GetTimes(
  const std::vector<vtkTrajectoryNodes::Leaf>& leaves, const std::string& importanceArray)
{
  std::vector<vtkMTimeType> times;
  for (const auto& leaf : leaves)
  {
    const LeafArrays arrays(leaf.Data, importanceArray);
    for (vtkDataArray* array : { arrays.Importance, arrays.Base, arrays.Weight })
    {
      times.push_back(array ? array->GetMTime() : 0);
    }
  }
  return times;
}

//------------------------------------------------------------------------------
std::vector<vtkTrajectorySegmentNodes::Node> vtkTrajectorySegmentNodes::Make(
  const vtkTrajectoryNodes& nodes, const std::string& importanceArray,
  const pellucid::ImportanceRange<double>& range)
{
  std::vector<LeafArrays> arrays;
  std::vector<int> firstSegments(1, 0);
  for (const auto& leaf : nodes.GetLeaves())
  {
    arrays.emplace_back(leaf.Data, importanceArray);
    const auto count = static_cast<int>(vtkOptimizedScene::CountSegments(leaf.Data));
    firstSegments.push_back(firstSegments.back() + count);
  }
  std::vector<Node> values(nodes.GetNodes().size());
  const auto& runs = nodes.GetRuns();
  for (std::size_t run = 0; run < runs.size(); ++run)
  {
    const vtkIdType end =
      run + 1 < runs.size() ? runs[run + 1].FirstNode : nodes.GetNumberOfNodes();
    for (vtkIdType node = runs[run].FirstNode; node < end; ++node)
    {
      const std::size_t leaf = runs[run].Leaf;
      values[node] = arrays[leaf].Get(nodes.GetPointIds()[node], range, firstSegments[leaf]);
    }
  }
  return values;
}

VTK_ABI_NAMESPACE_END
