// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkArrayValues.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArrayRange.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
template <typename Array>
void GatherFrom(
  vtkDataArray* array, const vtkIdType* ids, vtkIdType count, int component, double* values)
{
  const auto tuples = vtk::DataArrayTupleRange(static_cast<Array*>(array));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto value = static_cast<double>(tuples[ids[i]][component]);
    const double nanUnlessFinite = value - value;
    values[i] =
      std::clamp(value, -vtkArrayValues::Largest, vtkArrayValues::Largest) + nanUnlessFinite;
  }
}

//------------------------------------------------------------------------------
struct ChooseFunction
{
  template <typename Array, typename Function>
  void operator()(Array* vtkNotUsed(array), Function& function) const
  {
    function = &GatherFrom<Array>;
  }
};
}

//------------------------------------------------------------------------------
vtkArrayValues::vtkArrayValues(vtkDataArray* array)
  : Array(array)
  , Function(&GatherFrom<vtkDataArray>)
{
  if (array)
  {
    vtkArrayDispatch::Dispatch::Execute(array, ChooseFunction(), this->Function);
  }
}

VTK_ABI_NAMESPACE_END
