// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkIntrinsicTriangulation.h"

#include "vtkTriangleSurface.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// By how much, in mean lengths, two sides of a triangle have to exceed the third.
constexpr double Margin = 1e-5;

// The sum of two cotangents that counts as 0, so that four vertices on a circle are not flipped for
// ever.
constexpr double Tolerance = 1e-9;

//------------------------------------------------------------------------------
// By how much two sides exceed the third, at least.
double GetExcess(const std::array<double, 3>& lengths)
{
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  return lengths[0] + lengths[1] + lengths[2] - 2.0 * longest;
}
}

//------------------------------------------------------------------------------
vtkIntrinsicTriangulation::vtkIntrinsicTriangulation(const vtkTriangleSurface& surface)
{
  this->AddTriangles(surface);
  this->FindMates();
  this->Orient();
  this->FlipToDelaunay();
}

//------------------------------------------------------------------------------
// Heron's formula in W. Kahan's order, which does not cancel ("Miscalculating area and angles of a
// needle-like triangle", 2014).
double vtkIntrinsicTriangulation::ComputeArea(std::array<double, 3> lengths)
{
  std::sort(lengths.begin(), lengths.end());
  const double c = lengths[0];
  const double b = lengths[1];
  const double a = lengths[2];
  return 0.25 * std::sqrt((a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c)));
}

//------------------------------------------------------------------------------
std::pair<double, double> vtkIntrinsicTriangulation::LayOut(double base, double left, double right)
{
  const double x = 0.5 * (base + (left - right) * (left + right) / base);
  return { x, 2.0 * ComputeArea({ base, left, right }) / base };
}

//------------------------------------------------------------------------------
void vtkIntrinsicTriangulation::AddTriangles(const vtkTriangleSurface& surface)
{
  std::vector<std::size_t> componentOfVertex(surface.GetNumberOfVertices());
  for (std::size_t component = 0; component < surface.GetComponents().size(); ++component)
  {
    for (const vtkIdType vertex : surface.GetComponents()[component])
    {
      componentOfVertex[vertex] = component;
    }
  }
  std::vector<std::vector<Triangle>> components(surface.GetComponents().size());
  for (const auto& corners : surface.GetTriangles())
  {
    Triangle triangle{ corners, {}, 0.0 };
    bool isProper = true;
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType begin = corners[(i + 1) % 3];
      const vtkIdType end = corners[(i + 2) % 3];
      isProper = isProper && begin != end;
      triangle.Lengths[i] = (surface.GetPosition(end) - surface.GetPosition(begin)).Norm();
    }
    if (isProper)
    {
      components[componentOfVertex[corners[0]]].push_back(triangle);
    }
  }
  for (auto& component : components)
  {
    this->ProlongSides(component);
    this->Triangles.insert(this->Triangles.end(), component.begin(), component.end());
  }
}

//------------------------------------------------------------------------------
void vtkIntrinsicTriangulation::ProlongSides(std::vector<Triangle>& component) const
{
  double mean = 0.0;
  double leastExcess = VTK_DOUBLE_MAX;
  for (const Triangle& triangle : component)
  {
    for (const double length : triangle.Lengths)
    {
      mean += length / (3.0 * static_cast<double>(component.size()));
    }
    leastExcess = std::min(leastExcess, GetExcess(triangle.Lengths));
  }
  const double prolongation = std::max(0.0, Margin * mean - leastExcess);
  for (Triangle& triangle : component)
  {
    triangle.MeanLength = mean;
    for (double& length : triangle.Lengths)
    {
      length += prolongation;
    }
  }
}

//------------------------------------------------------------------------------
void vtkIntrinsicTriangulation::FindMates()
{
  const auto count = static_cast<Side>(3 * this->Triangles.size());
  using Edge = std::tuple<vtkIdType, vtkIdType, Side>;
  std::vector<Edge> edges;
  edges.reserve(count);
  for (Side side = 0; side < count; ++side)
  {
    const Side next = GetNext(side);
    const auto ends = std::minmax(this->GetVertex(next), this->GetVertex(GetNext(next)));
    edges.emplace_back(ends.first, ends.second, side);
  }
  std::sort(edges.begin(), edges.end());

  this->Mates.assign(count, NoSide);
  const auto isSame = [](const Edge& a, const Edge& b)
  { return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b); };
  for (auto begin = edges.begin(), end = begin; begin != edges.end(); begin = end)
  {
    end =
      std::find_if_not(begin, edges.end(), [&](const Edge& edge) { return isSame(edge, *begin); });
    if (end - begin == 2)
    {
      this->Mates[std::get<2>(begin[0])] = std::get<2>(begin[1]);
      this->Mates[std::get<2>(begin[1])] = std::get<2>(begin[0]);
    }
  }
}

//------------------------------------------------------------------------------
// Turn triangles round until mates have opposite directions, and part those for which that fails.
void vtkIntrinsicTriangulation::Orient()
{
  std::vector<bool> isKnown(this->Triangles.size(), false);
  std::vector<Side> stack;
  for (std::size_t first = 0; first < this->Triangles.size(); ++first)
  {
    if (!isKnown[first])
    {
      isKnown[first] = true;
      stack.push_back(static_cast<Side>(first));
    }
    while (!stack.empty())
    {
      const Side triangle = stack.back();
      stack.pop_back();
      for (Side side = 3 * triangle; side < 3 * triangle + 3; ++side)
      {
        if (this->Mates[side] == NoSide)
        {
          continue;
        }
        const Side other = this->Mates[side] / 3;
        const bool isOpposite =
          this->GetVertex(GetNext(side)) == this->GetVertex(GetNext(GetNext(this->Mates[side])));
        if (!isKnown[other])
        {
          isKnown[other] = true;
          stack.push_back(other);
          if (!isOpposite)
          {
            this->Reverse(other);
          }
        }
        else if (!isOpposite)
        {
          this->Mates[this->Mates[side]] = NoSide;
          this->Mates[side] = NoSide;
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkIntrinsicTriangulation::Reverse(Side triangle)
{
  const Side second = 3 * triangle + 1;
  const Side third = second + 1;
  std::swap(this->GetVertex(second), this->GetVertex(third));
  std::swap(this->GetLength(second), this->GetLength(third));
  std::swap(this->Mates[second], this->Mates[third]);
  for (const Side side : { second, third })
  {
    if (this->Mates[side] != NoSide)
    {
      this->Mates[this->Mates[side]] = side;
    }
  }
}

//------------------------------------------------------------------------------
// Of the angle opposite a side.
double vtkIntrinsicTriangulation::GetCotangent(Side side) const
{
  const auto& lengths = this->Triangles[side / 3].Lengths;
  const double a = lengths[side % 3];
  const double b = lengths[(side + 1) % 3];
  const double c = lengths[(side + 2) % 3];
  return (b * b + c * c - a * a) / (4.0 * ComputeArea(lengths));
}

//------------------------------------------------------------------------------
bool vtkIntrinsicTriangulation::IsDelaunay(Side side) const
{
  return this->Mates[side] == NoSide ||
    this->GetCotangent(side) + this->GetCotangent(this->Mates[side]) >= -Tolerance;
}

//------------------------------------------------------------------------------
// The triangles (a, b, c) and (d, c, b) at the side from b to c become (a, b, d) and (a, d, c).
// False if, by rounding, these are no triangles.
bool vtkIntrinsicTriangulation::Flip(Side side)
{
  const Side mate = this->Mates[side];
  const Side ca = GetNext(side);
  const Side ab = GetNext(ca);
  const Side bd = GetNext(mate);
  const Side dc = GetNext(bd);
  const double base = this->GetLength(side);
  const auto above = LayOut(base, this->GetLength(ab), this->GetLength(ca));
  const auto below = LayOut(base, this->GetLength(bd), this->GetLength(dc));
  const double across = std::hypot(above.first - below.first, above.second + below.second);

  const double mean = this->Triangles[side / 3].MeanLength;
  const Triangle left{ { this->GetVertex(side), this->GetVertex(ca), this->GetVertex(mate) },
    { this->GetLength(bd), across, this->GetLength(ab) }, mean };
  const Triangle right{ { this->GetVertex(side), this->GetVertex(mate), this->GetVertex(ab) },
    { this->GetLength(dc), this->GetLength(ca), across }, mean };
  if (!(ComputeArea(left.Lengths) > 0.0 && ComputeArea(right.Lengths) > 0.0))
  {
    return false;
  }

  const Side l = 3 * (side / 3);
  const Side r = 3 * (mate / 3);
  // The outer sides, before and after; two of them may be mates of each other.
  const std::array<std::pair<Side, Side>, 4> moves{ { { bd, l }, { ab, l + 2 }, { dc, r },
    { ca, r + 1 } } };
  std::array<Side, 4> mates;
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    mates[i] = this->Mates[moves[i].first];
    const auto moved = std::find_if(moves.begin(), moves.end(),
      [&](const std::pair<Side, Side>& move) { return move.first == mates[i]; });
    if (moved != moves.end())
    {
      mates[i] = moved->second;
    }
  }
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    this->Mates[moves[i].second] = mates[i];
    if (mates[i] != NoSide)
    {
      this->Mates[mates[i]] = moves[i].second;
    }
  }
  this->Mates[l + 1] = r + 2;
  this->Mates[r + 2] = l + 1;
  this->Triangles[l / 3] = left;
  this->Triangles[r / 3] = right;
  return true;
}

//------------------------------------------------------------------------------
void vtkIntrinsicTriangulation::FlipToDelaunay()
{
  const auto count = static_cast<Side>(3 * this->Triangles.size());
  std::vector<Side> stack;
  for (Side side = count - 1; side >= 0; --side)
  {
    stack.push_back(side);
  }
  // Rounding could make flips go round in a circle; no surface is known where it does.
  Side flipsLeft = 100 * count;
  while (!stack.empty() && flipsLeft > 0)
  {
    const Side side = stack.back();
    stack.pop_back();
    const Side l = 3 * (side / 3);
    const Side r = this->Mates[side] == NoSide ? NoSide : 3 * (this->Mates[side] / 3);
    if (l != r && !this->IsDelaunay(side) && this->Flip(side))
    {
      --flipsLeft;
      stack.insert(stack.end(), { l, l + 2, r, r + 1 });
    }
  }
}

VTK_ABI_NAMESPACE_END
