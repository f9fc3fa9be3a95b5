// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Tiles cover a picture once, within the memory limit, also where no 32 bits hold its pixels, bytes
// or fragments.
#include "vtkFragmentTiles.h"

#include "ReferenceTesting.h"

namespace
{
constexpr vtkIdType BytesPerMiB = 1024 * 1024;
constexpr vtkIdType BytesPerNode = 32;

void TestPicture(Checks& checks, int width, int height, vtkIdType limit, vtkIdType layers)
{
  const std::string name = std::to_string(width) + " x " + std::to_string(height) + ", " +
    std::to_string(layers) + " layers, " + std::to_string(limit / BytesPerMiB) + " MiB: ";
  vtkFragmentTiles tiles;
  for (const bool isFirst : { true, false })
  {
    tiles.Begin({ { 0, 0 }, { width, height } }, limit, vtkIdType(1) << 40, BytesPerNode);
    vtkPixelRectangle tile;
    vtkIdType pixels = 0;
    vtkIdType moment = 0; // tells a tile at a wrong place
    bool isInside = true;
    int split = 0;
    while (tiles.Next(tile))
    {
      const vtkIdType fragments = tile.GetNumberOfPixels() * layers;
      if (tiles.MustSplit(tile, fragments))
      {
        ++split;
        tiles.Split(tile, fragments);
        continue;
      }
      isInside &= tile.Origin[0] >= 0 && tile.Origin[1] >= 0 && tile.Size[0] > 0 &&
        tile.Size[1] > 0 && tile.Origin[0] + tile.Size[0] <= width &&
        tile.Origin[1] + tile.Size[1] <= height;
      checks.True(name + "a tile exceeds the limit",
        fragments * BytesPerNode <= limit && tile.GetNumberOfPixels() * 4 <= limit);
      pixels += tile.GetNumberOfPixels();
      moment += tile.GetNumberOfPixels() * (tile.Origin[0] + tile.Origin[1]) +
        tile.GetNumberOfPixels() * (tile.Size[0] + tile.Size[1] - 2) / 2;
      tiles.Finish(tile, fragments);
    }
    const vtkIdType all = static_cast<vtkIdType>(width) * height;
    checks.True(name + "a tile lies outside", isInside);
    checks.True(name + std::to_string(pixels) + " pixels in tiles", pixels == all);
    // Each tile may round a half away.
    checks.Near(name + "first moment", static_cast<double>(moment) / static_cast<double>(all),
      0.5 * (width + (height - 2.0)), 1.0);
    checks.True(name + "the second sweep has other tiles", isFirst || split == 0);
  }
}
}

//------------------------------------------------------------------------------
int TestFragmentTiles(int, char*[])
{
  Checks checks;
  TestPicture(checks, 46341, 46341, BytesPerMiB, 1);          // 2^31 pixels
  TestPicture(checks, 16384, 16385, 1024 * BytesPerMiB, 100); // 2^32 fragments
  TestPicture(checks, 65536, 65536, 4096 * BytesPerMiB, 5);   // 2^32 pixels and bytes
  TestPicture(checks, 1, 2147483647, 64 * BytesPerMiB, 3);
  return checks.Result();
}
