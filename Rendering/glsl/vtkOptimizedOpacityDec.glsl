// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The optimised opacity of a fragment; the C++ side is vtkSegmentOpacities.
//
// Reads: the opacities of segments and corners, negative where no fragment has shown them.

layout(std430, binding = PELLUCID_OPACITIES_BINDING) readonly buffer PellucidOpacities
{
  float pellucidOpacities[];
};

float pellucidMix(vec3 opacities, vec3 shares)
{
  vec3 known = mix(vec3(0.0), shares, greaterThanEqual(opacities, vec3(0.0)));
  float total = known.x + known.y + known.z;
  return total > 0.0 ? dot(known, opacities) / total : 1.0;
}

float pellucidOptimizedOpacity(uvec2 position)
{
  if ((position.y & (PELLUCID_TRIANGLE | PELLUCID_HAS_FACTOR)) == PELLUCID_HAS_FACTOR)
  {
    return uintBitsToFloat(position.y & ~PELLUCID_HAS_FACTOR);
  }
  float first = pellucidOpacities[position.x];
  if ((position.y & PELLUCID_TRIANGLE) != 0u)
  {
    vec2 shares = vec2(position.y & 32767u, (position.y >> 15) & 32767u) / 32767.0;
    vec3 opacities =
      vec3(first, pellucidOpacities[position.x + 1u], pellucidOpacities[position.x + 2u]);
    return pellucidMix(opacities, vec3(max(1.0 - shares.x - shares.y, 0.0), shares));
  }
  if (position.y == 0u)
  {
    return first < 0.0 ? 1.0 : first;
  }
  float share = uintBitsToFloat(position.y);
  return pellucidMix(
    vec3(first, pellucidOpacities[position.x + 1u], -1.0), vec3(1.0 - share, share, 0.0));
}
