// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ControlPanel.h"

#include "OpacityOptions.h"
#include "PlainText.h"

#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>

namespace pellucid
{
namespace
{
const ImVec4 ErrorColor(1.0F, 0.45F, 0.4F, 1.0F);
constexpr double LargestNumber = 1e6; // that a mouse can drag to; options and files may have more

//------------------------------------------------------------------------------
void Raise(Change& change, Change needed)
{
  change = std::max(change, needed);
}

//------------------------------------------------------------------------------
// Whether another of the names was chosen.
bool Choose(const char* label, int& index, const std::vector<std::string>& names)
{
  bool isChanged = false;
  if (ImGui::BeginCombo(label, index < 0 ? "" : names[index].c_str()))
  {
    for (int i = 0; i < static_cast<int>(names.size()); ++i)
    {
      ImGui::PushID(i);
      if (ImGui::Selectable(MakePrintable(names[i]).c_str(), i == index))
      {
        isChanged = i != index;
        index = i;
      }
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  return isChanged;
}

//------------------------------------------------------------------------------
template <typename Enum>
bool Choose(const char* label, Enum& value, const std::vector<std::string>& names)
{
  int index = static_cast<int>(value);
  const bool isChanged = Choose(label, index, names);
  value = static_cast<Enum>(index);
  return isChanged;
}

//------------------------------------------------------------------------------
// One of the arrays, or none, which is called `none`.
bool ChooseArray(
  const char* label, std::string& name, const char* none, const std::vector<std::string>& arrays)
{
  std::vector<std::string> names = { none };
  names.insert(names.end(), arrays.begin(), arrays.end());
  const auto found = std::find(arrays.begin(), arrays.end(), name);
  int index = name.empty()  ? 0
    : found == arrays.end() ? -1
                            : static_cast<int>(found - arrays.begin()) + 1;
  if (!Choose(label, index, names))
  {
    return false;
  }
  name = index == 0 ? std::string() : names[index];
  return true;
}

//------------------------------------------------------------------------------
bool Drag(const char* label, double& value, double minimum, double maximum)
{
  const auto speed = static_cast<float>(value > 0.0 ? 0.01 * value : 0.01);
  return ImGui::DragScalar(label, ImGuiDataType_Double, &value, speed, &minimum, &maximum, "%.4g",
    ImGuiSliderFlags_AlwaysClamp);
}

//------------------------------------------------------------------------------
// A number that has a default: the one in effect is shown.
bool Drag(
  const char* label, double inEffect, std::optional<double>& value, double minimum, double maximum)
{
  if (!Drag(label, inEffect, minimum, maximum))
  {
    return false;
  }
  value = inEffect;
  return true;
}

//------------------------------------------------------------------------------
// Whether the mouse or keyboard has left a number that it has changed.
bool Enter(const char* label, double& value)
{
  ImGui::InputDouble(label, &value, 0.0, 0.0, "%.6g");
  return ImGui::IsItemDeactivatedAfterEdit();
}

//------------------------------------------------------------------------------
bool EnterLimit(const char* label, RangeLimit& limit)
{
  ImGui::PushID(label);
  ImGui::SetNextItemWidth(0.42F * ImGui::GetContentRegionAvail().x);
  bool isChanged = Enter("##value", limit.Value);
  ImGui::SameLine();
  isChanged = ImGui::Checkbox("%", &limit.IsPercentile) || isChanged;
  if (limit.IsPercentile)
  {
    limit.Value = std::clamp(limit.Value, 0.0, 100.0);
  }
  ImGui::SameLine();
  ImGui::TextUnformatted(label);
  ImGui::PopID();
  return isChanged;
}

//------------------------------------------------------------------------------
// One of the arrays that importance is made from; without a name it is not.
bool DrawTerm(
  const char* label, const char* none, ImportanceTerm& term, const std::vector<std::string>& arrays)
{
  bool isChanged = ChooseArray(label, term.Array, none, arrays);
  if (isChanged)
  {
    term.Minimum = { 50.0, true };
    term.Maximum = { 99.0, true };
  }
  if (!term.Array.empty())
  {
    isChanged |= EnterLimit("is 0", term.Minimum);
    isChanged |= EnterLimit("is 1", term.Maximum);
    isChanged |= Enter("weight", term.Weight);
    term.Weight = std::max(0.0, term.Weight);
  }
  return isChanged;
}

//------------------------------------------------------------------------------
void DrawImportance(ViewedScene& scene, Change& change)
{
  RenderOptions& options = scene.Options;
  std::vector<ImportanceTerm>& terms = options.Importance;
  const bool isFactor = options.Opacities.Rule == OpacityRule::Factor;
  bool isChanged = false;
  terms.emplace_back(); // where one more can be chosen
  for (std::size_t i = 0; i < terms.size(); ++i)
  {
    ImGui::PushID(static_cast<int>(i));
    const char* none = i > 0 || isFactor ? "none" : "automatic";
    isChanged |= DrawTerm(i == 0 ? "importance" : "and", none, terms[i], scene.GetArrayNames());
    ImGui::PopID();
  }
  terms.erase(std::remove_if(terms.begin(), terms.end(),
                [](const ImportanceTerm& term) { return term.Array.empty(); }),
    terms.end());
  if (!terms.empty())
  {
    isChanged |= Enter("exponent", options.Exponent);
    options.Exponent = std::max(0.0, options.Exponent);
  }
  if (isChanged)
  {
    Raise(change, Change::Scene);
  }
  const MadeScene* made = scene.GetMade();
  if (made)
  {
    for (const ImportanceTerm& term : made->Statistics.Importance.Terms)
    {
      ImGui::TextWrapped("%s: %.4g to %.4g", MakePrintable(term.Array).c_str(), term.Minimum.Value,
        term.Maximum.Value);
    }
  }
}

//------------------------------------------------------------------------------
bool ChoosePreset(OpacityOptions& options)
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkOpacityOptimization::GetNumberOfPresets(); ++i)
  {
    names.emplace_back(vtkOpacityOptimization::GetPresetName(i));
  }
  const auto found = std::find(names.begin(), names.end(), options.Preset);
  int index = found == names.end() ? 0 : static_cast<int>(found - names.begin());
  if (!Choose("preset", index, names))
  {
    return false;
  }
  options.Preset = names[index];
  options.OcclusionWeight = options.ClutterWeight = options.Emphasis = {};
  options.SmoothingIterations = {};
  return true;
}

//------------------------------------------------------------------------------
bool DrawOptimization(OpacityOptions& options)
{
  const auto made = MakeOpacityParameters(options, false);
  auto* shown = vtkOpacityOptimization::SafeDownCast(made);
  bool isChanged = ChoosePreset(options);
  isChanged |=
    Drag("q: in front", shown->GetOcclusionWeight(), options.OcclusionWeight, 0.0, LargestNumber);
  isChanged |=
    Drag("r: behind", shown->GetClutterWeight(), options.ClutterWeight, 0.0, LargestNumber);
  isChanged |= Drag("lambda: spares", shown->GetEmphasis(), options.Emphasis, 0.01, 100.0);
  int steps = shown->GetSmoothingIterations();
  if (ImGui::SliderInt("s: smooths", &steps, 0, 100, "%d", ImGuiSliderFlags_AlwaysClamp))
  {
    options.SmoothingIterations = steps;
    isChanged = true;
  }
  isChanged |= ImGui::Checkbox("self-occlusion", &options.SelfOcclusion);
  int scale = options.GatherScale.value_or(1);
  if (ImGui::SliderInt("gather scale", &scale, 1, 4, "1/%d", ImGuiSliderFlags_AlwaysClamp))
  {
    options.GatherScale = scale;
    isChanged = true;
  }
  return isChanged;
}

//------------------------------------------------------------------------------
bool DrawAvoidance(OpacityOptions& options)
{
  const auto made = MakeOpacityParameters(options, false);
  auto* shown = vtkOcclusionAvoidance::SafeDownCast(made);
  bool isChanged = false;
  if (options.Rule == OpacityRule::Penalty)
  {
    isChanged |= Drag("penalty", shown->GetPenalty(), options.Penalty, 0.0, 1.0);
  }
  else
  {
    isChanged |= Drag(
      "m: importance", shown->GetImportanceWeight(), options.ImportanceWeight, 0.0, LargestNumber);
    isChanged |=
      Drag("c: coverage", shown->GetCoverageWeight(), options.CoverageWeight, 0.0, LargestNumber);
    isChanged |= Drag("v: directions", shown->GetDirectionalVarianceWeight(),
      options.VarianceWeight, 0.0, LargestNumber);
    isChanged |= Drag("d: depth", shown->GetDepthWeight(), options.DepthWeight, 0.0, LargestNumber);
    isChanged |=
      Drag("lambda: spares", shown->GetImportanceExponent(), options.Emphasis, 0.01, 100.0);
  }
  isChanged |= Drag("of all", shown->GetGlobalOpacity(), options.GlobalOpacity, 0.0, 1.0);
  isChanged |= ImGui::Checkbox("soft borders", &options.SmoothAttributes);
  return isChanged;
}

//------------------------------------------------------------------------------
void DrawOpacities(ViewedScene& scene, Change& change)
{
  OpacityOptions& options = scene.Options.Opacities;
  const OpacityRule previous = options.Rule;
  if (Choose("opacities", options.Rule,
        { "as they are", "optimised", "avoidance: penalty", "avoidance: weights" }))
  {
    if (previous == OpacityRule::Optimization || options.Rule == OpacityRule::Optimization)
    {
      options.Emphasis = {}; // lambda of another rule
    }
    options.Shown = {};
    Raise(change, Change::Scene);
  }
  DrawImportance(scene, change);
  const bool isChanged = options.Rule == OpacityRule::Optimization ? DrawOptimization(options)
    : options.Rule != OpacityRule::Factor                          ? DrawAvoidance(options)
                                                                   : false;
  if (isChanged)
  {
    Raise(change, Change::Appearance);
  }
}

//------------------------------------------------------------------------------
void DrawShown(ViewChoice& shown, Change& change)
{
  bool isChanged = Choose("show", shown.Kind,
    { "picture", "opacity", "importance", "segments", "number of layers", "first layers",
      "one layer" });
  if (shown.Kind == ViewKind::FirstLayers || shown.Kind == ViewKind::Layer)
  {
    isChanged |= ImGui::InputInt("layer", &shown.Layer);
    shown.Layer = std::max(1, shown.Layer);
  }
  if (isChanged)
  {
    Raise(change, Change::Appearance);
  }
}

//------------------------------------------------------------------------------
void DrawAppearance(ViewedScene& scene, Change& change)
{
  RenderOptions& options = scene.Options;
  if (ChooseArray("colours", options.ColorBy, "automatic", scene.GetArrayNames()))
  {
    options.ColorRange = {};
    Raise(change, Change::Scene);
  }
  const MadeScene* made = scene.GetMade();
  const bool hasImportance = made && !made->Statistics.Importance.Terms.empty();
  double opacity = options.Opacity.value_or(hasImportance ? 1.0 : 0.3);
  bool isChanged = Drag("opacity", opacity, options.Opacity, 0.0, 1.0);
  double radius = scene.GetRadius();
  if (Drag("radius", radius, 0.0, LargestNumber))
  {
    options.Radius = radius; // 0 goes back to that from the data
    isChanged = true;
  }
  isChanged |= ImGui::Checkbox("lighting", &options.Lighting);
  if (isChanged)
  {
    Raise(change, Change::Appearance);
  }
}

//------------------------------------------------------------------------------
void DrawStatistics(const FrameStatistics& statistics)
{
  const auto row = [](const std::string& name, const char* format, auto value)
  {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name.c_str());
    ImGui::TableNextColumn();
    ImGui::Text(format, value);
  };
  if (ImGui::BeginTable("statistics", 2))
  {
    if (statistics.Tiles > 0)
    {
      row("fragments", "%lld", statistics.Fragments);
      row("longest list", "%lld", statistics.LongestList);
      row("memory", "%.1f MiB", static_cast<double>(statistics.BufferBytes) / (1 << 20));
    }
    for (const auto& [name, milliseconds] : statistics.Stages)
    {
      row(name, "%.2f ms", milliseconds);
    }
    ImGui::EndTable();
  }
  ImGui::TextWrapped("%s, OpenGL %s", statistics.Renderer.c_str(), statistics.OpenGL.c_str());
}

//------------------------------------------------------------------------------
void DrawMessages(const PanelContents& contents)
{
  for (const auto& [text, color] : { std::pair(&contents.Error, ErrorColor),
         { &contents.Unsupported, ImVec4(1.0F, 0.8F, 0.4F, 1.0F) },
         { &contents.Message, ImVec4(0.7F, 0.9F, 0.7F, 1.0F) } })
  {
    if (!text->empty())
    {
      ImGui::PushStyleColor(ImGuiCol_Text, color);
      ImGui::TextWrapped("%s", MakePrintable(*text).c_str());
      ImGui::PopStyleColor();
    }
  }
}

//------------------------------------------------------------------------------
// Text that mouse and keyboard do not notice, where SetNextWindowPos() says.
void DrawNote(const char* name, const std::string& text, float width, ImGuiWindowFlags flags)
{
  flags |= ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
    ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing;
  ImGui::Begin(name, nullptr, flags);
  ImGui::PushTextWrapPos(width - ImGui::GetStyle().WindowPadding.x);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::End();
}

//------------------------------------------------------------------------------
void DrawMethod(ViewedScene& scene, const PanelContents& contents, Change& change)
{
  const Method previous = scene.Options.RenderMethod;
  if (Choose(
        "method", scene.Options.RenderMethod, { "exact", "VTK's default", "VTK's depth peeling" }))
  {
    if (scene.Options.RenderMethod == Method::Pellucid && !contents.Unsupported.empty())
    {
      scene.Options.RenderMethod = previous;
      return;
    }
    Raise(change, Change::Scene);
  }
}
}

//------------------------------------------------------------------------------
PanelRequest DrawPanel(
  ViewedScene& scene, double& fadeTime, const PanelContents& contents, float width)
{
  PanelRequest request;
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({ whole.x - width, 0.0F });
  ImGui::SetNextWindowSize({ width, whole.y });
  ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar);
  ImGui::PushItemWidth(0.55F * width);
  request.ResetsCamera = ImGui::Button("Reset view");
  ImGui::SameLine();
  request.SavesPicture = ImGui::Button("Save picture");
  DrawMessages(contents);
  DrawMethod(scene, contents, request.Changed);
  const bool isExact = scene.Options.RenderMethod == Method::Pellucid;
  if (ImGui::CollapsingHeader("Appearance", ImGuiTreeNodeFlags_DefaultOpen))
  {
    DrawAppearance(scene, request.Changed);
  }
  if (isExact && ImGui::CollapsingHeader("Opacities", ImGuiTreeNodeFlags_DefaultOpen))
  {
    DrawOpacities(scene, request.Changed);
    Drag("fade, s", fadeTime, 0.0, 10.0);
    DrawShown(scene.Options.Opacities.Shown, request.Changed);
  }
  if (ImGui::CollapsingHeader("Statistics", ImGuiTreeNodeFlags_DefaultOpen))
  {
    DrawStatistics(contents.Statistics);
  }
  ImGui::PopItemWidth();
  ImGui::End();
  return request;
}

//------------------------------------------------------------------------------
void DrawHint(const std::string& text, float width)
{
  ImGui::SetNextWindowPos(
    { 0.5F * width, 0.5F * ImGui::GetIO().DisplaySize.y }, ImGuiCond_Always, { 0.5F, 0.5F });
  DrawNote("hint", text, width, ImGuiWindowFlags_NoBackground);
}

//------------------------------------------------------------------------------
void DrawError(const std::string& text, float width)
{
  ImGui::SetNextWindowPos({ 0.0F, 0.0F });
  ImGui::PushStyleColor(ImGuiCol_Text, ErrorColor);
  DrawNote("error", MakePrintable(text), width, ImGuiWindowFlags_None);
  ImGui::PopStyleColor();
}
}
