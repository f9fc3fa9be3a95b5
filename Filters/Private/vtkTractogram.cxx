// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTractogram.h"

#include "vtkTrajectoryFileError.h"
#include "vtkTrajectoryLines.h"

#include "vtkArrayDispatch.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
struct FindNotFinite
{
  vtkIdType Point = -1;

  template <typename Array>
  void operator()(Array* coordinates)
  {
    const auto values = vtk::DataArrayValueRange<3>(coordinates);
    const auto found =
      std::find_if(values.begin(), values.end(), [](auto value) { return !std::isfinite(value); });
    if (found != values.end())
    {
      this->Point = std::distance(values.begin(), found) / 3;
    }
  }
};

//------------------------------------------------------------------------------
void RequireFinite(vtkDataArray* coordinates, const std::vector<vtkIdType>& offsets)
{
  FindNotFinite find;
  if (!vtkArrayDispatch::DispatchByValueType<vtkArrayDispatch::Reals>::Execute(coordinates, find))
  {
    find(coordinates);
  }
  if (find.Point >= 0)
  {
    const auto line = std::upper_bound(offsets.begin(), offsets.end(), find.Point) - 1;
    throw vtkTrajectoryFileError("expected finite coordinates, found NaN or infinity at point " +
      std::to_string(find.Point - *line) + " of line " +
      std::to_string(std::distance(offsets.begin(), line)));
  }
}
}

//------------------------------------------------------------------------------
int vtkTractogram::Recognize(
  const char* fileName, const std::function<bool(const std::string&)>& isOfKind)
{
  try
  {
    return fileName && isOfKind(fileName);
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
vtkTractogram::vtkTractogram(
  vtkPolyData* output, vtkDataArray* coordinates, const std::vector<vtkIdType>& offsets)
  : Output(output)
{
  RequireFinite(coordinates, offsets);
  coordinates->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "mm");
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);

  vtkNew<vtkIdTypeArray> ids;
  vtkNew<vtkIdTypeArray> ends;
  ends->InsertNextValue(0);
  for (std::size_t line = 0; line + 1 < offsets.size(); ++line)
  {
    if (offsets[line] < offsets[line + 1])
    {
      ids->InsertNextValue(static_cast<vtkIdType>(line));
      ends->InsertNextValue(offsets[line + 1]);
    }
  }
  this->LineNames.Take(vtkTrajectoryLines::IdName);
  vtkTrajectoryLines::SetLines(output, points, ends, ids);
  this->LineIds = ids;
}

//------------------------------------------------------------------------------
void vtkTractogram::AddPointArray(vtkDataArray* array)
{
  Add(array, this->Output->GetPointData(), this->PointNames);
}

//------------------------------------------------------------------------------
void vtkTractogram::AddLineArray(vtkDataArray* array)
{
  const vtkIdType count = this->LineIds->GetNumberOfTuples();
  if (count == array->GetNumberOfTuples())
  {
    Add(array, this->Output->GetCellData(), this->LineNames);
    return;
  }
  auto kept = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  kept->SetName(array->GetName());
  kept->SetNumberOfComponents(array->GetNumberOfComponents());
  kept->SetNumberOfTuples(count);
  for (vtkIdType line = 0; line < count; ++line)
  {
    kept->SetTuple(line, this->LineIds->GetValue(line), array);
  }
  Add(kept, this->Output->GetCellData(), this->LineNames);
}

//------------------------------------------------------------------------------
void vtkTractogram::AddFieldArray(vtkDataArray* array)
{
  Add(array, this->Output->GetFieldData(), this->FieldNames);
}

//------------------------------------------------------------------------------
void vtkTractogram::Add(vtkDataArray* array, vtkFieldData* data, vtkArrayNames& names)
{
  array->SetName(names.Take(array->GetName()).c_str());
  data->AddArray(array);
}

VTK_ABI_NAMESPACE_END
