// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// A heap with four children for each entry as priority queue: a pixel that is opaque after a few
// fragments never sorts the others (M. Bandle 2016, section 2.4.4).

int heapSize = 0;

// Move the entry down to where no child is nearer.
void siftDown(int entry)
{
  uint node = nodes[entry];
  uint depth = depths[entry];
  int child = 4 * entry + 1;
  while (child < heapSize)
  {
    int nearest = child;
    int last = min(child + 4, heapSize);
    for (int other = child + 1; other < last; ++other)
    {
      nearest = isEntryBefore(other, nearest) ? other : nearest;
    }
    if (!isBefore(nodes[nearest], depths[nearest], node, depth))
    {
      break;
    }
    nodes[entry] = nodes[nearest];
    depths[entry] = depths[nearest];
    entry = nearest;
    child = 4 * entry + 1;
  }
  nodes[entry] = node;
  depths[entry] = depth;
}

void sortArray()
{
  heapSize = count;
  for (int entry = (count - 2) / 4; entry >= 0; --entry)
  {
    siftDown(entry);
  }
}

uint takeFirst(out uint depth)
{
  uint node = nodes[0];
  depth = depths[0];
  --heapSize;
  nodes[0] = nodes[heapSize];
  depths[0] = depths[heapSize];
  siftDown(0);
  return node;
}
