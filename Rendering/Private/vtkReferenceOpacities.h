// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkReferenceOpacities.h
 * @brief   What the opacities of a scene follow from, in double precision.
 */

#ifndef vtkReferenceOpacities_h
#define vtkReferenceOpacities_h

#include "RayCasting.h"
#include "vtkOptimizedScene.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * Optimised opacities of all segments, then of all corners, as vtkOptimizedScene numbers them:
 * those of the fragments in 1/gatherScale of the width and height of the picture that `caster`
 * makes, smoothed and interpolated; NaN where nothing is seen. The opaque surface is that of one
 * pixel of the picture for each pixel of the small one, the middle of those that it covers.
 */
std::vector<double> vtkSolveReferenceOpacities(
  const pellucid::RayCaster<double>& caster, const vtkOptimizedScene& scene, int gatherScale);

/** The smoothed attributes of all pixels, row by row, with distances along the view direction;
 * empty where no surface needs them. */
std::vector<pellucid::PixelAttributes<double>> vtkSmoothReferenceAttributes(
  const pellucid::RayCaster<double>& caster);

VTK_ABI_NAMESPACE_END
#endif
