// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather of vtkCandidateListsPass: added to the fragment shader of every mapper.
//
// Writes: one node of the pixel; in arrays, unless pellucidFills, counts it only.

uniform int pellucidNodeCapacity; // nodes 1..capacity may be written
uniform int pellucidFills;

void pellucidStore(vec4 color, float depth)
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  if (!(color.a > 0.0) || pixel < 0)
  {
    return;
  }
  uint depthBits = floatBitsToUint(pellucidStoredDepth(depth));
#if PELLUCID_CONTIGUOUS
  uint node = pellucidHeads[2 * pixel] + atomicAdd(pellucidHeads[2 * pixel + 1], 1u);
  if (pellucidFills == 0 || node > uint(pellucidNodeCapacity))
  {
    return;
  }
  pellucidLinks[node] = depthBits;
#else
  uint node = atomicAdd(pellucidFragmentCount, 1u) + 1u;
  if (node > uint(pellucidNodeCapacity))
  {
    return;
  }
  pellucidLinks[node] = uvec2(atomicExchange(pellucidHeads[pixel], node), depthBits);
#endif
  pellucidStoreColor(node, color);
}
