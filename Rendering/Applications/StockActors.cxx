// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "StockActors.h"

#include "CellKinds.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace pellucid
{
namespace
{
constexpr int TubeSides = 8;
constexpr const char* FadedColors = "pellucid faded colors";

//------------------------------------------------------------------------------
// The part with a point array of colours whose opacity is the importance.
vtkSmartPointer<vtkPolyData> AddFadedColors(
  vtkPolyData* part, const Drawable& drawable, const Coloring& colors)
{
  const auto faded = colors.MapPoints(part, drawable);
  vtkDataArray* importance = part->GetPointData()->GetArray(ImportanceArray);
  for (vtkIdType id = 0; id < faded->GetNumberOfTuples(); ++id)
  {
    faded->SetTypedComponent(
      id, 3, static_cast<unsigned char>(std::lround(255.0 * importance->GetComponent(id, 0))));
  }
  faded->SetName(FadedColors);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(part);
  result->GetPointData()->AddArray(faded);
  return result;
}

//------------------------------------------------------------------------------
void ApplyFadedColors(vtkMapper* mapper)
{
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(FadedColors);
  mapper->SetColorModeToDirectScalars();
}
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkActor>> MakeStockActors(
  vtkPolyData* part, double radius, const Drawable& drawable, const Coloring& colors)
{
  vtkSmartPointer<vtkPolyData> colored = part;
  if (drawable.IsFaded)
  {
    colored = AddFadedColors(part, drawable, colors);
  }
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(colored);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(TubeSides);
  tubes->CappingOn();
  tubes->Update();
  const auto others = KeepCells(colored, Vertices | Surfaces);

  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (vtkPolyData* geometry : { tubes->GetOutput(), others.Get() })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(geometry);
    if (drawable.IsFaded)
    {
      ApplyFadedColors(mapper);
    }
    else
    {
      colors.Apply(mapper, drawable);
    }
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetBackfaceCulling(geometry != others);
    actors.push_back(actor);
  }
  return actors;
}
}
