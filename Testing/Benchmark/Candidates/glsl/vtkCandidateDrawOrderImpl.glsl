// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
//
// Quads that are not drawn have shrunk to a point.
if (node < pellucidSlice.x || node >= pellucidSlice.y)
{
  return;
}
node = int(pellucidOrder[node]);
