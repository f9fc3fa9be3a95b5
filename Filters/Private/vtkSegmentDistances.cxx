// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSegmentDistances.h"

#include "vtkHeatGeodesics.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceGraph.h"
#include "vtkTriangleSurface.h"

#include <algorithm>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkSegmentDistances::vtkSegmentDistances(const vtkTriangleSurface& surface,
  const vtkSurfaceGraph& graph, const std::vector<vtkIdType>& samples)
  : Surface(surface)
  , Samples(samples)
{
  vtkNearestSources nearest(graph, Count);
  std::vector<vtkNearestSources::Arrival> starts;
  for (const vtkIdType sample : samples)
  {
    starts.push_back({ { 0.0F, static_cast<int>(starts.size()) }, sample });
  }
  nearest.Add(starts);
  this->Nearest.reserve(Count * surface.GetNumberOfVertices());
  std::transform(nearest.Begin(0), nearest.Begin(surface.GetNumberOfVertices()),
    std::back_inserter(this->Nearest),
    [](const vtkNearestSources::Source& source) {
      return Sample{ source.Distance, source.Id };
    });
}

//------------------------------------------------------------------------------
// Where each sample is among the nearest.
std::vector<std::vector<vtkSegmentDistances::Sample*>> vtkSegmentDistances::FindEntriesOfSamples()
{
  std::vector<std::vector<Sample*>> entries(this->Samples.size());
  for (Sample& entry : this->Nearest)
  {
    if (entry.Id >= 0)
    {
      entries[entry.Id].push_back(&entry);
    }
  }
  return entries;
}

//------------------------------------------------------------------------------
// Colour the samples greedily. At each vertex the samples that it knows have different colours, and
// every other sample of their colours is farther away than all of them.
std::vector<std::vector<int>> vtkSegmentDistances::GroupSamples(
  const std::vector<std::vector<Sample*>>& entriesOfSamples) const
{
  std::vector<std::vector<int>> groups;
  std::vector<int> groupOfSample(this->Samples.size(), -1);
  std::vector<int> lastUser; // of each group: the last sample that must not join it
  for (int sample = 0; sample < static_cast<int>(this->Samples.size()); ++sample)
  {
    for (const Sample* entry : entriesOfSamples[sample])
    {
      const vtkIdType vertex = this->GetVertex(entry);
      for (auto other = this->Begin(vertex); other != this->End(vertex); ++other)
      {
        if (other->Id >= 0 && groupOfSample[other->Id] >= 0)
        {
          lastUser[groupOfSample[other->Id]] = sample;
        }
      }
    }
    const auto group = static_cast<int>(std::find_if(lastUser.begin(), lastUser.end(),
                                          [sample](int user) { return user != sample; }) -
      lastUser.begin());
    if (group == static_cast<int>(groups.size()))
    {
      groups.emplace_back();
      lastUser.push_back(-1);
    }
    groups[group].push_back(sample);
    groupOfSample[sample] = group;
  }
  return groups;
}

//------------------------------------------------------------------------------
void vtkSegmentDistances::Refine(const vtkHeatGeodesics& geodesics, const Progress& progress)
{
  const auto entriesOfSamples = this->FindEntriesOfSamples();
  const auto groups = this->GroupSamples(entriesOfSamples);
  const auto solve = [&](const std::vector<int>& group)
  {
    std::vector<vtkIdType> sources;
    for (const int sample : group)
    {
      sources.push_back(this->Samples[sample]);
    }
    const auto potential = geodesics.Solve(sources);
    for (const int sample : group)
    {
      const vtkIdType source = this->Samples[sample];
      for (Sample* entry : entriesOfSamples[sample])
      {
        const vtkIdType vertex = this->GetVertex(entry);
        const double straight =
          (this->Surface.GetPosition(vertex) - this->Surface.GetPosition(source)).Norm();
        const double least = std::max<double>(straight, vtkSurfaceGraph::LeastLength);
        const double heat = potential[vertex] - potential[source];
        // In this order, a heat that is not a number gives the path in the graph.
        entry->Distance = std::min(entry->Distance, std::max(heat, least));
      }
    }
  };
  const auto count = static_cast<vtkIdType>(groups.size());
  const vtkIdType batch = 4 * vtkSMPTools::GetEstimatedNumberOfThreads();
  bool goOn = true;
  for (vtkIdType first = 0; first < count && goOn; first += batch)
  {
    const vtkIdType last = std::min(first + batch, count);
    vtkSMPTools::For(first, last, 1,
      [&](vtkIdType begin, vtkIdType end)
      { std::for_each(groups.begin() + begin, groups.begin() + end, solve); });
    goOn = progress(static_cast<double>(last) / static_cast<double>(count));
  }

  vtkSMPTools::For(0, this->Surface.GetNumberOfVertices(),
    [this](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType vertex = begin; vertex < end; ++vertex)
      {
        const auto first = this->Nearest.begin() + vertex * Count;
        std::sort(first, first + Count,
          [](const Sample& a, const Sample& b)
          { return std::tie(a.Distance, a.Id) < std::tie(b.Distance, b.Id); });
      }
    });
}

VTK_ABI_NAMESPACE_END
