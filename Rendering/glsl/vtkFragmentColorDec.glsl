// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The colour of a fragment in 64 bits: opacity as the upper 25 bits below the sign of a float, then
// red, green and blue of the straight colour with 13 bits each. y is the upper word: the two order as
// opacity, red, green, blue do.

// To [0,1]; NaN becomes 0, which clamp() leaves undefined
vec3 pellucidSaturate(vec3 value)
{
  return mix(vec3(0.0), min(value, vec3(1.0)), greaterThan(value, vec3(0.0)));
}

uvec2 pellucidPackColor(vec3 color, float opacity)
{
  uvec3 rgb = uvec3(pellucidSaturate(color) * 8191.0 + 0.5);
  uint alpha = (floatBitsToUint(min(opacity, 1.0)) + 32u) >> 6;
  return uvec2(rgb.b | (rgb.g << 13) | (rgb.r << 26), (rgb.r >> 6) | (alpha << 7));
}

float pellucidUnpackOpacity(uvec2 words)
{
  return uintBitsToFloat((words.y >> 7) << 6);
}

vec4 pellucidUnpackColor(uvec2 words)
{
  uvec3 rgb =
    uvec3((words.x >> 26) | ((words.y & 127u) << 6), (words.x >> 13) & 8191u, words.x & 8191u);
  return vec4(vec3(rgb) / 8191.0, pellucidUnpackOpacity(words));
}
