// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What was measured of one method on one scene. README.md explains each number.
 */

#ifndef Row_h
#define Row_h

#include "PictureError.h"

#include "vtkType.h"

#include <optional> // for what is not known
#include <string>   // for names
#include <utility>  // for std::pair
#include <vector>   // for times

namespace pellucid
{
namespace benchmark
{
struct Row
{
  std::string Scene;
  std::string Method;
  std::string Family;
  std::optional<double> Parameter; // which orders the family
  std::string Shape;               // "cones" or "triangles"
  int Width = 0;
  int Height = 0;
  double Opacity = 0.0;
  vtkIdType Segments = 0;
  bool HasOptimizedOpacities = false;
  std::optional<vtkIdType> Fragments;
  std::optional<vtkIdType> LongestList;
  std::optional<vtkIdType> Bytes;
  std::optional<vtkIdType> BufferBytes;
  std::vector<double> Milliseconds; // one for each frame
  std::vector<std::pair<std::string, double>> Stages;
  std::optional<PictureError> Error;
  bool IsOnFront = false;
  bool IsInterleaved = false; // frames alternate with those of other methods
  bool IsCold = false;        // the time is that of the first frame
  std::string Skipped;        // what was not measured, and why

  /** The time, in milliseconds, that the fraction of all frames took less than; NaN where none was
   * timed. 0 is the shortest one, 0.5 the median, 1 the longest one. */
  double GetTime(double fraction) const;
  double GetMedian() const { return this->GetTime(0.5); }
};
}
}

#endif
