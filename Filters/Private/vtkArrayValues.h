// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkArrayValues
 * @brief   Values of a data array of any type, gathered quickly and made safe to calculate with.
 *
 * Private to the module. A value that is not finite becomes NaN, and one beyond +-Largest becomes
 * +-Largest, so that fourth powers of differences are finite.
 */

#ifndef vtkArrayValues_h
#define vtkArrayValues_h

#include "vtkDataArray.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkArrayValues
{
public:
  static constexpr double Largest = 1e75;

  /** The array has to live as long as this object; null where nothing will be gathered. */
  explicit vtkArrayValues(vtkDataArray* array);

  /** values[i] = component of tuple ids[i]; from any number of threads. */
  void Gather(const vtkIdType* ids, vtkIdType count, int component, double* values) const
  {
    this->Function(this->Array, ids, count, component, values);
  }

private:
  using GatherFunction = void (*)(vtkDataArray*, const vtkIdType*, vtkIdType, int, double*);

  vtkDataArray* Array;
  GatherFunction Function;
};

VTK_ABI_NAMESPACE_END
#endif
