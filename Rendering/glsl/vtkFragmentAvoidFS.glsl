#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Avoid: the factors on opacities that follow from the attributes of their pixel, M. Bandle 2016, section
// 3.3.2 and equations 3.2 and 3.3; Private/OcclusionAvoidance.h is the same in double precision.
//
// Reads: heads, sorted links, importances, segments, actors; attributes of the pixels around, where they are
// smoothed. Reads and writes: positions, which get the factor. No colour output.

//VTK::Pellucid::Lists
//VTK::Pellucid::Importance
//VTK::Pellucid::Segments
//VTK::Pellucid::Power
//VTK::Pellucid::Tangent
//VTK::Pellucid::Attributes

const int RADIUS = 2; // of the smoothed neighbourhood

// Means over the pixels around that have a fragment
vec2 smoothAttributes(ivec2 place)
{
  ivec2 first = max(place - RADIUS, ivec2(0));
  ivec2 last = min(place + RADIUS, pellucidPictureSize - 1);
  vec3 sum = vec3(0.0);
  for (int y = first.y; y <= last.y; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      vec2 neighbor = pellucidAttributes[y * pellucidPictureSize.x + x];
      sum += neighbor.y < 0.0 ? vec3(0.0) : vec3(neighbor, 1.0);
    }
  }
  return sum.xy / sum.z;
}

void main()
{
  ivec2 windowPixel = ivec2(gl_FragCoord.xy);
  int pixel = pellucidPixelIndex(windowPixel);
  uint first = pixel < 0 ? 0u : pellucidHeads[pixel];
  PixelAttributes attributes;
  if (!findAttributes(first, attributes) || !attributes.avoids)
  {
    return;
  }
#if PELLUCID_SMOOTH_ATTRIBUTES
  vec2 smoothed = smoothAttributes(windowPixel - pellucidPictureOrigin);
#endif
  for (uint node = first; node != 0u; node = pellucidLinks[node].x)
  {
    uvec2 fragment = pellucidImportances[node];
    if ((fragment.y & PELLUCID_AVOIDING) == 0u)
    {
      continue;
    }
    PellucidActor actor = pellucidActors[pellucidSegments[fragment.y & ~PELLUCID_AVOIDING].y];
    float depth = uintBitsToFloat(pellucidLinks[node].y);
    float own = uintBitsToFloat(fragment.x);
    float importance = attributes.importance;
    bool nearer = depth < attributes.depth;
#if PELLUCID_SMOOTH_ATTRIBUTES
    if ((actor.avoids & PELLUCID_SMOOTHS_ATTRIBUTES) != 0u)
    {
      importance = smoothed.x;
      nearer = pellucidDistance(depth) * PELLUCID_DISTANCE_MARGIN < smoothed.y;
    }
#endif
    bool inFront = nearer && own + PELLUCID_IMPORTANCE_TOLERANCE < importance;
    float factor = inFront ? actor.penalty : 1.0;
    if ((actor.avoids & PELLUCID_AVOIDS_BY_WEIGHTING) != 0u)
    {
      float occlusion = actor.importanceWeight * importance +
        actor.coverageWeight * attributes.coverage + actor.varianceWeight * attributes.variance +
        (inFront ? actor.depthWeight : 0.0);
      float unimportance = 1.0 - pellucidPower(own, actor.lambda);
      factor = unimportance > 0.0 ? 1.0 / (1.0 + unimportance * occlusion) : 1.0;
    }
    pellucidPositions[node].y =
      PELLUCID_HAS_FACTOR | floatBitsToUint(min(actor.globalOpacity * factor, 1.0));
  }
}
