// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Bottom-up merge sort between the two halves of the arrays.

int sorted = 0; // where the sorted half begins

void sortArray()
{
  for (int width = 1; width < count; width *= 2)
  {
    int target = PELLUCID_ARRAY_LENGTH - sorted;
    int left = 0;
    int right = width;
    int leftEnd = width;
    int rightEnd = min(2 * width, count);
    for (int i = 0; i < count; ++i)
    {
      if (i == rightEnd)
      {
        left = i;
        leftEnd = min(i + width, count);
        right = leftEnd;
        rightEnd = min(i + 2 * width, count);
      }
      bool takesRight =
        left == leftEnd || (right < rightEnd && isEntryBefore(sorted + right, sorted + left));
      int source = sorted + (takesRight ? right : left);
      nodes[target + i] = nodes[source];
      depths[target + i] = depths[source];
      right += takesRight ? 1 : 0;
      left += takesRight ? 0 : 1;
    }
    sorted = target;
  }
}

uint takeFirst(out uint depth)
{
  depth = depths[sorted + taken];
  return nodes[sorted + taken];
}
