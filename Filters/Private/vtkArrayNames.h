// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkArrayNames
 * @brief   Gives each array that a file holds a name of its own.
 *
 * Data sets find arrays by their names, and look at one after the other to do so: files are
 * untrusted, and their readers refuse to make more than GreatestNumber.
 */

#ifndef vtkArrayNames_h
#define vtkArrayNames_h

#include "vtkSystemIncludes.h"

#include <cstddef>
#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkArrayNames
{
public:
  static constexpr std::size_t GreatestNumber = 4096;

  /** Throws vtkTrajectoryFileError if `count` arrays are too many. */
  static void RequireNumber(std::size_t count);

  /**
   * `name`, or, if that is taken, the first of "NAME_2", "NAME_3" and so on that is not; taken from
   * now on. Over all calls the time is that of sorting the names.
   */
  std::string Take(const std::string& name);

private:
  std::map<std::string, int> Repetitions; // of each name that is taken
};

VTK_ABI_NAMESPACE_END
#endif
