// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The nearest of all entries and the new fragment is composited for good (M. Gross, S. Gumhold 2021,
// section 4.2). Where it is nearer than one before it, the order is lost.

void pellucidOverflow(int pixel, int first, uint depth, uvec2 color, inout uvec2 state)
{
  uint nearestDepth = pellucidDepths[first];
  uvec2 nearestColor = pellucidColors[first];
  if (pellucidIsBefore(depth, color, nearestDepth, nearestColor))
  {
    nearestDepth = depth;
    nearestColor = color;
  }
  else
  {
    int slot = first;
    int last = first + PELLUCID_LAYERS - 1;
    while (slot < last &&
      pellucidIsBefore(pellucidDepths[slot + 1], pellucidColors[slot + 1], depth, color))
    {
      pellucidDepths[slot] = pellucidDepths[slot + 1];
      pellucidColors[slot] = pellucidColors[slot + 1];
      ++slot;
    }
    pellucidDepths[slot] = depth;
    pellucidColors[slot] = color;
  }
  vec4 fragment = pellucidUnpackColor(nearestColor);
  vec4 front = pellucidFronts[pixel];
  float weight = (1.0 - front.a) * fragment.a;
  pellucidFronts[pixel] = front + weight * vec4(fragment.rgb, 1.0);
  state.x |= nearestDepth < state.y ? PELLUCID_LOSSY : 0u;
  state.y = max(state.y, nearestDepth);
}
