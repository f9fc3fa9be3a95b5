// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkShortArrays.h"

#include "vtkAbstractArray.h"
#include "vtkDataSetAttributes.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkRemoveShortArrays(
  vtkDataSetAttributes* attributes, vtkIdType count, std::set<std::string>& removed)
{
  for (int i = attributes->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < count)
    {
      removed.insert(array->GetName() ? array->GetName() : "");
      attributes->RemoveArray(i);
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkDescribeShortArrays(const std::set<std::string>& removed)
{
  std::string names;
  for (const std::string& name : removed)
  {
    names += (names.empty() ? "'" : ", '") + name + "'";
  }
  return "These arrays do not have a tuple for each point or cell, and are left out: " + names +
    ".";
}

VTK_ABI_NAMESPACE_END
