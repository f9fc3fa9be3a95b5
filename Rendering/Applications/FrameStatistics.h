// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Counts, memory and times of a picture, and their file.
 */

#ifndef FrameStatistics_h
#define FrameStatistics_h

#include "SceneImportance.h"

#include <string>  // for names
#include <utility> // for stages
#include <vector>  // for stages

class vtkTransparencyStatistics;

namespace pellucid
{
/** What is drawn. */
struct SceneStatistics
{
  long long InputPoints = 0; // after tracing, before selection
  long long InputLines = 0;
  long long SelectedLines = 0;
  FoundImportance Importance;
  std::string ColorBy; // empty: no array
};

/** How it was drawn. */
struct FrameStatistics
{
  long long Fragments = 0;       // 0 where the method does not count them
  long long SolvedFragments = 0; // of those, with an optimised opacity
  long long LongestList = 0;
  long long BufferBytes = 0;
  int Tiles = 0;
  std::vector<std::pair<std::string, double>> Stages; // milliseconds
  std::string Renderer;                               // of OpenGL, or the reference renderer
  std::string OpenGL;                                 // version; empty without OpenGL

  /** Take over what the exact pass did. */
  void Take(vtkTransparencyStatistics* statistics);
};

/**
 * Write JSON with the keys input_points, input_lines, selected_lines, color_by (null, or a name),
 * importance (an array of objects with array, minimum, maximum and weight), importance_histogram
 * (null, or an object with minimum, maximum and counts), fragments, solved_fragments, longest_list,
 * buffer_bytes, tiles, stages (an object: name to milliseconds), renderer and opengl; throw
 * RenderError when that fails.
 */
void WriteStatistics(
  const SceneStatistics& scene, const FrameStatistics& frame, const std::string& fileName);
}

#endif
