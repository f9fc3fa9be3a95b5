// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Puts what the fragments of a pixel come to over the opaque scene.
//
// Reads: the copied opaque colour. Writes: the colour of the pixel.

uniform sampler2D pellucidOpaqueColor;
uniform ivec2 pellucidOpaqueOrigin; // window pixel of texel 0, 0

layout(location = 0) out vec4 resolvedColor;

void pellucidBlend(vec3 color, float transmittance)
{
  vec4 behind = texelFetch(pellucidOpaqueColor, ivec2(gl_FragCoord.xy) - pellucidOpaqueOrigin, 0);
  resolvedColor =
    vec4(color + transmittance * behind.rgb, 1.0 - transmittance * (1.0 - behind.a));
}
