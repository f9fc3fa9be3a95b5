// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Depth of the opaque scene; the C++ side is vtkOpaqueLayer.
// PELLUCID_SAMPLES is the number of samples of the target, 1 without multisampling,
// PELLUCID_DEPTH_RESOLUTION one step of its depth.
//
// Reads: the copied depth. Declares: the farthest depth at which a fragment is still in front, and
// whether the fragment is hidden.

// As few uniforms as can be: Mesa's software renderer loads each anew for every four by two pixels.
#if PELLUCID_SAMPLES > 1
uniform sampler2DMS pellucidOpaqueDepth;
#else
uniform sampler2D pellucidOpaqueDepth;
#endif
uniform ivec2 pellucidOpaqueOrigin; // window pixel of texel 0, 0
uniform int pellucidOpaqueScale;    // texels for each window pixel, to either side

float pellucidOpaqueLimit(ivec2 windowPixel, int sampleIndex)
{
  ivec2 texel = (windowPixel - pellucidOpaqueOrigin) * pellucidOpaqueScale + pellucidOpaqueScale / 2;
#if PELLUCID_SAMPLES > 1
  ivec2 size = textureSize(pellucidOpaqueDepth);
  float depth = texelFetch(pellucidOpaqueDepth, min(texel, size - 1), sampleIndex).r;
#else
  ivec2 size = textureSize(pellucidOpaqueDepth, 0);
  float depth = texelFetch(pellucidOpaqueDepth, min(texel, size - 1), 0).r;
#endif
  return depth + PELLUCID_DEPTH_RESOLUTION;
}

// A fragment behind this is hidden in every sample of the pixel
float pellucidFarthestOpaqueLimit(ivec2 windowPixel)
{
  float limit = pellucidOpaqueLimit(windowPixel, 0);
#if PELLUCID_SAMPLES > 1 // a loop without rounds takes time, too
  for (int sampleIndex = 1; sampleIndex < PELLUCID_SAMPLES; ++sampleIndex)
  {
    limit = max(limit, pellucidOpaqueLimit(windowPixel, sampleIndex));
  }
#endif
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
