#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Interpolate: the opacity at each corner of a triangle from those of the segments around it, in one
// invocation each. Segments that no fragment has shown take no part.
//
// Reads: corners, opacities of segments. Writes: opacities of corners, behind those of the segments.

struct Corner
{
  uvec4 segments;
  vec4 weights;
};
layout(std430, binding = PELLUCID_CORNERS_BINDING) readonly buffer Corners
{
  Corner corners[];
};
layout(std430, binding = PELLUCID_TARGET_BINDING) buffer Target
{
  float opacities[];
};

uniform int segmentCount;
uniform int elementCount;
uniform int rowLength; // invocations of one row of the framebuffer

void main()
{
  int element = int(gl_FragCoord.y) * rowLength + int(gl_FragCoord.x);
  if (element >= elementCount)
  {
    return;
  }
  Corner corner = corners[element];
  float sum = 0.0;
  float total = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    float opacity = opacities[corner.segments[i]];
    float weight = opacity >= 0.0 ? corner.weights[i] : 0.0;
    sum += weight * opacity;
    total += weight;
  }
  opacities[segmentCount + element] = total > 0.0 ? sum / total : -1.0;
}
