// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What a method should show of a scene.
 */

#ifndef Expectation_h
#define Expectation_h

#include "PictureError.h"
#include "Scenes.h"

#include <array>    // for sizes
#include <optional> // for the picture

class vtkRenderer;

namespace pellucid
{
namespace benchmark
{
/** The first view of a scene; methods that draw the same form share it. */
struct Expectation
{
  std::optional<ExpectedPicture> Picture;
  vtkIdType Fragments = 0; // translucent ones
  vtkIdType LongestList = 0;
};

/** By vtkReferenceRenderer: what the renderer should show in a window of that size. */
Expectation DrawExpectation(vtkRenderer* renderer, const std::array<int, 2>& size);

/** Without a picture, by vtkExactTransparencyPass. */
Expectation CountFragments(
  Scene& scene, Geometry form, double opacity, const std::array<int, 2>& size);
}
}

#endif
