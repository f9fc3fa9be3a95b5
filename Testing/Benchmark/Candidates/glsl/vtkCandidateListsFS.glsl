#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sort and resolve of vtkCandidateListsPass in one draw: takes the fragments of each pixel from front to
// back until what is behind cannot be seen. The code for Sort is one of the vtkCandidate...SortDec.glsl,
// with these functions:
//   void beginList(uint first, uint end)   - the list of a pixel, from its first node to before `end`
//   uint takeNearest(out uint depth)       - the next node from front to back, 0 if there is none
//   uint getLength()                       - of the whole list, known after the first node was taken
//   bool isLossy()                         - whether nodes were left out that may have been nearer
// Drawn a second time for the pixels with fragments of equal depth, if there are any: only then a
// comparison looks at colours (PELLUCID_BREAK_TIES).
//
// Reads: links, colours, the copied opaque colour. Reads and writes: heads. Writes: the pixel's colour.

//VTK::Pellucid::Declarations
//VTK::Pellucid::Blend

uint nextNode(uint node)
{
#if PELLUCID_CONTIGUOUS
  return node + 1u;
#else
  return pellucidLinks[node].x;
#endif
}

uint getDepth(uint node)
{
#if PELLUCID_CONTIGUOUS
  return pellucidLinks[node];
#else
  return pellucidLinks[node].y;
#endif
}

// Nearer first, no two nodes equal
bool isBefore(uint a, uint depthA, uint b, uint depthB)
{
#if PELLUCID_BREAK_TIES
  if (depthA == depthB)
  {
    return pellucidHasLessColor(a, b);
  }
  return depthA < depthB;
#else
  return depthA < depthB || (depthA == depthB && a < b);
#endif
}

//VTK::Pellucid::Sort

void main()
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  int head = PELLUCID_CONTIGUOUS == 1 ? 2 * pixel : pixel;
  uint word = pixel < 0 ? 0u : pellucidHeads[head];
  uint first = word & ~PELLUCID_TIED;
  if (first == 0u || (PELLUCID_BREAK_TIES == 1 && word == first))
  {
    discard;
  }
#if PELLUCID_CONTIGUOUS
  uint end = first + pellucidHeads[head + 1];
#else
  uint end = 0u;
#endif

  beginList(first, end);
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  uint lastDepth = 0xffffffffu;
  bool hasTies = false;
  bool isCut = false;
  while (true)
  {
    uint depth;
    uint node = takeNearest(depth);
    if (node == 0u)
    {
      break;
    }
    hasTies = hasTies || depth == lastDepth;
    if (transmittance <= PELLUCID_NEGLIGIBLE_TRANSMITTANCE)
    {
      isCut = transmittance > PELLUCID_VISIBLE_TRANSMITTANCE;
      break;
    }
    lastDepth = depth;
    vec4 fragment = pellucidLoadColor(node);
    color += transmittance * fragment.a * fragment.rgb;
    transmittance *= 1.0 - fragment.a;
  }

#if !PELLUCID_BREAK_TIES
  pellucidNoteLength(getLength());
  if (isLossy() || isCut)
  {
    atomicAdd(pellucidLossyPixels, 1u);
  }
  if (hasTies)
  {
    pellucidHasTies = 1u;
    pellucidHeads[head] = first | PELLUCID_TIED;
  }
#endif
  pellucidBlend(color, transmittance);
}
