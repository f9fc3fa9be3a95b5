// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkScalarAttribute
 * @brief   One number at each point or cell of all leaves: an array found by its name, and its
 * percentiles.
 *
 * The number is the value of a one-component array and the magnitude of a tuple of more. NaN (also
 * in one component) means that it is missing. In each leaf the point data is searched before the
 * cell data; in a leaf that has no such array all values are missing.
 *
 * Private to the module.
 *
 * @sa vtkImportance vtkTrajectorySelection
 */

#ifndef vtkScalarAttribute_h
#define vtkScalarAttribute_h

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm> // for std::max
#include <array>     // for ranges
#include <cmath>     // for magnitudes
#include <string>    // for the name
#include <vector>    // for values

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
class vtkDataSet;

class vtkScalarAttribute
{
public:
  /**
   * Find the array in `data`, a data set or composite data. Throws std::invalid_argument, saying
   * what there is instead, when no leaf has it, when it does not hold numbers, or has fewer tuples
   * than there are points or cells. Data without a single point need not have it.
   */
  vtkScalarAttribute(vtkDataObject* data, const std::string& name);

  /** One end of a range: a value, or a percentile of the attribute. */
  struct Bound
  {
    double Number;
    bool IsPercentile;

    bool operator==(const Bound& other) const
    {
      return this->Number == other.Number && this->IsPercentile == other.IsPercentile;
    }
  };

  /**
   * The values of two bounds. Percentiles, in [0, 100], are those of all finite values of all
   * leaves; between two values that follow each other they are interpolated linearly. Without a
   * finite value they are NaN. Throws std::invalid_argument for a percentile outside of [0, 100]
   * and for a value that is not a number.
   */
  std::array<double, 2> ComputeRange(const Bound& minimum, const Bound& maximum) const;

  /** Where a leaf has the attribute: the array (or nullptr), on points or on cells. */
  struct Location
  {
    vtkDataArray* Array;
    bool OnCells;
  };
  Location Locate(vtkDataSet* leaf) const;

  /** Call `function(id, value)` for the tuples of [begin, end) in order, in double precision. */
  template <typename Function>
  static void ForEach(vtkDataArray* array, vtkIdType begin, vtkIdType end, Function&& function);

private:
  template <typename Tuple>
  static double ComputeMagnitude(const Tuple& tuple);

  std::vector<double> GetFiniteValues() const;

  vtkDataObject* Data;
  std::string Name;
};

//------------------------------------------------------------------------------
template <typename Tuple>
double vtkScalarAttribute::ComputeMagnitude(const Tuple& tuple)
{
  const auto sumSquares = [&tuple](double divisor)
  {
    double sum = 0.0;
    for (const auto value : tuple)
    {
      const double component = static_cast<double>(value) / divisor;
      sum += component * component;
    }
    return sum;
  };
  const double sum = sumSquares(1.0);
  if (std::isnormal(sum) || std::isnan(sum))
  {
    return std::sqrt(sum);
  }
  // The squares overflow or underflow, unless all components are 0 or one is infinite.
  double greatest = 0.0;
  for (const auto value : tuple)
  {
    greatest = std::max(greatest, std::abs(static_cast<double>(value)));
  }
  return greatest == 0.0 || std::isinf(greatest) ? greatest
                                                 : greatest * std::sqrt(sumSquares(greatest));
}

//------------------------------------------------------------------------------
template <typename Function>
void vtkScalarAttribute::ForEach(
  vtkDataArray* array, vtkIdType begin, vtkIdType end, Function&& function)
{
  const auto visit = [&function, begin, end](auto* typed)
  {
    vtkIdType id = begin;
    if (typed->GetNumberOfComponents() == 1)
    {
      for (const auto value : vtk::DataArrayValueRange<1>(typed, begin, end))
      {
        function(id++, static_cast<double>(value));
      }
      return;
    }
    for (const auto tuple : vtk::DataArrayTupleRange(typed, begin, end))
    {
      function(id++, ComputeMagnitude(tuple));
    }
  };
  if (!vtkArrayDispatch::Dispatch::Execute(array, visit))
  {
    visit(array);
  }
}

VTK_ABI_NAMESPACE_END
#endif
