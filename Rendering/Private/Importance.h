// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    Importance.h
 * @brief   What any number means as the importance of a point or fragment.
 */

#ifndef Importance_h
#define Importance_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellucid
{
/** Importance in [0,1]: what lies outside is moved to the nearer end, and NaN, a missing value, is
 * of no importance. */
template <typename Real>
Real ClampImportance(Real importance)
{
  if (importance > 0)
  {
    return importance < 1 ? importance : Real(1);
  }
  return 0;
}

/** So close to 1 nothing is missing to full importance: interpolation between points that have it
 * rounds to a little less, which a small exponent, or a great weight, would make much of. */
constexpr double LeastUnimportance = 1e-6;

/** What is missing to full importance, in [0,1]. */
template <typename Real>
Real GetUnimportance(Real importance)
{
  const Real unimportance = 1 - ClampImportance(importance);
  return unimportance > Real(LeastUnimportance) ? unimportance : Real(0);
}

/**
 * How importance follows from the values of an array, as vtkImportanceDrivenOpacity documents it.
 * Values that fall towards importance 1 count with the opposite sign. A shader needs the four
 * numbers alone: see glsl/vtkSurfaceImportanceVS.glsl.
 */
template <typename Real>
struct ImportanceRange
{
  ImportanceRange() = default;

  /** The values of importance 0 and 1. */
  explicit ImportanceRange(const double ends[2])
  {
    if (!std::isfinite(ends[0]) || !std::isfinite(ends[1]))
    {
      *this = ImportanceRange::None();
      return;
    }
    // Within them the width cannot overflow, nor its inverse be too small for a normal number.
    const double limit = std::numeric_limits<Real>::max() / 8;
    this->direction = ends[0] <= ends[1] ? Real(1) : Real(-1);
    this->first = this->direction * Real(std::clamp(ends[0], -limit, limit));
    this->last = this->direction * Real(std::clamp(ends[1], -limit, limit));
    this->scale = 1 / std::max(this->last - this->first, std::numeric_limits<Real>::min());
  }

  /** That of data without importance. */
  static ImportanceRange None()
  {
    ImportanceRange range;
    range.direction = 0;
    return range;
  }

  bool operator==(const ImportanceRange& other) const
  {
    return this->direction == other.direction && this->first == other.first &&
      this->last == other.last;
  }

  /** The importance in [0,1] of any number. */
  Real Map(Real value) const
  {
    const Real directed = this->direction * value;
    return directed >= this->last ? Real(1)
                                  : ClampImportance((directed - this->first) * this->scale);
  }

  Real direction = 1; ///< 1, -1, or 0: nothing is important
  ///@{
  /** In that direction: where importance begins to grow, and where it is 1. */
  Real first = 0;
  Real last = 1;
  ///@}
  Real scale = 1; ///< importance per value between the two; finite
};
}

#endif
