// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFieldSeeds
 * @brief   Deterministic seed positions inside the cells of a field.
 *
 * Private to the module. Every function places at most `count` seeds, all inside cells or on
 * points.
 *
 * @sa vtkFieldStreamlines
 */

#ifndef vtkFieldSeeds_h
#define vtkFieldSeeds_h

#include "vtkFieldVectors.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <vector> // for the locators

VTK_ABI_NAMESPACE_BEGIN

class vtkFieldSeeds
{
public:
  explicit vtkFieldSeeds(const vtkFieldVectors& field);

  /** Elements offset, offset + 1, ... of the Halton sequence of the bounding box. */
  vtkSmartPointer<vtkPoints> PlaceInVolume(vtkIdType count, vtkIdType offset);

  /** Every n-th point of the field, from point number `offset`, cyclically. */
  vtkSmartPointer<vtkPoints> PlaceAtPoints(vtkIdType count, vtkIdType offset);

  /** A lattice of nearly cubic cells that fills the bounding box. */
  vtkSmartPointer<vtkPoints> PlaceOnGrid(vtkIdType count);

  /** Evenly spaced positions from `first` to `last`, both included. */
  vtkSmartPointer<vtkPoints> PlaceOnLine(
    vtkIdType count, const double first[3], const double last[3]);

private:
  bool IsInside(double position[3]);

  const vtkFieldVectors& Field;
  std::vector<vtkSmartPointer<vtkStaticCellLocator>> Locators; // null: the leaf finds cells itself
};

VTK_ABI_NAMESPACE_END
#endif
