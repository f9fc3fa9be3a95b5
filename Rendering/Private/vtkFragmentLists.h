// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The buffers of the per-pixel fragment lists of one tile, and the shader constants that describe
 * them. glsl/vtkFragmentListsDec.glsl is the other side of this class.
 *
 * | buffer     | element | content                                                            |
 * | ---------- | ------- | ------------------------------------------------------------------ |
 * | Heads      | uint    | counters, first node of each pixel, flags of each block of pixels  |
 * | Links      | uvec2   | next node (0: none), window depth as bits                          |
 * | Colors     | uvec2   | straight colour and opacity, 64 bits                               |
 * | LongLists  | uint    | lists for the CPU: pixel, dropped nodes, opaque depth of samples   |
 * | Importances | uvec2  | importance as bits, segment; where they decide on opacities        |
 * | Positions  | uvec2   | between which opacities; where these follow from importance        |
 *
 * Node 0 does not exist, so that 0 can end a list and clearing to 0 empties all of them.
 * A current OpenGL 4.3 context is needed by every function but the static ones.
 */

#ifndef vtkFragmentLists_h
#define vtkFragmentLists_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses
#include "vtkSegmentOpacities.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkLongFragmentList;
class vtkOptimizedScene;
struct vtkPictureView;

class vtkFragmentLists
{
public:
  /** Lists of up to this length are sorted by the shader; see glsl/vtkFragmentSortFS.glsl. */
  static constexpr int MaximumShaderList = 2048;
  static constexpr int RunLength = 16;
  static constexpr vtkIdType BytesPerNode = 16;
  static constexpr vtkIdType BytesPerOptimizedNode = 32;
  static constexpr vtkIdType BytesPerPixel = 4;

  ///@{
  /** Squares of pixels know whether they have fragments, and of equal depth, so that stages can
   * pass over the others. */
  static constexpr int BlockSide = 16;
  static constexpr std::uint32_t BlockHasFragments = 1u;
  static constexpr std::uint32_t BlockHasTies = 2u;
  static std::array<int, 2> GetBlocks(const std::array<int, 2>& tileSize); ///< columns and rows
  ///@}

  /** Elements of LongLists for each list, before those of the samples. */
  static constexpr int LongListHead = 2;

  /** In a head: the CPU has collapsed the list. */
  static constexpr std::uint32_t CollapsedBit = 0x80000000u;

  /** In a head while lists are sorted: there are fragments of equal depth. */
  static constexpr std::uint32_t TiedBit = 0x80000000u;

  struct Counters
  {
    std::uint32_t Fragments = 0;
    std::uint32_t FragmentsHigh = 0;
    std::uint32_t LongestList = 0;
    std::uint32_t LongLists = 0;
    std::uint32_t SolvedFragments = 0;
    std::uint32_t HasTies = 0;

    vtkIdType GetFragments() const
    {
      return static_cast<vtkIdType>(this->FragmentsHigh) << 32 | this->Fragments;
    }
  };

  /** A node as the CPU sees it while it works on long lists. */
  struct Link
  {
    std::uint32_t Next;
    std::uint32_t DepthBits;
  };
  struct Color
  {
    std::uint32_t Low;
    std::uint32_t High;
  };

  struct Importance
  {
    std::uint32_t Bits;
    std::uint32_t Segment;
  };
  struct Position
  {
    std::uint32_t Opacity;
    std::uint32_t Share;
  };

  /** The nodes of all lists; importances and positions are null where they are not stored. */
  struct Nodes
  {
    Link* Links = nullptr;
    Color* Colors = nullptr;
    Importance* Importances = nullptr;
    Position* Positions = nullptr;
  };

  /** Works on one sorted list, of a pixel of the tile; for different pixels at the same time. */
  using LongListWork = std::function<void(vtkLongFragmentList& list, std::uint32_t pixel)>;

  vtkFragmentLists() = default;
  ~vtkFragmentLists() = default;
  vtkFragmentLists(const vtkFragmentLists&) = delete;
  void operator=(const vtkFragmentLists&) = delete;

  /** `#define`s for the shaders. With `storesImportance` the nodes hold importances and positions
   * too. */
  static std::string GetShaderDefinitions(bool storesImportance);

  /** Most nodes that one buffer of this context can hold, whatever the memory limit. */
  static vtkIdType GetLargestNodeCapacity();

  /**
   * Make room for the heads of a tile and so many nodes; never shrinks. Returns false, with the old
   * capacity untouched or 0, when OpenGL is out of memory.
   */
  bool Reserve(
    const std::array<int, 2>& tileSize, vtkIdType nodes, int samples, bool storesImportance);
  vtkIdType GetNodeCapacity() const { return this->NodeCapacity; }
  vtkIdType GetBytes() const;

  /** Empty the lists of a tile and the counters. */
  void Clear(const std::array<int, 2>& tileSize);
  void Bind() const;
  static void Unbind();
  Counters ReadCounters() const;
  void ClearSolvedFragments();

  /** Length of the longest of the lists that were too long for the shader. */
  vtkIdType MeasureLongLists(std::uint32_t count, int samples);

  /**
   * Find on the CPU the optimal opacities in the lists that were too long for the shader.
   */
  std::vector<vtkSegmentOpacities::SegmentOpacity> SolveLongLists(
    std::uint32_t count, int samples, const vtkOptimizedScene& scene);

  /**
   * Sort and composite on the CPU the lists that were too long for the shader, as the view shows
   * them, with the opacities that vtkSegmentOpacities shows, or where these are empty without. Each
   * list becomes one node for every group of fragments that the same samples see, which the resolve
   * only composites. `avoid` applies occlusion avoidance to the list of a pixel of the tile.
   */
  void CollapseLongLists(std::uint32_t count, int samples, const vtkPictureView& view,
    const std::vector<float>& opacities, const LongListWork& avoid);

  /** Call for each of these lists. */
  void VisitLongLists(std::uint32_t count, int samples, const LongListWork& visit);

  void Release();

private:
  enum Buffer
  {
    Heads,
    Links,
    Colors,
    LongLists,
    Importances,
    Positions,
    NumberOfBuffers
  };
  bool Allocate(Buffer buffer, vtkIdType bytes);

  template <typename Function>
  void ForLongLists(std::uint32_t count, int samples, bool storesImportance, Function&& work);

  std::array<GLuint, NumberOfBuffers> Handles{};
  std::array<vtkIdType, NumberOfBuffers> Bytes{};
  vtkIdType NodeCapacity = 0;
};

VTK_ABI_NAMESPACE_END
#endif
