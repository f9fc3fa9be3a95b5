#version 430
//VTK::Pellucid::Definitions
// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Solve: the opacity of each fragment by equation 9 of T. Guenther et al., Decoupled Opacity
// Optimization (2017), and of these the least of each segment. Lists up to PELLUCID_RUN_LENGTH are
// solved with PELLUCID_BLOCKS 1, longer ones in a second draw, block by block.
//
// Reads: heads, sorted links, importances, actors. Writes: the least opacity of segments, the number of
// fragments that were solved. No colour output.
//
// Sums behind a fragment are added up from the back. Algorithm 1 of the paper takes them as a difference, which
// cancels, and turns negative.

//VTK::Pellucid::Lists
//VTK::Pellucid::Importance
//VTK::Pellucid::Segments

// The fragments of one block that count; importance 0 of an actor that takes no part does not.
struct Block
{
  uint segments[PELLUCID_RUN_LENGTH];
  float importances[PELLUCID_RUN_LENGTH];
  int count;
};

// Reads up to PELLUCID_RUN_LENGTH nodes and moves on; `previous` is the segment in front.
void readBlock(inout uint node, inout uint previous, out Block block)
{
  block.count = 0;
  block.segments[0] = 0u; // compilers warn of arrays that are first written by a variable index
  block.importances[0] = 0.0;
  for (int i = 0; i < PELLUCID_RUN_LENGTH && node != 0u; ++i)
  {
    uvec2 fragment = pellucidImportances[node];
    bool again = fragment.y == previous &&
      pellucidActors[pellucidSegments[fragment.y].y].selfOcclusion == 0u;
    if (fragment.y != 0u && !again)
    {
      block.segments[block.count] = fragment.y;
      block.importances[block.count] = uintBitsToFloat(fragment.x);
      ++block.count;
    }
    previous = fragment.y;
    node = pellucidLinks[node].x;
  }
}

// x^y for x in [0,1], y > 0: whole powers by multiplication, since pow() of some drivers keeps 5 digits
float power(float x, float y)
{
  float result = y == floor(y) || x == 0.0 ? 1.0 : pow(x, fract(y));
  float factor = x;
  for (uint n = uint(y); n != 0u; n >>= 1)
  {
    result *= (n & 1u) != 0u ? factor : 1.0;
    factor *= factor;
  }
  return x == 0.0 ? 0.0 : result;
}

// Squared importances of the blocks before and behind go in; the sum of those before comes out
// with this block added.
void solveBlock(Block block, inout float front, float behindBlock)
{
  float behind[PELLUCID_RUN_LENGTH];
  behind[0] = 0.0;
  float sum = behindBlock;
  for (int i = block.count - 1; i >= 0; --i)
  {
    behind[i] = sum;
    sum += block.importances[i] * block.importances[i];
  }
  float within = 0.0;
  atomicAdd(pellucidSolvedCount, uint(block.count));
  for (int i = 0; i < block.count; ++i)
  {
    uint segment = block.segments[i];
    float importance = block.importances[i];
    PellucidActor actor = pellucidActors[pellucidSegments[segment].y];
    float energy = actor.clutterWeight * (front + within) + actor.occlusionWeight * behind[i];
    float opacity = 1.0 / (1.0 + power(1.0 - importance, actor.exponent) * energy);
    uint bits = floatBitsToUint(opacity);
    if (bits < pellucidSegments[segment].x)
    {
      atomicMin(pellucidSegments[segment].x, bits);
    }
    within += importance * importance;
  }
  front += within;
}

float sumOfSquares(Block block)
{
  float sum = 0.0;
  for (int i = 0; i < block.count; ++i)
  {
    sum += block.importances[i] * block.importances[i];
  }
  return sum;
}

void main()
{
  int pixel = pellucidPixelIndex(ivec2(gl_FragCoord.xy));
  uint node = pixel < 0 ? 0u : pellucidHeads[pixel];
  if (node == 0u)
  {
    return;
  }
  uint start = node;
  uint previous = 0u;
  Block block;
  float front = 0.0;
#if PELLUCID_BLOCKS == 1
  readBlock(node, previous, block);
  if (node == 0u)
  {
    solveBlock(block, front, 0.0);
  }
#else
  uint starts[PELLUCID_BLOCKS];
  uint before[PELLUCID_BLOCKS];
  float sums[PELLUCID_BLOCKS];
  int count = 0;
  while (node != 0u && count < PELLUCID_BLOCKS)
  {
    starts[count] = node;
    before[count] = previous;
    readBlock(node, previous, block);
    sums[count] = sumOfSquares(block);
    ++count;
  }
  if (count < 2 || node != 0u)
  {
    return; // the other draw, or the CPU, has it
  }
  float behind = 0.0;
  for (int i = count - 1; i >= 0; --i)
  {
    float sum = sums[i];
    sums[i] = behind;
    behind += sum;
  }
  for (int i = 0; i < count; ++i)
  {
    node = starts[i];
    previous = before[i];
    readBlock(node, previous, block);
    solveBlock(block, front, sums[i]);
  }
#endif
}
