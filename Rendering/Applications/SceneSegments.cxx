// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneSegments.h"

#include "CellKinds.h"
#include "SceneFilter.h"

#include "vtkNew.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectorySegments.h"

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
std::vector<Drawable> SeparateSurfaces(const std::vector<Drawable>& drawables)
{
  std::vector<Drawable> result;
  for (const Drawable& drawable : drawables)
  {
    for (const bool areSurfaces : { false, true })
    {
      std::vector<vtkSmartPointer<vtkPolyData>> parts;
      for (vtkPolyData* part : drawable.GetLeaves())
      {
        const int own = GetKinds(part);
        if (areSurfaces ? (own & Surfaces) != 0 : own != Surfaces)
        {
          const bool isMixed = (own & Surfaces) && own != Surfaces;
          parts.push_back(isMixed ? KeepCells(part, areSurfaces ? Surfaces : Vertices | Lines)
                                  : vtkSmartPointer<vtkPolyData>(part));
        }
      }
      if (!parts.empty())
      {
        result.push_back(drawable);
        result.back().Data = JoinParts({ parts.begin(), parts.end() });
        result.back().IsSurface = areSurfaces;
      }
    }
  }
  return result;
}
}

//------------------------------------------------------------------------------
void AddSegments(std::vector<Drawable>& drawables)
{
  const auto has = [](int kinds)
  { return [kinds](vtkPolyData* part) { return (GetKinds(part) & kinds) != 0; }; };
  drawables = SeparateSurfaces(drawables);
  FilterParts(drawables, has(Vertices | Lines), vtkNew<vtkTrajectorySegments>(), "Segments");
  FilterParts(drawables, has(Surfaces), vtkNew<vtkSurfaceSegments>(), "Segments");
}
}
