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
#include <optional>   // for parameters
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
  std::string Family; // of one colour in the plot
  std::string Description;
  Geometry Form = Geometry::Triangles;

  /** Make the renderer, which has its actors, draw by this method. */
  std::function<void(vtkRenderer* renderer)> Prepare;

  /** What orders the family, so that a line through it means something; or none. */
  std::optional<double> Parameter{};

  /** Of a candidate, why it is not in the product; else empty. */
  std::string Reason{};

  /** Opacities follow from importance, so the picture is not that of the others. */
  bool HasOptimizedOpacities() const { return this->Form == Geometry::Segments; }

  /** What it draws of the scene: "cones", which are ray-cast as balls are, or "triangles". */
  std::string GetShape(const Scene& scene) const;

  /** Whether the method says anything of this scene that no other one does. */
  bool Suits(const Scene& scene) const;
};

/** The product, with which candidates are compared. */
constexpr const char* ProductName = "pellucid";

/** All of them, in the order of their families and their parameters. */
const std::vector<Method>& GetMethods();
}
}

#endif
