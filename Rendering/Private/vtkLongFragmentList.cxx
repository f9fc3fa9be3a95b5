// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLongFragmentList.h"

#include "OpacitySolution.h"
#include "ViewColors.h"
#include "vtkExactTransparencyPass.h"
#include "vtkOptimizedScene.h"
#include "vtkPictureView.h"
#include "vtkPixelAttributes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
using Color = vtkFragmentLists::Color;

/** Straight colour and opacity. */
struct Layer
{
  std::array<double, 3> Rgb{};
  double Alpha = 0.0;
};

float ToFloat(std::uint32_t bits)
{
  float number = 0.0f;
  std::memcpy(&number, &bits, sizeof(number));
  return number;
}

// The inverse of pellucidPackColor in glsl/vtkFragmentColorDec.glsl.
Layer Unpack(const Color& color)
{
  const float alpha = ToFloat((color.High >> 7) << 6);
  const std::array<std::uint32_t, 3> rgb{ (color.Low >> 26) | ((color.High & 127u) << 6),
    (color.Low >> 13) & 8191u, color.Low & 8191u };
  return { { rgb[0] / 8191.0, rgb[1] / 8191.0, rgb[2] / 8191.0 }, alpha };
}

Color Pack(const Layer& layer)
{
  std::array<std::uint32_t, 3> rgb{};
  std::transform(layer.Rgb.begin(), layer.Rgb.end(), rgb.begin(),
    [](double component)
    { return static_cast<std::uint32_t>(std::lround(std::clamp(component, 0.0, 1.0) * 8191.0)); });
  const float alpha = static_cast<float>(std::min(layer.Alpha, 1.0));
  std::uint32_t alphaBits = 0;
  std::memcpy(&alphaBits, &alpha, sizeof(alpha));
  alphaBits = (alphaBits + 32u) >> 6;
  return { rgb[2] | (rgb[1] << 13) | (rgb[0] << 26), (rgb[0] >> 6) | (alphaBits << 7) };
}

pellucid::OcclusionAvoidance<double> ToAvoidance(const vtkOptimizedScene::Parameters& actor)
{
  using Avoidance = pellucid::OcclusionAvoidance<double>;
  Avoidance avoidance;
  avoidance.mode = (actor.Avoids & vtkOptimizedScene::AvoidsByWeighting) != 0 ? Avoidance::WEIGHTING
                                                                              : Avoidance::PENALTY;
  avoidance.penalty = actor.Penalty;
  avoidance.importanceWeight = actor.ImportanceWeight;
  avoidance.coverageWeight = actor.CoverageWeight;
  avoidance.varianceWeight = actor.VarianceWeight;
  avoidance.depthWeight = actor.DepthWeight;
  avoidance.lambda = actor.Lambda;
  avoidance.globalOpacity = actor.GlobalOpacity;
  avoidance.smoothAttributes = (actor.Avoids & vtkOptimizedScene::SmoothsAttributes) != 0;
  return avoidance;
}

bool IsAvoiding(const vtkFragmentLists::Importance& importance)
{
  return (importance.Segment & vtkSegmentOpacities::AvoidingBit) != 0;
}

// The inverse of pellucidPackTangent in glsl/vtkTangentDec.glsl.
pellucid::Vector3<double> UnpackTangent(std::uint32_t packed)
{
  if (packed == 0)
  {
    return pellucid::Vector3<double>(0.0);
  }
  const auto unpack = [](std::uint32_t part)
  { return (static_cast<double>(part) - 32768.0) / 32767.0; };
  pellucid::Vector3<double> v(unpack(packed & 65535u), unpack(packed >> 16), 0.0);
  v.z = 1.0 - std::abs(v.x) - std::abs(v.y);
  if (v.z < 0.0)
  {
    const double x = v.x;
    v.x = std::copysign(1.0 - std::abs(v.y), v.x);
    v.y = std::copysign(1.0 - std::abs(x), v.y);
  }
  return glm::normalize(v);
}

/** Front-to-back accumulation, premultiplied. */
class Accumulator
{
public:
  void Add(const Layer& layer)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Rgb[i] += this->Transmittance * layer.Alpha * layer.Rgb[i];
    }
    this->Transmittance *= 1.0 - layer.Alpha;
  }
  Layer GetLayer() const
  {
    Layer layer;
    layer.Alpha = 1.0 - this->Transmittance;
    if (layer.Alpha > 0.0)
    {
      std::transform(this->Rgb.begin(), this->Rgb.end(), layer.Rgb.begin(),
        [&layer](double component) { return component / layer.Alpha; });
    }
    return layer;
  }

private:
  std::array<double, 3> Rgb{};
  double Transmittance = 1.0;
};
}

//------------------------------------------------------------------------------
vtkLongFragmentList::vtkLongFragmentList(const vtkFragmentLists::Nodes& nodes, std::uint32_t head)
  : Nodes(nodes)
  , Head(head)
{
  for (std::uint32_t node = head; node != 0; node = nodes.Links[node].Next)
  {
    Fragment fragment{ nodes.Links[node].DepthBits, nodes.Colors[node], {}, {}, 1.0 };
    if (nodes.Importances)
    {
      fragment.Importance = nodes.Importances[node];
      fragment.Position = nodes.Positions[node];
    }
    this->Fragments.push_back(fragment);
  }
  // The same order as isBefore in glsl/vtkFragmentSortFS.glsl.
  std::sort(this->Fragments.begin(), this->Fragments.end(),
    [](const Fragment& a, const Fragment& b)
    {
      return std::tie(a.DepthBits, a.Color.High, a.Color.Low, a.Importance.Bits,
               a.Importance.Segment, a.Position.Opacity, a.Position.Share) <
        std::tie(b.DepthBits, b.Color.High, b.Color.Low, b.Importance.Bits, b.Importance.Segment,
          b.Position.Opacity, b.Position.Share);
    });
}

//------------------------------------------------------------------------------
void vtkLongFragmentList::Solve(
  const vtkOptimizedScene& scene, std::vector<vtkSegmentOpacities::SegmentOpacity>& opacities) const
{
  std::vector<pellucid::OpacityParameters<double>> parameters;
  for (const auto& actor : scene.GetParameters())
  {
    parameters.push_back(
      { actor.OcclusionWeight, actor.ClutterWeight, 0.5 * actor.Exponent, !actor.SelfOcclusion });
  }
  std::vector<pellucid::OpacityFragment<double>> list;
  for (const Fragment& fragment : this->Fragments)
  {
    const std::uint32_t segment = fragment.Importance.Segment;
    list.push_back({ ToFloat(fragment.Importance.Bits), segment,
      segment == 0 || IsAvoiding(fragment.Importance) ? nullptr
                                                      : &parameters[scene.GetActors()[segment]] });
  }
  std::vector<double> solution;
  pellucid::SolveOpacities(list, solution);
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    if (list[i].parameters && !pellucid::IsSelfOcclusion(list, i))
    {
      opacities.push_back(
        { this->Fragments[i].Importance.Segment, static_cast<float>(solution[i]) });
    }
  }
}

//------------------------------------------------------------------------------
void vtkLongFragmentList::Fade(const std::vector<float>& opacities)
{
  for (Fragment& fragment : this->Fragments)
  {
    fragment.Factor = opacities.empty() || IsAvoiding(fragment.Importance)
      ? 1.0
      : vtkSegmentOpacities::Interpolate(
          opacities, fragment.Position.Opacity, fragment.Position.Share);
  }
}

//------------------------------------------------------------------------------
pellucid::PixelAttributes<double> vtkLongFragmentList::GetAttributes(
  const vtkPixelAttributes* distances) const
{
  std::vector<pellucid::AttributeFragment<double>> fragments;
  for (const Fragment& fragment : this->Fragments)
  {
    const double depth = ToFloat(fragment.DepthBits);
    fragments.push_back(
      { distances ? distances->GetDistance(depth) : depth, ToFloat(fragment.Importance.Bits),
        IsAvoiding(fragment.Importance) ? UnpackTangent(fragment.Position.Opacity)
                                        : pellucid::Vector3<double>(0.0) });
  }
  return pellucid::ComputePixelAttributes(fragments);
}

//------------------------------------------------------------------------------
void vtkLongFragmentList::Avoid(const vtkOptimizedScene& scene, const vtkPixelAttributes& pixels,
  const pellucid::PixelAttributes<double>& smooth)
{
  const auto sharp = this->GetAttributes(nullptr);
  auto smoothed = this->GetAttributes(&pixels);
  smoothed.importance = smooth.importance;
  smoothed.depth = smooth.depth;
  for (Fragment& fragment : this->Fragments)
  {
    if (IsAvoiding(fragment.Importance))
    {
      const std::uint32_t segment = fragment.Importance.Segment & ~vtkSegmentOpacities::AvoidingBit;
      const auto avoidance = ToAvoidance(scene.GetParameters()[scene.GetActors()[segment]]);
      const double depth = ToFloat(fragment.DepthBits);
      const double importance = ToFloat(fragment.Importance.Bits);
      fragment.Factor = avoidance.smoothAttributes
        ? avoidance.Factor(pixels.GetDistance(depth), importance, smoothed)
        : avoidance.Factor(depth, importance, sharp);
    }
  }
}

//------------------------------------------------------------------------------
void vtkLongFragmentList::Show(const vtkPictureView& view)
{
  using Pass = vtkExactTransparencyPass;
  if (view.Kind == Pass::VIEW_PICTURE)
  {
    return;
  }
  const double length = static_cast<double>(this->Fragments.size());
  int layer = 0;
  for (Fragment& fragment : this->Fragments)
  {
    ++layer;
    const auto replace = [&fragment](const auto& color)
    {
      fragment.Color = Pack({ { color.x, color.y, color.z }, 1.0 });
      fragment.Factor = 1.0;
    };
    switch (view.Kind)
    {
      case Pass::VIEW_FIRST_LAYERS:
        fragment.Factor *= layer <= view.Layer ? 1.0 : 0.0;
        break;
      case Pass::VIEW_LAYER:
        fragment.Factor *= layer == view.Layer ? 1.0 : 0.0;
        break;
      case Pass::VIEW_OPACITY:
        replace(pellucid::HotColor(fragment.Factor));
        break;
      case Pass::VIEW_IMPORTANCE:
        replace(pellucid::HotColor<double>(ToFloat(fragment.Importance.Bits)));
        break;
      case Pass::VIEW_SEGMENTS:
        replace(pellucid::SegmentColor<double>(
          IsAvoiding(fragment.Importance) ? 0 : fragment.Importance.Segment));
        break;
      case Pass::VIEW_LENGTH:
        replace(pellucid::HotColor(length / static_cast<double>(view.LongestList)));
        break;
      default:
        break;
    }
  }
}

//------------------------------------------------------------------------------
void vtkLongFragmentList::Collapse(const std::uint32_t* opaqueLimits, int samples)
{
  std::vector<std::uint32_t> limits(opaqueLimits, opaqueLimits + samples);
  std::sort(limits.begin(), limits.end());

  std::uint32_t node = this->Head;
  auto limit = limits.begin();
  auto fragment = this->Fragments.begin();
  while (fragment != this->Fragments.end())
  {
    limit = std::lower_bound(limit, limits.end(), fragment->DepthBits);
    const auto groupEnd = limit == limits.end()
      ? this->Fragments.end()
      : std::find_if(fragment, this->Fragments.end(),
          [&limit](const Fragment& candidate) { return candidate.DepthBits > *limit; });
    Accumulator accumulator;
    std::for_each(fragment, groupEnd,
      [&accumulator](const Fragment& member)
      {
        Layer layer = Unpack(member.Color);
        layer.Alpha *= member.Factor;
        accumulator.Add(layer);
      });
    this->Nodes.Colors[node] = Pack(accumulator.GetLayer());
    this->Nodes.Links[node].DepthBits = fragment->DepthBits;
    fragment = groupEnd;
    if (fragment == this->Fragments.end())
    {
      this->Nodes.Links[node].Next = 0;
    }
    node = this->Nodes.Links[node].Next;
  }
}

VTK_ABI_NAMESPACE_END
