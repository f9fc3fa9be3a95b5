// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Added to the vertex shader of rounded cones: the nodes in the order of vtkCandidateKBufferPass.

layout(std430, binding = PELLUCID_ORDER_BINDING) readonly buffer PellucidOrder
{
  uint pellucidOrder[];
};
