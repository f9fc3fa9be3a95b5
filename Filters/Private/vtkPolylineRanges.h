// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolylineRanges
 * @brief   How far the values of a point array spread along each polyline, or within a time.
 *
 * Private to the module. A line of n points takes O(n) time if its times are in order, else
 * O(n log n).
 *
 * @sa vtkTrajectoryAttributes
 */

#ifndef vtkPolylineRanges_h
#define vtkPolylineRanges_h

#include "vtkArrayValues.h"
#include "vtkPolylines.h"

#include <optional> // for the times
#include <vector>   // for the points of a line

VTK_ABI_NAMESPACE_BEGIN

class vtkPolylineRanges
{
public:
  /** `times` may be null: then whole lines are meant, and `window` is not used. */
  vtkPolylineRanges(
    const vtkPolylines& lines, vtkDataArray* values, vtkDataArray* times, double window);

  /** ranges[line] for the lines first, ..., last - 1; NaN where a line has no value. */
  void Compute(vtkIdType first, vtkIdType last, float* ranges) const;

private:
  struct Sample
  {
    double Time;
    double Value;
  };
  struct Scratch;

  double ComputeOfLine(vtkIdType line) const;
  double ComputeInWindow(vtkIdType line, Scratch& scratch) const;
  void GatherSamples(vtkIdType line, std::vector<Sample>& samples) const;

  const vtkPolylines& Lines;
  vtkArrayValues Values;
  std::optional<vtkArrayValues> Times;
  double Window;
};

VTK_ABI_NAMESPACE_END
#endif
