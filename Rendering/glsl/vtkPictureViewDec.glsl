// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a fragment shows in the views of vtkExactTransparencyPass that are not the picture itself;
// Private/ViewColors.h is the same in C++. PELLUCID_VIEW is the view, the other constants name them.
//
// Reads: links, importances.

uniform int pellucidLayer;
uniform int pellucidLongestOfPicture;

// 0 black, 1/3 red, 2/3 yellow, 1 white
vec3 pellucidHotColor(float value)
{
  return clamp(3.0 * value - vec3(0.0, 1.0, 2.0), 0.0, 1.0);
}

vec3 pellucidSegmentColor(uint segment)
{
  uint hash = segment * 2654435769u;
  hash ^= hash >> 16;
  hash *= 2246822519u;
  hash ^= hash >> 13;
  vec3 bytes = vec3(uvec3(hash, hash >> 8, hash >> 16) & 255u);
  return segment == 0u ? vec3(0.0) : 0.2 + 0.8 * bytes / 255.0;
}

float pellucidRelativeLength(uint node)
{
  uint length = 0u;
  for (; node != 0u; node = pellucidLinks[node].x)
  {
    ++length;
  }
  return float(length) / float(pellucidLongestOfPicture);
}

// The colour of the fragment that is number `layer`, from 1, of its pixel; `factor` is on its opacity
vec4 pellucidViewed(vec4 color, float factor, uint node, int layer)
{
#if PELLUCID_VIEW == PELLUCID_VIEW_FIRST_LAYERS
  return vec4(color.rgb, layer <= pellucidLayer ? factor * color.a : 0.0);
#elif PELLUCID_VIEW == PELLUCID_VIEW_LAYER
  return vec4(color.rgb, layer == pellucidLayer ? factor * color.a : 0.0);
#elif PELLUCID_VIEW == PELLUCID_VIEW_OPACITY
  return vec4(pellucidHotColor(factor), 1.0);
#elif PELLUCID_VIEW == PELLUCID_VIEW_LENGTH
  return vec4(pellucidHotColor(pellucidRelativeLength(node)), 1.0);
#elif PELLUCID_OPTIMIZE && PELLUCID_VIEW == PELLUCID_VIEW_IMPORTANCE
  return vec4(pellucidHotColor(uintBitsToFloat(pellucidImportances[node].x)), 1.0);
#elif PELLUCID_OPTIMIZE && PELLUCID_VIEW == PELLUCID_VIEW_SEGMENTS
  return vec4(pellucidSegmentColor(uint(max(int(pellucidImportances[node].y), 0))), 1.0);
#else
  return vec4(vec3(0.0), 1.0);
#endif
}
