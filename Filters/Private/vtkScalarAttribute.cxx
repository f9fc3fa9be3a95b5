// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkScalarAttribute.h"

#include "vtkFieldVectors.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
void CheckArray(vtkAbstractArray* array, vtkIdType count, const std::string& what)
{
  if (!vtkDataArray::SafeDownCast(array))
  {
    throw std::invalid_argument("The array '" + std::string(array->GetName()) + "' holds " +
      array->GetDataTypeAsString() + "s instead of numbers; choose another.");
  }
  if (array->GetNumberOfTuples() < count)
  {
    throw std::invalid_argument("The array '" + std::string(array->GetName()) + "' has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples for " + std::to_string(count) + " " +
      what + "; it has to have one for each.");
  }
}

//------------------------------------------------------------------------------
void CheckBound(const vtkScalarAttribute::Bound& bound, const std::string& name)
{
  if (bound.IsPercentile ? !(bound.Number >= 0.0 && bound.Number <= 100.0)
                         : std::isnan(bound.Number))
  {
    throw std::invalid_argument("A bound for the array '" + name + "' is " +
      (bound.IsPercentile ? "the percentile " + std::to_string(bound.Number) +
            "; percentiles lie between 0 and 100."
                          : "not a number; set a value or a percentile."));
  }
}

//------------------------------------------------------------------------------
double Interpolate(double below, double above, double fraction)
{
  // The first form would overflow for bounds far apart, the second blurs equal ones.
  return (below < 0.0) == (above < 0.0) ? std::min(below + fraction * (above - below), above)
                                        : (1.0 - fraction) * below + fraction * above;
}

//------------------------------------------------------------------------------
// Partly sorts the values.
double ComputePercentile(std::vector<double>& values, double percent)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double position = percent / 100.0 * static_cast<double>(values.size() - 1);
  const auto below = values.begin() + static_cast<std::ptrdiff_t>(position);
  const double fraction = position - std::floor(position);
  std::nth_element(values.begin(), below, values.end());
  return fraction > 0.0 ? Interpolate(*below, *std::min_element(below + 1, values.end()), fraction)
                        : *below;
}
}

//------------------------------------------------------------------------------
vtkScalarAttribute::vtkScalarAttribute(vtkDataObject* data, const std::string& name)
  : Data(data)
  , Name(name)
{
  bool isFound = false;
  bool isEmpty = true;
  for (vtkDataSet* leaf : vtkCompositeDataSet::GetDataSets<vtkDataSet>(data))
  {
    isEmpty = isEmpty && leaf->GetNumberOfPoints() == 0;
    if (vtkAbstractArray* onPoints = leaf->GetPointData()->GetAbstractArray(name.c_str()))
    {
      CheckArray(onPoints, leaf->GetNumberOfPoints(), "points");
      isFound = true;
    }
    else if (vtkAbstractArray* onCells = leaf->GetCellData()->GetAbstractArray(name.c_str()))
    {
      CheckArray(onCells, leaf->GetNumberOfCells(), "cells");
      isFound = true;
    }
  }
  if (!isFound && !isEmpty)
  {
    throw std::invalid_argument("There is no array named '" + name +
      "'. The input has the arrays (association, components): " +
      vtkFieldVectors::ListArrays(data) + ".");
  }
}

//------------------------------------------------------------------------------
vtkScalarAttribute::Location vtkScalarAttribute::Locate(vtkDataSet* leaf) const
{
  vtkDataArray* onPoints = leaf->GetPointData()->GetArray(this->Name.c_str());
  return onPoints ? Location{ onPoints, false }
                  : Location{ leaf->GetCellData()->GetArray(this->Name.c_str()), true };
}

//------------------------------------------------------------------------------
std::vector<double> vtkScalarAttribute::GetFiniteValues() const
{
  std::vector<double> values;
  for (vtkDataSet* leaf : vtkCompositeDataSet::GetDataSets<vtkDataSet>(this->Data))
  {
    const Location location = this->Locate(leaf);
    const vtkIdType count = location.OnCells ? leaf->GetNumberOfCells() : leaf->GetNumberOfPoints();
    if (location.Array)
    {
      values.reserve(values.size() + count);
      ForEach(location.Array, 0, count,
        [&values](vtkIdType, double value)
        {
          if (std::isfinite(value))
          {
            values.push_back(value);
          }
        });
    }
  }
  return values;
}

//------------------------------------------------------------------------------
std::array<double, 2> vtkScalarAttribute::ComputeRange(
  const Bound& minimum, const Bound& maximum) const
{
  CheckBound(minimum, this->Name);
  CheckBound(maximum, this->Name);
  std::vector<double> values;
  if (minimum.IsPercentile || maximum.IsPercentile)
  {
    values = this->GetFiniteValues();
  }
  const auto compute = [&values](const Bound& bound)
  { return bound.IsPercentile ? ComputePercentile(values, bound.Number) : bound.Number; };
  return { compute(minimum), compute(maximum) };
}

VTK_ABI_NAMESPACE_END
