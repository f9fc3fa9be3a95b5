// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Declarations for the shaders that read the nodes of trajectories, vtkRoundedConeVS.glsl and
// vtkRoundedConeExitDecFS.glsl.

// xyz: point minus the centre of the data, data units. |w|: radius, world units; w < 0: a segment
// leads to the next node.
uniform samplerBuffer nodes;

uniform mat4 nodeVCMatrix;  // node to view coordinates

//VTK::NodeRemainder::Dec

vec4 fetchNode(int index)
{
  vec4 node = texelFetch(nodes, index);
  //VTK::NodeRemainder::Impl
  return node;
}

// The normal of a joint plane: it halves the angle between the segments that meet there. Zero where
// the line turns straight back. (Normal to the chord from the previous to the next node, as in Gross
// and Gumhold 2021, eq. 11, the plane would cut segments of unequal length in different ellipses.)
vec3 bisector(vec3 before, vec3 after)
{
  vec3 sum = normalize(before) + normalize(after);
  return dot(sum, sum) > 1e-12 ? normalize(sum) : vec3(0.0);
}
