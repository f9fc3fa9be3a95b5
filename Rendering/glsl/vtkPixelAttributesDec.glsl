// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// View-dependent attributes of a pixel, M. Bandle 2016, section 3.2; Private/OcclusionAvoidance.h is the
// same in double precision, and Private/vtkPixelAttributes the C++ side.
//
// Reads: links, importances, positions. Declares: attributes of the picture's pixels.

// Maximum importance of the pixel, and distance of the fragment that has it; negative: there is none
layout(std430, binding = PELLUCID_ATTRIBUTES_BINDING) buffer PellucidAttributes
{
  vec2 pellucidAttributes[];
};

uniform ivec2 pellucidPictureOrigin; // window pixel of the first of them
uniform ivec2 pellucidPictureSize;
uniform vec4 pellucidDepthToDistance; // elements 22, 23, 32, 33 of the projection

// Distance from the eye along the view direction
float pellucidDistance(float windowDepth)
{
  float depth = 2.0 * windowDepth - 1.0;
  return (depth * pellucidDepthToDistance.w - pellucidDepthToDistance.y) /
    (depth * pellucidDepthToDistance.z - pellucidDepthToDistance.x);
}

struct PixelAttributes
{
  float coverage;
  float importance;
  float depth; // window depth of the nearest fragment of that importance
  float variance;
  bool avoids; // some fragment follows from this
};

// False for lists that are left to the CPU
bool findAttributes(uint first, out PixelAttributes pixel)
{
  pixel = PixelAttributes(0.0, 0.0, 0.0, 0.0, false);
  vec3 sum = vec3(0.0);
  float directions = 0.0;
  uint length = 0u;
  uint node = first;
  for (; node != 0u && length < uint(PELLUCID_LONGEST_SORTED_LIST); ++length)
  {
    uvec2 fragment = pellucidImportances[node];
    pixel.importance = max(pixel.importance, uintBitsToFloat(fragment.x));
    if ((fragment.y & PELLUCID_AVOIDING) != 0u)
    {
      pixel.avoids = true;
      uint tangent = pellucidPositions[node].x;
      sum += pellucidUnpackTangent(tangent);
      directions += tangent != 0u ? 1.0 : 0.0;
    }
    node = pellucidLinks[node].x;
  }
  uint most = first;
  while (most != 0u &&
    uintBitsToFloat(pellucidImportances[most].x) + PELLUCID_IMPORTANCE_TOLERANCE < pixel.importance)
  {
    most = pellucidLinks[most].x;
  }
  pixel.depth = most != 0u ? uintBitsToFloat(pellucidLinks[most].y) : 0.0;
  pixel.coverage = float(length);
  pixel.variance = directions > 0.0 ? max(0.0, 1.0 - sqrt(dot(sum, sum)) / directions) : 0.0;
  return node == 0u;
}
