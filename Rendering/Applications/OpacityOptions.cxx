// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OpacityOptions.h"

#include "OptionGroup.h"
#include "OptionText.h"

#include "vtkNew.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"

#include <limits>

namespace pellucid
{
namespace
{
constexpr double LargestWeight = std::numeric_limits<float>::max();

/** An option, and when it has an effect. */
struct Requirement
{
  const char* Option;
  bool IsGiven;
  bool IsMet;
  const char* Reason; // why it has none
};

//------------------------------------------------------------------------------
void Check(const std::vector<Requirement>& requirements)
{
  for (const Requirement& requirement : requirements)
  {
    if (requirement.IsGiven && !requirement.IsMet)
    {
      throw CLI::ValidationError(requirement.Option, requirement.Reason);
    }
  }
}

//------------------------------------------------------------------------------
void AddOptimizationOptions(OptionGroup& group, OpacityOptions& options)
{
  std::vector<std::pair<std::string, std::string>> presets;
  for (int i = 0; i < vtkOpacityOptimization::GetNumberOfPresets(); ++i)
  {
    const char* name = vtkOpacityOptimization::GetPresetName(i);
    presets.emplace_back(name, name);
  }
  group.AddFlag("--optimize", options.Optimize,
    "Fade lines, points and surfaces where they hide, or clutter, what is more important. "
    "--importance says what is important. Without it, values from the 50th to the 99th percentile "
    "count, of the first of these: the speed of traced lines; TotalPressureDifference, where lines "
    "have pressure; the array of --color-by; the active or first array of lines, then of points, "
    "then of surfaces; Curvature of lines. Without --color-by that array colours. What lacks the "
    "array has importance 0");
  group.AddChoice("--preset", options.Preset, presets,
    "Settings of the optimisation: clear-front (default), what hides goes; balanced, more of the "
    "surroundings stays; focus, little but the important stays; clear-back, a quiet background; "
    "points, for particles. This and the following five imply --optimize");
  group.AddNumber("--q", options.OcclusionWeight, 0.0, OptionGroup::Unbounded, "Q",
    "How much fades what lies in front of something important, at least 0; published: 50 to 1000; "
    "default: the preset's");
  group.AddNumber("--r", options.ClutterWeight, 0.0, OptionGroup::Unbounded, "R",
    "How much fades what lies behind something important, at least 0; published: 10 to 400; "
    "default: the preset's");
  group.AddNumber("--lambda", options.Emphasis, 0.01, 100.0, "L",
    "The greater, the more of what is of medium importance stays, 0.01 to 100; default: the "
    "preset's, and 1 with --avoid weighting");
  group.AddInteger("--smoothing", options.SmoothingIterations, 0, 10000, "S",
    "Steps that even the opacities out along lines and over surfaces, 0 to 10000; default: the "
    "preset's, for lines; surfaces take at most 5 of them");
  group.AddFlag("--self-occlusion", options.SelfOcclusion,
    "A segment of a line or surface may also hide itself");
  group.AddInteger("--gather-scale", options.GatherScale, 1, 4, "N",
    "Find the opacities in a picture of 1/N of the width and height, 1 to 4: fewer fragments to "
    "solve, but the geometry is drawn twice, and thin things may be missed. Pays only where "
    "pixels, not geometry, cost the time; default 1");
}

//------------------------------------------------------------------------------
void AddAvoidanceOptions(OptionGroup& group, OpacityOptions& options)
{
  group.AddChoice("--avoid", options.Rule,
    { { "penalty", OpacityRule::Penalty }, { "weighting", OpacityRule::Weighting } },
    "Instead of --optimize, fade by what else is in the pixel: all in front of the most important "
    "thing by one factor, or everything by weights. Importance is that of --optimize");
  group.AddNumber("--avoid-penalty", options.Penalty, 0.0, 1.0, "A",
    "Factor on what is in front of the most important thing, 0 to 1; default 0.25");
  group.AddNumber("--avoid-importance", options.ImportanceWeight, 0.0, LargestWeight, "M",
    "How much fades where something important is in the pixel, at least 0; default 1");
  group.AddNumber("--avoid-coverage", options.CoverageWeight, 0.0, LargestWeight, "C",
    "How much fades for each fragment in the pixel, at least 0; default 0.02");
  group.AddNumber("--avoid-variance", options.VarianceWeight, 0.0, LargestWeight, "V",
    "How much fades where lines run in many directions, at least 0; default 0.5");
  group.AddNumber("--avoid-depth", options.DepthWeight, 0.0, LargestWeight, "D",
    "How much fades in front of the most important thing, at least 0; default 10");
  group.AddNumber("--avoid-opacity", options.GlobalOpacity, 0.0, 1.0, "A",
    "Factor on the opacity of everything with importance, 0 to 1; default 1");
  group.AddFlag("--avoid-smoothing", options.SmoothAttributes,
    "Soften the borders of what is faded: means over 5 x 5 pixels");
}

//------------------------------------------------------------------------------
void CheckRule(const OpacityOptions& options, bool optimizes)
{
  const bool penalizes = options.Rule == OpacityRule::Penalty;
  const bool weights = options.Rule == OpacityRule::Weighting;
  const bool avoids = penalizes || weights;
  const char* ofOptimization = "belongs to --optimize, which --avoid replaces; leave out one";
  const char* ofPenalty = "belongs to --avoid penalty; add that, or leave it out";
  const char* ofWeighting = "belongs to --avoid weighting; add that, or leave it out";
  const char* ofAvoidance = "belongs to --avoid; add that, or leave it out";
  const char* ofBoth = "shows what --optimize or --avoid finds; add one of these";
  Check({
    { "--optimize", options.Optimize, !avoids, "and --avoid replace each other; leave out one" },
    { "--preset", !options.Preset.empty(), !avoids, ofOptimization },
    { "--q", options.OcclusionWeight.has_value(), !avoids, ofOptimization },
    { "--r", options.ClutterWeight.has_value(), !avoids, ofOptimization },
    { "--lambda", options.Emphasis.has_value(), !penalizes,
      "has no effect with --avoid penalty; leave it out, or take --avoid weighting" },
    { "--smoothing", options.SmoothingIterations.has_value(), !avoids, ofOptimization },
    { "--self-occlusion", options.SelfOcclusion, !avoids, ofOptimization },
    { "--gather-scale", options.GatherScale.has_value(), !avoids, ofOptimization },
    { "--gather-scale", options.GatherScale.has_value(), optimizes,
      "belongs to --optimize; add that, or leave it out" },
    { "--avoid-penalty", options.Penalty.has_value(), penalizes, ofPenalty },
    { "--avoid-importance", options.ImportanceWeight.has_value(), weights, ofWeighting },
    { "--avoid-coverage", options.CoverageWeight.has_value(), weights, ofWeighting },
    { "--avoid-variance", options.VarianceWeight.has_value(), weights, ofWeighting },
    { "--avoid-depth", options.DepthWeight.has_value(), weights, ofWeighting },
    { "--avoid-opacity", options.GlobalOpacity.has_value(), avoids, ofAvoidance },
    { "--avoid-smoothing", options.SmoothAttributes, avoids, ofAvoidance },
    { "--view opacity", options.Shown.Kind == ViewKind::Opacity, optimizes || avoids, ofBoth },
    { "--view importance", options.Shown.Kind == ViewKind::Importance, optimizes || avoids,
      ofBoth },
    { "--view segments", options.Shown.Kind == ViewKind::Segments, optimizes,
      "shows what --optimize works with; add that" },
  });
}

//------------------------------------------------------------------------------
template <typename Parameters, typename Number, typename Value>
void SetIfGiven(Parameters* parameters, void (Parameters::*set)(Number), std::optional<Value> value)
{
  if (value)
  {
    (parameters->*set)(*value);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImportanceDrivenOpacity> MakeOptimization(
  const OpacityOptions& options, bool isSurface)
{
  using Parameters = vtkOpacityOptimization;
  auto parameters = vtkSmartPointer<Parameters>::New();
  if (!options.Preset.empty())
  {
    parameters->UsePreset(options.Preset.c_str(), isSurface);
  }
  SetIfGiven(parameters.Get(), &Parameters::SetOcclusionWeight, options.OcclusionWeight);
  SetIfGiven(parameters.Get(), &Parameters::SetClutterWeight, options.ClutterWeight);
  SetIfGiven(parameters.Get(), &Parameters::SetEmphasis, options.Emphasis);
  SetIfGiven(parameters.Get(), &Parameters::SetSmoothingIterations, options.SmoothingIterations);
  parameters->SetSelfOcclusion(options.SelfOcclusion);
  return parameters;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImportanceDrivenOpacity> MakeAvoidance(const OpacityOptions& options)
{
  using Parameters = vtkOcclusionAvoidance;
  auto parameters = vtkSmartPointer<Parameters>::New();
  parameters->SetMode(
    options.Rule == OpacityRule::Penalty ? Parameters::PENALTY : Parameters::WEIGHTING);
  SetIfGiven(parameters.Get(), &Parameters::SetPenalty, options.Penalty);
  SetIfGiven(parameters.Get(), &Parameters::SetImportanceWeight, options.ImportanceWeight);
  SetIfGiven(parameters.Get(), &Parameters::SetCoverageWeight, options.CoverageWeight);
  SetIfGiven(parameters.Get(), &Parameters::SetDirectionalVarianceWeight, options.VarianceWeight);
  SetIfGiven(parameters.Get(), &Parameters::SetDepthWeight, options.DepthWeight);
  SetIfGiven(parameters.Get(), &Parameters::SetImportanceExponent, options.Emphasis);
  SetIfGiven(parameters.Get(), &Parameters::SetGlobalOpacity, options.GlobalOpacity);
  parameters->SetSmoothAttributes(options.SmoothAttributes);
  return parameters;
}
}

//------------------------------------------------------------------------------
void AddOpacityOptions(CLI::App& app, OpacityOptions& options)
{
  OptionGroup group(app, "Opacity that clears the view");
  AddOptimizationOptions(group, options);
  AddAvoidanceOptions(group, options);
  group.Add(
    "--view",
    [&options](const std::string& text)
    {
      const auto view = ToView(text);
      if (!view)
      {
        Refuse("--view",
          "picture|opacity|importance|segments|length|first:N|layer:N, N a whole number from 1",
          text);
      }
      options.Shown = *view;
    },
    "picture|opacity|importance|segments|length|first:N|layer:N",
    "Show instead of the picture: opacity, importance or segment of the nearest fragment; the "
    "number of fragments of each pixel; the first N layers; layer N alone");
}

//------------------------------------------------------------------------------
void CompleteOpacityOptions(RenderOptions& options)
{
  OpacityOptions& opacities = options.Opacities;
  const bool avoids = opacities.Rule != OpacityRule::Factor;
  const bool optimizes = opacities.Optimize || !opacities.Preset.empty() ||
    opacities.OcclusionWeight || opacities.ClutterWeight || opacities.SmoothingIterations ||
    opacities.SelfOcclusion || (opacities.Emphasis && !avoids);
  CheckRule(opacities, optimizes);
  if (optimizes)
  {
    opacities.Rule = OpacityRule::Optimization;
  }

  const bool drawsExactly = options.RenderMethod == Method::Pellucid || options.Compare;
  const char* ofMethod = "is not for VTK's own methods; leave out --method, or add --compare";
  Check({
    { "--optimize", optimizes, drawsExactly, ofMethod },
    { "--avoid", avoids, drawsExactly, ofMethod },
    { "--view", opacities.Shown.Kind != ViewKind::Picture, drawsExactly, ofMethod },
    { "--exponent", options.Exponent != 1.0,
      !options.Importance.empty() || opacities.Rule != OpacityRule::Factor,
      "is the power of an importance; add --importance" },
  });
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImportanceDrivenOpacity> MakeOpacityParameters(
  const OpacityOptions& options, bool isSurface)
{
  switch (options.Rule)
  {
    case OpacityRule::Optimization:
      return MakeOptimization(options, isSurface);
    case OpacityRule::Penalty:
    case OpacityRule::Weighting:
      return MakeAvoidance(options);
    default:
      return nullptr;
  }
}
}
