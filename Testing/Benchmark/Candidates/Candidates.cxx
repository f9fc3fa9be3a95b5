// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Candidates.h"

#include "vtkCandidateDepthSlicesPass.h"
#include "vtkCandidateKBufferPass.h"
#include "vtkCandidateListsPass.h"
#include "vtkCandidateMultiLayerPass.h"

#include <iterator>

namespace pellucid
{
namespace
{
using Lists = vtkCandidateListsPass;

//------------------------------------------------------------------------------
/** A pass of a class, with its parameters set by a function. */
template <typename Pass, typename Prepare>
std::function<vtkSmartPointer<vtkCandidatePass>()> Make(Prepare prepare)
{
  return [prepare]
  {
    auto pass = vtkSmartPointer<Pass>::New();
    prepare(pass.Get());
    return pass;
  };
}

//------------------------------------------------------------------------------
struct NamedSort
{
  const char* Name;
  const char* Description;
  const char* Reason;
  int Sort;
};
constexpr NamedSort Insertion = { "insertion", "insertion sort in local memory",
  "wrong beyond lists of 320, where its quadratic time has long been the slowest",
  Lists::SORT_INSERTION };
constexpr NamedSort Heap = { "heap-4", "quaternary heap as priority queue",
  "wrong beyond lists of 512; what it gained by stopping early the product's sort does too",
  Lists::SORT_HEAP };
constexpr NamedSort Selection = { "selection-16", "repeated selection of the 16 nearest",
  "wrong beyond lists of 208 to thousands, by their order", Lists::SORT_SELECTION };

//------------------------------------------------------------------------------
void AddLists(std::vector<Candidate>& candidates)
{
  for (const NamedSort& sort : { Insertion,
         NamedSort{
           "shell", "Shell sort in local memory", "wrong beyond lists of 512", Lists::SORT_SHELL },
         Heap,
         NamedSort{ "merge", "bottom-up merge sort in local memory", "wrong beyond lists of 512",
           Lists::SORT_MERGE },
         Selection })
  {
    const int kind = sort.Sort;
    candidates.push_back({ std::string("lists-") + sort.Name, "lists", std::nullopt,
      std::string("linked lists, ") + sort.Description, sort.Reason, true,
      Make<Lists>([kind](Lists* pass) { pass->SetSort(kind); }) });
    candidates.push_back({ std::string("count-and-fill-") + sort.Name, "count-and-fill",
      std::nullopt, std::string("arrays filled in a second draw, ") + sort.Description,
      "draws the geometry twice, to save a link for each fragment", true,
      Make<Lists>(
        [kind](Lists* pass)
        {
          pass->SetSort(kind);
          pass->SetContiguous(true);
        }) });
  }
}

//------------------------------------------------------------------------------
void AddColors(std::vector<Candidate>& candidates)
{
  const auto add = [&candidates](Lists::Colors bytes, const char* reason)
  {
    const std::string bits = std::to_string(8 * bytes);
    candidates.push_back({ "lists-color-" + bits, "lists-color", 8.0 * bytes,
      "linked lists, quaternary heap, colours of " + bits + " bits instead of 64", reason,
      bytes != Lists::COLOR_32_BITS,
      Make<Lists>([bytes](Lists* pass) { pass->SetColorBytes(bytes); }) });
  };
  add(Lists::COLOR_32_BITS, "an opacity of 8 bits is a bias that long lists add up");
  add(Lists::COLOR_128_BITS, "half as much memory again, for what 8 bits cannot show");
}

//------------------------------------------------------------------------------
/** Thresholds of what is negligible: one 8-bit step, and those of the papers. */
struct Threshold
{
  const char* Name;
  double Transmittance;
};
constexpr Threshold Thresholds[] = { { "0.004", 1.0 / 255.0 }, { "0.01", 0.01 }, { "0.05", 0.05 } };

//------------------------------------------------------------------------------
void AddThresholds(std::vector<Candidate>& candidates)
{
  for (const NamedSort& sort : { Insertion, Heap, Selection })
  {
    const std::string family = std::string("lists-stop-") + sort.Name;
    for (const Threshold& threshold : Thresholds)
    {
      const double value = threshold.Transmittance;
      const int kind = sort.Sort;
      candidates.push_back({ family + "-" + threshold.Name, family, value,
        std::string("linked lists, ") + sort.Description + ", stops at a transmittance of " +
          threshold.Name,
        std::string("what it leaves out can be seen, and ") + sort.Reason, false,
        Make<Lists>(
          [kind, value](Lists* pass)
          {
            pass->SetSort(kind);
            pass->SetNegligibleTransmittance(value);
          }) });
    }
  }
}

//------------------------------------------------------------------------------
void AddLayers(std::vector<Candidate>& candidates)
{
  for (const int layers : { 2, 4, 8, 16, 32 })
  {
    const std::string number = std::to_string(layers);
    candidates.push_back({ "k-buffer-" + number, "k-buffer", layers,
      "sorted geometry, the nearest of " + number + " entries is composited when they are full",
      "sorts the geometry in every frame, and is wrong where it cannot be sorted", false,
      Make<vtkCandidateKBufferPass>([layers](auto* pass) { pass->SetLayers(layers); }) });
  }
  for (const int layers : { 4, 8, 16 })
  {
    const std::string number = std::to_string(layers);
    candidates.push_back({ "multi-layer-" + number, "multi-layer", layers,
      "multi-layer alpha blending, the farthest of " + number + " layers are merged",
      "wrong where more lines overlap than there are layers", false,
      Make<vtkCandidateMultiLayerPass>([layers](auto* pass) { pass->SetLayers(layers); }) });
  }
}

//------------------------------------------------------------------------------
void AddDepthSlices(std::vector<Candidate>& candidates)
{
  std::vector<Threshold> thresholds = { { "0.0001", vtkCandidatePass::ExactTransmittance } };
  thresholds.insert(thresholds.end(), std::begin(Thresholds), std::end(Thresholds));
  for (const Threshold& threshold : thresholds)
  {
    const double value = threshold.Transmittance;
    candidates.push_back({ std::string("depth-slices-") + threshold.Name, "depth-slices", value,
      std::string("k-buffer of 8, ten slices culled by opacity at a transmittance of ") +
        threshold.Name,
      "as the k-buffer; culls only what is behind lines that are nearly opaque", false,
      Make<vtkCandidateDepthSlicesPass>(
        [value](auto* pass)
        {
          pass->SetLayers(8);
          pass->SetNegligibleTransmittance(value);
        }) });
  }
}
}

//------------------------------------------------------------------------------
std::vector<Candidate> GetCandidates()
{
  std::vector<Candidate> candidates;
  AddLists(candidates);
  AddColors(candidates);
  AddThresholds(candidates);
  AddLayers(candidates);
  AddDepthSlices(candidates);
  return candidates;
}
}
