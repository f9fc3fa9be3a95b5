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
void WriteStatistics(const FrameStatistics& statistics, const std::string& fileName)
{
  nlohmann::ordered_json stages = nlohmann::ordered_json::object();
  for (const auto& [name, milliseconds] : statistics.Stages)
  {
    stages[name] = milliseconds;
  }
  const nlohmann::ordered_json document = {
    { "input_points", statistics.InputPoints },
    { "input_lines", statistics.InputLines },
    { "fragments", statistics.Fragments },
    { "longest_list", statistics.LongestList },
    { "buffer_bytes", statistics.BufferBytes },
    { "tiles", statistics.Tiles },
    { "stages", stages },
    { "renderer", statistics.Renderer },
    { "opengl", statistics.OpenGL },
  };
  std::ofstream file(fileName);
  file << document.dump(2) << "\n";
  if (!file.flush())
  {
    throw RenderError(fileName + ": cannot be written");
  }
}
}
