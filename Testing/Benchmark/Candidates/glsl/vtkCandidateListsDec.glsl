// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fragments of all pixels, in linked lists or in arrays; the C++ side is vtkCandidateListsPass.
// Node 0 does not exist, so that it can stand for none.

// Linked lists: the first node of each pixel, 0: none. Arrays: that, then the number of nodes. The
// first node may have PELLUCID_TIED.
layout(std430, binding = PELLUCID_HEADS_BINDING) buffer PellucidHeads
{
  uint pellucidHeads[];
};

// Window depth as bits, which order as the non-negative floats do; in linked lists after the next node
#if PELLUCID_CONTIGUOUS
#define PELLUCID_LINK uint
#else
#define PELLUCID_LINK uvec2
#endif
layout(std430, binding = PELLUCID_LINKS_BINDING) buffer PellucidLinks
{
  PELLUCID_LINK pellucidLinks[];
};

// Straight colour and opacity, so that the words from last to first order as opacity, red, green and
// blue do
#if PELLUCID_COLOR_BYTES == 4
#define PELLUCID_COLOR uint
#elif PELLUCID_COLOR_BYTES == 8
#define PELLUCID_COLOR uvec2
#else
#define PELLUCID_COLOR uvec4
#endif
layout(std430, binding = PELLUCID_COLORS_BINDING) buffer PellucidColors
{
  PELLUCID_COLOR pellucidColors[];
};

void pellucidStoreColor(uint node, vec4 color)
{
#if PELLUCID_COLOR_BYTES == 4
  uvec4 bytes = uvec4(vec4(pellucidSaturate(color.bgr), min(color.a, 1.0)) * 255.0 + 0.5);
  pellucidColors[node] = bytes.x | (bytes.y << 8) | (bytes.z << 16) | (bytes.w << 24);
#elif PELLUCID_COLOR_BYTES == 8
  pellucidColors[node] = pellucidPackColor(color.rgb, color.a);
#else
  pellucidColors[node] = floatBitsToUint(vec4(pellucidSaturate(color.bgr), min(color.a, 1.0)));
#endif
}

vec4 pellucidLoadColor(uint node)
{
  PELLUCID_COLOR words = pellucidColors[node];
#if PELLUCID_COLOR_BYTES == 4
  return vec4((uvec4(words) >> uvec4(16u, 8u, 0u, 24u)) & 255u) / 255.0;
#elif PELLUCID_COLOR_BYTES == 8
  return pellucidUnpackColor(words);
#else
  return uintBitsToFloat(words).bgra;
#endif
}

// Less opaque first; then by red, green and blue; then by the nodes themselves
bool pellucidHasLessColor(uint a, uint b)
{
  PELLUCID_COLOR wordsA = pellucidColors[a];
  PELLUCID_COLOR wordsB = pellucidColors[b];
#if PELLUCID_COLOR_BYTES == 4
  return wordsA != wordsB ? wordsA < wordsB : a < b;
#else
  for (int word = PELLUCID_COLOR_BYTES / 4 - 1; word >= 0; --word)
  {
    if (wordsA[word] != wordsB[word])
    {
      return wordsA[word] < wordsB[word];
    }
  }
  return a < b;
#endif
}
