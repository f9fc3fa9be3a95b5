// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Repeated selection of the 16 nearest of what is left, by insertion into registers: the list stays
// where it is. Long lists that end before the budget of loop iterations are complete.

const int SELECTED = 16;

uint nodes[SELECTED];
uint depths[SELECTED];
uint firstNode = 0u;
uint endNode = 0u;
uint listLength = 0u;
int count = SELECTED;
int taken = SELECTED;
uint lastNode = 0u; // of those taken; 0: none yet
uint lastDepth = 0u;
uint steps = 0u;
bool ranOut = false;

void beginList(uint first, uint end)
{
  firstNode = first;
  endNode = end;
}

uint getLength()
{
  return listLength;
}

bool isLossy()
{
  return ranOut;
}

void selectNearest()
{
  bool isFirst = lastNode == 0u;
  nodes[0] = 0u;
  depths[0] = 0u;
  count = 0;
  taken = 0;
  for (uint node = firstNode; node != endNode && steps < PELLUCID_LOOP_BUDGET; node = nextNode(node))
  {
    ++steps;
    listLength += isFirst ? 1u : 0u;
    uint depth = getDepth(node);
    if ((!isFirst && !isBefore(lastNode, lastDepth, node, depth)) ||
      (count == SELECTED && !isBefore(node, depth, nodes[SELECTED - 1], depths[SELECTED - 1])))
    {
      continue;
    }
    ++steps; // of the loop below, the one that ends it
    int slot = min(count, SELECTED - 1);
    while (slot > 0 && isBefore(node, depth, nodes[slot - 1], depths[slot - 1]))
    {
      nodes[slot] = nodes[slot - 1];
      depths[slot] = depths[slot - 1];
      --slot;
      ++steps;
    }
    nodes[slot] = node;
    depths[slot] = depth;
    count = min(count + 1, SELECTED);
  }
  ranOut = steps >= PELLUCID_LOOP_BUDGET;
}

uint takeNearest(out uint depth)
{
  depth = 0u;
  if (taken == SELECTED)
  {
    selectNearest();
  }
  if (taken == count || ranOut)
  {
    return 0u;
  }
  lastNode = nodes[taken];
  lastDepth = depths[taken];
  depth = lastDepth;
  ++taken;
  return lastNode;
}
