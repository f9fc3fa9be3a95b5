// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameStatistics.h"

#include "RenderError.h"

#include "vtkTransparencyStatistics.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace pellucid
{
//------------------------------------------------------------------------------
void FrameStatistics::Take(vtkTransparencyStatistics* statistics)
{
  this->Fragments = statistics->GetFragments();
  this->SolvedFragments = statistics->GetSolvedFragments();
  this->LongestList = statistics->GetLongestList();
  this->BufferBytes = statistics->GetBufferBytes();
  this->Tiles = statistics->GetTiles();
  for (int stage = 0; stage < statistics->GetNumberOfStages(); ++stage)
  {
    this->Stages.emplace_back(
      statistics->GetStageName(stage), statistics->GetStageMilliseconds(stage));
  }
}

//------------------------------------------------------------------------------
void WriteStatistics(
  const SceneStatistics& scene, const FrameStatistics& frame, const std::string& fileName)
{
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [name, milliseconds] : frame.Stages)
  {
    stages[name] = milliseconds;
  }
  nlohmann::ordered_json colorBy;
  if (!scene.ColorBy.empty())
  {
    colorBy = scene.ColorBy;
  }
  nlohmann::ordered_json importance = nlohmann::ordered_json::array();
  for (const ImportanceTerm& term : scene.Importance.Terms)
  {
    importance.push_back({ { "array", term.Array }, { "minimum", term.Minimum.Value },
      { "maximum", term.Maximum.Value }, { "weight", term.Weight } });
  }
  nlohmann::ordered_json histogram;
  if (!scene.Importance.Histogram.empty())
  {
    histogram = { { "minimum", 0 }, { "maximum", 1 }, { "counts", scene.Importance.Histogram } };
  }
  const nlohmann::ordered_json document = {
    { "input_points", scene.InputPoints },
    { "input_lines", scene.InputLines },
    { "selected_lines", scene.SelectedLines },
    { "color_by", colorBy },
    { "importance", importance },
    { "importance_histogram", histogram },
    { "fragments", frame.Fragments },
    { "solved_fragments", frame.SolvedFragments },
    { "longest_list", frame.LongestList },
    { "buffer_bytes", frame.BufferBytes },
    { "tiles", frame.Tiles },
    { "stages", stages },
    { "renderer", frame.Renderer },
    { "opengl", frame.OpenGL },
  };
  std::ofstream file(fileName);
  // Names of arrays may be no UTF-8.
  constexpr auto replace = nlohmann::ordered_json::error_handler_t::replace;
  file << document.dump(2, ' ', false, replace) << "\n";
  if (!file.flush())
  {
    throw RenderError(fileName + ": cannot be written");
  }
}
}
