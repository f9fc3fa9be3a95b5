// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Times methods on a scene side by side, and compares their pictures with the reference.
 */

#ifndef Measurement_h
#define Measurement_h

#include "Methods.h"
#include "Row.h"
#include "Scenes.h"

#include <array>  // for the size
#include <limits> // for no limit
#include <vector> // for methods and rows

namespace pellucid
{
namespace benchmark
{
struct MeasurementSettings
{
  std::array<int, 2> Size = { 800, 600 };
  double Opacity = 0.3;

  /** Frames to time of each method, at least 1. */
  int Frames = 9;

  /**
   * Seconds after which a method gets no more frames, at least 0. The first frame, which makes
   * shaders and buffers, does not count, and another one follows it, unless it took more than four
   * times as long as this: then it is the only one, and marked as cold.
   */
  double Budget = 20.0;

  /** Whether to compare with vtkReferenceRenderer, at its cost. */
  bool FindsErrors = true;

  /** Segments up to which the methods of a scene share a window and take turns. Each method has
   * larger scenes alone, and what it held is released before the next one begins. */
  int InterleavedSegments = 500000;

  /** Bytes that a method may take. It is skipped where an estimate says that it needs more, and is
   * not compared where the reference does. */
  double Memory = std::numeric_limits<double>::max();
};

/**
 * One row for each method, in their order. Each draws the first view, the picture of which is
 * compared; then they take turns frame by frame, so that a busy machine slows all of them, in views
 * that turn round the scene by a degree from frame to frame. Throws RenderError where a frame
 * cannot be drawn.
 */
std::vector<Row> Measure(
  Scene& scene, const std::vector<Method>& methods, const MeasurementSettings& settings);
}
}

#endif
