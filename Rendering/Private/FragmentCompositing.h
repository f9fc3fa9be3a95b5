// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    FragmentCompositing.h
 * @brief   The exact order of the fragments of a pixel, how they fade, and what they look like
 *          together.
 */

#ifndef FragmentCompositing_h
#define FragmentCompositing_h

#include "OcclusionAvoidance.h"
#include "RayIntersection.h"
#include "SegmentOpacity.h"

#include <algorithm>
#include <tuple>
#include <vector>

namespace pellucid
{
/** Importance of a fragment, and where it lies among the segments whose opacities are optimised. */
template <typename Real>
struct SegmentPlace
{
  OpacityFragment<Real> nearest{};      ///< its importance, and the segment that it belongs to
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
  Real distance = 0;                                   ///< from the eye, along the view direction
  Vector3<Real> tangent{ Real(0) };                    ///< as AttributeFragment has it
  const OcclusionAvoidance<Real>* avoidance = nullptr; ///< where its opacity follows from that
  Real fading = 1; ///< the factor on its opacity that PixelFragments::Fade() finds
};

/**
 * Front to back; of equal depths the less opaque one is in front, then the one with less red, green
 * and blue, then the less important one. Fragments that compare equal are identical, so that the
 * order in which they were found never shows.
 */
template <typename Real>
bool operator<(const Fragment<Real>& a, const Fragment<Real>& b)
{
  const auto key = [](const Fragment<Real>& f)
  {
    return std::tie(f.depth, f.color.a, f.color.r, f.color.g, f.color.b, f.place.nearest.importance,
      f.place.nearest.segment, f.tangent.x, f.tangent.y, f.tangent.z);
  };
  return key(a) < key(b);
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

  /**
   * Add a surface; what is fully transparent leaves no trace, as VTK's shaders discard it. That is
   * also what rounding leaves of 0 on the edge between two corners without opacity: even so little
   * would lend its importance to the pixel. (OpenGL shows either side of such an edge, and may have
   * such a leftover, too.)
   */
  void Add(const Fragment<Real>& fragment, bool opaque)
  {
    if (!opaque)
    {
      if (fragment.color.a > Real(1e-12))
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

  /** Depth of the nearest opaque surface; 1 where there is none. */
  Real GetOpaqueDepth() const { return this->Opaque.depth; }

  /** Drop what lies behind the nearest opaque surface and bring the rest into order, front first.
   * A fragment at the depth of the opaque surface is in front of it. */
  void Sort() { this->Sort(this->GetOpaqueDepth()); }

  /** The same with an opaque surface at that depth. */
  void Sort(Real opaqueDepth)
  {
    auto& list = this->Translucent;
    list.erase(std::remove_if(list.begin(), list.end(),
                 [opaqueDepth](const Fragment<Real>& f) { return f.depth > opaqueDepth; }),
      list.end());
    std::sort(list.begin(), list.end());
  }

  /** The translucent fragments; after Sort(), those that are visible, front to back. */
  const std::vector<Fragment<Real>>& GetTranslucent() const { return this->Translucent; }

  /** The attributes of the pixel, with depth either of the two measures: &Fragment::depth or
   * &Fragment::distance. */
  PixelAttributes<Real> GetAttributes(Real Fragment<Real>::*depth) const
  {
    std::vector<AttributeFragment<Real>> fragments;
    fragments.reserve(this->Translucent.size());
    for (const auto& fragment : this->Translucent)
    {
      fragments.push_back({ fragment.*depth, fragment.place.nearest.importance, fragment.tangent });
    }
    return ComputePixelAttributes(fragments);
  }

  /**
   * Find the factors on the opacities that follow from importance. `opacities` are those of
   * segments and corners, as SegmentPlace counts them; empty where nothing is optimised. `smooth`
   * are the smoothed attributes of the pixel, for fragments that need them.
   */
  void Fade(const std::vector<Real>& opacities, const PixelAttributes<Real>& smooth)
  {
    auto& list = this->Translucent;
    const bool avoids = std::any_of(list.begin(), list.end(),
      [](const Fragment<Real>& f) { return f.avoidance && !f.avoidance->smoothAttributes; });
    const auto sharp =
      avoids ? this->GetAttributes(&Fragment<Real>::depth) : PixelAttributes<Real>();
    for (auto& fragment : list)
    {
      const SegmentPlace<Real>& place = fragment.place;
      if (fragment.avoidance)
      {
        const auto& avoidance = *fragment.avoidance;
        fragment.fading = avoidance.smoothAttributes
          ? avoidance.Factor(fragment.distance, place.nearest.importance, smooth)
          : avoidance.Factor(fragment.depth, place.nearest.importance, sharp);
      }
      else if (place.nearest.parameters && !opacities.empty())
      {
        fragment.fading = InterpolateOpacity(
          opacities, place.opacities.data(), place.shares.data(), place.shares.size());
      }
    }
  }

  /** Keep the layers `first` to `last`, counted from 1, of the sorted fragments. */
  void KeepLayers(std::size_t first, std::size_t last)
  {
    auto& list = this->Translucent;
    list.resize(std::min(list.size(), last));
    list.erase(list.begin(), list.begin() + std::min(list.size(), first - 1));
  }

  /** Show the nearest of the sorted fragments, if there is one, opaque and in that colour. */
  void ShowNearest(const Vector3<Real>& color)
  {
    this->KeepLayers(1, 1);
    for (auto& fragment : this->Translucent)
    {
      fragment.color = Vector4<Real>(color, 1);
      fragment.fading = 1;
    }
  }

  /**
   * Blend the sorted fragments over the opaque surface, or over `background` where there is none
   * (Porter and Duff 1984, "over"). The background, like the result, is what a framebuffer holds:
   * a colour that is taken as it is, and the alpha beside it.
   */
  Vector4<Real> Composite(const Vector4<Real>& background) const
  {
    Vector3<Real> color(Real(0));
    Real transmittance = 1;
    for (const auto& fragment : this->Translucent)
    {
      const Real alpha = fragment.color.a * fragment.fading;
      color += transmittance * alpha * Vector3<Real>(fragment.color);
      transmittance *= 1 - alpha;
    }
    const Vector4<Real> behind =
      this->HasOpaque ? Vector4<Real>(Vector3<Real>(this->Opaque.color), Real(1)) : background;
    return Vector4<Real>(color, 1 - transmittance) + transmittance * behind;
  }

  /** By how much the colour may fall, at most 0, and rise, at least 0. */
  struct ColorChange
  {
    Vector3<Real> fall = Vector3<Real>(Real(0));
    Vector3<Real> rise = Vector3<Real>(Real(0));
  };

  /**
   * Bounds of how the colour of the pixel changes in other orders of those of its sorted fragments
   * that are less than `resolution` apart in depth. Those of the very same depth have an order of
   * their own.
   *
   * An exchange of neighbours changes the colour by the transmittance in front of both times both
   * alphas times the difference of their colours. Any order is reached by exchanging each pair at
   * most once, such that what was in front of the nearer one still is. What one passes hides each
   * other, so that together they change it by no more than the largest difference.
   */
  ColorChange GetOrderChange(Real resolution) const
  {
    const auto& list = this->Translucent;
    const Vector3<Real> none(Real(0));
    ColorChange change;
    Real transmittance = 1;
    auto behind = list.begin();
    for (const auto& front : list)
    {
      while (behind != list.end() && !(behind->depth > front.depth))
      {
        ++behind;
      }
      ColorChange sum;
      ColorChange largest;
      for (auto back = behind; back != list.end() && back->depth - front.depth < resolution; ++back)
      {
        const auto difference = Vector3<Real>(back->color) - Vector3<Real>(front.color);
        const Vector3<Real> fall = glm::min(difference, none);
        const Vector3<Real> rise = glm::max(difference, none);
        const Real alpha = back->color.a * back->fading;
        sum.fall += alpha * fall;
        sum.rise += alpha * rise;
        largest.fall = glm::min(largest.fall, fall);
        largest.rise = glm::max(largest.rise, rise);
      }
      const Real alpha = front.color.a * front.fading;
      change.fall += transmittance * alpha * glm::max(sum.fall, largest.fall);
      change.rise += transmittance * alpha * glm::min(sum.rise, largest.rise);
      transmittance *= 1 - alpha;
    }
    return change;
  }

private:
  std::vector<Fragment<Real>> Translucent;
  Fragment<Real> Opaque;
  bool HasOpaque = false;
};
}

#endif
