// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkUnsharedPoints
 * @brief   Poly data in which each line has its points for itself.
 *
 * Private to the module. A point that several lines use, or one line several times (a closed line,
 * the output of vtkCleanPolyData), cannot hold one value for each of these uses.
 */

#ifndef vtkUnsharedPoints_h
#define vtkUnsharedPoints_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkUnsharedPoints
{
public:
  enum Cells
  {
    LINES,
    LINES_AND_VERTICES
  };

  /**
   * `input` itself if these cells use no point twice, else a poly data in which the first use keeps
   * its point and each further use, in the order of the lines and then of the vertices, has a copy
   * with all its point data. The copies follow the points of the input, whose ids stay. Throws
   * std::out_of_range, with a message for the user, if a cell uses a point that does not exist.
   * Point arrays with fewer tuples than points have no values to copy: the poly data with copies
   * lacks them, and `filter` gives a warning that names them.
   *
   * Cost: one parallel pass over the connectivity where its ids increase from use to use, as
   * readers and tracers write them; else also a serial one.
   */
  static vtkSmartPointer<vtkPolyData> Make(vtkPolyData* input, Cells cells, vtkObject* filter);
};

VTK_ABI_NAMESPACE_END
#endif
