// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The sorted fragment lists of a picture: gathers and sorts them, and lets stages work on them,
 * tile by tile where the memory limit asks for it. The lists of a picture of one tile stay, for
 * other sweeps and for frames that show the same.
 */

#ifndef vtkFragmentSweep_h
#define vtkFragmentSweep_h

#include "vtkEmptyFramebuffer.h"
#include "vtkFragmentLists.h"
#include "vtkFragmentTiles.h"

#include <functional>

VTK_ABI_NAMESPACE_BEGIN

class vtkFragmentStages;
class vtkObject;
class vtkOpaqueLayer;
class vtkOpenGLRenderWindow;
class vtkStageTimers;

class vtkFragmentSweep
{
public:
  /** What all sweeps of a frame share. */
  struct Frame
  {
    vtkObject* Owner = nullptr; ///< warnings and errors are its
    vtkOpenGLRenderWindow* Window = nullptr;
    vtkFragmentStages* Stages = nullptr;
    vtkOpaqueLayer* Opaque = nullptr;
    vtkStageTimers* Timers = nullptr;
    vtkPixelRectangle Picture;
    vtkIdType LimitBytes = 0;
    bool StoresImportance = false;
    bool KeepsHidden = true;         ///< fragments that cannot be seen for those in front of them
    std::function<void()> DrawProps; ///< appends all fragments to the lists, which are bound
  };

  vtkFragmentSweep() = default;
  ~vtkFragmentSweep() = default;
  vtkFragmentSweep(const vtkFragmentSweep&) = delete;
  void operator=(const vtkFragmentSweep&) = delete;

  /** Begin a frame. `isSame` tells whether the lists of the frame before are right for it too. */
  void Begin(const Frame& frame, bool isSame);

  /**
   * Call `work` for each tile, with its sorted lists bound and in the current framebuffer. The
   * picture is 1/scale as wide and high; with 1, lists that are there are not gathered again.
   */
  void Run(int scale, const std::function<void()>& work);

  /** Whether the lists of the whole picture are there. */
  bool HasLists() const { return this->HasAll; }
  void ForgetLists() { this->HasAll = false; }

  ///@{
  /** While `work` runs: the tile, its lists, and how many of these are left to the CPU. */
  const vtkPixelRectangle& GetTile() const { return this->Tile; }
  vtkFragmentLists& GetLists() { return this->Lists; }
  std::uint32_t GetNumberOfLongLists() const { return this->LongLists; }
  ///@}

  /** Draw into a framebuffer without attachments, in which the tile has its window coordinates. */
  void DrawOffScreen(const std::function<void()>& draw);

  ///@{
  /** Of the last sweep. */
  vtkIdType GetNumberOfFragments() const { return this->Fragments; }
  vtkIdType GetLongestList() const { return this->LongestList; }
  ///@}

  /** Tiles of the picture in its full size. */
  int GetNumberOfTiles() const { return this->Tiles.GetNumberOfTiles(); }

  /** Times that this frame has gathered a tile. */
  int GetNumberOfGathers() const { return this->Gathers; }

  vtkIdType GetBytes() const { return this->Lists.GetBytes(); }
  void Release();

private:
  bool Fill();
  vtkIdType Gather();
  void Sort();
  void DivideForMemory(vtkIdType nodes);
  void GiveUp(vtkIdType nodes);
  void WarnOfMemory(vtkIdType fragments);
  vtkIdType GetBytesPerNode() const;

  Frame Current;
  vtkFragmentLists Lists;
  vtkFragmentTiles Tiles;
  vtkFragmentTiles SmallTiles; ///< of sweeps with a scale above 1
  vtkFragmentTiles* SweepTiles = &Tiles;
  vtkPixelRectangle Tile;
  vtkEmptyFramebuffer Framebuffer;
  bool HasAll = false;
  std::uint32_t LongLists = 0;
  vtkIdType Fragments = 0;
  vtkIdType LongestList = 0;
  int Gathers = 0;

  // Each is said once.
  bool WarnedOfMemory = false;
  bool ReportedNoMemory = false;
};

VTK_ABI_NAMESPACE_END
#endif
