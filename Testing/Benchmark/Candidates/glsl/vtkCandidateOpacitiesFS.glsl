#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Makes one level of the minimum opacities from the one before it, or the first from the
// pixels. The viewport starts at 0, 0 and has the size of the level.
//
// Reads: fronts, or a level. Writes: a level. No colour output.

//VTK::Pellucid::Declarations

uniform int pellucidLevel;

float opacityBefore(ivec2 texel)
{
  ivec2 last = (pellucidViewportSize - 1) >> (pellucidLevel - 1);
  texel = min(texel, last);
  return pellucidLevel == 1 ? pellucidFronts[texel.y * pellucidViewportSize.x + texel.x].a
                            : pellucidOpacities[pellucidOpacityIndex(pellucidLevel - 1, texel)];
}

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float low = min(opacityBefore(2 * texel), opacityBefore(2 * texel + ivec2(1, 0)));
  float high = min(opacityBefore(2 * texel + ivec2(0, 1)), opacityBefore(2 * texel + 1));
  pellucidOpacities[pellucidOpacityIndex(pellucidLevel, texel)] = min(low, high);
}
