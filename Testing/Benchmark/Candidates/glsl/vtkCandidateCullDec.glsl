// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Added to the vertex shader of rounded cones, after vtkCandidateOpacitiesDec.glsl: segments that lie
// behind saturated pixels only (M. Gross, S. Gumhold 2021, section 4.3).

uniform ivec2 pellucidViewportSize;

// Whether all pixels of the picture that see something of a box in VC are saturated
bool pellucidIsBehindSaturated(vec3 low, vec3 high)
{
  vec2 lowDC = vec2(1e30);
  vec2 highDC = vec2(-1e30);
  for (int corner = 0; corner < 8; ++corner)
  {
    bvec3 isHigh = bvec3((corner & 1) != 0, (corner & 2) != 0, (corner & 4) != 0);
    vec4 point = VCDCMatrix * vec4(mix(low, high, vec3(isHigh)), 1.0);
    if (point.w <= 0.0)
    {
      return false;
    }
    lowDC = min(lowDC, point.xy / point.w);
    highDC = max(highDC, point.xy / point.w);
  }
  vec2 size = vec2(pellucidViewportSize);
  ivec2 first = ivec2(clamp(floor((0.5 * lowDC + 0.5) * size - 0.5), vec2(0.0), size - 1.0));
  ivec2 last = ivec2(clamp(ceil((0.5 * highDC + 0.5) * size - 0.5), vec2(0.0), size - 1.0));
  ivec2 extent = last - first + 1;
  // Squares at least as large as the box: it overlaps no more than two by two of them.
  int level = max(int(ceil(log2(float(max(extent.x, extent.y))))), 1);
  ivec2 begin = first >> level;
  ivec2 end = last >> level;
  float opacity =
    min(min(pellucidOpacities[pellucidOpacityIndex(level, begin)],
          pellucidOpacities[pellucidOpacityIndex(level, ivec2(end.x, begin.y))]),
      min(pellucidOpacities[pellucidOpacityIndex(level, ivec2(begin.x, end.y))],
        pellucidOpacities[pellucidOpacityIndex(level, end)]));
  return 1.0 - opacity <= PELLUCID_NEGLIGIBLE_TRANSMITTANCE;
}
