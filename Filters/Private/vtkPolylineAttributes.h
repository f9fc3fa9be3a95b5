// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolylineAttributes
 * @brief   The attributes of the points of polylines, computed in one pass over them.
 *
 * Private to the module. vtkTrajectoryAttributes defines them. A block of points is gathered,
 * each attribute computed of it while it is in the cache, and the results stored; a block depends
 * on one point more at either side only, so that long lines are shared out too. Points that
 * coincide with a neighbour are the exception: the turning angle there depends on points that may
 * be any number of points away. Compute() finds these, and Repair() computes them again.
 */

#ifndef vtkPolylineAttributes_h
#define vtkPolylineAttributes_h

#include "vtkArrayValues.h"
#include "vtkPolylines.h"
#include "vtkTrajectoryAttributes.h"

#include <array>    // for the outputs
#include <optional> // for arrays that may be absent

VTK_ABI_NAMESPACE_BEGIN

class vtkPolylineAttributes
{
public:
  /** No point may be used twice (vtkUnsharedPoints). An array may be null if no attribute that is
   * asked for needs it; without `height` the coordinate along `upAxis` is the height. */
  vtkPolylineAttributes(const vtkPolylines& lines, vtkDataArray* coordinates, int upAxis,
    vtkDataArray* pressure, vtkDataArray* height, vtkDataArray* time);

  /** Ask for an attribute of points: where its value for each point goes. */
  void SetOutput(int attribute, float* values) { this->Outputs[attribute] = values; }

  /** Compute the attributes at the positions [first, last); returns whether a turning angle
   * may have to be repaired there. */
  bool Compute(vtkIdType first, vtkIdType last) const;

  /** Compute the turning angles of the groups of coincident points whose first is at one of the
   * positions [first, last). Only when Compute() has been called for all positions. */
  void Repair(vtkIdType first, vtkIdType last) const;

private:
  struct Block;
  struct Segment;

  bool ComputeBlock(vtkIdType line, vtkIdType first, vtkIdType last) const;
  void ComputeSegments(const Block& block) const;
  void ComputeTurning(const Block& block) const;
  void RepairLine(vtkIdType line, vtkIdType first, vtkIdType last) const;
  Segment GetSegment(vtkIdType line, vtkIdType position) const;

  const vtkPolylines& Lines;
  int UpAxis;
  vtkArrayValues Coordinates;
  std::optional<vtkArrayValues> Pressure;
  std::optional<vtkArrayValues> Height;
  std::optional<vtkArrayValues> Time;
  std::array<float*, vtkTrajectoryAttributes::NUMBER_OF_ATTRIBUTES> Outputs{};
};

VTK_ABI_NAMESPACE_END
#endif
