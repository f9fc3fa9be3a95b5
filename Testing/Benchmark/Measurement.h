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
   * Seconds after which a method gets no more frames, at least 0. One that takes longer for its
   * first frame, which makes its shaders and buffers and otherwise does not count, has that alone.
   */
  double Budget = 20.0;

  /** Whether to compare with vtkReferenceRenderer, at its cost. */
  bool FindsErrors = true;
};

/**
 * One row for each method, in their order. The methods share a window. Each draws the first view,
 * the picture of which is compared; then they take turns frame by frame, so that a busy machine
 * slows all of them, in views that turn round the scene by a degree from frame to frame. Throws
 * RenderError where a frame cannot be drawn.
 */
std::vector<Row> Measure(
  Scene& scene, const std::vector<Method>& methods, const MeasurementSettings& settings);
}
}

#endif
