#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A point sprite over each block of pixels that has PELLUCID_DRAWN_BLOCKS among its flags. The viewport
// begins with the tile and has room for whole blocks. Software renderers spend as much on a pixel without
// fragments as on one with a few.
//
// Reads: the flags of the blocks.

//VTK::Pellucid::Lists

void main()
{
  ivec2 blocks = pellucidBlocks();
  vec2 center = vec2(gl_VertexID % blocks.x, gl_VertexID / blocks.x) + 0.5;
  bool isDrawn = (pellucidHeads[pellucidBlockIndex(gl_VertexID)] & PELLUCID_DRAWN_BLOCKS) != 0u;
  gl_Position = isDrawn ? vec4(2.0 * center / vec2(blocks) - 1.0, 0.0, 1.0)
                        : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = float(PELLUCID_BLOCK_SIDE);
}
