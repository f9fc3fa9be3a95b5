#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Fade: moves the opacities that are shown towards those of the solution, in one invocation for each
// segment. A segment that was not seen before is at its aim at once, one that is seen no more has none.
//
// Reads: opacities of the solution. Writes: opacities that are shown, and whether any has a way left.

layout(std430, binding = PELLUCID_SOURCE_BINDING) readonly buffer Source
{
  float solution[];
};
layout(std430, binding = PELLUCID_TARGET_BINDING) buffer Target
{
  float shown[];
};

layout(std430, binding = PELLUCID_PENDING_BINDING) writeonly buffer Pending
{
  uint pending;
};

uniform int elementCount;
uniform int rowLength; // invocations of one row of the framebuffer
uniform float share;   // of the way

void main()
{
  int segment = int(gl_FragCoord.y) * rowLength + int(gl_FragCoord.x);
  if (segment >= elementCount)
  {
    return;
  }
  float aim = solution[segment];
  float before = shown[segment];
  float moved = mix(before, aim, share);
  bool jumps = aim < 0.0 || before < 0.0;
  shown[segment] = jumps ? aim : moved;
  if (!jumps && abs(aim - moved) > PELLUCID_NEGLIGIBLE_WAY)
  {
    pending = 1u;
  }
}
