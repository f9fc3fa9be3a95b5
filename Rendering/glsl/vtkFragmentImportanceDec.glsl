// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the nodes of vtkFragmentListsDec.glsl hold besides, in frames whose opacities are optimised;
// the C++ side is vtkFragmentLists.
//
// Declares: the buffers of importances and positions, one element for each node.

// x: importance in [0,1], as bits; y: the segment, 0: of an actor that takes no part; with PELLUCID_AVOIDING
// of one whose opacities follow from occlusion avoidance
layout(std430, binding = PELLUCID_IMPORTANCES_BINDING) buffer PellucidImportances
{
  uvec2 pellucidImportances[];
};

// Between which opacities the fragment lies. x: the first of them. y: as bits, how far it is on the way to
// the second, in [0,1); or with PELLUCID_TRIANGLE set, 15 bits each for the shares of the second and third.
// With PELLUCID_HAS_FACTOR set instead, x is the tangent of vtkTangentDec.glsl, and y has the factor on the
// opacity as bits.
layout(std430, binding = PELLUCID_POSITIONS_BINDING) buffer PellucidPositions
{
  uvec2 pellucidPositions[];
};
