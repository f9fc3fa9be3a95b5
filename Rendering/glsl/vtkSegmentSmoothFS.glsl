#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Smooth: one step of Laplacian smoothing of the opacities of segments, in one invocation each. A
// segment moves by PELLUCID_RELAXATION towards the mean of its neighbours. Segments that no fragment
// has shown take no part; theirs is negative.
//
// Reads: segments, actors, neighbours, the opacities of the step before. Writes: opacities; forgets the
// least opacities of the fragments.

//VTK::Pellucid::Segments

// The neighbours of segment i are neighbors[firstNeighbors[i]] ... up to firstNeighbors[i + 1]
layout(std430, binding = PELLUCID_FIRST_NEIGHBORS_BINDING) readonly buffer FirstNeighbors
{
  uint firstNeighbors[];
};
layout(std430, binding = PELLUCID_NEIGHBORS_BINDING) readonly buffer Neighbors
{
  uint neighbors[];
};
layout(std430, binding = PELLUCID_SOURCE_BINDING) readonly buffer Source
{
  float source[];
};
layout(std430, binding = PELLUCID_TARGET_BINDING) writeonly buffer Target
{
  float target[];
};

uniform int elementCount;
uniform int rowLength;  // invocations of one row of the framebuffer
uniform int iteration;  // 0 takes the least opacities of fragments as they are

void main()
{
  int segment = int(gl_FragCoord.y) * rowLength + int(gl_FragCoord.x);
  if (segment >= elementCount)
  {
    return;
  }
  uvec2 state = pellucidSegments[segment];
  if (iteration == 0)
  {
    float least = state.x == PELLUCID_UNSEEN ? -1.0 : uintBitsToFloat(state.x);
    target[segment] = segment == 0 ? 1.0 : least;
    pellucidSegments[segment].x = PELLUCID_UNSEEN;
    return;
  }
  float opacity = source[segment];
  if (opacity >= 0.0 && uint(iteration) <= pellucidActors[state.y].smoothingIterations)
  {
    float sum = 0.0;
    float count = 0.0;
    for (uint i = firstNeighbors[segment]; i < firstNeighbors[segment + 1]; ++i)
    {
      float neighbor = source[neighbors[i]];
      sum += max(neighbor, 0.0);
      count += neighbor >= 0.0 ? 1.0 : 0.0;
    }
    opacity += count > 0.0 ? PELLUCID_RELAXATION * (sum / count - opacity) : 0.0;
  }
  target[segment] = opacity;
}
