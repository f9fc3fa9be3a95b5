// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSegmentedGeometry.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectorySegments.h"

#include <algorithm>
#include <array>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkSegmentedGeometry);

namespace
{
// The range of what vtkImportance makes is known.
constexpr char MappedImportance[] = "Importance";

constexpr std::array<double, 2> Percentiles{ 0.50, 0.99 };

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
double TakePercentile(std::vector<double>& values, double share)
{
  const auto rank = std::lround(share * static_cast<double>(values.size() - 1));
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}
}

//------------------------------------------------------------------------------
vtkSegmentedGeometry::vtkSegmentedGeometry() = default;

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
void vtkSegmentedGeometry::SetImportanceArray(const std::string& name)
{
  if (name.empty() != this->ImportanceArray.empty())
  {
    this->Modified();
  }
  this->RangeOutdated = this->RangeOutdated || name != this->ImportanceArray;
  this->ImportanceArray = name;
}

//------------------------------------------------------------------------------
const std::array<double, 2>& vtkSegmentedGeometry::GetImportanceRange()
{
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  if (!input || (!this->RangeOutdated && input->GetMTime() < this->RangeTime))
  {
    return this->ImportanceRange;
  }
  this->ImportanceRange = { 0.0, 1.0 };
  std::vector<double> values;
  if (this->ImportanceArray != MappedImportance)
  {
    values = GetFiniteValues(
      vtkCompositeDataSet::GetDataSets<vtkPolyData>(input), this->ImportanceArray.c_str());
  }
  for (std::size_t i = 0; i < Percentiles.size() && !values.empty(); ++i)
  {
    this->ImportanceRange[i] = TakePercentile(values, Percentiles[i]);
  }
  this->RangeOutdated = false;
  this->RangeTime.Modified();
  return this->ImportanceRange;
}

//------------------------------------------------------------------------------
void vtkSegmentedGeometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ImportanceArray: " << this->ImportanceArray << "\n";
  os << indent << "ImportanceRange: " << this->ImportanceRange[0] << ", "
     << this->ImportanceRange[1] << "\n";
  os << indent << "NumberOfSegments: " << this->NumberOfSegments << "\n";
}

VTK_ABI_NAMESPACE_END
