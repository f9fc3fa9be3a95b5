#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes level PELLUCID_LEVEL of the minimum opacities from the one before it, or the first from the
// pixels. The viewport starts at 0, 0 and has the size of the level.
//
// Reads: fronts, or a level. Writes: a level. No colour output.

//VTK::Pellucid::Declarations

float opacityBefore(ivec2 texel)
{
  ivec2 last = (pellucidViewportSize - 1) >> (PELLUCID_LEVEL - 1);
  texel = min(texel, last);
#if PELLUCID_LEVEL == 1
  return pellucidFronts[texel.y * pellucidViewportSize.x + texel.x].a;
#else
  return pellucidOpacities[pellucidOpacityIndex(PELLUCID_LEVEL - 1, texel)];
#endif
}

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float low = min(opacityBefore(2 * texel), opacityBefore(2 * texel + ivec2(1, 0)));
  float high = min(opacityBefore(2 * texel + ivec2(0, 1)), opacityBefore(2 * texel + 1));
  pellucidOpacities[pellucidOpacityIndex(PELLUCID_LEVEL, texel)] = min(low, high);
}
