// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The per-pixel fragment lists, as every stage sees them; the C++ side is vtkFragmentLists.
// Constants PELLUCID_... come from vtkFragmentLists::GetShaderDefinitions().
//
// Declares: the buffers of heads, links, colours and long lists; the tile that they cover.

layout(std430, binding = PELLUCID_HEADS_BINDING) buffer PellucidHeads
{
  uint pellucidFragmentCount;     // fragments that asked for a node, modulo 2^32
  uint pellucidFragmentCountHigh; // multiples of 2^32
  uint pellucidLongestList;       // of the lists that the sort saw as a whole
  uint pellucidLongListCount;     // lists that are left to the CPU
  uint pellucidSolvedCount;       // fragments whose opacity was optimised
  uint pellucidHasTies;           // whether a list that the sort saw has fragments of equal depth
  // First node of each pixel of the tile, 0: none; then the PELLUCID_BLOCK_... of each block of it.
  // With PELLUCID_COLLAPSED set, the CPU has taken the list's fragments together to what each sample
  // sees. Only the sort sees PELLUCID_TIED.
  uint pellucidHeads[];
};

// x: the next node, 0 at the end; y: window depth as bits, which order as the non-negative floats do
layout(std430, binding = PELLUCID_LINKS_BINDING) buffer PellucidLinks
{
  uvec2 pellucidLinks[];
};

// As vtkFragmentColorDec.glsl packs them
layout(std430, binding = PELLUCID_COLORS_BINDING) buffer PellucidColors
{
  uvec2 pellucidColors[];
};

// For each long list: pixel, nodes that the sort has dropped, then the depth of each sample of the opaque
// scene
layout(std430, binding = PELLUCID_LONG_LISTS_BINDING) buffer PellucidLongLists
{
  uint pellucidLongLists[];
};

// In window pixels
uniform ivec2 pellucidTileOrigin;
uniform ivec2 pellucidTileSize;

// Index of the window pixel in the tile, -1 outside
int pellucidPixelIndex(ivec2 windowPixel)
{
  ivec2 pixel = windowPixel - pellucidTileOrigin;
  bool inside = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, pellucidTileSize));
  return inside ? pixel.y * pellucidTileSize.x + pixel.x : -1;
}

// Columns and rows
ivec2 pellucidBlocks()
{
  return (pellucidTileSize + PELLUCID_BLOCK_SIDE - 1) / PELLUCID_BLOCK_SIDE;
}

// Where pellucidHeads has the flags of a block
int pellucidBlockIndex(int block)
{
  return pellucidTileSize.x * pellucidTileSize.y + block;
}

// Where pellucidHeads has the flags of a pixel's block
int pellucidBlockOfPixel(ivec2 windowPixel)
{
  uvec2 block = uvec2(windowPixel - pellucidTileOrigin) / uint(PELLUCID_BLOCK_SIDE);
  return pellucidBlockIndex(int(block.y) * pellucidBlocks().x + int(block.x));
}
