// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFragmentTiles.h"

#include "vtkFragmentLists.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Parts of the memory limit: a quarter for heads, so that small tiles need no other division than
// large ones; little for counters and the notes on long lists; the rest for nodes.
constexpr vtkIdType HeadsPart = 4;
constexpr vtkIdType NotesPart = 64;

vtkIdType DivideUp(vtkIdType dividend, vtkIdType divisor)
{
  return (dividend + divisor - 1) / divisor;
}
}

//------------------------------------------------------------------------------
void vtkFragmentTiles::Begin(const vtkPixelRectangle& viewport, vtkIdType limitBytes,
  vtkIdType nodeCapacity, vtkIdType bytesPerNode)
{
  const bool sameImage = viewport == this->Viewport && limitBytes == this->LimitBytes &&
    nodeCapacity == this->NodeCapacity && bytesPerNode == this->BytesPerNode;
  this->Viewport = viewport;
  this->LimitBytes = limitBytes;
  this->NodeCapacity = nodeCapacity;
  this->BytesPerNode = bytesPerNode;

  // Half the room of one tile is left when the last frame is gathered as a whole again.
  const bool fitsAsWhole = this->Fragments <= this->GetNodeLimit() / 2;
  this->Pending.clear();
  if (sameImage && !fitsAsWhole)
  {
    this->Pending.assign(this->Finished.begin(), this->Finished.end());
  }
  if (this->Pending.empty())
  {
    this->Pending.push_back(viewport);
  }
  this->Finished.clear();
  this->Fragments = 0;
}

//------------------------------------------------------------------------------
void vtkFragmentTiles::LowerNodeCapacity(vtkIdType nodeCapacity)
{
  this->NodeCapacity = std::max<vtkIdType>(nodeCapacity, 1);
}

//------------------------------------------------------------------------------
bool vtkFragmentTiles::HeadsFit(const vtkPixelRectangle& tile) const
{
  return tile.GetNumberOfPixels() * vtkFragmentLists::BytesPerPixel <= this->LimitBytes / HeadsPart;
}

//------------------------------------------------------------------------------
bool vtkFragmentTiles::Next(vtkPixelRectangle& tile)
{
  if (this->Pending.empty())
  {
    return false;
  }
  tile = this->Pending.front();
  this->Pending.pop_front();
  while (!this->HeadsFit(tile) && tile.GetNumberOfPixels() > 1)
  {
    this->Split(tile, 0);
    tile = this->Pending.front();
    this->Pending.pop_front();
  }
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentTiles::GetNodeLimit() const
{
  const vtkIdType nodeBytes =
    this->LimitBytes - this->LimitBytes / HeadsPart - this->LimitBytes / NotesPart;
  return std::clamp<vtkIdType>(nodeBytes / this->BytesPerNode, 1, this->NodeCapacity);
}

//------------------------------------------------------------------------------
bool vtkFragmentTiles::MustSplit(const vtkPixelRectangle& tile, vtkIdType fragments) const
{
  return fragments > this->GetNodeLimit() && tile.GetNumberOfPixels() > 1;
}

//------------------------------------------------------------------------------
void vtkFragmentTiles::Split(const vtkPixelRectangle& tile, vtkIdType fragments)
{
  const int axis = tile.Size[0] > tile.Size[1] ? 0 : 1;
  // A quarter more than an even distribution of the fragments would need.
  const vtkIdType wanted = DivideUp(fragments + fragments / 4, this->GetNodeLimit());
  const int parts = static_cast<int>(std::clamp<vtkIdType>(wanted, 2, tile.Size[axis]));
  for (int part = parts - 1; part >= 0; --part)
  {
    const auto boundary = [&](int index)
    { return static_cast<int>(static_cast<vtkIdType>(tile.Size[axis]) * index / parts); };
    vtkPixelRectangle rectangle = tile;
    rectangle.Origin[axis] += boundary(part);
    rectangle.Size[axis] = boundary(part + 1) - boundary(part);
    this->Pending.push_front(rectangle);
  }
}

//------------------------------------------------------------------------------
void vtkFragmentTiles::Finish(const vtkPixelRectangle& tile, vtkIdType fragments)
{
  this->Finished.push_back(tile);
  this->Fragments += fragments;
}

VTK_ABI_NAMESPACE_END
