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
  std::vector<double> Milliseconds; // one for each frame
  std::vector<std::pair<std::string, double>> Stages;
  std::optional<PictureError> Error;
  bool IsOnFront = false;

  // Of the times; NaN where there are none.
  double GetMedian() const;
  double GetMinimum() const;
  double GetMaximum() const;
};
}
}

#endif
