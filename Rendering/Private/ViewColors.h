// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    ViewColors.h
 * @brief   Colours of the views of vtkExactTransparencyPass; glsl/vtkPictureViewDec.glsl is the
 * same.
 */

#ifndef ViewColors_h
#define ViewColors_h

#include "RayIntersection.h"

#include <cstdint>

namespace pellucid
{
/** Black at 0, red at 1/3, yellow at 2/3, white at 1. */
template <typename Real>
Vector3<Real> HotColor(Real value)
{
  return glm::clamp(Real(3) * value - Vector3<Real>(0, 1, 2), Real(0), Real(1));
}

/** Black for segment 0, which stands for what takes no part; otherwise a bright colour. */
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
  const Vector3<Real> bytes(static_cast<Real>(hash & 255u), static_cast<Real>(hash >> 8 & 255u),
    static_cast<Real>(hash >> 16 & 255u));
  return Real(0.2) + Real(0.8) * bytes / Real(255);
}
}

#endif
