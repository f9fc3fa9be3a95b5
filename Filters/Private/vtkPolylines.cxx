// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPolylines.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkIdType vtkPolylines::FindLine(vtkIdType position) const
{
  // The last line that begins at the position or before it: those of no points are passed over.
  vtkIdType low = 0;
  vtkIdType high = this->GetNumberOfLines();
  while (high - low > 1)
  {
    const vtkIdType middle = low + (high - low) / 2;
    (this->GetBegin(middle) <= position ? low : high) = middle;
  }
  return low;
}

VTK_ABI_NAMESPACE_END
