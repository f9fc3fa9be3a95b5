// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    FragmentCompositing.h
 * @brief   The exact order of the fragments of a pixel, and what they look like together.
 */

#ifndef FragmentCompositing_h
#define FragmentCompositing_h

#include "RayIntersection.h"
#include "SegmentOpacity.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace pellucid
{
/** Where a fragment lies among the segments whose opacities are optimised. */
template <typename Real>
struct SegmentPlace
{
  OpacityFragment<Real> nearest;        ///< its importance, and the segment that it belongs to
  std::array<SegmentId, 3> opacities{}; ///< between which it lies
  std::array<Real, 3> shares{};         ///< of each of these; 0: not of it
};

/** One surface in one pixel: window depth in [0,1], straight colour and alpha in [0,1]. */
template <typename Real>
struct Fragment
{
  Real depth = 1;
  Vector4<Real> color{ Real(0) };
  SegmentPlace<Real> place{};
};

/**
 * Front to back; of equal depths the less opaque one is in front, then the one with less red, green
 * and blue, then the less important one. Fragments that compare equal are identical, so that the
 * order in which they were found never shows.
 */
template <typename Real>
bool operator<(const Fragment<Real>& a, const Fragment<Real>& b)
{
  return std::tie(a.depth, a.color.a, a.color.r, a.color.g, a.color.b, a.place.nearest.importance,
           a.place.nearest.segment) < std::tie(b.depth, b.color.a, b.color.r, b.color.g, b.color.b,
                                        b.place.nearest.importance, b.place.nearest.segment);
}

/** The fragments of one pixel. */
template <typename Real>
class PixelFragments
{
public:
  /** Forget all fragments, keeping the memory. */
  void Clear()
  {
    this->Translucent.clear();
    this->Opaque = Fragment<Real>();
    this->HasOpaque = false;
  }

  /** Add a surface; what is fully transparent leaves no trace, as VTK's shaders discard it. */
  void Add(const Fragment<Real>& fragment, bool opaque)
  {
    if (!opaque)
    {
      if (fragment.color.a > 0)
      {
        this->Translucent.push_back(fragment);
      }
    }
    else if (!this->HasOpaque || fragment < this->Opaque)
    {
      this->Opaque = fragment;
      this->HasOpaque = true;
    }
  }

  /** Drop what lies behind the nearest opaque surface and bring the rest into order, front first.
   * A fragment at the depth of the opaque surface is in front of it. */
  void Sort()
  {
    auto& list = this->Translucent;
    if (this->HasOpaque)
    {
      list.erase(std::remove_if(list.begin(), list.end(),
                   [this](const Fragment<Real>& f) { return f.depth > this->Opaque.depth; }),
        list.end());
    }
    std::sort(list.begin(), list.end());
  }

  /** The translucent fragments; after Sort(), those that are visible, front to back. */
  const std::vector<Fragment<Real>>& GetTranslucent() const { return this->Translucent; }

  /**
   * Blend the sorted fragments over the opaque surface, or over `background` where there is none
   * (Porter and Duff 1984, "over"). The background, like the result, is what a framebuffer holds:
   * a colour that is taken as it is, and the alpha beside it. `opacities` are those of segments and
   * corners, as SegmentPlace counts them, and multiply; empty where nothing is optimised.
   */
  Vector4<Real> Composite(
    const Vector4<Real>& background, const std::vector<Real>& opacities = {}) const
  {
    Vector3<Real> color(Real(0));
    Real transmittance = 1;
    for (const auto& fragment : this->Translucent)
    {
      const SegmentPlace<Real>& place = fragment.place;
      const Real alpha = fragment.color.a *
        (place.nearest.parameters && !opacities.empty()
            ? InterpolateOpacity(
                opacities, place.opacities.data(), place.shares.data(), place.shares.size())
            : Real(1));
      color += transmittance * alpha * Vector3<Real>(fragment.color);
      transmittance *= 1 - alpha;
    }
    const Vector4<Real> behind =
      this->HasOpaque ? Vector4<Real>(Vector3<Real>(this->Opaque.color), Real(1)) : background;
    return Vector4<Real>(color, 1 - transmittance) + transmittance * behind;
  }

private:
  std::vector<Fragment<Real>> Translucent;
  Fragment<Real> Opaque;
  bool HasOpaque = false;
};
}

#endif
