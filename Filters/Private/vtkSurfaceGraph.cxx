// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceGraph.h"

#include "vtkTriangleSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Path = vtkSurfaceGraph::Path;
using Source = vtkNearestSources::Source;
using Arrival = vtkNearestSources::Arrival;

// An edge as a triangle has it.
struct Side
{
  vtkIdType First; // the lesser vertex
  vtkIdType Last;
  vtkIdType Opposite;
};

//------------------------------------------------------------------------------
bool IsSameEdge(const Side& a, const Side& b)
{
  return a.First == b.First && a.Last == b.Last;
}

//------------------------------------------------------------------------------
// Sides of all triangles, those of an edge together; none between a vertex and itself.
std::vector<Side> FindSides(const vtkTriangleSurface& surface)
{
  std::vector<Side> sides;
  sides.reserve(3 * surface.GetTriangles().size());
  for (const auto& triangle : surface.GetTriangles())
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto ends = std::minmax(triangle[(i + 1) % 3], triangle[(i + 2) % 3]);
      if (ends.first < ends.second)
      {
        sides.push_back({ ends.first, ends.second, triangle[i] });
      }
    }
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    { return std::tie(a.First, a.Last, a.Opposite) < std::tie(b.First, b.Last, b.Opposite); });
  return sides;
}

//------------------------------------------------------------------------------
// Length of the line between the opposite vertices of an edge's two sides, unfolded into a plane;
// infinite where it misses the edge.
double MeasureAcross(const vtkTriangleSurface& surface, const Side& upper, const Side& lower)
{
  const vtkVector3d origin = surface.GetPosition(upper.First);
  vtkVector3d axis = surface.GetPosition(upper.Last) - origin;
  const double length = axis.Normalize();
  const auto unfold = [&](vtkIdType vertex)
  {
    const vtkVector3d offset = surface.GetPosition(vertex) - origin;
    return vtkVector2d(offset.Dot(axis), offset.Cross(axis).Norm());
  };
  const vtkVector2d above = unfold(upper.Opposite);
  const vtkVector2d below = unfold(lower.Opposite);
  const double height = above.GetY() + below.GetY();
  const double along = below.GetX() - above.GetX();
  const double crossing = above.GetX() + along * above.GetY() / height;
  return crossing >= 0.0 && crossing <= length ? std::hypot(along, height)
                                               : std::numeric_limits<double>::infinity();
}

//------------------------------------------------------------------------------
bool IsLess(const Source& a, const Source& b)
{
  return std::tie(a.Distance, a.Id) < std::tie(b.Distance, b.Id);
}

// Puts the nearest arrival on top of a priority queue.
struct IsLater
{
  bool operator()(const Arrival& a, const Arrival& b) const
  {
    return std::tie(a.From.Distance, a.From.Id, a.Vertex) >
      std::tie(b.From.Distance, b.From.Id, b.Vertex);
  }
};
}

//------------------------------------------------------------------------------
vtkSurfaceGraph::vtkSurfaceGraph(const vtkTriangleSurface& surface)
  : Begins(surface.GetNumberOfVertices() + 1, 0)
{
  std::vector<Path> paths;
  const auto add = [&paths](vtkIdType a, vtkIdType b, double length)
  {
    const float rounded = std::max(static_cast<float>(length), LeastLength);
    paths.push_back({ a, b, rounded });
    paths.push_back({ b, a, rounded });
  };

  const auto sides = FindSides(surface);
  for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end)
  {
    end = std::find_if_not(
      begin, sides.end(), [&](const Side& side) { return IsSameEdge(side, *begin); });
    add(begin->First, begin->Last,
      (surface.GetPosition(begin->Last) - surface.GetPosition(begin->First)).Norm());
    if (end - begin == 2 && begin[0].Opposite != begin[1].Opposite)
    {
      const double across = MeasureAcross(surface, begin[0], begin[1]);
      if (std::isfinite(across))
      {
        add(begin[0].Opposite, begin[1].Opposite, across);
      }
    }
  }

  for (const Path& path : paths)
  {
    ++this->Begins[path.From + 1];
  }
  for (std::size_t i = 1; i < this->Begins.size(); ++i)
  {
    this->Begins[i] += this->Begins[i - 1];
  }
  auto next = this->Begins;
  this->Paths.resize(paths.size());
  for (const Path& path : paths)
  {
    this->Paths[next[path.From]++] = path;
  }
}

//------------------------------------------------------------------------------
vtkNearestSources::vtkNearestSources(const vtkSurfaceGraph& graph, int count)
  : Graph(graph)
  , Count(count)
  , Sources(graph.GetNumberOfVertices() * count, { std::numeric_limits<float>::infinity(), -1 })
{
}

//------------------------------------------------------------------------------
void vtkNearestSources::Add(const std::vector<Arrival>& starts)
{
  std::priority_queue<Arrival, std::vector<Arrival>, IsLater> arrivals;
  const auto arrive = [&](const Arrival& arrival)
  {
    if (this->Improve(arrival.Vertex, arrival.From))
    {
      arrivals.push(arrival);
    }
  };
  std::for_each(starts.begin(), starts.end(), arrive);
  while (!arrivals.empty())
  {
    const Arrival arrival = arrivals.top();
    arrivals.pop();
    if (this->Has(arrival.Vertex, arrival.From))
    {
      for (auto path = this->Graph.BeginPaths(arrival.Vertex);
           path != this->Graph.EndPaths(arrival.Vertex); ++path)
      {
        arrive({ { arrival.From.Distance + path->Length, arrival.From.Id }, path->To });
      }
    }
  }
}

//------------------------------------------------------------------------------
// Whether no shorter way from the source was found since, nor enough nearer sources.
bool vtkNearestSources::Has(vtkIdType vertex, const Source& source) const
{
  return std::any_of(this->Begin(vertex), this->End(vertex),
    [&source](const Source& known)
    { return known.Id == source.Id && known.Distance == source.Distance; });
}

//------------------------------------------------------------------------------
// Put the source in the place of a longer way from it or of the last one; false if that is nearer.
bool vtkNearestSources::Improve(vtkIdType vertex, const Source& source)
{
  const auto begin = this->Sources.begin() + vertex * this->Count;
  const auto end = begin + this->Count;
  auto place =
    std::find_if(begin, end, [&source](const Source& known) { return known.Id == source.Id; });
  if (place == end)
  {
    --place;
  }
  if (!IsLess(source, *place))
  {
    return false;
  }
  *place = source;
  for (; place != begin && IsLess(*place, *(place - 1)); --place)
  {
    std::swap(*place, *(place - 1));
  }
  return true;
}

VTK_ABI_NAMESPACE_END
