// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Which array colours the scene, and by which colours.
 */

#ifndef Coloring_h
#define Coloring_h

#include "Drawables.h"

#include "vtkLookupTable.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

class vtkMapper;

namespace pellucid
{
/**
 * The array that colours where no option names one: the speed of traced lines, or else the active
 * or the first array; empty if there is none.
 */
std::string ChooseColorArray(const std::vector<Drawable>& drawables);

/** One array name and one range for the whole scene, so that colours compare across inputs. */
class Coloring
{
public:
  /**
   * Choose the array: the one that the options name, or ChooseColorArray(); and its range: that of
   * the options, or most of the values. Throw RenderError if the options give a range and there is
   * no array.
   */
  Coloring(const std::vector<Drawable>& drawables, const RenderOptions& options);

  /** Of the array; empty if there is nothing to colour by. */
  const std::string& GetName() const { return this->Name; }

  /** Make the mapper of a drawable colour by the array; one colour where it lacks the array. */
  void Apply(vtkMapper* mapper, const Drawable& drawable) const;

  /**
   * The colours of the points of a part of the drawable, 4 components; where the array is one of
   * the cells, the mean of those at a point counts, and where there is none, white.
   */
  vtkSmartPointer<vtkUnsignedCharArray> MapPoints(
    vtkPolyData* part, const Drawable& drawable) const;

private:
  std::string Name;
  vtkSmartPointer<vtkLookupTable> Table;
};
}

#endif
