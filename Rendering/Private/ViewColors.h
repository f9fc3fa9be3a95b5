// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    ViewColors.h
 * @brief   Colours of the views into a picture, vtkExactTransparencyPass::Views.
 */

#ifndef ViewColors_h
#define ViewColors_h

#include "RayIntersection.h"

#include <cstdint>

namespace pellucid
{
/** The colour of a number in [0,1]: black, red, yellow, white. */
template <typename Real>
Vector3<Real> HotColor(Real number)
{
  return glm::clamp(3 * number - Vector3<Real>(0, 1, 2), Real(0), Real(1));
}

/** A colour that tells a segment from its neighbours: a hash of its number in vtkOptimizedScene;
 * black for number 0, what has no segment. */
template <typename Real>
Vector3<Real> SegmentColor(std::uint32_t segment)
{
  if (segment == 0)
  {
    return Vector3<Real>(Real(0));
  }
  std::uint32_t hash = segment * 2654435769u;
  hash ^= hash >> 16;
  hash *= 2246822519u;
  hash ^= hash >> 13;
  const Vector3<Real> bytes(hash & 255u, (hash >> 8) & 255u, (hash >> 16) & 255u);
  return Real(0.2) + Real(0.8) * bytes / Real(255);
}
}

#endif
