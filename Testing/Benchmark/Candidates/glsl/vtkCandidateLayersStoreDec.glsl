// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather of vtkCandidateLayersPass: added to the fragment shader of every mapper, after the code of one
// of its subclasses:
//   void pellucidOverflow(int pixel, int first, uint depth, uvec2 color, inout uvec2 state)
//     - takes a fragment where all entries are used
//
// Reads and writes: the entries of the pixel.

void pellucidStore(vec4 color, float depth)
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  if (!(color.a > 0.0) || pixel < 0)
  {
    return;
  }
  atomicAdd(pellucidFragmentCount, 1u);
  uint depthBits = floatBitsToUint(pellucidStoredDepth(depth));
  uvec2 state = pellucidStates[pixel];
  if (1.0 - pellucidFronts[pixel].a <= PELLUCID_NEGLIGIBLE_TRANSMITTANCE)
  {
    if (depthBits < state.y)
    {
      pellucidStates[pixel].x = state.x | PELLUCID_LOSSY;
    }
    return;
  }
  uvec2 words = pellucidPackColor(color.rgb, color.a);
  int first = pixel * PELLUCID_LAYERS;
  uint count = state.x & ~PELLUCID_LOSSY;
  if (count < uint(PELLUCID_LAYERS))
  {
    pellucidInsert(first, count, depthBits, words);
    ++state.x;
  }
  else
  {
    pellucidOverflow(pixel, first, depthBits, words, state);
  }
  pellucidStates[pixel] = state;
}

#if PELLUCID_INTERLOCK
layout(pixel_interlock_ordered) in;
// The two must be called by main() itself.
#define pellucidStoreInOrder(color, depth) beginInvocationInterlockARB(); pellucidStore(color, depth); endInvocationInterlockARB()
#else
#define pellucidStoreInOrder(color, depth) pellucidStore(color, depth)
#endif
