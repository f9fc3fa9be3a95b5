// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The scene of a picture: actors, background and camera in a renderer.
 */

#ifndef RenderScene_h
#define RenderScene_h

#include "Coloring.h"
#include "Drawables.h"
#include "RenderOptions.h"

#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace pellucid
{
/** What is drawn, without how. */
struct Scene
{
  std::vector<Drawable> Drawables;
  Coloring Colors;
};

/**
 * A renderer of the scene for a picture of width / height = `aspect`. With Method::Pellucid lines
 * and points are drawn by vtkTrajectoryMapper; otherwise lines are tubes of eight sides and of
 * the same radius, and opacities follow from importance only where it is a factor.
 */
vtkSmartPointer<vtkRenderer> MakeRenderer(
  const Scene& scene, const RenderOptions& options, Method method, double aspect);

/**
 * Give the actors of such a renderer, made with Method::Pellucid, the radius, opacity and lighting
 * of the options, and parameters of the rule that the scene was made for.
 */
void SetAppearance(vtkRenderer* renderer, const Scene& scene, const RenderOptions& options);
}

#endif
