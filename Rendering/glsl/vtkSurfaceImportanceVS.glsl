// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather: added to the vertex shader of VTK's mappers for actors whose opacities are optimised.
//
// Reads: the vertex's value of the importance array, and the range of it. Writes: what
// vtkSurfaceImportanceDec.glsl reads. Of data that vtkSurfaceSegments made, vertex 3 t + c is corner c of
// triangle t.

in float pellucidImportanceMC;
uniform vec4 pellucidImportanceRange; // of pellucid::ImportanceRange: direction, first, last, scale
out float pellucidImportanceVSOutput;
out vec2 pellucidSharesVSOutput;
flat out int pellucidVertexVSOutput;

// pellucid::ImportanceRange::Map(): also of NaN, which would spread over the triangle, a number
float pellucidMapImportance(float value)
{
  float directed = pellucidImportanceRange.x * value;
  float importance = (directed - pellucidImportanceRange.y) * pellucidImportanceRange.w;
  return directed >= pellucidImportanceRange.z ? 1.0 : (importance > 0.0 ? min(importance, 1.0) : 0.0);
}

void pellucidPassImportance()
{
  int corner = gl_VertexID % 3;
  pellucidImportanceVSOutput = pellucidMapImportance(pellucidImportanceMC);
  pellucidSharesVSOutput = vec2(corner == 1, corner == 2);
  pellucidVertexVSOutput = gl_VertexID;
}
