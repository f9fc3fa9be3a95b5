// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
std::string GetPlace(const Drawable& drawable, int association)
{
  if (association == vtkDataObject::POINT)
  {
    return "points";
  }
  const auto leaves = drawable.GetLeaves();
  const bool onlyLines = std::all_of(leaves.begin(), leaves.end(),
    [](vtkPolyData* leaf) { return leaf->GetNumberOfLines() == leaf->GetNumberOfCells(); });
  return onlyLines ? "lines" : "cells";
}
}

//------------------------------------------------------------------------------
std::vector<SceneArray> GetArrays(const Drawable& drawable)
{
  std::vector<SceneArray> arrays;
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    const std::string place = GetPlace(drawable, association);
    for (vtkPolyData* leaf : drawable.GetLeaves())
    {
      vtkDataSetAttributes* attributes = leaf->GetAttributes(association);
      for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      {
        vtkDataArray* part = attributes->GetArray(i);
        if (!part || !part->GetName())
        {
          continue;
        }
        const std::string name = part->GetName();
        auto array = std::find_if(arrays.begin(), arrays.end(),
          [&](const SceneArray& candidate)
          { return candidate.Name == name && candidate.Association == association; });
        if (array == arrays.end())
        {
          const bool isComputed = drawable.Computed.count(name) != 0;
          array = arrays.insert(array, { name, association, place, isComputed, {} });
        }
        array->Parts.push_back(part);
      }
    }
  }
  return arrays;
}

//------------------------------------------------------------------------------
std::optional<SceneArray> FindArray(const Drawable& drawable, const std::string& name)
{
  const auto arrays = GetArrays(drawable);
  const auto array = std::find_if(arrays.begin(), arrays.end(),
    [&name](const SceneArray& candidate) { return candidate.Name == name; });
  return array != arrays.end() ? std::optional<SceneArray>(*array) : std::nullopt;
}

//------------------------------------------------------------------------------
double GetNumber(vtkDataArray* array, vtkIdType id)
{
  double number = array->GetComponent(id, 0);
  for (int i = 1; i < array->GetNumberOfComponents(); ++i)
  {
    number = std::hypot(number, array->GetComponent(id, i));
  }
  return number;
}

//------------------------------------------------------------------------------
std::string ListArrays(const std::vector<Drawable>& drawables)
{
  std::set<std::string> texts;
  for (const Drawable& drawable : drawables)
  {
    for (const SceneArray& array : GetArrays(drawable))
    {
      texts.insert(array.Name + " (" + array.Place + (array.IsComputed ? ", computed)" : ")"));
    }
  }
  std::string list;
  for (const std::string& text : texts)
  {
    list += (list.empty() ? "" : ", ") + text;
  }
  return list.empty() ? "none" : list;
}
}
