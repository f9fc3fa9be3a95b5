// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Coloring.h"

#include "RenderError.h"
#include "RenderOptions.h"
#include "SceneArrays.h"

#include "vtkCellDataToPointData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMapper.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace pellucid
{
namespace
{
constexpr int TableSize = 256;
constexpr double MissingGray = 0.5;
constexpr double OutlierShare = 0.01;     // of the values, at either end of the range
constexpr vtkIdType SampleSize = 1000000; // values of an array that are looked at, about

// Cool to warm: K. Moreland, Diverging Color Maps for Scientific Visualization (2009). Both ends
// stay visible on dark and on light backgrounds.
constexpr double Cool[3] = { 0.230, 0.299, 0.754 };
constexpr double Warm[3] = { 0.706, 0.016, 0.150 };

//------------------------------------------------------------------------------
// The active scalars, or the first array other than normals; empty if there is none.
std::string ChooseName(const Drawable& drawable)
{
  if (!drawable.Speed.empty())
  {
    return drawable.Speed;
  }
  std::string first;
  std::string active;
  const auto leaves = drawable.GetLeaves();
  for (const SceneArray& array : GetArrays(drawable))
  {
    const auto isOneOf = [&](vtkDataArray* (vtkDataSetAttributes::*get)())
    {
      return std::any_of(leaves.begin(), leaves.end(),
        [&](vtkPolyData* leaf)
        {
          vtkDataArray* part = (leaf->GetAttributes(array.Association)->*get)();
          return part && std::count(array.Parts.begin(), array.Parts.end(), part) != 0;
        });
    };
    active = active.empty() && isOneOf(&vtkDataSetAttributes::GetScalars) ? array.Name : active;
    first = first.empty() && !isOneOf(&vtkDataSetAttributes::GetNormals) ? array.Name : first;
  }
  return active.empty() ? first : active;
}

//------------------------------------------------------------------------------
// Append finite values of the array, lengths in case of vectors; of a large array, some.
void Sample(vtkDataArray* array, std::vector<double>& values)
{
  const vtkIdType step = std::max<vtkIdType>(1, array->GetNumberOfTuples() / SampleSize);
  for (vtkIdType id = 0; id < array->GetNumberOfTuples(); id += step)
  {
    const double value = GetNumber(array, id);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
}

//------------------------------------------------------------------------------
// The value below which that share of the values lies; 0 of no values.
double GetQuantile(std::vector<double>& values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto position =
    values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), position, values.end());
  return *position;
}

//------------------------------------------------------------------------------
// From the smallest to the largest value of the array, less a few of either end that would
// otherwise take most of the colours.
NumberRange MeasureRange(const std::vector<Drawable>& drawables, const std::string& name)
{
  std::vector<double> values;
  for (const Drawable& drawable : drawables)
  {
    if (const auto array = FindArray(drawable, name))
    {
      for (vtkDataArray* part : array->Parts)
      {
        Sample(part, values);
      }
    }
  }
  return { GetQuantile(values, OutlierShare), GetQuantile(values, 1.0 - OutlierShare) };
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLookupTable> MakeTable(const NumberRange& range)
{
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToDiverging();
  function->AddRGBPoint(0.0, Cool[0], Cool[1], Cool[2]);
  function->AddRGBPoint(1.0, Warm[0], Warm[1], Warm[2]);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(TableSize);
  for (int i = 0; i < TableSize; ++i)
  {
    double color[3];
    function->GetColor(static_cast<double>(i) / (TableSize - 1), color);
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  table->SetTableRange(range.data());
  table->SetVectorModeToMagnitude();
  // VTK's own colour of missing values is a red like that of the greatest ones.
  table->SetNanColor(MissingGray, MissingGray, MissingGray, 1.0);
  table->BuildSpecialColors(); // a table of given colours is not built by itself
  return table;
}
}

//------------------------------------------------------------------------------
std::string ChooseColorArray(const std::vector<Drawable>& drawables)
{
  std::string name;
  for (auto drawable = drawables.begin(); name.empty() && drawable != drawables.end(); ++drawable)
  {
    name = ChooseName(*drawable);
  }
  return name;
}

//------------------------------------------------------------------------------
Coloring::Coloring(const std::vector<Drawable>& drawables, const RenderOptions& options)
  : Name(options.ColorBy)
{
  if (this->Name.empty())
  {
    this->Name = ChooseColorArray(drawables);
  }
  if (options.ColorRange && this->Name.empty())
  {
    throw RenderError("--color-range: there is no array of numbers to colour by");
  }
  this->Table =
    MakeTable(options.ColorRange ? *options.ColorRange : MeasureRange(drawables, this->Name));
}

//------------------------------------------------------------------------------
void Coloring::Apply(vtkMapper* mapper, const Drawable& drawable) const
{
  const auto array = FindArray(drawable, this->Name);
  if (!array)
  {
    mapper->ScalarVisibilityOff();
    return;
  }
  mapper->SetScalarMode(array->Association == vtkDataObject::POINT
      ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
      : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SelectColorArray(this->Name.c_str());
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(this->Table);
  mapper->UseLookupTableScalarRangeOn();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkUnsignedCharArray> Coloring::MapPoints(
  vtkPolyData* part, const Drawable& drawable) const
{
  vtkSmartPointer<vtkPolyData> points = part;
  const auto array = FindArray(drawable, this->Name);
  if (array && array->Association == vtkDataObject::CELL)
  {
    vtkNew<vtkCellDataToPointData> spread;
    spread->SetInputData(part);
    spread->Update();
    points = spread->GetPolyDataOutput();
  }
  vtkDataArray* values = array ? points->GetPointData()->GetArray(this->Name.c_str()) : nullptr;
  if (!values)
  {
    constexpr unsigned char white = 255;
    auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colors->SetNumberOfComponents(4);
    colors->SetNumberOfTuples(part->GetNumberOfPoints());
    colors->FillValue(white);
    return colors;
  }
  constexpr int length = -1;
  return vtk::TakeSmartPointer(this->Table->MapScalars(values, VTK_COLOR_MODE_MAP_SCALARS, length));
}
}
