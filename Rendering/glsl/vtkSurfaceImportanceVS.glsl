// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather: added to the vertex shader of VTK's mappers for actors whose opacities are optimised.
//
// Reads: the importance of the vertex. Writes: what vtkSurfaceImportanceDec.glsl reads. Of data that
// vtkSurfaceSegments made, vertex 3 t + c is corner c of triangle t.

in float pellucidImportanceMC;
out float pellucidImportanceVSOutput;
out vec2 pellucidSharesVSOutput;
flat out int pellucidVertexVSOutput;

void pellucidPassImportance()
{
  int corner = gl_VertexID % 3;
  // Also of NaN, which would spread over the triangle, a number
  pellucidImportanceVSOutput = pellucidImportanceMC > 0.0 ? min(pellucidImportanceMC, 1.0) : 0.0;
  pellucidSharesVSOutput = vec2(corner == 1, corner == 2);
  pellucidVertexVSOutput = gl_VertexID;
}
