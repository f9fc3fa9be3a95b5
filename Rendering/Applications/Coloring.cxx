// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Coloring.h"

#include "RenderError.h"

#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMapper.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <set>

namespace pellucid
{
namespace
{
constexpr int TableSize = 256;

// Nine colours of viridis, by S. van der Walt and N. Smith (2015, CC0): its lightness grows evenly.
constexpr double Viridis[9][3] = { { 0.267004, 0.004874, 0.329415 },
  { 0.278826, 0.175490, 0.483397 }, { 0.229739, 0.322361, 0.545706 },
  { 0.172719, 0.448791, 0.557885 }, { 0.127568, 0.566949, 0.550556 },
  { 0.157851, 0.683765, 0.501686 }, { 0.369214, 0.788888, 0.382914 },
  { 0.678489, 0.863742, 0.189503 }, { 0.993248, 0.906157, 0.143936 } };

//------------------------------------------------------------------------------
// Call visit(array, association) for every array of numbers that has a name.
template <typename Visitor>
void VisitArrays(const Drawable& drawable, const Visitor& visit)
{
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    for (vtkPolyData* leaf : drawable.GetLeaves())
    {
      vtkDataSetAttributes* attributes = leaf->GetAttributes(association);
      for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
      {
        vtkDataArray* array = attributes->GetArray(i);
        if (array && array->GetName())
        {
          visit(array, association);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// vtkDataObject::POINT or CELL, the points before the cells; nothing where there is no such array.
std::optional<int> FindAssociation(const Drawable& drawable, const std::string& name)
{
  std::optional<int> found;
  VisitArrays(drawable,
    [&](vtkDataArray* array, int association)
    { found = !found && name == array->GetName() ? association : found; });
  return found;
}

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
  VisitArrays(drawable,
    [&](vtkDataArray* array, int association)
    {
      for (vtkPolyData* leaf : drawable.GetLeaves())
      {
        vtkDataSetAttributes* attributes = leaf->GetAttributes(association);
        active = active.empty() && array == attributes->GetScalars() ? array->GetName() : active;
        first = first.empty() && array != attributes->GetNormals() ? array->GetName() : first;
      }
    });
  return active.empty() ? first : active;
}

//------------------------------------------------------------------------------
std::string ListArrays(const std::vector<Drawable>& drawables)
{
  std::set<std::string> arrays;
  for (const Drawable& drawable : drawables)
  {
    VisitArrays(drawable,
      [&arrays](vtkDataArray* array, int association)
      {
        arrays.insert(array->GetName() +
          std::string(association == vtkDataObject::POINT ? " (points)" : " (cells)"));
      });
  }
  std::string list;
  for (const std::string& array : arrays)
  {
    list += (list.empty() ? "" : ", ") + array;
  }
  return list.empty() ? "none" : list;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLookupTable> MakeTable(double minimum, double maximum)
{
  constexpr int colors = static_cast<int>(std::size(Viridis));
  vtkNew<vtkColorTransferFunction> function;
  function->SetColorSpaceToLab();
  for (int i = 0; i < colors; ++i)
  {
    const double share = static_cast<double>(i) / (colors - 1);
    function->AddRGBPoint(share, Viridis[i][0], Viridis[i][1], Viridis[i][2]);
  }
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(TableSize);
  for (int i = 0; i < TableSize; ++i)
  {
    double color[3];
    function->GetColor(static_cast<double>(i) / (TableSize - 1), color);
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  table->SetTableRange(minimum, maximum);
  table->SetVectorModeToMagnitude();
  return table;
}
}

//------------------------------------------------------------------------------
Coloring::Coloring(const std::vector<Drawable>& drawables, const std::string& name)
  : Name(name)
{
  for (auto drawable = drawables.begin(); this->Name.empty() && drawable != drawables.end();
       ++drawable)
  {
    this->Name = ChooseName(*drawable);
  }

  double minimum = std::numeric_limits<double>::max();
  double maximum = std::numeric_limits<double>::lowest();
  for (const Drawable& drawable : drawables)
  {
    VisitArrays(drawable,
      [&](vtkDataArray* array, int)
      {
        if (this->Name == array->GetName())
        {
          double range[2];
          array->GetFiniteRange(range, array->GetNumberOfComponents() > 1 ? -1 : 0);
          minimum = std::min(minimum, range[0]);
          maximum = std::max(maximum, range[1]);
        }
      });
  }
  if (!name.empty() && minimum > maximum)
  {
    throw RenderError("--color-by: there is no array '" + name + "' with numbers; there are " +
      ListArrays(drawables));
  }
  this->Table = MakeTable(minimum, maximum);
}

//------------------------------------------------------------------------------
void Coloring::Apply(vtkMapper* mapper, const Drawable& drawable) const
{
  const auto association = FindAssociation(drawable, this->Name);
  if (!association)
  {
    mapper->ScalarVisibilityOff();
    return;
  }
  mapper->SetScalarMode(*association == vtkDataObject::POINT ? VTK_SCALAR_MODE_USE_POINT_FIELD_DATA
                                                             : VTK_SCALAR_MODE_USE_CELL_FIELD_DATA);
  mapper->SelectColorArray(this->Name.c_str());
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(this->Table);
  mapper->UseLookupTableScalarRangeOn();
}
}
