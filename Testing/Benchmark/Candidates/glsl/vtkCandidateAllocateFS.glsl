#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Between the two draws of the geometry that fill arrays: gives each pixel as many nodes as it has
// fragments, and counts them from 0 again. Pixels are served in the order of the invocations; unlike
// a prefix sum over the image this needs one draw.
//
// Reads and writes: heads. Writes: the number of fragments, the longest list. No colour output.

//VTK::Pellucid::Declarations

void main()
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  uint count = pixel < 0 ? 0u : pellucidHeads[2 * pixel + 1];
  if (count == 0u)
  {
    discard;
  }
  pellucidHeads[2 * pixel] = atomicAdd(pellucidFragmentCount, count) + 1u;
  pellucidHeads[2 * pixel + 1] = 0u;
}
