// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectorySegmentNodes
 * @brief   Importance and place among the segments of each node of trajectories.
 *
 * Segments are those of vtkTrajectorySegments; a leaf that has not passed it is one segment. They
 * are numbered through all leaves, as vtkOptimizedScene does.
 */

#ifndef vtkTrajectorySegmentNodes_h
#define vtkTrajectorySegmentNodes_h

#include "Importance.h"
#include "vtkTrajectoryNodes.h"

#include <array>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkTrajectorySegmentNodes
{
public:
  /** Of a node: importance in [0,1] as bits, SegmentBase, SegmentWeight as bits, 0. */
  using Node = std::array<int, 4>;

  /** When what Make() reads has changed. */
  static std::vector<vtkMTimeType> GetTimes(
    const std::vector<vtkTrajectoryNodes::Leaf>& leaves, const std::string& importanceArray);

  /** With the importances that follow from an array; a leaf without it has importance 0. */
  static std::vector<Node> Make(const vtkTrajectoryNodes& nodes, const std::string& importanceArray,
    const pellucid::ImportanceRange<double>& range);
};

VTK_ABI_NAMESPACE_END
#endif
