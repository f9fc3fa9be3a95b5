// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryOpacities
 * @brief   Factors on the opacity of trajectories, from a point array with one component.
 *
 * Values are clamped to [0,1]. NaN counts as 1, and so do all points of a leaf without the array:
 * what has no factor keeps its opacity.
 */

#ifndef vtkTrajectoryOpacities_h
#define vtkTrajectoryOpacities_h

#include "vtkSmartPointer.h" // for the factors of points
#include "vtkTrajectoryNodes.h"

#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkDataArray;
class vtkFloatArray;

class vtkTrajectoryOpacities
{
public:
  /** Read the array of that name, empty for none, from now on. */
  explicit vtkTrajectoryOpacities(std::string name)
    : Name(std::move(name))
  {
  }

  /** The time of each leaf's array, 0 where there is none. Equal times mean equal factors. */
  std::vector<vtkMTimeType> GetTimes(const std::vector<vtkTrajectoryNodes::Leaf>& leaves) const;

  /** Has the data an array of that name that cannot be used: several components, or too short? */
  bool IsBad(vtkPolyData* data) const;

  /** The array of that name; null if the data lacks it, or if it cannot be used. */
  vtkDataArray* FindGoodArray(vtkPolyData* data) const;

  /** Has the data a factor below 1? */
  bool IsTranslucent(vtkPolyData* data) const;

  /** The factor of each node; empty if no leaf has the array. */
  std::vector<float> GetNodeFactors(const vtkTrajectoryNodes& nodes) const;

  /** The factor of each point; null if the data lacks the array. */
  vtkSmartPointer<vtkFloatArray> GetPointFactors(vtkPolyData* data) const;

private:
  vtkDataArray* FindArray(vtkPolyData* data) const;

  std::string Name;
};

VTK_ABI_NAMESPACE_END
#endif
