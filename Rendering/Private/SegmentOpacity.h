// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    SegmentOpacity.h
 * @brief   From the opacities of fragments to smooth ones of segments and vertices.
 *
 * Guenther, Theisel and Gross 2017, section 5, steps 3 to 5: the least opacity of a segment's
 * fragments, smoothed over neighbouring segments, and interpolated between them. A segment without
 * a fragment has no opacity: it is undefined, which is NaN, and takes no part in what its
 * neighbours get.
 */

#ifndef SegmentOpacity_h
#define SegmentOpacity_h

#include "OpacitySolution.h"

#include <array>
#include <limits>
#include <utility>

namespace pellucid
{
/** The opacity of a segment without a fragment. */
template <typename Real>
constexpr Real UndefinedOpacity()
{
  return std::numeric_limits<Real>::quiet_NaN();
}

template <typename Real>
bool IsDefined(Real opacity)
{
  return !std::isnan(opacity);
}

/**
 * Lower the opacities of segments, undefined at first, to those of the fragments of one pixel, as
 * SolveOpacities() finds them. The minimum, not the mean: one fragment that hides something is
 * reason enough (section 6.5).
 */
template <typename Real>
void LowerSegmentOpacities(const std::vector<OpacityFragment<Real>>& list,
  const std::vector<Real>& opacities, std::vector<Real>& segments)
{
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    if (list[i].parameters)
    {
      Real& segment = segments[static_cast<std::size_t>(list[i].segment)];
      segment = std::fmin(segment, opacities[i]);
    }
  }
}

/** The neighbours of segment i are ids[offsets[i]] to ids[offsets[i + 1] - 1]: two or one along a
 * line, eight on a surface, none for a point. There is one offset more than there are segments. */
struct SegmentNeighbors
{
  std::vector<std::size_t> offsets{ 0 };
  std::vector<SegmentId> ids;
};

/**
 * Laplacian smoothing: `iterations` times, and for all segments at once,
 *
 *   a_i <- (1 - relaxation) a_i + relaxation * (mean of the defined neighbours' a_j)
 *
 * with the relaxation in (0,1]; the paper gives none. A segment without defined neighbours keeps
 * its opacity, an undefined one stays so.
 */
template <typename Real>
void SmoothOpacities(std::vector<Real>& opacities, const SegmentNeighbors& neighbors,
  int iterations, Real relaxation = Real(0.5))
{
  std::vector<Real> smooth(opacities);
  for (int iteration = 0; iteration < iterations; ++iteration)
  {
    for (std::size_t i = 0; i < opacities.size(); ++i)
    {
      Real sum = 0;
      int count = 0;
      for (std::size_t k = neighbors.offsets[i]; k < neighbors.offsets[i + 1]; ++k)
      {
        const Real neighbor = opacities[static_cast<std::size_t>(neighbors.ids[k])];
        sum += IsDefined(neighbor) ? neighbor : 0;
        count += IsDefined(neighbor);
      }
      smooth[i] =
        count == 0 ? opacities[i] : (1 - relaxation) * opacities[i] + relaxation * (sum / count);
    }
    std::swap(smooth, opacities);
  }
}

/**
 * The opacity at a vertex: the mean of `count` segments by their weights, over those that are
 * defined and whose weight is above 0; 1 if there is none.
 */
template <typename Real>
Real InterpolateOpacity(const std::vector<Real>& opacities, const SegmentId* segments,
  const Real* weights, std::size_t count)
{
  Real sum = 0;
  Real total = 0;
  for (std::size_t k = 0; k < count; ++k)
  {
    if (weights[k] > 0)
    {
      const Real opacity = opacities[static_cast<std::size_t>(segments[k])];
      sum += IsDefined(opacity) ? weights[k] * opacity : 0;
      total += IsDefined(opacity) ? weights[k] : 0;
    }
  }
  return total > 0 ? sum / total : 1;
}

/** The same on a line: between the centres of segment `base` and the next one, `weight` in [0,1)
 * of the way; with the weight 0 there need not be a next one. */
template <typename Real>
Real InterpolateOpacity(const std::vector<Real>& opacities, SegmentId base, Real weight)
{
  const std::array<SegmentId, 2> segments{ base, base + 1 };
  const std::array<Real, 2> weights{ 1 - weight, weight };
  return InterpolateOpacity(opacities, segments.data(), weights.data(), segments.size());
}
}

#endif
