// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A list in local memory: what the candidates that sort it there share. Each has
//   void sortArray()                - prepares the entries 0..count-1
//   uint takeFirst(out uint depth)  - the node of the nearest entry but those `taken`
// Only the first PELLUCID_ARRAY_LENGTH nodes of a list fit: as BAN16, listing A.3, but counted as lost.

uint nodes[PELLUCID_ARRAY_SIZE];
uint depths[PELLUCID_ARRAY_SIZE];
uint listLength = 0u;
int count = 0;
int taken = 0;

// Compilers warn of arrays that are first written by a variable index.
void clearArray()
{
  nodes[0] = 0u;
  depths[0] = 0u;
}

bool isEntryBefore(int a, int b)
{
  return isBefore(nodes[a], depths[a], nodes[b], depths[b]);
}

//VTK::Pellucid::SortArray

void beginList(uint first, uint end)
{
  clearArray();
  for (uint node = first; node != end && listLength < PELLUCID_COUNTED_LENGTH; node = nextNode(node))
  {
    if (listLength < uint(PELLUCID_ARRAY_LENGTH))
    {
      nodes[listLength] = node;
      depths[listLength] = getDepth(node);
    }
    ++listLength;
  }
  count = min(int(listLength), PELLUCID_ARRAY_LENGTH);
  sortArray();
}

uint getLength()
{
  return listLength;
}

bool isLossy()
{
  return listLength > uint(PELLUCID_ARRAY_LENGTH);
}

uint takeNearest(out uint depth)
{
  depth = 0u;
  if (taken == count)
  {
    return 0u;
  }
  uint node = takeFirst(depth);
  ++taken;
  return node;
}
