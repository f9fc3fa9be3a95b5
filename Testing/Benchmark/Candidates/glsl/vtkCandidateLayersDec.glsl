// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// PELLUCID_LAYERS entries for each pixel, nearest first; the C++ side is vtkCandidateLayersPass. The
// invocations of one pixel must come one after the other.

layout(std430, binding = PELLUCID_DEPTHS_BINDING) coherent buffer PellucidDepths
{
  uint pellucidDepths[]; // window depth as bits
};

layout(std430, binding = PELLUCID_COLORS_BINDING) coherent buffer PellucidColors
{
  uvec2 pellucidColors[]; // as vtkFragmentColorDec.glsl packs them
};

// x: number of entries, with PELLUCID_LOSSY where their order is not that of the fragments;
// y: the farthest depth that has left the entries for good
layout(std430, binding = PELLUCID_STATES_BINDING) coherent buffer PellucidStates
{
  uvec2 pellucidStates[];
};

// Colour and opacity of what is composited in front of the entries
layout(std430, binding = PELLUCID_FRONTS_BINDING) coherent buffer PellucidFronts
{
  vec4 pellucidFronts[];
};

// Whether nothing behind what is composited in a window pixel can be seen
bool pellucidIsSaturated(ivec2 windowPixel)
{
  int pixel = pellucidPixelIndex(windowPixel);
  return pixel >= 0 && 1.0 - pellucidFronts[pixel].a <= PELLUCID_NEGLIGIBLE_TRANSMITTANCE;
}

// Nearer first; of equal depth as the product orders them
bool pellucidIsBefore(uint depthA, uvec2 colorA, uint depthB, uvec2 colorB)
{
  if (depthA == depthB)
  {
    return colorA.y != colorB.y ? colorA.y < colorB.y : colorA.x < colorB.x;
  }
  return depthA < depthB;
}

// Put a fragment among the first `count` entries from `first` on; there is room for one more.
void pellucidInsert(int first, uint count, uint depth, uvec2 color)
{
  int slot = first + int(count);
  while (slot > first &&
    pellucidIsBefore(depth, color, pellucidDepths[slot - 1], pellucidColors[slot - 1]))
  {
    pellucidDepths[slot] = pellucidDepths[slot - 1];
    pellucidColors[slot] = pellucidColors[slot - 1];
    --slot;
  }
  pellucidDepths[slot] = depth;
  pellucidColors[slot] = color;
}
