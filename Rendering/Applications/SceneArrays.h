// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The arrays of numbers that drawables have.
 */

#ifndef SceneArrays_h
#define SceneArrays_h

#include "Drawables.h"

#include "vtkType.h"

#include <optional> // for what may not be there
#include <string>   // for names
#include <vector>   // for lists

class vtkDataArray;

namespace pellucid
{
/** All arrays of one name at one place in the parts of a drawable. */
struct SceneArray
{
  std::string Name;
  int Association;   // vtkDataObject::POINT or CELL
  std::string Place; // "points", or "lines" where all cells are lines, or "cells"
  bool IsComputed;   // by us, not read
  std::vector<vtkDataArray*> Parts;
};

/** Those of the points come first. */
std::vector<SceneArray> GetArrays(const Drawable& drawable);

/** The one of that name, of the points rather than the cells; nothing if there is none. */
std::optional<SceneArray> FindArray(const Drawable& drawable, const std::string& name);

/** The value of a tuple: its number, or the length of a vector. */
double GetNumber(vtkDataArray* array, vtkIdType id);

/** "density (points), TurningAngle (points, computed), ...", in the order of the alphabet. */
std::string ListArrays(const std::vector<Drawable>& drawables);
}

#endif
