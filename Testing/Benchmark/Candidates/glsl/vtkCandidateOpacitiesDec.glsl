// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The minimum opacity of what is composited, in squares of 2, 4, 8... pixels: the mip map of
// vtkCandidateDepthSlicesPass without its finest level. Level l has 2^(PELLUCID_LEVELS - l) rows and
// columns, of which the picture takes a part.

layout(std430, binding = PELLUCID_OPACITIES_BINDING) buffer PellucidOpacities
{
  float pellucidOpacities[];
};

int pellucidOpacityIndex(int level, ivec2 texel)
{
  int levels = 1 << (2 * PELLUCID_LEVELS);
  int first = (levels - (1 << (2 * (PELLUCID_LEVELS - level + 1)))) / 3;
  return first + (texel.y << (PELLUCID_LEVELS - level)) + texel.x;
}
