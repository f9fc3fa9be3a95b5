// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkEnteredTubes.h"

#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
struct Ball
{
  double Center[3];
  double Radius;
};

// A segment that holds a part of the near plane: by how much the near plane's middle is outside.
struct Candidate
{
  vtkIdType Node;
  double Distance;
};

class View
{
public:
  View(const vtkTrajectoryNodes& nodes, vtkMatrix4x4* nodeToView,
    const vtkEnteredTubes::NearPlane& nearPlane)
    : Nodes(nodes)
    , Matrix(nodeToView)
    , Near(nearPlane)
  {
  }

  bool BeginsSegment(vtkIdType node) const { return this->Nodes.GetNodes()[node][3] < 0.0f; }

  Ball GetBall(vtkIdType node) const
  {
    const vtkTrajectoryNodes::Node& values = this->Nodes.GetNodes()[node];
    const auto& remainders = this->Nodes.GetRemainders();
    Ball ball;
    ball.Radius = std::abs(values[3]);
    for (int i = 0; i < 3; ++i)
    {
      ball.Center[i] = this->Matrix->GetElement(3, i);
      for (int j = 0; j < 3; ++j)
      {
        const double point =
          remainders.empty() ? values[j] : values[j] + double(remainders[node][j]);
        ball.Center[i] += point * this->Matrix->GetElement(j, i);
      }
    }
    return ball;
  }

  // Signed distance of the near plane's middle from the rounded cone that begins at a node.
  double GetDistance(vtkIdType node) const
  {
    const Ball ball1 = this->GetBall(node);
    const Ball ball2 = this->GetBall(node + 1);
    double axis[3];
    double way[3];
    vtkMath::Subtract(ball2.Center, ball1.Center, axis);
    vtkMath::Subtract(this->Near.Center.data(), ball1.Center, way);
    const double length = vtkMath::Norm(axis);
    const double slope = length > 0.0 ? (ball1.Radius - ball2.Radius) / length : 1.0;
    if (std::abs(slope) >= 1.0)
    {
      const Ball& larger = ball1.Radius > ball2.Radius ? ball1 : ball2;
      return std::sqrt(vtkMath::Distance2BetweenPoints(larger.Center, this->Near.Center.data())) -
        larger.Radius;
    }
    const double x = vtkMath::Dot(way, axis) / length;
    const double y = std::sqrt(std::max(vtkMath::Dot(way, way) - x * x, 0.0));
    const double nearest =
      vtkMath::ClampValue(x - y * slope / std::sqrt(1.0 - slope * slope), 0.0, length);
    return std::hypot(x - nearest, y) - (ball1.Radius - slope * nearest);
  }

  // The rays through a ball: a cone around a direction, or in parallel projection a disc.
  struct Window
  {
    std::array<double, 3> Middle;
    double Radius;
  };

  Window GetWindow(vtkIdType node) const
  {
    const Ball ball = this->GetBall(node);
    if (this->Near.Parallel)
    {
      return { { { ball.Center[0], ball.Center[1], 0.0 } }, ball.Radius };
    }
    Window window{ { { ball.Center[0], ball.Center[1], ball.Center[2] } }, 0.0 };
    const double distance = vtkMath::Normalize(window.Middle.data());
    const double sine = distance > 0.0 ? (ball.Radius + this->Near.Radius) / distance : 1.0;
    window.Radius = sine < 1.0 ? std::asin(sine) : vtkMath::Pi();
    return window;
  }

  bool Overlap(const Window& a, const Window& b) const
  {
    const double distance = this->Near.Parallel
      ? std::sqrt(vtkMath::Distance2BetweenPoints(a.Middle.data(), b.Middle.data()))
      : vtkMath::AngleBetweenVectors(a.Middle.data(), b.Middle.data());
    return distance <= a.Radius + b.Radius;
  }

  // The last joint that can be seen from a segment through all joints on the way to it.
  vtkIdType FollowJoints(vtkIdType joint, int step, vtkIdType end) const
  {
    if (joint == end)
    {
      return joint;
    }
    Window narrowest = this->GetWindow(joint);
    while (joint + step != end)
    {
      const Window next = this->GetWindow(joint + step);
      if (!this->Overlap(narrowest, next))
      {
        break;
      }
      narrowest = next.Radius < narrowest.Radius ? next : narrowest;
      joint += step;
    }
    return joint;
  }

  vtkEnteredTubes::Tube MakeTube(vtkIdType node) const
  {
    vtkIdType first = node;
    while (first > 0 && this->BeginsSegment(first - 1))
    {
      --first;
    }
    vtkIdType last = node + 1;
    while (this->BeginsSegment(last))
    {
      ++last;
    }
    vtkEnteredTubes::Tube tube;
    for (int end = 0; end < 2; ++end)
    {
      const Ball ball = this->GetBall(node + end);
      std::copy(ball.Center, ball.Center + 3, tube.Balls[end].begin());
      tube.Balls[end][3] = static_cast<float>(ball.Radius);
    }
    tube.First = std::max(this->FollowJoints(node, -1, first) - 1, first);
    tube.Last = std::min(this->FollowJoints(node + 1, 1, last), last - 1);
    return tube;
  }

private:
  const vtkTrajectoryNodes& Nodes;
  vtkMatrix4x4* Matrix;
  const vtkEnteredTubes::NearPlane& Near;
};
}

//------------------------------------------------------------------------------
std::vector<vtkEnteredTubes::Tube> vtkEnteredTubes::Find(
  const vtkTrajectoryNodes& nodes, vtkMatrix4x4* nodeToView, const NearPlane& nearPlane)
{
  const View view(nodes, nodeToView, nearPlane);
  vtkSMPThreadLocal<std::vector<Candidate>> found;
  vtkSMPTools::For(0, nodes.GetNumberOfNodes(),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<Candidate>& local = found.Local();
      for (vtkIdType node = begin; node < end; ++node)
      {
        const double distance =
          view.BeginsSegment(node) ? view.GetDistance(node) : nearPlane.Radius;
        if (distance < nearPlane.Radius)
        {
          local.push_back({ node, distance });
        }
      }
    });
  std::vector<Candidate> candidates;
  for (const auto& local : found)
  {
    candidates.insert(candidates.end(), local.begin(), local.end());
  }
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& a, const Candidate& b)
    { return a.Distance != b.Distance ? a.Distance < b.Distance : a.Node < b.Node; });

  std::vector<Tube> tubes;
  std::vector<std::pair<vtkIdType, vtkIdType>> covered;
  for (const Candidate& candidate : candidates)
  {
    // A segment that holds the whole near plane speaks for all others that it sees.
    const bool spokenFor = std::any_of(covered.begin(), covered.end(),
      [&](const auto& stretch)
      { return stretch.first <= candidate.Node && candidate.Node <= stretch.second; });
    if (spokenFor || tubes.size() == Maximum)
    {
      continue;
    }
    tubes.push_back(view.MakeTube(candidate.Node));
    if (candidate.Distance <= -nearPlane.Radius)
    {
      covered.emplace_back(tubes.back().First, tubes.back().Last);
    }
  }
  return tubes;
}

VTK_ABI_NAMESPACE_END
