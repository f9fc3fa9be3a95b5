// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReferenceOpacities.h"

#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <cmath>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Opacities = std::vector<double>;

/** What a thread needs again and again. */
struct Workspace
{
  std::vector<pellucid::PixelFragments<double>> Pixels;
  std::vector<pellucid::OpacityFragment<double>> List;
  Opacities Solution;
  Opacities Segments;
};

//------------------------------------------------------------------------------
Opacities FindLeastOpacities(
  const pellucid::RayCaster<double>& caster, std::size_t numberOfSegments)
{
  const Opacities unseen(numberOfSegments, pellucid::UndefinedOpacity<double>());
  Workspace exemplar;
  exemplar.Segments = unseen;
  vtkSMPThreadLocal<Workspace> workspaces(exemplar);
  vtkSMPTools::For(0, caster.GetNumberOfTiles(), 8,
    [&](vtkIdType begin, vtkIdType end)
    {
      Workspace& work = workspaces.Local();
      for (int tile = static_cast<int>(begin); tile < end; ++tile)
      {
        caster.Cast(tile, caster.GetTile(tile), work.Pixels);
        for (const auto& pixel : work.Pixels)
        {
          work.List.clear();
          for (const auto& fragment : pixel.GetTranslucent())
          {
            work.List.push_back(fragment.place.nearest);
          }
          pellucid::SolveOpacities(work.List, work.Solution);
          pellucid::LowerSegmentOpacities(work.List, work.Solution, work.Segments);
        }
      }
    });
  // The least of any order is the same.
  Opacities least = unseen;
  for (const Workspace& work : workspaces)
  {
    for (std::size_t segment = 0; segment < least.size(); ++segment)
    {
      least[segment] = std::fmin(least[segment], work.Segments[segment]);
    }
  }
  return least;
}

//------------------------------------------------------------------------------
// Actors differ in their number of steps, and do not touch each other.
Opacities Smooth(const Opacities& least, const vtkOptimizedScene& scene)
{
  pellucid::SegmentNeighbors neighbors;
  neighbors.offsets.assign(scene.GetFirstNeighbors().begin(), scene.GetFirstNeighbors().end());
  neighbors.ids.assign(scene.GetNeighbors().begin(), scene.GetNeighbors().end());
  std::set<std::uint32_t> numbersOfSteps;
  for (const auto& actor : scene.GetParameters())
  {
    numbersOfSteps.insert(actor.SmoothingIterations);
  }
  Opacities smooth = least;
  for (const std::uint32_t steps : numbersOfSteps)
  {
    Opacities candidate = least;
    pellucid::SmoothOpacities(candidate, neighbors, static_cast<int>(steps));
    for (std::size_t segment = 0; segment < smooth.size(); ++segment)
    {
      if (scene.GetParameters()[scene.GetActors()[segment]].SmoothingIterations == steps)
      {
        smooth[segment] = candidate[segment];
      }
    }
  }
  return smooth;
}

//------------------------------------------------------------------------------
double InterpolateAt(const vtkOptimizedScene::Corner& corner, const Opacities& segments)
{
  double sum = 0.0;
  double total = 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const double opacity = segments[corner.Segments[i]];
    if (corner.Weights[i] > 0.0f && pellucid::IsDefined(opacity))
    {
      sum += corner.Weights[i] * opacity;
      total += corner.Weights[i];
    }
  }
  return total > 0.0 ? sum / total : pellucid::UndefinedOpacity<double>();
}
}

//------------------------------------------------------------------------------
std::vector<double> vtkSolveReferenceOpacities(
  const pellucid::RayCaster<double>& caster, const vtkOptimizedScene& scene)
{
  Opacities opacities = Smooth(
    FindLeastOpacities(caster, static_cast<std::size_t>(scene.GetNumberOfSegments())), scene);
  const Opacities segments = opacities;
  for (const auto& corner : scene.GetCorners())
  {
    opacities.push_back(InterpolateAt(corner, segments));
  }
  return opacities;
}
VTK_ABI_NAMESPACE_END
