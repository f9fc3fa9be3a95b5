// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkReferenceOpacities.h
 * @brief   The optimised opacities of a scene in double precision.
 */

#ifndef vtkReferenceOpacities_h
#define vtkReferenceOpacities_h

#include "RayCasting.h"
#include "vtkOptimizedScene.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/**
 * Opacities of all segments, then of all corners, as vtkOptimizedScene numbers them: those of the
 * fragments that `caster` finds, smoothed and interpolated; NaN where nothing is seen.
 */
std::vector<double> vtkSolveReferenceOpacities(
  const pellucid::RayCaster<double>& caster, const vtkOptimizedScene& scene);

VTK_ABI_NAMESPACE_END
#endif
