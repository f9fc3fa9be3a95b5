// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneSegments.h"

#include "CellKinds.h"
#include "SceneFilter.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectorySegments.h"

#include <algorithm>
#include <cmath>

namespace pellucid
{
namespace
{
constexpr double MostSegments = 20000.0; // of lines, about
constexpr double SegmentsAcross = 128.0; // some ten pixels each: smoothing needs such as show

//------------------------------------------------------------------------------
void SeparateSurfaces(Drawable& drawable)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (vtkPolyData* part : drawable.GetLeaves())
  {
    const int kinds = GetKinds(part);
    if ((kinds & Surfaces) && kinds != Surfaces)
    {
      parts.push_back(KeepCells(part, Vertices | Lines));
      parts.push_back(KeepCells(part, Surfaces));
    }
    else
    {
      parts.push_back(part);
    }
  }
  drawable.Data = JoinParts({ parts.begin(), parts.end() });
}

//------------------------------------------------------------------------------
PartTest PartsWithImportance(bool areSurfaces)
{
  return [areSurfaces](vtkPolyData* part)
  {
    const int kinds = GetKinds(part);
    return part->GetPointData()->HasArray(ImportanceArray) &&
      (areSurfaces ? kinds == Surfaces : (kinds & (Vertices | Lines)) != 0);
  };
}

//------------------------------------------------------------------------------
// Of the lines; those with a missing coordinate do not count.
double MeasureLength(vtkPolyData* part)
{
  double total = 0.0;
  const auto iterator = vtk::TakeSmartPointer(part->GetLines()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* ids;
    iterator->GetCurrentCell(count, ids);
    double length = 0.0;
    for (vtkIdType i = 1; i < count; ++i)
    {
      double ends[2][3];
      part->GetPoint(ids[i - 1], ends[0]);
      part->GetPoint(ids[i], ends[1]);
      length += std::sqrt(vtkMath::Distance2BetweenPoints(ends[0], ends[1]));
    }
    total += std::isfinite(length) ? length : 0.0;
  }
  return total;
}

//------------------------------------------------------------------------------
// World units; 0 without lines.
double ChooseSegmentLength(const std::vector<Drawable>& drawables, const PartTest& takesPart)
{
  double length = 0.0;
  vtkBoundingBox box;
  for (const Drawable& drawable : drawables)
  {
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      if (takesPart(part))
      {
        length += MeasureLength(part);
        box.AddBounds(part->GetBounds());
      }
    }
  }
  return length > 0.0 ? std::max(length / MostSegments, box.GetDiagonalLength() / SegmentsAcross)
                      : 0.0;
}
}

//------------------------------------------------------------------------------
void AddSegments(std::vector<Drawable>& drawables)
{
  for (Drawable& drawable : drawables)
  {
    if (drawable.HasImportance)
    {
      SeparateSurfaces(drawable);
    }
  }
  vtkNew<vtkTrajectorySegments> divideLines;
  divideLines->SetSegmentLength(ChooseSegmentLength(drawables, PartsWithImportance(false)));
  FilterParts(drawables, PartsWithImportance(false), divideLines, "Segments");
  FilterParts(drawables, PartsWithImportance(true), vtkNew<vtkSurfaceSegments>(), "Segments");
}
}
