// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkReferenceSweep.h
 * @brief   Casts all pixels of a scene with all threads.
 */

#ifndef vtkReferenceSweep_h
#define vtkReferenceSweep_h

#include "RayCasting.h"

#include "vtkABINamespace.h"   // for the namespace macros
#include "vtkSMPThreadLocal.h" // for the fragments of a thread
#include "vtkSMPTools.h"       // for the threads

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/** Calls visit(x, y, fragments) for each pixel, in any order and from several threads; the visitor
 * may change the fragments. */
template <typename Visit>
void vtkForEachReferencePixel(const pellucid::RayCaster<double>& caster, Visit&& visit)
{
  vtkSMPThreadLocal<std::vector<pellucid::PixelFragments<double>>> localPixels;
  vtkSMPTools::For(0, caster.GetNumberOfTiles(), 8,
    [&](vtkIdType begin, vtkIdType end)
    {
      auto& pixels = localPixels.Local();
      for (int tile = static_cast<int>(begin); tile < end; ++tile)
      {
        const auto area = caster.GetTile(tile);
        caster.Cast(tile, area, pixels);
        auto pixel = pixels.begin();
        for (int y = area.y0; y < area.y1; ++y)
        {
          for (int x = area.x0; x < area.x1; ++x, ++pixel)
          {
            visit(x, y, *pixel);
          }
        }
      }
    });
}

VTK_ABI_NAMESPACE_END
#endif
