// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Angles between vectors, fast enough for every point of 10^7. Private to the module.
 */

#ifndef vtkVectorAngle_h
#define vtkVectorAngle_h

#include "vtkABINamespace.h"
#include "vtkMath.h"

#include <algorithm> // for the range reduction
#include <cmath>     // for signs
#include <limits>    // for the smallest number

VTK_ABI_NAMESPACE_BEGIN

/**
 * std::atan2(y, x) with a relative error below 3e-9 and without branches; 0 if both are 0, NaN if
 * one is, and not defined for infinite arguments.
 *
 * The quotient is reduced to r in [0, 1]; atan(r) / r is the polynomial of degree 9 in r^2 with the
 * least greatest relative error, 2.4e-9, found by Remez' algorithm.
 */
inline double vtkFastAtan2(double y, double x)
{
  const double absX = std::abs(x);
  const double absY = std::abs(y);
  const double small = std::min(absX, absY);
  const double large = std::max(absX, absY);
  const double ratio = small / std::max(large, std::numeric_limits<double>::min());
  const double square = ratio * ratio;
  double series = -0.0017539301625394998;
  series = series * square + 0.010726944164809765;
  series = series * square - 0.030804597472136257;
  series = series * square + 0.0575521025628845;
  series = series * square - 0.08377315494739714;
  series = series * square + 0.10942030685932563;
  series = series * square - 0.14261933110140482;
  series = series * square + 0.19998266041947926;
  series = series * square - 0.3333328364171018;
  series = series * square + 0.9999999976306287;
  const double first = series * ratio;
  const double second = absY > absX ? vtkMath::Pi() / 2.0 - first : first;
  const double angle = x < 0.0 ? vtkMath::Pi() - second : second;
  return std::copysign(angle, y) + (x - x) + (y - y);
}

/** Scales a vector with components below 1e-60 by a power of two, which leaves the digits as they
 * are, so that fourth powers do not underflow. */
inline void vtkScaleSmallVector(double& x, double& y, double& z)
{
  const double largest = std::max(std::max(std::abs(x), std::abs(y)), std::abs(z));
  const double scale = largest < 0x1p-200 ? 0x1p400 : 1.0;
  x *= scale;
  y *= scale;
  z *= scale;
}

/** The angle, in [0, pi], between a and b, of components up to 1e75; 0 if one of them has no
 * length. Unlike the inverse cosine, which loses half the digits near 0 and pi, as exact for small
 * angles as for others. */
inline double vtkVectorAngle(double ax, double ay, double az, double bx, double by, double bz)
{
  vtkScaleSmallVector(ax, ay, az);
  vtkScaleSmallVector(bx, by, bz);
  const double cx = ay * bz - az * by;
  const double cy = az * bx - ax * bz;
  const double cz = ax * by - ay * bx;
  return vtkFastAtan2(std::sqrt(cx * cx + cy * cy + cz * cz), ax * bx + ay * by + az * bz);
}

VTK_ABI_NAMESPACE_END
#endif
