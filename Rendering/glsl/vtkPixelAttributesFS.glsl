#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Attributes: what vtkFragmentAvoidFS.glsl smooths over neighbouring pixels.
//
// Reads: heads, sorted links, importances, positions. Writes: the attributes of the pixel. No colour output.

//VTK::Pellucid::Lists
//VTK::Pellucid::Importance
//VTK::Pellucid::Tangent
//VTK::Pellucid::Attributes

void main()
{
  ivec2 windowPixel = ivec2(gl_FragCoord.xy);
  int pixel = pellucidPixelIndex(windowPixel);
  uint node = pixel < 0 ? 0u : pellucidHeads[pixel];
  PixelAttributes attributes;
  bool complete = findAttributes(node, attributes);
  if (pixel >= 0 && complete)
  {
    ivec2 place = windowPixel - pellucidPictureOrigin;
    pellucidAttributes[place.y * pellucidPictureSize.x + place.x] = node == 0u
      ? vec2(-1.0)
      : vec2(attributes.importance, pellucidDistance(attributes.depth));
  }
}
