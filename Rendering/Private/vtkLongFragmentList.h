// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One fragment list on the CPU, for lists that are too long for a shader. Works in place on the
 * mapped buffers of vtkFragmentLists; needs no OpenGL itself.
 */

#ifndef vtkLongFragmentList_h
#define vtkLongFragmentList_h

#include "OcclusionAvoidance.h"
#include "vtkFragmentLists.h"
#include "vtkSegmentOpacities.h"

#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkOptimizedScene;
class vtkPixelAttributes;
struct vtkPictureView;

class vtkLongFragmentList
{
public:
  /** The list that starts at node `head`, in any order; it is read and sorted; only Collapse()
   * changes it. */
  vtkLongFragmentList(const vtkFragmentLists::Nodes& nodes, std::uint32_t head);

  /** Append the optimal opacity of each fragment, in double precision, with its segment. */
  void Solve(const vtkOptimizedScene& scene,
    std::vector<vtkSegmentOpacities::SegmentOpacity>& opacities) const;

  /** Multiply the opacity of each fragment by the one that follows from importance, if there are
   * any; see glsl/vtkOptimizedOpacityDec.glsl. */
  void Fade(const std::vector<float>& opacities);

  /** Of the pixel; depths are distances along the view direction where `distances` are given, else
   * those of the window. */
  pellucid::PixelAttributes<double> GetAttributes(const vtkPixelAttributes* distances) const;

  /**
   * Multiply the opacity of each fragment of an actor with occlusion avoidance by the factor that
   * follows from the attributes of its pixel. `smooth` are the smoothed ones, of importance and
   * distance only, for actors that want them.
   */
  void Avoid(const vtkOptimizedScene& scene, const vtkPixelAttributes& pixels,
    const pellucid::PixelAttributes<double>& smooth);

  /** Change each fragment to what the view shows of it; see glsl/vtkPictureViewDec.glsl. */
  void Show(const vtkPictureView& view);

  /**
   * Composite in double precision all fragments between two neighbouring opaque depths into one
   * node, and link these nodes from the head on. `opaqueLimits` are the farthest depths, as
   * bits, at which a fragment is in front of each sample.
   */
  void Collapse(const std::uint32_t* opaqueLimits, int samples);

private:
  struct Fragment
  {
    std::uint32_t DepthBits;
    vtkFragmentLists::Color Color;
    vtkFragmentLists::Importance Importance;
    vtkFragmentLists::Position Position;
    double Factor; ///< on the opacity
  };

  vtkFragmentLists::Nodes Nodes;
  std::uint32_t Head;
  std::vector<Fragment> Fragments;
};

VTK_ABI_NAMESPACE_END
#endif
