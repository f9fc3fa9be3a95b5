// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// The segments of the scene and the parameters of their actors; the C++ side is vtkSegmentOpacities.
//
// Declares: the buffers of segments and of actors.

// x: least opacity of the segment's fragments as bits, PELLUCID_UNSEEN where it has none; y: its actor.
// Segment 0 stands for all actors that take no part.
layout(std430, binding = PELLUCID_SEGMENTS_BINDING) buffer PellucidSegments
{
  uvec2 pellucidSegments[];
};

struct PellucidActor
{
  // vtkOpacityOptimization
  float occlusionWeight;  // q of equation 9 of Guenther et al. 2017
  float clutterWeight;    // r
  float exponent;         // 2 lambda
  uint smoothingIterations;
  uint selfOcclusion;     // 1: a segment may hide itself

  // vtkOcclusionAvoidance
  uint avoids;            // 0: is optimised; 1: by penalty, 2: by weighting, 4 more: attributes are smoothed
  float penalty;
  float importanceWeight; // m of equation 3.3 of Bandle 2016
  float coverageWeight;   // c
  float varianceWeight;   // v
  float depthWeight;      // d
  float lambda;
  float globalOpacity;
};

layout(std430, binding = PELLUCID_ACTORS_BINDING) readonly buffer PellucidActors
{
  PellucidActor pellucidActors[];
};
