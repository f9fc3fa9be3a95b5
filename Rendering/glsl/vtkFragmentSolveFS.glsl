#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Solve: the opacity of each fragment by equation 9 of T. Guenther et al., Decoupled Opacity
// Optimization (2017), and of these the least of each segment.
//
// Reads: heads, sorted links, importances, actors. Writes: the least opacity of segments, the number of
// fragments that were solved. No colour output.
//
// As Algorithm 1 of the paper, the sum behind a fragment is what the sum over the list leaves. In single
// precision this cancels; in double precision the squares are exact, and the sums of the lists that a
// shader takes differ by less than 1e-12. (Sums from the back need an array, which costs twice the time.)

//VTK::Pellucid::Lists
//VTK::Pellucid::Importance
//VTK::Pellucid::Segments
//VTK::Pellucid::Power

// Whether a fragment is solved and weighs in the sums, which those of occlusion avoidance do not; `previous`
// is the segment in front of it
bool counts(uvec2 fragment, uint previous)
{
  return int(fragment.y) > 0 &&
    (fragment.y != previous || pellucidActors[pellucidSegments[fragment.y].y].selfOcclusion != 0u);
}

double square(uvec2 fragment)
{
  double importance = double(uintBitsToFloat(fragment.x));
  return importance * importance;
}

void main()
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  uint first = pixel < 0 ? 0u : pellucidHeads[pixel];
  double behind = 0.0;
  uint length = 0u;
  uint solved = 0u;
  uint previous = 0u;
  uint node = first;
  for (; node != 0u && length < uint(PELLUCID_LONGEST_SORTED_LIST); ++length)
  {
    uvec2 fragment = pellucidImportances[node];
    if (counts(fragment, previous))
    {
      behind += square(fragment);
      ++solved;
    }
    previous = fragment.y;
    node = pellucidLinks[node].x;
  }
  if (solved == 0u || node != 0u)
  {
    return; // nothing to do, or left to the CPU
  }
  atomicAdd(pellucidSolvedCount, solved);

  double front = 0.0;
  uint actorIndex = 0u;
  PellucidActor actor = pellucidActors[0];
  previous = 0u;
  for (node = first; node != 0u; node = pellucidLinks[node].x)
  {
    uvec2 fragment = pellucidImportances[node];
    if (counts(fragment, previous))
    {
      uvec2 segment = pellucidSegments[fragment.y];
      if (segment.y != actorIndex)
      {
        actorIndex = segment.y;
        actor = pellucidActors[actorIndex];
      }
      double own = square(fragment);
      behind = max(behind - own, 0.0LF);
      float energy =
        actor.clutterWeight * float(front) + actor.occlusionWeight * float(behind);
      front += own;
      float unimportance = 1.0 - uintBitsToFloat(fragment.x);
      unimportance = unimportance > PELLUCID_LEAST_UNIMPORTANCE ? unimportance : 0.0;
      float weight = pellucidPower(unimportance, actor.exponent);
      // What is of full importance keeps its opacity, against an infinite energy too.
      float opacity = weight > 0.0 ? 1.0 / (1.0 + weight * energy) : 1.0;
      uint bits = floatBitsToUint(opacity);
      if (bits < segment.x)
      {
        atomicMin(pellucidSegments[fragment.y].x, bits);
      }
    }
    previous = fragment.y;
  }
}
