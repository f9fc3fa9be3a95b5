// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather: added to the fragment shader of every mapper, after vtkFragmentListsDec,
// vtkFragmentColorDec and vtkOpaqueDepthDec.
//
// Reads: the opaque depth. Writes: one node, the head of its pixel, the flag of its block.

uniform int pellucidNodeCapacity; // nodes 1..capacity may be written

#if PELLUCID_OPTIMIZE
uvec2 pellucidImportance = uvec2(0u); // of this fragment; of an actor that takes part, the mapper's code sets it
uvec2 pellucidPosition = uvec2(0u);
#endif

void pellucidAppend(vec4 color, float depth)
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  if (!(color.a > 0.0) || pixel < 0)
  {
    return;
  }
  uint node = atomicAdd(pellucidFragmentCount, 1u) + 1u;
  if (node == 0u)
  {
    atomicAdd(pellucidFragmentCountHigh, 1u);
  }
  else if (node <= uint(pellucidNodeCapacity))
  {
    uint next = atomicExchange(pellucidHeads[pixel], node);
    if (next == 0u)
    {
      pellucidHeads[pellucidBlockOfPixel(ivec2(gl_FragCoord.xy))] = PELLUCID_BLOCK_HAS_FRAGMENTS;
    }
    pellucidLinks[node] = uvec2(next, floatBitsToUint(pellucidStoredDepth(depth)));
    pellucidColors[node] = pellucidPackColor(color.rgb, color.a);
#if PELLUCID_OPTIMIZE
    pellucidImportances[node] = pellucidImportance;
    pellucidPositions[node] = pellucidPosition;
#endif
  }
}
