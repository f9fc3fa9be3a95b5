// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Unit vectors in 32 bits, by their projection to an octahedron; 0 stands for none.

vec2 pellucidFold(vec2 v)
{
  return (1.0 - abs(v.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(v, vec2(0.0)));
}

uint pellucidPackTangent(vec3 tangent)
{
  vec3 v = tangent / (abs(tangent.x) + abs(tangent.y) + abs(tangent.z));
  uvec2 parts = uvec2((v.z < 0.0 ? pellucidFold(v.xy) : v.xy) * 32767.0 + 32768.5);
  return parts.x | (parts.y << 16);
}

vec3 pellucidUnpackTangent(uint bits)
{
  if (bits == 0u)
  {
    return vec3(0.0);
  }
  vec2 xy = (vec2(bits & 65535u, bits >> 16) - 32768.0) / 32767.0;
  float z = 1.0 - abs(xy.x) - abs(xy.y);
  return normalize(vec3(z < 0.0 ? pellucidFold(xy) : xy, z));
}
