// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReferenceOpacities.h"

#include "vtkReferenceSweep.h"

#include "vtkSMPThreadLocal.h"

#include <algorithm>
#include <cmath>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Opacities = std::vector<double>;
using PixelFragments = pellucid::PixelFragments<double>;

/** What a thread needs again and again. */
struct Workspace
{
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
  vtkForEachReferencePixel(caster,
    [&workspaces](int, int, const PixelFragments& pixel)
    {
      Workspace& work = workspaces.Local();
      work.List.clear();
      for (const auto& fragment : pixel.GetTranslucent())
      {
        work.List.push_back(fragment.place.nearest);
      }
      pellucid::SolveOpacities(work.List, work.Solution);
      pellucid::LowerSegmentOpacities(work.List, work.Solution, work.Segments);
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
pellucid::RayCaster<double> Reduce(const pellucid::RayCaster<double>& caster, int scale)
{
  const auto& full = caster.GetView();
  const auto reduced = full.Reduced(scale);
  std::vector<double> opaqueDepths(static_cast<std::size_t>(reduced.width) * reduced.height);
  // Whether this is, in its row or column, the pixel that a pixel of the small picture samples.
  const auto isSample = [scale](int pixel, int size)
  { return pixel == std::min(pixel / scale * scale + scale / 2, size - 1); };
  vtkForEachReferencePixel(caster,
    [&](int x, int y, const PixelFragments& pixel)
    {
      if (isSample(x, full.width) && isSample(y, full.height))
      {
        opaqueDepths[static_cast<std::size_t>(y / scale) * reduced.width + x / scale] =
          pixel.GetOpaqueDepth();
      }
    });
  return { caster.GetScene(), reduced, std::move(opaqueDepths) };
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
  const pellucid::RayCaster<double>& caster, const vtkOptimizedScene& scene, int gatherScale)
{
  const auto numberOfSegments = static_cast<std::size_t>(scene.GetNumberOfSegments());
  Opacities opacities =
    Smooth(gatherScale > 1 ? FindLeastOpacities(Reduce(caster, gatherScale), numberOfSegments)
                           : FindLeastOpacities(caster, numberOfSegments),
      scene);
  const Opacities segments = opacities;
  for (const auto& corner : scene.GetCorners())
  {
    opacities.push_back(InterpolateAt(corner, segments));
  }
  return opacities;
}

//------------------------------------------------------------------------------
std::vector<pellucid::PixelAttributes<double>> vtkSmoothReferenceAttributes(
  const pellucid::RayCaster<double>& caster)
{
  const auto& surfaces = caster.GetScene().surfaces;
  if (std::none_of(surfaces.begin(), surfaces.end(),
        [](const auto& s) { return s.avoidance && s.avoidance->smoothAttributes; }))
  {
    return {};
  }
  const auto& view = caster.GetView();
  std::vector<pellucid::PixelAttributes<double>> attributes(
    static_cast<std::size_t>(view.width) * view.height);
  vtkForEachReferencePixel(caster,
    [&](int x, int y, const PixelFragments& pixel)
    {
      attributes[static_cast<std::size_t>(y) * view.width + x] =
        pixel.GetAttributes(&pellucid::Fragment<double>::distance);
    });
  pellucid::SmoothPixelAttributes(attributes, view.width);
  return attributes;
}
VTK_ABI_NAMESPACE_END
