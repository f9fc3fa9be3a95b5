// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolylines
 * @brief   The lines of a cell array as one sequence of positions, which threads can share out.
 *
 * Private to the module. Position p is the p-th entry of the lines' connectivity. Shares of equal
 * numbers of positions keep all threads busy whether there are many short lines or a few long ones.
 */

#ifndef vtkPolylines_h
#define vtkPolylines_h

#include "vtkCellArray.h"

#include <algorithm> // for copies of ids

VTK_ABI_NAMESPACE_BEGIN

class vtkPolylines
{
public:
  /** A number of points that fit into the cache with everything that is computed of them. */
  static constexpr vtkIdType BlockSize = 512;

  explicit vtkPolylines(vtkCellArray* lines)
    : Lines(lines)
  {
  }

  vtkIdType GetNumberOfLines() const { return this->Lines->GetNumberOfCells(); }
  vtkIdType GetNumberOfPositions() const { return this->Lines->GetNumberOfConnectivityIds(); }

  ///@{
  /** The positions of a line are begin, ..., end - 1. */
  vtkIdType GetBegin(vtkIdType line) const { return this->Lines->GetOffset(line); }
  vtkIdType GetEnd(vtkIdType line) const { return this->Lines->GetOffset(line + 1); }
  ///@}

  /** The line that a position belongs to. */
  vtkIdType FindLine(vtkIdType position) const;

  /** Point ids at the positions first, ..., last - 1. */
  void CopyIds(vtkIdType first, vtkIdType last, vtkIdType* ids) const
  {
    VisitIds(this->Lines,
      [=](const auto* connectivity) { std::copy(connectivity + first, connectivity + last, ids); });
  }

  vtkIdType GetId(vtkIdType position) const
  {
    vtkIdType id = 0;
    this->CopyIds(position, position + 1, &id);
    return id;
  }

  /** Call function(line, first, last) for the part in [first, last) of each line that has one. */
  template <typename Function>
  void ForEachPart(vtkIdType first, vtkIdType last, Function&& function) const
  {
    for (vtkIdType line = first < last ? this->FindLine(first) : 0; first < last; ++line)
    {
      const vtkIdType partEnd = std::min(last, this->GetEnd(line));
      if (first < partEnd)
      {
        function(line, first, partEnd);
        first = partEnd;
      }
    }
  }

  /** Call function(pointer to the connectivity of the cells), whatever its integers are. */
  template <typename Function>
  static void VisitIds(vtkCellArray* cells, Function&& function)
  {
    if (cells->IsStorage64Bit())
    {
      function(cells->GetConnectivityArray64()->GetPointer(0));
    }
    else
    {
      function(cells->GetConnectivityArray32()->GetPointer(0));
    }
  }

private:
  vtkCellArray* Lines;
};

VTK_ABI_NAMESPACE_END
#endif
