// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth of the opaque scene; the C++ side is vtkOpaqueLayer.
// PELLUCID_SAMPLES is the number of samples of the target, 1 without multisampling.
//
// Reads: the copied depth. Declares: the farthest depth at which a fragment is still in front, and
// whether the fragment is hidden.

#if PELLUCID_SAMPLES > 1
uniform sampler2DMS pellucidOpaqueDepth;
#else
uniform sampler2D pellucidOpaqueDepth;
#endif
uniform ivec2 pellucidOpaqueOrigin;    // window pixel of texel 0, 0
uniform ivec2 pellucidOpaqueSize;      // texels
uniform int pellucidOpaqueScale;       // texels for each window pixel, to either side
uniform float pellucidDepthResolution; // one step of the depth buffer

float pellucidOpaqueLimit(ivec2 windowPixel, int sampleIndex)
{
  ivec2 texel = (windowPixel - pellucidOpaqueOrigin) * pellucidOpaqueScale + pellucidOpaqueScale / 2;
  return texelFetch(pellucidOpaqueDepth, min(texel, pellucidOpaqueSize - 1),
#if PELLUCID_SAMPLES > 1
    sampleIndex
#else
    0
#endif
    ).r + pellucidDepthResolution;
}

// A fragment behind this is hidden in every sample of the pixel
float pellucidFarthestOpaqueLimit(ivec2 windowPixel)
{
  float limit = pellucidOpaqueLimit(windowPixel, 0);
  for (int sampleIndex = 1; sampleIndex < PELLUCID_SAMPLES; ++sampleIndex)
  {
    limit = max(limit, pellucidOpaqueLimit(windowPixel, sampleIndex));
  }
  return limit;
}

// Window depth as it is stored; NaN becomes 0
float pellucidStoredDepth(float depth)
{
  return depth > 0.0 ? min(depth, 1.0) : 0.0;
}

bool pellucidIsHidden(float depth)
{
  return pellucidStoredDepth(depth) > pellucidFarthestOpaqueLimit(ivec2(gl_FragCoord.xy));
}
