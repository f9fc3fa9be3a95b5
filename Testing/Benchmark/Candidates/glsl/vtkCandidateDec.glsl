// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What all candidates share: counters, and the pixels of the picture. The C++ side is vtkCandidatePass.

layout(std430, binding = PELLUCID_COUNTERS_BINDING) buffer PellucidCounters
{
  uint pellucidFragmentCount; // translucent fragments in front of the opaque scene
  uint pellucidLongestList;   // of the fragments of one pixel that were kept at a time
  uint pellucidLossyPixels;   // whose fragments were not all composited in their order
  uint pellucidHasTies;       // whether a pixel has fragments of equal depth
};

// In window pixels
uniform ivec2 pellucidViewportOrigin;
uniform ivec2 pellucidViewportSize;

// Index of the window pixel in the picture, -1 outside
int pellucidPixelIndex(ivec2 windowPixel)
{
  ivec2 pixel = windowPixel - pellucidViewportOrigin;
  bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, pellucidViewportSize));
  return inside ? pixel.y * pellucidViewportSize.x + pixel.x : -1;
}

void pellucidNoteLength(uint length)
{
  if (length > pellucidLongestList)
  {
    atomicMax(pellucidLongestList, length);
  }
}
