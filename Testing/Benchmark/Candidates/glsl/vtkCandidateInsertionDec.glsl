// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gapped insertion sort: PELLUCID_GAPS { 1 } is insertion sort, Ciura's gaps are Shell sort (M. Bandle
// 2016, section 2.4.3 and listing A.2.3).

void sortArray()
{
  const int gaps[PELLUCID_NUMBER_OF_GAPS] = int[](PELLUCID_GAPS);
  for (int i = 0; i < PELLUCID_NUMBER_OF_GAPS; ++i)
  {
    int gap = gaps[i];
    for (int entry = gap; entry < count; ++entry)
    {
      uint node = nodes[entry];
      uint depth = depths[entry];
      int slot = entry;
      while (slot >= gap && isBefore(node, depth, nodes[slot - gap], depths[slot - gap]))
      {
        nodes[slot] = nodes[slot - gap];
        depths[slot] = depths[slot - gap];
        slot -= gap;
      }
      nodes[slot] = node;
      depths[slot] = depth;
    }
  }
}

uint takeFirst(out uint depth)
{
  depth = depths[taken];
  return nodes[taken];
}
