// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather: added to the fragment shader of VTK's mappers for actors whose opacities are optimised, after
// vtkFragmentAppendDec.glsl.
//
// Reads: importance and place of the fragment, corners. Writes: pellucidImportance, pellucidPosition.

struct PellucidCorner
{
  uvec4 segments; // the nearest one first
  vec4 weights;
};
layout(std430, binding = PELLUCID_GATHER_CORNERS_BINDING) readonly buffer PellucidCorners
{
  PellucidCorner pellucidCorners[];
};

uniform int pellucidFirstSegment;
uniform bool pellucidAvoids;           // the actor's opacities follow from occlusion avoidance
uniform int pellucidFirstCorner; // in pellucidCorners; -1: the actor is one segment
uniform int pellucidFirstCornerOpacity;

in float pellucidImportanceVSOutput;
in vec2 pellucidSharesVSOutput;
flat in int pellucidVertexVSOutput;

void pellucidSetImportance()
{
  float importance = pellucidSaturate(vec3(pellucidImportanceVSOutput)).x;
  pellucidImportance = uvec2(floatBitsToUint(importance), uint(pellucidFirstSegment));
  pellucidPosition = uvec2(uint(pellucidFirstSegment), 0u);
  if (pellucidAvoids)
  {
    pellucidImportance.y |= PELLUCID_AVOIDING;
    pellucidPosition = uvec2(0u, PELLUCID_FACTOR_OF_ONE);
  }
  else if (pellucidFirstCorner >= 0)
  {
    int triangle = pellucidVertexVSOutput / 3 * 3;
    vec3 shares = vec3(1.0 - pellucidSharesVSOutput.x - pellucidSharesVSOutput.y, pellucidSharesVSOutput);
    int nearest = shares.y > shares.x ? (shares.z > shares.y ? 2 : 1) : (shares.z > shares.x ? 2 : 0);
    pellucidImportance.y = pellucidCorners[pellucidFirstCorner + triangle + nearest].segments.x;
    uvec3 parts = uvec3(pellucidSaturate(shares) * 32767.0 + 0.5);
    pellucidPosition = uvec2(uint(pellucidFirstCornerOpacity + triangle),
      PELLUCID_TRIANGLE | (parts.z << 15) | parts.y);
  }
}
