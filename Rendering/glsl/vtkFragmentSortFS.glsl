#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sort: each list front to back, in place. Runs of PELLUCID_RUN_LENGTH nodes are sorted by insertion
// in local memory and merged through a binary counter of sorted lists, so that a short list costs
// one insertion sort and a long one n log n steps. Lists above PELLUCID_MAXIMUM_SHADER_LIST are
// noted for the CPU: software renderers end a shader invocation after some 65,000 loop iterations.
//
// Drawn once by depth alone, which marks the lists with fragments of equal depth, and where there are
// such lists again for these (PELLUCID_BREAK_TIES). A comparison that also knows what to do with ties
// costs software renderers half of the sort, since they execute branches that no pixel takes.
//
// With PELLUCID_DROPS_HIDDEN, merging ends where the rest of a list cannot be seen, and nodes that come
// later and lie behind that are not sorted at all: what a part of a list hides, the whole list hides.
// Fragments of equal depth stay together, since their order is not known before ties are broken.
//
// Reads and writes: links, heads. Reads, for ties: colours, importances, positions; to drop: colours.
// Writes: whether there are ties, the longest list, the long lists. No colour output.

//VTK::Pellucid::Lists
//VTK::Pellucid::Importance
//VTK::Pellucid::OpaqueDepth

bool hasTies = false;

#if PELLUCID_BREAK_TIES
bool isLess(uvec2 a, uvec2 b)
{
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// Less opaque first; then by red, green, blue; then less important, and by where they are among the
// segments. Nodes equal in all this are interchangeable.
bool isBeforeOfEqualDepth(uint a, uint b)
{
  uvec2 colorA = pellucidColors[a];
  uvec2 colorB = pellucidColors[b];
#if PELLUCID_OPTIMIZE
  if (colorA == colorB)
  {
    uvec2 importanceA = pellucidImportances[a];
    uvec2 importanceB = pellucidImportances[b];
    if (importanceA == importanceB)
    {
      return isLess(pellucidPositions[a], pellucidPositions[b]);
    }
    return isLess(importanceA, importanceB);
  }
#endif
  return isLess(colorA.yx, colorB.yx);
}
#endif

// Nearer first
bool isBefore(uint a, uint depthA, uint b, uint depthB)
{
#if PELLUCID_BREAK_TIES
  if (depthA == depthB)
  {
    return isBeforeOfEqualDepth(a, b);
  }
#else
  // Neighbours in the result have been compared with each other, so that this finds all ties.
  hasTies = hasTies || depthA == depthB;
#endif
  return depthA < depthB;
}

#if PELLUCID_DROPS_HIDDEN
uint hiddenDepth = 0xffffffffu; // what is not nearer cannot be seen

// Whether a sorted list that so far lets `transmittance` through hides the node behind
bool hides(float transmittance, uint last, uint depth)
{
  bool isHidden = transmittance < PELLUCID_HIDDEN_TRANSMITTANCE && pellucidLinks[last].y != depth;
  hiddenDepth = isHidden ? min(hiddenDepth, depth) : hiddenDepth;
  return isHidden;
}
#endif

// Both lists are not empty
uint merge(uint a, uint b)
{
#if PELLUCID_DROPS_HIDDEN
  float transmittance = 1.0;
#endif
  uint depthA = pellucidLinks[a].y;
  uint depthB = pellucidLinks[b].y;
  uint first = 0u;
  uint last = 0u;
  while (a != 0u && b != 0u)
  {
    bool takeB = isBefore(b, depthB, a, depthA);
    uint node = takeB ? b : a;
    uint next = pellucidLinks[node].x;
#if PELLUCID_DROPS_HIDDEN
    if (hides(transmittance, last, takeB ? depthB : depthA))
    {
      break;
    }
    transmittance *= 1.0 - pellucidUnpackOpacity(pellucidColors[node]);
#endif
    if (last == 0u)
    {
      first = node;
    }
    else
    {
      pellucidLinks[last].x = node;
    }
    last = node;
    uint nextDepth = next == 0u ? 0u : pellucidLinks[next].y;
    if (takeB)
    {
      b = next;
      depthB = nextDepth;
    }
    else
    {
      a = next;
      depthA = nextDepth;
    }
  }
  uint rest = a == 0u || b != 0u && depthB < depthA ? b : a;
#if PELLUCID_DROPS_HIDDEN
  rest = hides(transmittance, last, pellucidLinks[rest].y) ? 0u : rest;
#endif
  pellucidLinks[last].x = rest;
  return first;
}

void noteLongList(int pixel, uint dropped)
{
  // There is room for all: the buffer has an entry for every PELLUCID_MAXIMUM_SHADER_LIST nodes.
  uint entry = atomicAdd(pellucidLongListCount, 1u) * uint(PELLUCID_LONG_LIST_HEAD + PELLUCID_SAMPLES);
  pellucidLongLists[entry] = uint(pixel);
  pellucidLongLists[entry + 1u] = dropped;
  for (int sampleIndex = 0; sampleIndex < PELLUCID_SAMPLES; ++sampleIndex)
  {
    pellucidLongLists[entry + uint(PELLUCID_LONG_LIST_HEAD + sampleIndex)] =
      floatBitsToUint(pellucidOpaqueLimit(ivec2(gl_FragCoord.xy), sampleIndex));
  }
}

void main()
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  uint node = pixel < 0 ? 0u : pellucidHeads[pixel];
#if PELLUCID_BREAK_TIES
  node = (node & PELLUCID_TIED) != 0u ? node & ~PELLUCID_TIED : 0u;
#endif
  if (node == 0u)
  {
    discard;
  }

  // Where `runs` has bit k: a sorted list of PELLUCID_RUN_LENGTH * 2^k nodes
  uint lists[PELLUCID_LIST_LEVELS];
  lists[0] = 0u; // compilers warn of arrays that are first written by a variable index
  uint runs = 0u;
  uint length = 0u;
  uint sorted = 0u;
  while (node != 0u && length <= uint(PELLUCID_MAXIMUM_SHADER_LIST))
  {
    uint nodes[PELLUCID_RUN_LENGTH];
    uint depths[PELLUCID_RUN_LENGTH];
    nodes[0] = 0u;
    depths[0] = 0u;
    int count = 0;
    while (node != 0u && count < PELLUCID_RUN_LENGTH && length <= uint(PELLUCID_MAXIMUM_SHADER_LIST))
    {
      uvec2 link = pellucidLinks[node];
      ++length;
#if PELLUCID_DROPS_HIDDEN
      if (link.y >= hiddenDepth)
      {
        node = link.x;
        continue;
      }
#endif
      int slot = count;
      while (slot > 0 && isBefore(node, link.y, nodes[slot - 1], depths[slot - 1]))
      {
        nodes[slot] = nodes[slot - 1];
        depths[slot] = depths[slot - 1];
        --slot;
      }
      nodes[slot] = node;
      depths[slot] = link.y;
      ++count;
      node = link.x;
    }
    for (int i = 0; i < count; ++i)
    {
      pellucidLinks[nodes[i]].x = i + 1 < count ? nodes[i + 1] : 0u;
    }
    sorted = nodes[0];
    if (count > 0 && (node != 0u || length > uint(PELLUCID_RUN_LENGTH)))
    {
      int level = 0;
      while ((runs >> level & 1u) != 0u)
      {
        sorted = merge(lists[level], sorted);
        ++level;
      }
      lists[level] = sorted;
      ++runs;
    }
  }

  if (runs != 0u)
  {
    sorted = lists[findLSB(runs)];
    runs &= runs - 1u;
  }
  while (runs != 0u)
  {
    sorted = merge(lists[findLSB(runs)], sorted);
    runs &= runs - 1u;
  }

  if (node != 0u)
  {
    // The nodes that have been read are in `sorted`; hang the rest behind them.
    uint last = sorted;
    uint kept = 1u;
    while (pellucidLinks[last].x != 0u)
    {
      last = pellucidLinks[last].x;
      ++kept;
    }
    pellucidLinks[last].x = node;
    noteLongList(pixel, length - kept);
  }
  else
  {
    if (length > pellucidLongestList)
    {
      atomicMax(pellucidLongestList, length);
    }
    if (hasTies)
    {
      pellucidHasTies = 1u;
      atomicOr(pellucidHeads[pellucidBlockOfPixel(ivec2(gl_FragCoord.xy))], PELLUCID_BLOCK_HAS_TIES);
      sorted |= PELLUCID_TIED;
    }
  }
  pellucidHeads[pixel] = sorted;
}
