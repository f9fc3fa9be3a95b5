// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    OpacitySolution.h
 * @brief   The opacities that clear the view of the important fragments of one pixel.
 *
 * Decoupled opacity optimisation (Guenther, Theisel and Gross 2017, section 4.2): the opacities of
 * the fragments i = 1..n of a pixel, nearest first, minimise
 *
 *   E = sum_i [ (alpha_i - 1)^2
 *             + q sum_{j>i} (alpha_i (1 - g_i)^lambda g_j)^2      what hides important fragments
 *             + r sum_{j<i} (alpha_i (1 - g_i)^lambda g_j)^2 ] / 2     what lies behind them
 *
 * with the importance g_i in [0,1]. No term joins two unknowns, so that each has its own closed
 * form (eq. 9, p = 1) and q, r and lambda may differ from object to object: those that count are
 * those of the fragment's own object.
 */

#ifndef OpacitySolution_h
#define OpacitySolution_h

#include "Importance.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pellucid
{
/** Index of a segment of any object: unique in the scene, 0 or more. */
using SegmentId = std::int64_t;

/** How the opacities of an object are found; all finite. */
template <typename Real>
struct OpacityParameters
{
  /** Weight, 0 or more, of hiding important fragments. */
  Real q = 0;
  /** Weight, 0 or more, of lying behind important fragments. */
  Real r = 0;
  /** Emphasis of the important, above 0. */
  Real lambda = 1;
  /**
   * Whether a fragment is skipped when the one directly in front of it in the pixel's list, of
   * whatever object and skipped itself or not, has the same segment. What is skipped weighs
   * nothing and is not solved. With a fragment of something else between the two, both count.
   */
  bool skipSelfOcclusion = false;
};

/** One fragment of a pixel. */
template <typename Real>
struct OpacityFragment
{
  /** Any number; see ClampImportance(). */
  Real importance = 0;
  SegmentId segment = -1;
  /** Those of its object, or null when the object takes no part: its fragments are of no
   * importance to others and stay as they are. */
  const OpacityParameters<Real>* parameters = nullptr;
};

/** Whether the fragment at `index` of a list is skipped as self-occlusion. */
template <typename Real>
bool IsSelfOcclusion(const std::vector<OpacityFragment<Real>>& list, std::size_t index)
{
  const auto& fragment = list[index];
  return fragment.parameters && fragment.parameters->skipSelfOcclusion && index > 0 &&
    list[index - 1].segment == fragment.segment;
}

/**
 * The optimal opacity, in [0,1], of each fragment of a list sorted front to back; 1 for those that
 * are skipped or take no part. Two sweeps, so that no sum is ever found by subtraction: Algorithm 1
 * of the paper cancels.
 */
template <typename Real>
void SolveOpacities(const std::vector<OpacityFragment<Real>>& list, std::vector<Real>& opacities)
{
  const auto counts = [&list](std::size_t i)
  { return list[i].parameters && !IsSelfOcclusion(list, i); };
  const auto square = [&list](std::size_t i)
  {
    const Real importance = ClampImportance(list[i].importance);
    return importance * importance;
  };

  opacities.assign(list.size(), Real(1));
  Real behind = 0;
  for (std::size_t i = list.size(); i-- > 0;)
  {
    if (counts(i))
    {
      opacities[i] = behind;
      behind += square(i);
    }
  }
  Real inFront = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    if (counts(i))
    {
      const auto& parameters = *list[i].parameters;
      const Real unimportance = GetUnimportance(list[i].importance);
      const Real weight = std::pow(unimportance, 2 * parameters.lambda);
      const Real energy = parameters.r * inFront + parameters.q * opacities[i];
      opacities[i] = weight > 0 ? 1 / (1 + weight * energy) : Real(1);
      inFront += square(i);
    }
  }
}
}

#endif
