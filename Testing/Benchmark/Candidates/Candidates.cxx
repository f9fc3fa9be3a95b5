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
void AddLists(std::vector<Candidate>& candidates)
{
  struct Named
  {
    const char* Name;
    const char* Description;
    int Sort;
  };
  for (const Named& sort :
    { Named{ "insertion", "insertion sort in local memory", Lists::SORT_INSERTION },
      { "shell", "Shell sort in local memory", Lists::SORT_SHELL },
      { "heap-4", "quaternary heap as priority queue", Lists::SORT_HEAP },
      { "merge", "bottom-up merge sort in local memory", Lists::SORT_MERGE },
      { "selection-16", "repeated selection of the 16 nearest", Lists::SORT_SELECTION } })
  {
    const int kind = sort.Sort;
    candidates.push_back({ std::string("lists-") + sort.Name, "lists",
      std::string("linked lists, ") + sort.Description, true,
      Make<Lists>([kind](Lists* pass) { pass->SetSort(kind); }) });
    candidates.push_back({ std::string("count-and-fill-") + sort.Name, "count-and-fill",
      std::string("arrays filled in a second draw, ") + sort.Description, true,
      Make<Lists>(
        [kind](Lists* pass)
        {
          pass->SetSort(kind);
          pass->SetContiguous(true);
        }) });
  }
}

//------------------------------------------------------------------------------
void AddFormats(std::vector<Candidate>& candidates)
{
  for (const Lists::Colors bytes : { Lists::COLOR_32_BITS, Lists::COLOR_128_BITS })
  {
    candidates.push_back({ "lists-" + std::to_string(bytes + 4) + "-bytes", "lists",
      "linked lists, quaternary heap, colours of " + std::to_string(8 * bytes) +
        " bits instead of 64",
      bytes != Lists::COLOR_32_BITS,
      Make<Lists>([bytes](Lists* pass) { pass->SetColorBytes(bytes); }) });
  }
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
  for (const Threshold& threshold : Thresholds)
  {
    const double value = threshold.Transmittance;
    candidates.push_back({ std::string("lists-stop-") + threshold.Name, "lists-stop",
      std::string("linked lists, quaternary heap, stops at a transmittance of ") + threshold.Name,
      false, Make<Lists>([value](Lists* pass) { pass->SetNegligibleTransmittance(value); }) });
  }
}

//------------------------------------------------------------------------------
void AddLayers(std::vector<Candidate>& candidates)
{
  for (const int layers : { 2, 4, 8, 16, 32 })
  {
    const std::string number = std::to_string(layers);
    candidates.push_back({ "k-buffer-" + number, "k-buffer",
      "sorted geometry, the nearest of " + number + " entries is composited when they are full",
      false, Make<vtkCandidateKBufferPass>([layers](auto* pass) { pass->SetLayers(layers); }) });
  }
  for (const int layers : { 4, 8, 16 })
  {
    const std::string number = std::to_string(layers);
    candidates.push_back({ "multi-layer-" + number, "multi-layer",
      "multi-layer alpha blending, the farthest of " + number + " layers are merged", false,
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
    candidates.push_back({ std::string("depth-slices-") + threshold.Name, "depth-slices",
      std::string("k-buffer of 8, ten slices culled by opacity at a transmittance of ") +
        threshold.Name,
      false,
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
  AddFormats(candidates);
  AddThresholds(candidates);
  AddLayers(candidates);
  AddDepthSlices(candidates);
  return candidates;
}
}
