// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryColors.h"

#include "vtkFloatArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// What vtkAbstractMapper::GetAbstractScalars reports of an array.
enum ArrayKind
{
  PointArray = 0,
  CellArray = 1,
  FieldArray = 2
};

// Where VTK's colour map holds the colour of NaN.
constexpr std::array<float, 2> NanCoordinate{ { 0.5f, 1.0f } };

// One value of an 8-bit colour array with 1 to 4 components, as RGBA.
std::array<unsigned char, 4> GetColor(vtkUnsignedCharArray* colors, vtkIdType tuple)
{
  const int components = colors->GetNumberOfComponents();
  const unsigned char* value = colors->GetPointer(tuple * components);
  const bool gray = components < 3;
  return { { value[0], value[gray ? 0 : 1], value[gray ? 0 : 2],
    components == 2     ? value[1]
      : components == 4 ? value[3]
                        : static_cast<unsigned char>(255) } };
}
}

//------------------------------------------------------------------------------
void vtkTrajectoryColors::Map(
  vtkMapper* mapper, const vtkTrajectoryNodes& nodes, const std::array<unsigned char, 4>& plain)
{
  *this = vtkTrajectoryColors();
  const auto& runs = nodes.GetRuns();
  const std::size_t count = nodes.GetNodes().size();
  std::size_t colored = 0;
  for (std::size_t first = 0, last = 0; first < runs.size(); first = last)
  {
    last = std::find_if(runs.begin() + first, runs.end(),
             [&](const auto& run) { return run.Leaf != runs[first].Leaf; }) -
      runs.begin();
    vtkPolyData* data = nodes.GetLeaves()[runs[first].Leaf].Data;
    int kind = PointArray;
    // The mapper's arrays are those of one data set: without this it may return the last one's.
    mapper->ClearColorArrays();
    vtkUnsignedCharArray* colors = mapper->MapScalars(data, 1.0, kind);
    vtkFloatArray* coordinates = mapper->GetColorCoordinates();
    if (!colors && !coordinates)
    {
      continue;
    }
    if (colors && this->Direct.empty())
    {
      this->Direct.reserve(4 * count);
      for (std::size_t i = 0; i < count; ++i)
      {
        this->Direct.insert(this->Direct.end(), plain.begin(), plain.end());
      }
    }
    if (coordinates && this->Coordinates.empty())
    {
      this->Coordinates.reserve(2 * count);
      for (std::size_t i = 0; i < count; ++i)
      {
        this->Coordinates.insert(
          this->Coordinates.end(), NanCoordinate.begin(), NanCoordinate.end());
      }
      this->ColorMap = mapper->GetColorTextureMap();
    }

    const vtkIdType end = last < runs.size() ? runs[last].FirstNode : nodes.GetNumberOfNodes();
    std::size_t run = first;
    for (vtkIdType node = runs[first].FirstNode; node < end; ++node)
    {
      run += run + 1 < last && runs[run + 1].FirstNode == node ? 1 : 0;
      vtkIdType tuple = kind == PointArray ? nodes.GetPointIds()[node] : runs[run].Cell;
      if (kind == FieldArray && mapper->GetFieldDataTupleId() >= 0)
      {
        tuple = mapper->GetFieldDataTupleId();
      }
      if (colors && tuple < colors->GetNumberOfTuples())
      {
        const auto color = GetColor(colors, tuple);
        std::copy(color.begin(), color.end(), this->Direct.begin() + 4 * node);
        ++colored;
      }
      if (coordinates && tuple < coordinates->GetNumberOfTuples())
      {
        coordinates->GetTypedTuple(tuple, this->Coordinates.data() + 2 * node);
      }
    }
  }
  mapper->ClearColorArrays();
  if (!this->Coordinates.empty())
  {
    // One texture serves all leaves or none; a direct colour of some leaf does not fit in.
    this->Direct.clear();
  }
  this->UsesPlain = !this->Direct.empty() && colored < count;
}

VTK_ABI_NAMESPACE_END
