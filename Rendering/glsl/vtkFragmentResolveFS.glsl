#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve: composites the sorted list of each pixel over the opaque scene. Multisampled targets get
// two draws: PELLUCID_SAMPLE_SHADING 0 for pixels whose samples all have the same result, then 1,
// once for each sample of the others.
//
// Reads: heads, links, colours, the copied opaque colour and depth, the optimised opacities, and what the
// view shows. Writes: the pixel's colour.
//
// Front-to-back compositing: M. Bandle 2016, equations 2.3 and 2.4, with premultiplied accumulation.

//VTK::Pellucid::Lists
//VTK::Pellucid::Importance
//VTK::Pellucid::Opacity
//VTK::Pellucid::OpaqueDepth
//VTK::Pellucid::View

#if PELLUCID_SAMPLES > 1
uniform sampler2DMS pellucidOpaqueColor;
#else
uniform sampler2D pellucidOpaqueColor;
#endif

layout(location = 0) out vec4 resolvedColor;

vec4 opaqueColor(ivec2 windowPixel, int sampleIndex)
{
#if PELLUCID_SAMPLES > 1
  return texelFetch(pellucidOpaqueColor, windowPixel - pellucidOpaqueOrigin, sampleIndex);
#else
  return texelFetch(pellucidOpaqueColor, windowPixel - pellucidOpaqueOrigin, 0);
#endif
}

// Whether the samples of the pixel differ in opaque colour, or in the fragments in front of it
bool samplesDiffer(ivec2 windowPixel, uint node)
{
  vec4 color = opaqueColor(windowPixel, 0);
  float nearest = pellucidOpaqueLimit(windowPixel, 0);
  for (int sampleIndex = 1; sampleIndex < PELLUCID_SAMPLES; ++sampleIndex)
  {
    if (opaqueColor(windowPixel, sampleIndex) != color)
    {
      return true;
    }
    nearest = min(nearest, pellucidOpaqueLimit(windowPixel, sampleIndex));
  }
  uint nearestBits = floatBitsToUint(nearest);
  while (node != 0u)
  {
    uvec2 link = pellucidLinks[node];
    if (link.y > nearestBits)
    {
      return true;
    }
    node = link.x;
  }
  return false;
}

void main()
{
  ivec2 windowPixel = ivec2(gl_FragCoord.xy);
  int pixel = pellucidPixelIndex(windowPixel);
  uint head = pixel < 0 ? 0u : pellucidHeads[pixel];
  uint node = head & ~PELLUCID_COLLAPSED;
  bool collapsed = node != head; // the CPU has applied all but the compositing
  if (node == 0u)
  {
    discard;
  }
  int sampleIndex = 0;
#if PELLUCID_SAMPLES > 1
  if (samplesDiffer(windowPixel, node) != (PELLUCID_SAMPLE_SHADING == 1))
  {
    discard;
  }
#if PELLUCID_SAMPLE_SHADING
  sampleIndex = gl_SampleID;
#endif
#endif

  uint limit = floatBitsToUint(pellucidOpaqueLimit(windowPixel, sampleIndex));
  vec3 color = vec3(0.0);
  float transmittance = 1.0;
  int layer = 0;
  while (node != 0u && transmittance > PELLUCID_NEGLIGIBLE_TRANSMITTANCE)
  {
    uvec2 link = pellucidLinks[node];
    if (link.y > limit)
    {
      break;
    }
    vec4 fragment = pellucidUnpackColor(pellucidColors[node]);
    float factor = 1.0;
#if PELLUCID_OPTIMIZE
    factor = collapsed ? 1.0 : pellucidOptimizedOpacity(pellucidPositions[node]);
#endif
#if PELLUCID_VIEW
    fragment = collapsed ? fragment : pellucidViewed(fragment, factor, node, ++layer);
#else
    fragment.a *= factor;
#endif
    color += transmittance * fragment.a * fragment.rgb;
    transmittance *= 1.0 - fragment.a;
    node = link.x;
  }

  vec4 behind = opaqueColor(windowPixel, sampleIndex);
#if PELLUCID_ROUND_LAYERS
  color = round(255.0 * color) / 255.0;
  transmittance = round(255.0 * transmittance) / 255.0;
#endif
  resolvedColor =
    vec4(color + transmittance * behind.rgb, 1.0 - transmittance * (1.0 - behind.a));
}
