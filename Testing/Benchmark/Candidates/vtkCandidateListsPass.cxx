// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCandidateListsPass.h"

#include "vtkCandidateAllocateFS.h"
#include "vtkCandidateAppendDec.h"
#include "vtkCandidateArrayDec.h"
#include "vtkCandidateHeapDec.h"
#include "vtkCandidateInsertionDec.h"
#include "vtkCandidateListsDec.h"
#include "vtkCandidateListsFS.h"
#include "vtkCandidateMergeDec.h"
#include "vtkCandidateSelectionDec.h"
#include "vtkObjectFactory.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkCandidateListsPass);

namespace
{
// Nodes for each pixel before anything is known about a scene.
constexpr vtkIdType FirstNodesPerPixel = 2;

// Steps that selection may take. Mesa's software renderer ends a shader invocation after some
// 65,000 loop iterations; it was seen to end selection between 30,000 and 50,000 of these steps.
constexpr std::uint32_t LoopBudget = 30000;

// Lists are counted up to this length.
constexpr std::uint32_t CountedLength = 8192;

// 320 * 320 / 2 iterations are within the limit of the software renderer; all others need fewer.
constexpr int InsertionLength = 320;
constexpr int ArrayLength = 512;

// Inserting into the 16 nearest takes up to 17 steps for each node that is left, in every scan of
// the list: 27,456 for so many.
constexpr int SelectionLength = 208;

constexpr std::uint32_t TiedBit = 0x80000000u;
constexpr vtkIdType LargestNode = 0x7fffffff;
}

//------------------------------------------------------------------------------
int vtkCandidateListsPass::GetLargestExactList() const
{
  switch (this->Sort)
  {
    case SORT_INSERTION:
      return InsertionLength;
    case SORT_SELECTION:
      return SelectionLength;
    default:
      return ArrayLength;
  }
}

//------------------------------------------------------------------------------
void vtkCandidateListsPass::Define(vtkShaderDefinitions& definitions)
{
  const bool isInsertion = this->Sort == SORT_INSERTION;
  const int length = this->GetLargestExactList();
  definitions.Define("HEADS_BINDING", static_cast<int>(HeadsBinding));
  definitions.Define("LINKS_BINDING", static_cast<int>(LinksBinding));
  definitions.Define("COLORS_BINDING", static_cast<int>(ColorsBinding));
  definitions.Define("COLOR_BYTES", static_cast<int>(this->ColorBytes));
  definitions.Define("CONTIGUOUS", this->Contiguous ? 1 : 0);
  definitions.Define("TIED", TiedBit);
  definitions.Define("COUNTED_LENGTH", CountedLength);
  definitions.Define("LOOP_BUDGET", LoopBudget);
  definitions.Define("ARRAY_LENGTH", length);
  definitions.Define("ARRAY_SIZE", this->Sort == SORT_MERGE ? 2 * length : length);
  definitions.Define("NUMBER_OF_GAPS", isInsertion ? 1 : 7);
  definitions.Define("GAPS", isInsertion ? "1" : "301, 132, 57, 23, 10, 4, 1");
}

//------------------------------------------------------------------------------
std::string vtkCandidateListsPass::GetDeclarations()
{
  return vtkCandidateListsDec;
}

//------------------------------------------------------------------------------
std::string vtkCandidateListsPass::GetStoreCode()
{
  return vtkCandidateAppendDec;
}

//------------------------------------------------------------------------------
void vtkCandidateListsPass::SetStoreUniforms(vtkShaderProgram* program)
{
  program->SetUniformi("pellucidNodeCapacity", static_cast<int>(this->NodeCapacity));
  program->SetUniformi("pellucidFills", this->Fills ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkCandidateListsPass::RenderTranslucent(const vtkRenderState* state)
{
  const vtkIdType headBytes = this->GetNumberOfPixels() * (this->Contiguous ? 8 : 4);
  if (!this->Reserve(HeadsBinding, headBytes) ||
    !(this->Contiguous ? this->GatherArrays(state) : this->Gather(state)))
  {
    return false;
  }
  vtkStageTimers::Scope stage(this->Timers, "resolve");
  this->Resolve();
  return true;
}

//------------------------------------------------------------------------------
void vtkCandidateListsPass::ClearHeads()
{
  this->Buffers.Clear(CountersBinding, sizeof(Counters));
  this->Buffers.Clear(HeadsBinding, this->GetNumberOfPixels() * (this->Contiguous ? 8 : 4));
  this->Buffers.Bind();
}

//------------------------------------------------------------------------------
bool vtkCandidateListsPass::ReserveNodes(vtkIdType needed)
{
  // Node 0 takes room too. A quarter more, so that a slowly turning view does not grow them every
  // frame.
  const vtkIdType linkBytes = this->Contiguous ? 4 : 8;
  const vtkIdType largest = std::min(LargestNode,
    vtkCandidateBuffers::GetLargestBytes() / std::max<vtkIdType>(linkBytes, this->ColorBytes) - 1);
  const vtkIdType wanted = std::max(needed, std::min(needed + needed / 4, largest));
  const vtkIdType capacity = needed > this->NodeCapacity ? wanted : this->NodeCapacity;
  const bool reserved = this->Reserve(LinksBinding, (capacity + 1) * linkBytes) &&
    this->Reserve(ColorsBinding, (capacity + 1) * this->ColorBytes);
  this->NodeCapacity = reserved ? capacity : 0;
  return reserved;
}

//------------------------------------------------------------------------------
bool vtkCandidateListsPass::Gather(const vtkRenderState* state)
{
  vtkStageTimers::Scope stage(this->Timers, "gather");
  vtkIdType needed = FirstNodesPerPixel * this->GetNumberOfPixels();
  do
  {
    if (!this->ReserveNodes(needed))
    {
      return false;
    }
    this->ClearHeads();
    this->DrawProps(state);
    needed = this->ReadCounters().Fragments;
  } while (needed > this->NodeCapacity);
  return true;
}

//------------------------------------------------------------------------------
bool vtkCandidateListsPass::GatherArrays(const vtkRenderState* state)
{
  this->ClearHeads();
  {
    vtkStageTimers::Scope stage(this->Timers, "count");
    this->Fills = false;
    this->DrawProps(state);
  }
  vtkStageTimers::Scope stage(this->Timers, "gather");
  this->DrawOffScreen([this] { this->DrawPixels(this->AssembleShader(vtkCandidateAllocateFS)); });
  if (!this->ReserveNodes(this->ReadCounters().Fragments))
  {
    return false;
  }
  this->Buffers.Bind();
  this->Fills = true;
  this->DrawProps(state);
  return true;
}

//------------------------------------------------------------------------------
void vtkCandidateListsPass::Resolve()
{
  const char* array = nullptr;
  switch (this->Sort)
  {
    case SORT_HEAP:
      array = vtkCandidateHeapDec;
      break;
    case SORT_MERGE:
      array = vtkCandidateMergeDec;
      break;
    default:
      array = vtkCandidateInsertionDec;
  }
  std::string sort = this->Sort == SORT_SELECTION ? vtkCandidateSelectionDec : vtkCandidateArrayDec;
  vtkShaderProgram::Substitute(sort, "//VTK::Pellucid::SortArray", array);
  std::string shader = vtkCandidateListsFS;
  vtkShaderProgram::Substitute(shader, "//VTK::Pellucid::Sort", sort);

  this->DrawPixels(this->AssembleShader(shader, "#define PELLUCID_BREAK_TIES 0\n"));
  if (this->ReadCounters().HasTies != 0)
  {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    this->DrawPixels(this->AssembleShader(shader, "#define PELLUCID_BREAK_TIES 1\n"));
  }
}

//------------------------------------------------------------------------------
void vtkCandidateListsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Sort: " << this->Sort << "\n";
  os << indent << "ColorBytes: " << this->ColorBytes << "\n";
  os << indent << "Contiguous: " << this->Contiguous << "\n";
}

VTK_ABI_NAMESPACE_END
