// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    OcclusionAvoidance.h
 * @brief   View-dependent attributes of a pixel, and opacities that follow from them directly.
 *
 * Bandle 2016, sections 3.2 and 3.3.2: instead of an optimisation, the opacity of a fragment is
 * multiplied with a factor that follows from what else is in its pixel.
 */

#ifndef OcclusionAvoidance_h
#define OcclusionAvoidance_h

#include "Importance.h"
#include "RayIntersection.h"

#include <limits>
#include <vector>

namespace pellucid
{
/** A fragment as the attributes of its pixel see it. */
template <typename Real>
struct AttributeFragment
{
  /** Distance from the eye, in any unit that is linear in it where depths are smoothed. */
  Real depth = 0;
  /** Any number; see ClampImportance(). */
  Real importance = 0;
  /** Unit vector along a line; zero for what has no direction. */
  Vector3<Real> tangent{ Real(0) };
};

/** Importances that differ by no more than this are the same: between equals, rounding would decide
 * what hides what. */
constexpr double ImportanceTolerance = 1e-5;

/** So are a distance from the eye and a smoothed one that differ by no more than this part of it:
 * on a flat surface, where the mean of the distances around is the fragment's own, rounding would
 * decide. */
constexpr double DistanceTolerance = 1e-4;

/** What a pixel holds; all 0 where it holds nothing. */
template <typename Real>
struct PixelAttributes
{
  /** Number of fragments: C. */
  Real coverage = 0;
  /** Greatest importance, in [0,1]: M. */
  Real importance = 0;
  /** Depth of the fragment that has it, of the nearest one where several have: D. */
  Real depth = 0;
  /** V = 1 - |sum of the tangents| / their number, in [0,1]: 0 where all are parallel, and where
   * there is none. */
  Real directionalVariance = 0;
};

/** The attributes of a pixel with these fragments, in any order. */
template <typename Real>
PixelAttributes<Real> ComputePixelAttributes(const std::vector<AttributeFragment<Real>>& fragments)
{
  PixelAttributes<Real> pixel;
  Vector3<Real> sum(Real(0));
  Real directions = 0;
  for (const auto& fragment : fragments)
  {
    const Real importance = ClampImportance(fragment.importance);
    pixel.importance = std::max(pixel.importance, importance);
    pixel.coverage += 1;
    if (glm::dot(fragment.tangent, fragment.tangent) > 0)
    {
      sum += fragment.tangent;
      directions += 1;
    }
  }
  pixel.depth = fragments.empty() ? Real(0) : std::numeric_limits<Real>::infinity();
  for (const auto& fragment : fragments)
  {
    if (ClampImportance(fragment.importance) + Real(ImportanceTolerance) >= pixel.importance)
    {
      pixel.depth = std::min(pixel.depth, fragment.depth);
    }
  }
  if (directions > 0)
  {
    pixel.directionalVariance = std::max(Real(0), 1 - glm::length(sum) / directions);
  }
  return pixel;
}

/**
 * The attributes of the pixel in column x of row y, with the borders of what is important softened:
 * importance and depth of a pixel that has a fragment become their means over those of the 5 x 5
 * pixels around it that have one. Bandle 2016, section 3.2.1, also takes the empty ones into the
 * mean. `pixels` are the rows of an image one after the other, `width` pixels each.
 */
template <typename Real>
PixelAttributes<Real> SmoothPixelAttributes(
  const std::vector<PixelAttributes<Real>>& pixels, int width, int x, int y)
{
  constexpr int radius = 2;
  const int height = static_cast<int>(pixels.size() / width);
  const auto at = [width](int column, int row)
  { return static_cast<std::size_t>(row) * width + column; };
  PixelAttributes<Real> pixel = pixels[at(x, y)];
  if (!(pixel.coverage > 0))
  {
    return pixel;
  }
  pixel.importance = 0;
  pixel.depth = 0;
  Real count = 0;
  for (int row = std::max(0, y - radius); row <= std::min(height - 1, y + radius); ++row)
  {
    for (int column = std::max(0, x - radius); column <= std::min(width - 1, x + radius); ++column)
    {
      const auto& neighbor = pixels[at(column, row)];
      if (neighbor.coverage > 0)
      {
        pixel.importance += neighbor.importance;
        pixel.depth += neighbor.depth;
        count += 1;
      }
    }
  }
  pixel.importance /= count;
  pixel.depth /= count;
  return pixel;
}

/** The same for all pixels. */
template <typename Real>
void SmoothPixelAttributes(std::vector<PixelAttributes<Real>>& pixels, int width)
{
  const auto original = pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i)
  {
    pixels[i] = SmoothPixelAttributes(
      original, width, static_cast<int>(i % width), static_cast<int>(i / width));
  }
}

/** How a fragment's opacity follows from the attributes of its pixel. */
template <typename Real>
struct OcclusionAvoidance
{
  enum Modes
  {
    PENALTY,  // what lies in front of the most important fragment gets the penalty
    WEIGHTING // every fragment gets a factor that falls with the weighted attributes
  };

  Modes mode = PENALTY;
  /** Factor in [0,1] on what lies in front; 0 removes it. */
  Real penalty = Real(0.25);

  ///@{
  /** Weights, 0 or more, of importance (m), coverage (c), directional variance (v), and of lying in
   * front (d). The sources name no defaults. */
  Real importanceWeight = 0;
  Real coverageWeight = 0;
  Real varianceWeight = 0;
  Real depthWeight = 0;
  ///@}

  /** Exponent, above 0, of the fragment's own importance. */
  Real lambda = 1;
  /** Factor in [0,1] on every opacity, in both modes. */
  Real globalOpacity = 1;
  /** Whether the attributes are those that SmoothPixelAttributes() gives. */
  bool smoothAttributes = false;

  /** The factor in [0,1] on the opacity of a fragment. A weighted one is (eqs. 3.2 and 3.3)
   * 1 / (1 + (1 - g^lambda) (m M + c C + v V + d [in front])), and in front is what is nearer than
   * D and less important than M. The source asks for the first only, which is the same for sharp
   * attributes; but a smoothed D lies behind the nearest part of what is important itself. */
  Real Factor(Real depth, Real importance, const PixelAttributes<Real>& pixel) const
  {
    const Real own = ClampImportance(importance);
    const Real margin = this->smoothAttributes ? Real(1 + DistanceTolerance) : Real(1);
    const bool inFront =
      depth * margin < pixel.depth && own + Real(ImportanceTolerance) < pixel.importance;
    if (this->mode == PENALTY)
    {
      return this->globalOpacity * (inFront ? this->penalty : Real(1));
    }
    const Real occlusion = this->importanceWeight * pixel.importance +
      this->coverageWeight * pixel.coverage + this->varianceWeight * pixel.directionalVariance +
      (inFront ? this->depthWeight : Real(0));
    const Real unimportance = 1 - std::pow(own, this->lambda);
    return this->globalOpacity / (1 + unimportance * occlusion);
  }
};
}

#endif
