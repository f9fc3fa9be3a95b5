// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFieldVectors.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkThreshold.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <set>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr const char* ValidName = "vtkFieldVectorsValid";

//------------------------------------------------------------------------------
bool IsHidden(vtkUnsignedCharArray* ghosts, vtkIdType id, unsigned char bit)
{
  return ghosts && (ghosts->GetValue(id) & bit) != 0;
}

//------------------------------------------------------------------------------
bool IsFinite(const double vector[3])
{
  return std::isfinite(vector[0]) && std::isfinite(vector[1]) && std::isfinite(vector[2]);
}

//------------------------------------------------------------------------------
// One flag for each point or cell: usable unless hidden or, where the vectors are, not finite.
std::vector<bool> FindValid(
  vtkUnsignedCharArray* ghosts, unsigned char bit, vtkDataArray* vectors, vtkIdType count)
{
  std::vector<bool> valid(count, true);
  for (vtkIdType id = 0; id < count; ++id)
  {
    double vector[3] = { 0.0, 0.0, 0.0 };
    if (vectors)
    {
      vectors->GetTuple(id, vector);
    }
    valid[id] = !IsHidden(ghosts, id, bit) && IsFinite(vector);
  }
  return valid;
}

//------------------------------------------------------------------------------
int GetCellDimension(vtkDataSet* leaf)
{
  vtkNew<vtkGenericCell> cell;
  int type = VTK_EMPTY_CELL;
  int dimension = 0;
  for (vtkIdType id = 0; id < leaf->GetNumberOfCells() && dimension < 3; ++id)
  {
    if (leaf->GetCellType(id) != type)
    {
      type = leaf->GetCellType(id);
      cell->SetCellType(type);
      dimension = std::max(dimension, cell->GetCellDimension());
    }
  }
  return dimension;
}

//------------------------------------------------------------------------------
// The part of a data set that consists of its valid cells, or the data set itself where it can be
// traced as it is.
vtkSmartPointer<vtkDataSet> ExtractValid(vtkDataSet* leaf, vtkDataArray* vectors, int association)
{
  const bool onPoints = association == vtkDataObject::POINT;
  const auto points = FindValid(leaf->GetPointGhostArray(), vtkDataSetAttributes::HIDDENPOINT,
    onPoints ? vectors : nullptr, leaf->GetNumberOfPoints());
  auto cells = FindValid(leaf->GetCellGhostArray(), vtkDataSetAttributes::HIDDENCELL,
    onPoints ? nullptr : vectors, leaf->GetNumberOfCells());

  if (std::find(points.begin(), points.end(), false) != points.end())
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < leaf->GetNumberOfCells(); ++cell)
    {
      leaf->GetCellPoints(cell, ids);
      cells[cell] = cells[cell] &&
        std::all_of(ids->begin(), ids->end(), [&points](vtkIdType id) { return points[id]; });
    }
  }
  // vtkStreamTracer follows surfaces of point sets only, and fails on those of images.
  const bool isFlatImage = !vtkPointSet::SafeDownCast(leaf) && GetCellDimension(leaf) == 2;
  if (!isFlatImage && std::find(cells.begin(), cells.end(), false) == cells.end())
  {
    return leaf;
  }

  vtkNew<vtkUnsignedCharArray> valid;
  valid->SetName(ValidName);
  valid->SetNumberOfValues(leaf->GetNumberOfCells());
  std::copy(cells.begin(), cells.end(), valid->GetPointer(0));

  auto marked = vtk::TakeSmartPointer(leaf->NewInstance());
  marked->ShallowCopy(leaf);
  // The flags hold what the ghost arrays say; a threshold would copy them along.
  marked->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  marked->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  marked->GetCellData()->AddArray(valid);

  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(marked);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, ValidName);
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(1.0);
  threshold->Update();
  vtkSmartPointer<vtkDataSet> result = threshold->GetOutput();
  result->GetCellData()->RemoveArray(ValidName);
  return result;
}

//------------------------------------------------------------------------------
vtkDataArray* FindVectors(vtkDataSetAttributes* attributes, const char* name)
{
  vtkDataArray* array = name ? attributes->GetArray(name) : attributes->GetVectors();
  for (int i = 0; !array && !name && i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* candidate = attributes->GetArray(i);
    array = candidate && candidate->GetNumberOfComponents() == 3 && candidate->GetName() ? candidate
                                                                                         : nullptr;
  }
  return array && array->GetName() && array->GetNumberOfComponents() == 3 ? array : nullptr;
}
}

//------------------------------------------------------------------------------
vtkFieldVectors::vtkFieldVectors(vtkDataObject* data, vtkInformation* request)
{
  if (!this->Choose(data, request))
  {
    return;
  }
  for (vtkDataSet* leaf : vtkCompositeDataSet::GetDataSets<vtkDataSet>(data))
  {
    this->Add(leaf);
  }
  vtkBoundingBox box;
  for (vtkDataSet* leaf : this->Leaves)
  {
    box.AddBounds(leaf->GetBounds());
    this->Dimension = std::max(this->Dimension, GetCellDimension(leaf));
  }
  box.GetBounds(this->Bounds);
}

//------------------------------------------------------------------------------
bool vtkFieldVectors::Choose(vtkDataObject* data, vtkInformation* request)
{
  const char* name = request ? request->Get(vtkDataObject::FIELD_NAME()) : nullptr;
  const int field = request && request->Has(vtkDataObject::FIELD_ASSOCIATION())
    ? request->Get(vtkDataObject::FIELD_ASSOCIATION())
    : vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS;
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    const int excluded = association == vtkDataObject::POINT
      ? vtkDataObject::FIELD_ASSOCIATION_CELLS
      : vtkDataObject::FIELD_ASSOCIATION_POINTS;
    for (vtkDataSet* leaf : vtkCompositeDataSet::GetDataSets<vtkDataSet>(data))
    {
      vtkDataArray* vectors = field == excluded
        ? nullptr
        : FindVectors(leaf->GetAttributes(association), name && *name ? name : nullptr);
      if (vectors)
      {
        this->Name = vectors->GetName();
        this->Association = association;
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkFieldVectors::Add(vtkDataSet* leaf)
{
  vtkDataArray* vectors = FindVectors(leaf->GetAttributes(this->Association), this->Name.c_str());
  if (!vectors)
  {
    return;
  }
  const auto valid = ExtractValid(leaf, vectors, this->Association);
  if (valid->GetNumberOfCells() == 0)
  {
    return;
  }
  vectors = valid->GetAttributes(this->Association)->GetArray(this->Name.c_str());
  this->MaximumMagnitude = std::max(this->MaximumMagnitude, vectors->GetRange(-1)[1]);
  this->Domain->SetBlock(this->Domain->GetNumberOfBlocks(), valid);
  this->Leaves.push_back(valid);
}

//------------------------------------------------------------------------------
std::string vtkFieldVectors::ListArrays(vtkDataObject* data)
{
  std::set<std::string> arrays;
  for (vtkDataSet* leaf : vtkCompositeDataSet::GetDataSets<vtkDataSet>(data))
  {
    for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
    {
      vtkDataSetAttributes* attributes = leaf->GetAttributes(association);
      for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      {
        vtkAbstractArray* array = attributes->GetAbstractArray(i);
        arrays.insert(std::string(array->GetName() ? array->GetName() : "(no name)") +
          (association == vtkDataObject::POINT ? " (points, " : " (cells, ") +
          std::to_string(array->GetNumberOfComponents()) + ")");
      }
    }
  }
  std::string list;
  for (const std::string& array : arrays)
  {
    list += (list.empty() ? "" : ", ") + array;
  }
  return list.empty() ? "none" : list;
}

VTK_ABI_NAMESPACE_END
