// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFragmentLists.h"

#include "vtkLongFragmentList.h"
#include "vtkSMPTools.h"
#include "vtkShaderDefinitions.h"
#include "vtkStorageBuffer.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Sorted lists that the binary counter of the sort needs for the longest list it takes.
constexpr int GetNumberOfListLevels()
{
  int levels = 1;
  int runs = vtkFragmentLists::MaximumShaderList / vtkFragmentLists::RunLength + 1;
  while (runs > 1)
  {
    runs /= 2;
    ++levels;
  }
  return levels;
}

static_assert(sizeof(vtkIdType) == 8, "fragment counts need VTK_USE_64BIT_IDS");

vtkIdType GetHeadsBytes(const std::array<int, 2>& tileSize)
{
  const auto area = [](const std::array<int, 2>& size)
  { return static_cast<vtkIdType>(size[0]) * size[1]; };
  return static_cast<vtkIdType>(sizeof(vtkFragmentLists::Counters)) +
    (area(tileSize) + area(vtkFragmentLists::GetBlocks(tileSize))) *
    vtkFragmentLists::BytesPerPixel;
}

/** Maps a whole buffer, if there is one, for the life of the object. */
template <typename T>
class MappedBuffer
{
public:
  MappedBuffer(GLuint handle, vtkIdType bytes)
    : Handle(handle)
  {
    if (handle == 0)
    {
      return;
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, handle);
    this->Data = static_cast<T*>(
      glMapBufferRange(GL_SHADER_STORAGE_BUFFER, 0, bytes, GL_MAP_READ_BIT | GL_MAP_WRITE_BIT));
  }
  ~MappedBuffer()
  {
    if (!this->Data)
    {
      return;
    }
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handle);
    glUnmapBuffer(GL_SHADER_STORAGE_BUFFER);
  }
  MappedBuffer(const MappedBuffer&) = delete;
  void operator=(const MappedBuffer&) = delete;
  T* Data = nullptr;

private:
  GLuint Handle;
};
}

//------------------------------------------------------------------------------
std::string vtkFragmentLists::GetShaderDefinitions(bool storesImportance)
{
  vtkShaderDefinitions definitions;
  definitions.Define("HEADS_BINDING", static_cast<int>(Heads));
  definitions.Define("LINKS_BINDING", static_cast<int>(Links));
  definitions.Define("COLORS_BINDING", static_cast<int>(Colors));
  definitions.Define("LONG_LISTS_BINDING", static_cast<int>(LongLists));
  definitions.Define("IMPORTANCES_BINDING", static_cast<int>(Importances));
  definitions.Define("POSITIONS_BINDING", static_cast<int>(Positions));
  definitions.Define("OPTIMIZE", storesImportance ? 1 : 0);
  definitions.Define("MAXIMUM_SHADER_LIST", MaximumShaderList);
  // The sort takes one node more before it leaves a list to the CPU.
  definitions.Define("LONGEST_SORTED_LIST", MaximumShaderList + 1);
  definitions.Define("COLLAPSED", CollapsedBit);
  definitions.Define("TIED", TiedBit);
  definitions.Define("BLOCK_SIDE", BlockSide);
  definitions.Define("BLOCK_HAS_FRAGMENTS", BlockHasFragments);
  definitions.Define("BLOCK_HAS_TIES", BlockHasTies);
  definitions.Define("RUN_LENGTH", RunLength);
  definitions.Define("LIST_LEVELS", GetNumberOfListLevels());
  definitions.Define("NEGLIGIBLE_TRANSMITTANCE", "(1.0 / 8192.0)");
  // A little less, since the sort multiplies in another order than the resolve.
  definitions.Define("HIDDEN_TRANSMITTANCE", "(0.99 / 8192.0)");
  definitions.Define("LONG_LIST_HEAD", LongListHead);
  return definitions.GetText();
}

//------------------------------------------------------------------------------
std::array<int, 2> vtkFragmentLists::GetBlocks(const std::array<int, 2>& tileSize)
{
  const auto count = [](int pixels) { return (pixels + BlockSide - 1) / BlockSide; };
  return { { count(tileSize[0]), count(tileSize[1]) } };
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentLists::GetLargestNodeCapacity()
{
  GLint64 blockBytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &blockBytes);
  // Node 0 takes room too, and the shader compares with a signed 32-bit capacity.
  return std::min<vtkIdType>(
    blockBytes / sizeof(Link) - 1, std::numeric_limits<std::int32_t>::max());
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::Allocate(Buffer buffer, vtkIdType bytes)
{
  if (this->Bytes[buffer] >= bytes)
  {
    return true;
  }
  const bool allocated = vtkAllocateStorage(this->Handles[buffer], bytes, nullptr);
  this->Bytes[buffer] = allocated ? bytes : 0;
  return allocated;
}

//------------------------------------------------------------------------------
bool vtkFragmentLists::Reserve(
  const std::array<int, 2>& tileSize, vtkIdType nodes, int samples, bool storesImportance)
{
  const vtkIdType nodeElements = std::max(nodes, this->NodeCapacity) + 1;
  const vtkIdType longLists = nodeElements / MaximumShaderList + 1;
  const bool allocated = this->Allocate(Heads, GetHeadsBytes(tileSize)) &&
    this->Allocate(Links, nodeElements * static_cast<vtkIdType>(sizeof(Link))) &&
    this->Allocate(Colors, nodeElements * static_cast<vtkIdType>(sizeof(Color))) &&
    this->Allocate(LongLists,
      longLists * (LongListHead + samples) * static_cast<vtkIdType>(sizeof(std::uint32_t))) &&
    (!storesImportance ||
      (this->Allocate(Importances, nodeElements * static_cast<vtkIdType>(sizeof(Importance))) &&
        this->Allocate(Positions, nodeElements * static_cast<vtkIdType>(sizeof(Position)))));
  this->NodeCapacity = allocated ? nodeElements - 1 : 0;
  return allocated;
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentLists::GetBytes() const
{
  vtkIdType bytes = 0;
  for (const vtkIdType bufferBytes : this->Bytes)
  {
    bytes += bufferBytes;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkFragmentLists::Clear(const std::array<int, 2>& tileSize)
{
  const GLuint zero = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[Heads]);
  glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0, GetHeadsBytes(tileSize),
    GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkFragmentLists::Bind() const
{
  for (GLuint buffer = 0; buffer < NumberOfBuffers; ++buffer)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, buffer, this->Handles[buffer]);
  }
}

//------------------------------------------------------------------------------
void vtkFragmentLists::Unbind()
{
  for (GLuint buffer = 0; buffer < NumberOfBuffers; ++buffer)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, buffer, 0);
  }
}

//------------------------------------------------------------------------------
vtkFragmentLists::Counters vtkFragmentLists::ReadCounters() const
{
  Counters counters;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[Heads]);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(counters), &counters);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return counters;
}

//------------------------------------------------------------------------------
void vtkFragmentLists::ClearSolvedFragments()
{
  const std::uint32_t zero = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[Heads]);
  glBufferSubData(
    GL_SHADER_STORAGE_BUFFER, offsetof(Counters, SolvedFragments), sizeof(zero), &zero);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
template <typename Function>
void vtkFragmentLists::ForLongLists(
  std::uint32_t count, int samples, bool storesImportance, Function&& work)
{
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  MappedBuffer<std::uint32_t> heads(this->Handles[Heads], this->Bytes[Heads]);
  MappedBuffer<std::uint32_t> entries(this->Handles[LongLists], this->Bytes[LongLists]);
  MappedBuffer<Link> links(this->Handles[Links], this->Bytes[Links]);
  MappedBuffer<Color> colors(this->Handles[Colors], this->Bytes[Colors]);
  MappedBuffer<Importance> importances(
    storesImportance ? this->Handles[Importances] : 0, this->Bytes[Importances]);
  MappedBuffer<Position> positions(
    storesImportance ? this->Handles[Positions] : 0, this->Bytes[Positions]);
  if (!heads.Data || !entries.Data || !links.Data || !colors.Data ||
    (storesImportance && (!importances.Data || !positions.Data)))
  {
    return;
  }
  const Nodes nodes{ links.Data, colors.Data, importances.Data, positions.Data };
  std::uint32_t* pixelHeads = heads.Data + sizeof(Counters) / sizeof(std::uint32_t);
  vtkSMPTools::For(0, count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const std::uint32_t* entry = entries.Data + i * (LongListHead + samples);
        work(i, nodes, pixelHeads[entry[0]], entry);
      }
    });
}

//------------------------------------------------------------------------------
std::vector<vtkSegmentOpacities::SegmentOpacity> vtkFragmentLists::SolveLongLists(
  std::uint32_t count, int samples, const vtkOptimizedScene& scene)
{
  std::vector<std::vector<vtkSegmentOpacities::SegmentOpacity>> solutions(count);
  this->ForLongLists(count, samples, true,
    [&](vtkIdType i, const Nodes& nodes, std::uint32_t head, const std::uint32_t*)
    { vtkLongFragmentList(nodes, head).Solve(scene, solutions[i]); });
  std::vector<vtkSegmentOpacities::SegmentOpacity> all;
  for (const auto& solution : solutions)
  {
    all.insert(all.end(), solution.begin(), solution.end());
  }
  return all;
}

//------------------------------------------------------------------------------
vtkIdType vtkFragmentLists::MeasureLongLists(std::uint32_t count, int samples)
{
  std::vector<vtkIdType> lengths(count);
  this->ForLongLists(count, samples, false,
    [&](vtkIdType i, const Nodes& nodes, std::uint32_t head, const std::uint32_t* entry)
    {
      lengths[i] = entry[1];
      for (std::uint32_t node = head; node != 0; node = nodes.Links[node].Next)
      {
        ++lengths[i];
      }
    });
  return *std::max_element(lengths.begin(), lengths.end());
}

//------------------------------------------------------------------------------
void vtkFragmentLists::CollapseLongLists(std::uint32_t count, int samples,
  const vtkPictureView& view, const std::vector<float>& opacities, const LongListWork& avoid)
{
  this->ForLongLists(count, samples, !opacities.empty(),
    [&](vtkIdType, const Nodes& nodes, std::uint32_t& head, const std::uint32_t* entry)
    {
      vtkLongFragmentList list(nodes, head);
      list.Fade(opacities);
      avoid(list, entry[0]);
      list.Show(view);
      list.Collapse(entry + LongListHead, samples);
      head |= CollapsedBit;
    });
}

//------------------------------------------------------------------------------
void vtkFragmentLists::VisitLongLists(std::uint32_t count, int samples, const LongListWork& visit)
{
  this->ForLongLists(count, samples, true,
    [&](vtkIdType, const Nodes& nodes, std::uint32_t head, const std::uint32_t* entry)
    {
      vtkLongFragmentList list(nodes, head);
      visit(list, entry[0]);
    });
}

//------------------------------------------------------------------------------
void vtkFragmentLists::Release()
{
  glDeleteBuffers(NumberOfBuffers, this->Handles.data());
  this->Handles.fill(0);
  this->Bytes.fill(0);
  this->NodeCapacity = 0;
}

VTK_ABI_NAMESPACE_END
