// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentedGeometry.h"

#include "vtkCallbackCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectorySegments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSegmentedGeometry);

namespace
{
constexpr char RangeName[] = "ImportanceRange";

// The range of what vtkImportance makes is known.
constexpr char MappedImportance[] = "Importance";

constexpr std::array<double, 2> Percentiles{ 0.50, 0.99 };
constexpr int QuantilesPerProcess = 1001;

//------------------------------------------------------------------------------
// With leaves of its own, which can be changed.
std::vector<vtkPolyData*> CopyLeaves(vtkDataObject* input, vtkDataObject* output)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    output->ShallowCopy(input);
    return { vtkPolyData::SafeDownCast(output) };
  }
  auto* copy = vtkCompositeDataSet::SafeDownCast(output);
  copy->CopyStructure(composite);
  copy->GetFieldData()->ShallowCopy(composite->GetFieldData());
  std::vector<vtkPolyData*> leaves;
  auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkDataObject* leaf = iterator->GetCurrentDataObject();
    auto leafCopy = vtk::TakeSmartPointer(leaf->NewInstance());
    leafCopy->ShallowCopy(leaf);
    copy->SetDataSet(iterator, leafCopy);
    if (auto* geometry = vtkPolyData::SafeDownCast(leafCopy))
    {
      leaves.push_back(geometry);
    }
  }
  return leaves;
}

//------------------------------------------------------------------------------
bool HasLines(vtkPolyData* leaf)
{
  return leaf->GetNumberOfVerts() + leaf->GetNumberOfLines() > 0;
}

//------------------------------------------------------------------------------
bool IsSurface(vtkPolyData* leaf)
{
  return !HasLines(leaf) && leaf->GetNumberOfPolys() + leaf->GetNumberOfStrips() > 0;
}

//------------------------------------------------------------------------------
std::vector<double> GetFiniteValues(const std::vector<vtkPolyData*>& leaves, const char* name)
{
  std::vector<double> values;
  for (vtkPolyData* leaf : leaves)
  {
    vtkDataArray* array = leaf->GetPointData()->GetArray(name);
    if (!array || array->GetNumberOfComponents() != 1)
    {
      continue;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      const double value = array->GetComponent(i, 0);
      if (std::isfinite(value))
      {
        values.push_back(value);
      }
    }
  }
  return values;
}

//------------------------------------------------------------------------------
std::size_t GetRank(double share, std::size_t count)
{
  return static_cast<std::size_t>(std::lround(share * static_cast<double>(count - 1)));
}

//------------------------------------------------------------------------------
double TakePercentile(std::vector<double>& values, double share)
{
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(GetRank(share, values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

//------------------------------------------------------------------------------
// Quantiles of this process, each standing for as many values as the others; none without values.
std::vector<double> TakeQuantiles(std::vector<double>& values)
{
  std::sort(values.begin(), values.end());
  std::vector<double> quantiles(values.empty() ? 0 : QuantilesPerProcess);
  for (std::size_t i = 0; i < quantiles.size(); ++i)
  {
    quantiles[i] =
      values[GetRank(static_cast<double>(i) / (QuantilesPerProcess - 1), values.size())];
  }
  return quantiles;
}

//------------------------------------------------------------------------------
// The percentiles of the values of all processes; empty where there are none.
std::vector<double> FindPercentiles(std::vector<double>& values)
{
  std::vector<double> found;
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const int processes = controller ? controller->GetNumberOfProcesses() : 1;
  if (processes == 1)
  {
    for (std::size_t i = 0; i < Percentiles.size() && !values.empty(); ++i)
    {
      found.push_back(TakePercentile(values, Percentiles[i]));
    }
    return found;
  }

  const auto count = static_cast<double>(values.size());
  std::vector<double> quantiles = TakeQuantiles(values);
  quantiles.resize(QuantilesPerProcess, 0.0);
  std::vector<double> counts(processes);
  std::vector<double> all(static_cast<std::size_t>(processes) * QuantilesPerProcess);
  controller->AllGather(&count, counts.data(), 1);
  controller->AllGather(quantiles.data(), all.data(), QuantilesPerProcess);
  std::vector<std::pair<double, double>> weighted; // value, share of all values
  double total = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    weighted.emplace_back(all[i], counts[i / QuantilesPerProcess]);
    total += weighted.back().second;
  }
  std::sort(weighted.begin(), weighted.end());
  for (std::size_t i = 0; i < Percentiles.size() && total > 0.0; ++i)
  {
    double sum = 0.0;
    const auto place = std::find_if(weighted.begin(), weighted.end(),
      [&](const std::pair<double, double>& value)
      {
        sum += value.second;
        return sum >= Percentiles[i] * total;
      });
    found.push_back(place->first);
  }
  return found;
}
}

//------------------------------------------------------------------------------
vtkSegmentedGeometry::vtkSegmentedGeometry()
{
  for (vtkAlgorithm* part :
    std::array<vtkAlgorithm*, 2>{ this->LineSegments, this->SurfaceSegments })
  {
    vtkNew<vtkCallbackCommand> forward;
    forward->SetClientData(this);
    forward->SetCallback(
      [](vtkObject* caller, unsigned long, void* self, void*)
      {
        auto* algorithm = static_cast<vtkSegmentedGeometry*>(self);
        algorithm->UpdateProgress(vtkAlgorithm::SafeDownCast(caller)->GetProgress());
        vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(algorithm->GetAbortExecute());
      });
    part->AddObserver(vtkCommand::ProgressEvent, forward);
  }
}

//------------------------------------------------------------------------------
vtkSegmentedGeometry::~vtkSegmentedGeometry() = default;

//------------------------------------------------------------------------------
int vtkSegmentedGeometry::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSegmentedGeometry::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0]);
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  if (this->ImportanceArray.empty())
  {
    output->ShallowCopy(input);
    return 1;
  }
  const std::vector<vtkPolyData*> leaves = CopyLeaves(input, output);
  this->AddRange(leaves);
  this->DivideLines(leaves);
  for (vtkPolyData* leaf : leaves)
  {
    if (IsSurface(leaf))
    {
      this->DivideSurface(leaf);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
// All at once, so that they have one length of segments.
void vtkSegmentedGeometry::DivideLines(const std::vector<vtkPolyData*>& leaves)
{
  vtkNew<vtkMultiBlockDataSet> lines;
  std::vector<vtkPolyData*> divided;
  for (vtkPolyData* leaf : leaves)
  {
    if (HasLines(leaf))
    {
      auto copy = vtk::TakeSmartPointer(leaf->NewInstance());
      copy->ShallowCopy(leaf);
      lines->SetBlock(lines->GetNumberOfBlocks(), copy);
      divided.push_back(leaf);
    }
  }
  if (divided.empty())
  {
    return;
  }
  this->LineSegments->SetNumberOfSegments(this->NumberOfSegments);
  this->LineSegments->SetInputDataObject(lines);
  this->LineSegments->Update();
  auto* result = vtkMultiBlockDataSet::SafeDownCast(this->LineSegments->GetOutputDataObject(0));
  // An error leaves an empty output: the lines are then drawn as they are.
  for (unsigned int i = 0; i < result->GetNumberOfBlocks(); ++i)
  {
    divided[i]->ShallowCopy(result->GetBlock(i));
  }
  this->LineSegments->SetInputDataObject(nullptr);
}

//------------------------------------------------------------------------------
void vtkSegmentedGeometry::DivideSurface(vtkPolyData* leaf)
{
  auto copy = vtk::TakeSmartPointer(leaf->NewInstance());
  copy->ShallowCopy(leaf);
  this->SurfaceSegments->SetInputDataObject(copy);
  this->SurfaceSegments->Update();
  leaf->ShallowCopy(this->SurfaceSegments->GetOutputDataObject(0));
  this->SurfaceSegments->SetInputDataObject(nullptr);
}

//------------------------------------------------------------------------------
void vtkSegmentedGeometry::AddRange(const std::vector<vtkPolyData*>& leaves)
{
  std::vector<double> ends{ 0.0, 1.0 };
  if (this->ImportanceArray != MappedImportance)
  {
    std::vector<double> values = GetFiniteValues(leaves, this->ImportanceArray.c_str());
    ends = FindPercentiles(values);
  }
  if (ends.empty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> range;
  range->SetName(RangeName);
  range->SetNumberOfComponents(2);
  range->InsertNextTuple(ends.data());
  for (vtkPolyData* leaf : leaves)
  {
    leaf->GetFieldData()->AddArray(range);
  }
}

//------------------------------------------------------------------------------
bool vtkSegmentedGeometry::GetImportanceRange(vtkDataObject* output, double range[2])
{
  for (vtkPolyData* leaf : vtkCompositeDataSet::GetDataSets<vtkPolyData>(output))
  {
    vtkDataArray* array = leaf->GetFieldData()->GetArray(RangeName);
    if (array && array->GetNumberOfComponents() == 2 && array->GetNumberOfTuples() == 1)
    {
      array->GetTuple(0, range);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkSegmentedGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImportanceArray: " << this->ImportanceArray << "\n";
  os << indent << "NumberOfSegments: " << this->NumberOfSegments << "\n";
}

VTK_ABI_NAMESPACE_END
