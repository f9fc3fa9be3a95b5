// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The ways to draw translucent geometry that are compared.
 */

#ifndef Methods_h
#define Methods_h

#include "Scenes.h"

#include <functional> // for what makes a method
#include <string>     // for names
#include <vector>     // for the list

class vtkRenderer;

namespace pellucid
{
namespace benchmark
{
struct Method
{
  std::string Name;
  std::string Family; // of one line in the plot
  std::string Description;
  Geometry Form = Geometry::Triangles;

  /** Make the renderer, which has its actors, draw by this method. */
  std::function<void(vtkRenderer* renderer)> Prepare;

  /** Opacities follow from importance, so the picture is not that of the others. */
  bool HasOptimizedOpacities() const { return this->Form == Geometry::Segments; }

  /** Whether the method says anything of this scene that no other one does. */
  bool Suits(const Scene& scene) const;
};

/** All of them: VTK's, those of the product, and candidates for it. */
const std::vector<Method>& GetMethods();
}
}

#endif
