#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fade: moves the opacities that are shown towards those of the solution, in one invocation for each
// segment. A segment that was not seen before is at its aim at once, one that is seen no more has none.
//
// Reads: opacities of the solution. Writes: opacities that are shown.

layout(std430, binding = PELLUCID_SOURCE_BINDING) readonly buffer Source
{
  float solution[];
};
layout(std430, binding = PELLUCID_TARGET_BINDING) buffer Target
{
  float shown[];
};

uniform int elementCount;
uniform int rowLength; // invocations of one row of the framebuffer
uniform float share;   // of the way; 1: all of it

void main()
{
  int segment = int(gl_FragCoord.y) * rowLength + int(gl_FragCoord.x);
  if (segment >= elementCount)
  {
    return;
  }
  float aim = solution[segment];
  float before = shown[segment];
  bool jumps = aim < 0.0 || before < 0.0 || share >= 1.0;
  shown[segment] = jumps ? aim : mix(before, aim, share);
}
