#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A quad over each block of pixels that has PELLUCID_DRAWN_BLOCKS among its flags; the instance is the
// block. Software renderers spend as much on a pixel without fragments as on one with a few.
//
// Reads: the flags of the blocks.

//VTK::Pellucid::Lists

// In window pixels
uniform ivec2 pellucidViewportOrigin;
uniform ivec2 pellucidViewportSize;

void main()
{
  int columns = pellucidBlockColumns();
  ivec2 block = ivec2(gl_InstanceID % columns, gl_InstanceID / columns);
  ivec2 corner = PELLUCID_BLOCK_SIDE * (block + ivec2(gl_VertexID & 1, gl_VertexID >> 1));
  vec2 place = vec2(min(corner, pellucidTileSize) + pellucidTileOrigin - pellucidViewportOrigin);
  bool isDrawn = (pellucidHeads[pellucidBlockIndex(gl_InstanceID)] & PELLUCID_DRAWN_BLOCKS) != 0u;
  gl_Position = isDrawn ? vec4(2.0 * place / vec2(pellucidViewportSize) - 1.0, 0.0, 1.0)
                        : vec4(2.0, 2.0, 2.0, 1.0);
}
