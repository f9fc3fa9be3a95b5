// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Divides the image into rectangles whose fragment lists fit into the memory limit. What was
 * learned in a frame is where the next one begins. Needs no OpenGL.
 */

#ifndef vtkFragmentTiles_h
#define vtkFragmentTiles_h

#include "vtkABINamespace.h"
#include "vtkType.h"

#include <array>
#include <deque>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

/** A rectangle in window pixels. */
struct vtkPixelRectangle
{
  std::array<int, 2> Origin{};
  std::array<int, 2> Size{};

  vtkIdType GetNumberOfPixels() const
  {
    return static_cast<vtkIdType>(this->Size[0]) * this->Size[1];
  }
  bool operator==(const vtkPixelRectangle& other) const
  {
    return this->Origin == other.Origin && this->Size == other.Size;
  }
};

class vtkFragmentTiles
{
public:
  /**
   * Begin a frame, or the second sweep over its tiles. `limitBytes` bounds heads and nodes
   * together, `nodeCapacity` the nodes of one tile, and its heads, which are smaller, too.
   */
  void Begin(const vtkPixelRectangle& viewport, vtkIdType limitBytes, vtkIdType nodeCapacity,
    vtkIdType bytesPerNode);

  /** Allow fewer nodes in this frame, because there was no memory for more. */
  void LowerNodeCapacity(vtkIdType nodeCapacity);

  /** Give up the rest of the frame. */
  void Abandon() { this->Pending.clear(); }

  /** Take the next tile; false when the frame is complete. */
  bool Next(vtkPixelRectangle& tile);

  /** Nodes that a tile may use, at least 1. */
  vtkIdType GetNodeLimit() const;

  /** Nodes that the list of a single pixel may use, whatever the memory limit. */
  vtkIdType GetNodeCapacity() const { return this->NodeCapacity; }

  /** Whether a tile with so many fragments has to be divided, and can be. */
  bool MustSplit(const vtkPixelRectangle& tile, vtkIdType fragments) const;

  /** Put parts of the tile back, so many that each can be expected to fit. */
  void Split(const vtkPixelRectangle& tile, vtkIdType fragments);

  /** The tile is drawn. */
  void Finish(const vtkPixelRectangle& tile, vtkIdType fragments);

  /** Tiles that were drawn in this frame. */
  int GetNumberOfTiles() const { return static_cast<int>(this->Finished.size()); }

private:
  bool HeadsFit(const vtkPixelRectangle& tile) const;

  vtkPixelRectangle Viewport;
  vtkIdType LimitBytes = 0;
  vtkIdType NodeCapacity = 0;
  vtkIdType BytesPerNode = 1;
  vtkIdType Fragments = 0;
  std::deque<vtkPixelRectangle> Pending;
  std::vector<vtkPixelRectangle> Finished;
};

VTK_ABI_NAMESPACE_END
#endif
