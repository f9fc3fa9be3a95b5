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
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
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
  catch (const vtkTrajectoryFileError&)
  {
    return 0;
  }
}

//------------------------------------------------------------------------------
void vtkTractogram::SetLines(
  vtkPolyData* output, vtkDataArray* coordinates, const std::vector<vtkIdType>& offsets)
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
  vtkTrajectoryLines::SetLines(output, points, ends, ids);
}

//------------------------------------------------------------------------------
void vtkTractogram::AddLineArray(vtkPolyData* output, vtkDataArray* array)
{
  auto* ids =
    vtkIdTypeArray::SafeDownCast(output->GetCellData()->GetArray(vtkTrajectoryLines::IdName));
  const vtkIdType count = ids->GetNumberOfTuples();
  if (count == array->GetNumberOfTuples())
  {
    AddArray(output->GetCellData(), array);
    return;
  }
  auto kept = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  kept->SetName(array->GetName());
  kept->SetNumberOfComponents(array->GetNumberOfComponents());
  kept->SetNumberOfTuples(count);
  for (vtkIdType line = 0; line < count; ++line)
  {
    kept->SetTuple(line, ids->GetValue(line), array);
  }
  AddArray(output->GetCellData(), kept);
}

//------------------------------------------------------------------------------
void vtkTractogram::AddArray(vtkFieldData* data, vtkDataArray* array)
{
  const std::string name = array->GetName();
  for (int number = 2; data->HasArray(array->GetName()); ++number)
  {
    array->SetName((name + "_" + std::to_string(number)).c_str());
  }
  data->AddArray(array);
}

VTK_ABI_NAMESPACE_END
