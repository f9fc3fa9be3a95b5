// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The two farthest of all entries and the new fragment become one (M. Salvi, K. Vaidyanathan,
// Multi-Layer Alpha Blending, 2014), at the depth of the nearer. Only the last entry can be such a one.
// A fragment that belongs between what it was made from comes too late.

vec4 pellucidMerge(uvec2 nearer, uvec2 farther)
{
  vec4 front = pellucidUnpackColor(nearer);
  vec4 back = pellucidUnpackColor(farther);
  float weight = (1.0 - front.a) * back.a;
  float opacity = front.a + weight;
  return vec4((front.a * front.rgb + weight * back.rgb) / opacity, opacity);
}

void pellucidOverflow(int pixel, int first, uint depth, uvec2 color, inout uvec2 state)
{
  int last = first + PELLUCID_LAYERS - 1;
  uint farDepth = pellucidDepths[last];
  uvec2 farColor = pellucidColors[last];
  if (pellucidIsBefore(depth, color, farDepth, farColor))
  {
    pellucidInsert(first, uint(PELLUCID_LAYERS - 1), depth, color);
  }
  else
  {
    state.x |= depth < state.y ? PELLUCID_LOSSY : 0u;
    farDepth = depth;
    farColor = color;
  }
  vec4 merged = pellucidMerge(pellucidColors[last], farColor);
  pellucidColors[last] = pellucidPackColor(merged.rgb, merged.a);
  state.y = max(state.y, farDepth);
}
