#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Resolve of vtkCandidateLayersPass: what is composited already, the entries, the opaque scene.
//
// Reads: states, entries, the copied opaque colour. Writes: the pixel's colour.

//VTK::Pellucid::Declarations
//VTK::Pellucid::Blend

void main()
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  uint state = pixel < 0 ? 0u : pellucidStates[pixel].x;
  if (state == 0u)
  {
    discard;
  }
  vec4 front = pellucidFronts[pixel];
  vec3 color = front.rgb;
  float transmittance = 1.0 - front.a;
  bool isCut = transmittance <= PELLUCID_NEGLIGIBLE_TRANSMITTANCE &&
    transmittance > PELLUCID_VISIBLE_TRANSMITTANCE;
  int first = pixel * PELLUCID_LAYERS;
  int count = int(state & ~PELLUCID_LOSSY);
  for (int slot = first; slot < first + count; ++slot)
  {
    vec4 fragment = pellucidUnpackColor(pellucidColors[slot]);
    color += transmittance * fragment.a * fragment.rgb;
    transmittance *= 1.0 - fragment.a;
  }
  pellucidNoteLength(uint(count));
  if (isCut || (state & PELLUCID_LOSSY) != 0u)
  {
    atomicAdd(pellucidLossyPixels, 1u);
  }
  pellucidBlend(color, transmittance);
}
