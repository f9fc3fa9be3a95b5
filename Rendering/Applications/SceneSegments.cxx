// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneSegments.h"

#include "CellKinds.h"
#include "SceneFilter.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectorySegments.h"

namespace pellucid
{
namespace
{
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
  FilterParts(drawables, PartsWithImportance(false), vtkNew<vtkTrajectorySegments>(), "Segments");
  FilterParts(drawables, PartsWithImportance(true), vtkNew<vtkSurfaceSegments>(), "Segments");
}
}
