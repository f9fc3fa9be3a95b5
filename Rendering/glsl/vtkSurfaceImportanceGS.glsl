// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gather: added to the geometry shaders with which VTK's mappers draw edges and wide lines.
//
// Passes what vtkSurfaceImportanceVS.glsl writes; VTK renames the inputs of the fragment shader.

in float pellucidImportanceVSOutput[];
in vec2 pellucidSharesVSOutput[];
flat in int pellucidVertexVSOutput[];
out float pellucidImportanceGSOutput;
out vec2 pellucidSharesGSOutput;
flat out int pellucidVertexGSOutput;

#define pellucidPassImportance(vertex) \
  pellucidImportanceGSOutput = pellucidImportanceVSOutput[vertex]; \
  pellucidSharesGSOutput = pellucidSharesVSOutput[vertex]; \
  pellucidVertexGSOutput = pellucidVertexVSOutput[vertex]
