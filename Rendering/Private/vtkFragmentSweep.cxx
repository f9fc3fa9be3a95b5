// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFragmentSweep.h"

#include "vtkFragmentStages.h"
#include "vtkObject.h"
#include "vtkOpaqueLayer.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkStageTimers.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Nodes for each pixel before anything is known about a scene.
constexpr vtkIdType FirstNodesPerPixel = 2;

constexpr vtkIdType BytesPerMiB = 1024 * 1024;

// Smaller tiles are not divided when OpenGL has no memory: it would not help.
constexpr vtkIdType LeastPixelsForMemory = 4096;
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::Begin(const Frame& frame, bool isSame)
{
  // Nodes of another size would be as many as before.
  const bool isOtherFormat = this->Current.StoresImportance != frame.StoresImportance;
  const bool lacksHidden = frame.KeepsHidden && !this->Current.KeepsHidden;
  this->Current = frame;
  this->Gathers = 0;
  this->HasAll = this->HasAll && isSame && !lacksHidden;
  if (isOtherFormat || this->Lists.GetBytes() > frame.LimitBytes)
  {
    this->Lists.Release();
    this->HasAll = false;
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentSweep::GetBytesPerNode() const
{
  return this->Current.StoresImportance ? vtkFragmentLists::BytesPerOptimizedNode
                                        : vtkFragmentLists::BytesPerNode;
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::Run(int scale, const std::function<void()>& work)
{
  const vtkPixelRectangle& picture = this->Current.Picture;
  vtkOpenGLState* state = this->Current.Window->GetState();
  const auto setScissor = [state](const vtkPixelRectangle& area)
  { state->vtkglScissor(area.Origin[0], area.Origin[1], area.Size[0], area.Size[1]); };
  vtkOpenGLState::ScopedglScissor scissorSaver(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(state, GL_SCISSOR_TEST);
  state->vtkglEnable(GL_SCISSOR_TEST);
  if (scale == 1 && this->HasAll)
  {
    this->Tile = picture;
    setScissor(picture);
    this->Lists.Bind();
    work();
    return;
  }

  vtkPixelRectangle scaled = picture;
  for (int& side : scaled.Size)
  {
    side = (side + scale - 1) / scale;
  }
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  state->vtkglViewport(scaled.Origin[0], scaled.Origin[1], scaled.Size[0], scaled.Size[1]);
  this->Current.Opaque->SetScale(scale);
  this->SweepTiles = scale == 1 ? &this->Tiles : &this->SmallTiles;
  this->SweepTiles->Begin(scaled, this->Current.LimitBytes,
    vtkFragmentLists::GetLargestNodeCapacity(), this->GetBytesPerNode());
  this->Fragments = 0;
  this->LongestList = 0;
  this->HasAll = false;
  while (this->SweepTiles->Next(this->Tile))
  {
    setScissor(this->Tile);
    if (this->Fill())
    {
      this->HasAll = scale == 1 && this->Tile == picture;
      work();
    }
  }
}

//------------------------------------------------------------------------------
bool vtkFragmentSweep::Fill()
{
  const vtkPixelRectangle tile = this->Tile;
  vtkFragmentTiles& tiles = *this->SweepTiles;
  vtkIdType fragments = 0;
  vtkIdType nodes = std::min(tiles.GetNodeLimit(), FirstNodesPerPixel * tile.GetNumberOfPixels());
  do
  {
    if (!this->Lists.Reserve(
          tile.Size, nodes, this->Current.Opaque->GetSamples(), this->Current.StoresImportance))
    {
      this->Lists.Release();
      this->DivideForMemory(nodes);
      return false;
    }
    fragments = this->Gather();
    if (tiles.MustSplit(tile, fragments))
    {
      tiles.Split(tile, fragments);
      return false;
    }
    if (fragments > tiles.GetNodeCapacity())
    {
      this->GiveUp(fragments);
      return false;
    }
    // A quarter more, so that a slowly turning view does not grow the buffers every frame.
    nodes = std::max(fragments, std::min(fragments + fragments / 4, tiles.GetNodeLimit()));
  } while (fragments > this->Lists.GetNodeCapacity());

  this->WarnOfMemory(fragments);
  this->Sort();
  tiles.Finish(tile, fragments);
  this->Fragments += fragments;
  return true;
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentSweep::Gather()
{
  vtkStageTimers::Scope stage(*this->Current.Timers, "gather");
  ++this->Gathers;
  this->Lists.Clear(this->Tile.Size);
  this->Lists.Bind();
  this->DrawOffScreen(this->Current.DrawProps);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return this->Lists.ReadCounters().GetFragments();
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::Sort()
{
  vtkStageTimers::Scope stage(*this->Current.Timers, "sort");
  const vtkOpaqueLayer& opaque = *this->Current.Opaque;
  this->DrawOffScreen(
    [&] { this->Current.Stages->Sort(this->Current.Window, opaque, this->Tile); });
  const vtkFragmentLists::Counters counters = this->Lists.ReadCounters();
  if (counters.HasTies != 0)
  {
    this->DrawOffScreen(
      [&] { this->Current.Stages->BreakTies(this->Current.Window, opaque, this->Tile); });
  }
  this->LongLists = counters.LongLists;
  const vtkIdType longest = this->LongLists > 0
    ? this->Lists.MeasureLongLists(this->LongLists, opaque.GetSamples())
    : counters.LongestList;
  this->LongestList = std::max(this->LongestList, longest);
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::DrawOffScreen(const std::function<void()>& draw)
{
  this->Framebuffer.Use(this->Current.Window, this->Tile.Origin[0] + this->Tile.Size[0],
    this->Tile.Origin[1] + this->Tile.Size[1], draw);
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::DivideForMemory(vtkIdType nodes)
{
  this->SweepTiles->LowerNodeCapacity(nodes / 2);
  if (this->Tile.GetNumberOfPixels() > LeastPixelsForMemory)
  {
    this->SweepTiles->Split(this->Tile, nodes);
  }
  else
  {
    this->GiveUp(nodes);
  }
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::GiveUp(vtkIdType nodes)
{
  this->SweepTiles->Abandon();
  if (!this->ReportedNoMemory)
  {
    vtkErrorWithObjectMacro(this->Current.Owner,
      "OpenGL has no room for the fragment lists of "
        << this->Tile.Size[0] << " x " << this->Tile.Size[1] << " pixels: needed are "
        << nodes * this->GetBytesPerNode() / BytesPerMiB + 1
        << " MiB. The rest of the picture shows the opaque scene only. Free graphics memory, or "
           "draw fewer translucent layers.");
    this->ReportedNoMemory = true;
  }
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::WarnOfMemory(vtkIdType fragments)
{
  if (fragments > this->SweepTiles->GetNodeLimit() && !this->WarnedOfMemory)
  {
    vtkWarningWithObjectMacro(this->Current.Owner,
      "One pixel has " << fragments << " translucent fragments, which need "
                       << fragments * this->GetBytesPerNode()
                       << " bytes, more than the memory limit of "
                       << this->Current.LimitBytes / BytesPerMiB
                       << " MiB. The limit is exceeded to keep the picture exact.");
    this->WarnedOfMemory = true;
  }
}

//------------------------------------------------------------------------------
void vtkFragmentSweep::Release()
{
  this->Lists.Release();
  this->Framebuffer.Release();
  this->HasAll = false;
}

VTK_ABI_NAMESPACE_END
