// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolylineRanges
 * @brief   How far the values of a point array spread along each trajectory, or within a time.
 *
 * Private to the module. A trajectory of n points takes O(n) time if its times are in order, else
 * O(n log n).
 *
 * @sa vtkTrajectoryAttributes vtkTrajectoryParts.h
 */

#ifndef vtkPolylineRanges_h
#define vtkPolylineRanges_h

#include "vtkArrayValues.h"
#include "vtkPolylines.h"

#include <optional> // for the times
#include <vector>   // for lines and samples

VTK_ABI_NAMESPACE_BEGIN

class vtkPolylineRanges
{
public:
  /** `firstLines` is that of vtkFindTrajectories(). `times` may be null: then whole trajectories
   * are meant, and `window` is not used. */
  vtkPolylineRanges(const vtkPolylines& lines, const std::vector<vtkIdType>& firstLines,
    vtkDataArray* values, vtkDataArray* times, double window);

  /** ranges[line] for the lines of the trajectories first, ..., last - 1; NaN where these have no
   * value. */
  void Compute(vtkIdType first, vtkIdType last, float* ranges) const;

private:
  struct Sample
  {
    double Time;
    double Value;
  };
  struct Scratch;

  double ComputeWhole(vtkIdType begin, vtkIdType end) const;
  double ComputeInWindow(vtkIdType begin, vtkIdType end, Scratch& scratch) const;
  void GatherSamples(vtkIdType begin, vtkIdType end, std::vector<Sample>& samples) const;

  const vtkPolylines& Lines;
  const std::vector<vtkIdType>& FirstLines;
  vtkArrayValues Values;
  std::optional<vtkArrayValues> Times;
  double Window;
};

VTK_ABI_NAMESPACE_END
#endif
