// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFieldSeeds.h"

#include "vtkPointSet.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// A field that fills less than this part of its bounding box gets fewer seeds than asked for.
constexpr vtkIdType MaximumTriesPerSeed = 1000;
constexpr int HaltonBases[3] = { 2, 3, 5 };

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> NewSeeds()
{
  auto seeds = vtkSmartPointer<vtkPoints>::New();
  seeds->SetDataTypeToDouble();
  return seeds;
}

//------------------------------------------------------------------------------
// The digits of `index` in `base`, mirrored at the point: element `index` of van der Corput's
// sequence, in [0, 1).
double RadicalInverse(vtkIdType index, int base)
{
  double inverse = 0.0;
  double digit = 1.0;
  for (; index > 0; index /= base)
  {
    digit /= base;
    inverse += digit * static_cast<double>(index % base);
  }
  return inverse;
}
}

//------------------------------------------------------------------------------
vtkFieldSeeds::vtkFieldSeeds(const vtkFieldVectors& field)
  : Field(field)
{
  for (vtkDataSet* leaf : field.GetLeaves())
  {
    vtkSmartPointer<vtkStaticCellLocator> locator;
    if (vtkPointSet::SafeDownCast(leaf))
    {
      locator = vtkSmartPointer<vtkStaticCellLocator>::New();
      locator->SetDataSet(leaf);
      locator->BuildLocator();
    }
    this->Locators.push_back(locator);
  }
}

//------------------------------------------------------------------------------
bool vtkFieldSeeds::IsInside(double position[3])
{
  for (std::size_t i = 0; i < this->Locators.size(); ++i)
  {
    double parametric[3];
    double weights[VTK_CELL_SIZE];
    int subId = 0;
    const vtkIdType cell = this->Locators[i] ? this->Locators[i]->FindCell(position)
                                             : this->Field.GetLeaves()[i]->FindCell(position,
                                                 nullptr, -1, 0.0, subId, parametric, weights);
    if (cell >= 0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkFieldSeeds::PlaceInVolume(vtkIdType count, vtkIdType offset)
{
  const auto seeds = NewSeeds();
  const double* bounds = this->Field.GetBounds();
  const vtkIdType end = offset + 1 + MaximumTriesPerSeed * std::min(count, VTK_ID_MAX / 2000);
  // Element 0 is a corner of the box.
  for (vtkIdType index = offset + 1; index < end && seeds->GetNumberOfPoints() < count; ++index)
  {
    double position[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = bounds[2 * axis] +
        (bounds[2 * axis + 1] - bounds[2 * axis]) * RadicalInverse(index, HaltonBases[axis]);
    }
    if (this->IsInside(position))
    {
      seeds->InsertNextPoint(position);
    }
  }
  return seeds;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkFieldSeeds::PlaceAtPoints(vtkIdType count, vtkIdType offset)
{
  vtkIdType total = 0;
  for (vtkDataSet* leaf : this->Field.GetLeaves())
  {
    total += leaf->GetNumberOfPoints();
  }
  std::vector<vtkIdType> chosen;
  const vtkIdType seedCount = std::min(count, total);
  for (vtkIdType seed = 0; seed < seedCount; ++seed)
  {
    const double share = static_cast<double>(seed) / static_cast<double>(seedCount);
    const auto point = static_cast<vtkIdType>(share * static_cast<double>(total));
    chosen.push_back((point + offset) % total);
  }
  std::sort(chosen.begin(), chosen.end());

  const auto seeds = NewSeeds();
  vtkIdType first = 0;
  auto next = chosen.begin();
  for (vtkDataSet* leaf : this->Field.GetLeaves())
  {
    for (; next != chosen.end() && *next < first + leaf->GetNumberOfPoints(); ++next)
    {
      seeds->InsertNextPoint(leaf->GetPoint(*next - first));
    }
    first += leaf->GetNumberOfPoints();
  }
  return seeds;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkFieldSeeds::PlaceOnGrid(vtkIdType count)
{
  const double* bounds = this->Field.GetBounds();
  double volume = 1.0;
  int dimensions = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    volume *= length > 0.0 ? length : 1.0;
    dimensions += length > 0.0 ? 1 : 0;
  }
  const double spacing =
    dimensions > 0 ? std::pow(volume / static_cast<double>(count), 1.0 / dimensions) : 1.0;
  vtkIdType counts[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double length = bounds[2 * axis + 1] - bounds[2 * axis];
    counts[axis] = std::max<vtkIdType>(1, std::llround(length / spacing));
  }

  const auto seeds = NewSeeds();
  for (vtkIdType lattice = 0; lattice < counts[0] * counts[1] * counts[2]; ++lattice)
  {
    const vtkIdType index[3] = { lattice % counts[0], lattice / counts[0] % counts[1],
      lattice / counts[0] / counts[1] };
    double position[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double share =
        (static_cast<double>(index[axis]) + 0.5) / static_cast<double>(counts[axis]);
      position[axis] = bounds[2 * axis] + (bounds[2 * axis + 1] - bounds[2 * axis]) * share;
    }
    if (seeds->GetNumberOfPoints() < count && this->IsInside(position))
    {
      seeds->InsertNextPoint(position);
    }
  }
  return seeds;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkFieldSeeds::PlaceOnLine(
  vtkIdType count, const double first[3], const double last[3])
{
  const auto seeds = NewSeeds();
  for (vtkIdType seed = 0; seed < count; ++seed)
  {
    const double share =
      count > 1 ? static_cast<double>(seed) / static_cast<double>(count - 1) : 0.5;
    double position[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      position[axis] = first[axis] + share * (last[axis] - first[axis]);
    }
    if (this->IsInside(position))
    {
      seeds->InsertNextPoint(position);
    }
  }
  return seeds;
}

VTK_ABI_NAMESPACE_END
