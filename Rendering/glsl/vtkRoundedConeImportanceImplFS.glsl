// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
  // Importance and position of the fragment, where the opacities are optimised; see
  // vtkFragmentImportanceDec.glsl. startSegment and endSegment are those of vtkTrajectorySegmentNodes.
#ifdef PELLUCID_OPTIMIZE
#if PELLUCID_OPTIMIZE
  {
    float along = clamp(0.5 + 0.5 * hit.w / max(coneShape.x, 1e-30), 0.0, 1.0);
    float importance =
      mix(intBitsToFloat(startSegment.x), intBitsToFloat(endSegment.x), along);
    if (pellucidAvoids)
    {
      pellucidImportance =
        uvec2(floatBitsToUint(importance), uint(pellucidFirstSegment) | PELLUCID_AVOIDING);
      pellucidPosition = uvec2(
        coneShape.x > 0.0 ? pellucidPackTangent(axisVC) : 0u, PELLUCID_FACTOR_OF_ONE);
    }
    else
    {
      float place = mix(intBitsToFloat(startSegment.z),
        float(endSegment.y - startSegment.y) + intBitsToFloat(endSegment.z), along);
      uint first = uint(pellucidFirstSegment + startSegment.y + int(floor(place)));
      float share = fract(place);
      pellucidImportance = uvec2(floatBitsToUint(importance), first + (share < 0.5 ? 0u : 1u));
      pellucidPosition = uvec2(first, floatBitsToUint(share));
    }
  }
#endif
#endif
