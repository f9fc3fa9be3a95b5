// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkArrayNames.h"

#include "vtkTrajectoryFileError.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkArrayNames::RequireNumber(std::size_t count)
{
  if (count > GreatestNumber)
  {
    throw vtkTrajectoryFileError(
      "expected at most " + std::to_string(GreatestNumber) + " arrays in it, found more");
  }
}

//------------------------------------------------------------------------------
std::string vtkArrayNames::Take(const std::string& name)
{
  std::string unique = name;
  while (!this->Repetitions.emplace(unique, 1).second)
  {
    unique = name + "_" + std::to_string(++this->Repetitions[name]);
  }
  return unique;
}

VTK_ABI_NAMESPACE_END
