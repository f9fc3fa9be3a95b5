// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The scene as VTK without Pellucid draws it: lines as tubes made of triangles.
 */

#ifndef StockActors_h
#define StockActors_h

#include "Coloring.h"
#include "Drawables.h"

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <vector> // for the actors

namespace pellucid
{
/**
 * Actors of one part of a drawable: its lines as tubes of eight sides without inner walls, so that
 * the layers are those of a vtkTrajectoryMapper, and everything else as it is. Where importance
 * fades the drawable, the colours of its points get it as their opacity, rounded to 1/255.
 */
std::vector<vtkSmartPointer<vtkActor>> MakeStockActors(
  vtkPolyData* part, double radius, const Drawable& drawable, const Coloring& colors);
}

#endif
