// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   How time and memory grow with the number of fragments, and with that of segments.
 */

#ifndef Scaling_h
#define Scaling_h

#include "Measurement.h"

#include <functional> // for the progress
#include <string>     // for names
#include <vector>     // for rows

namespace pellucid
{
namespace benchmark
{
/** A method over scenes that differ in one number, which is "fragments" or "segments". */
struct Series
{
  std::string Method;
  std::string Over;
  std::vector<Row> Rows;

  /** Exponents b of the power laws a x^b that fit the times of warm frames and the bytes of all
   * buffers best, in the sense of least squares of the logarithms; NaN where there are no two rows
   * that tell. */
  double TimeExponent = 0.0;
  double MemoryExponent = 0.0;
};

struct ScalingLimits
{
  double Fragments = 1e8;
  double Segments = 1e7;
};

struct ScalingProgress
{
  /** Called with the name of each step before it is measured. */
  std::function<void(const std::string&)> Tell;

  /** Called after each step with all that has been measured. */
  std::function<void(const std::vector<Series>&)> Save;
};

/**
 * Two series for each method, with three sizes in each power of ten. Fragments, from about 1e5:
 * 5000 lines in windows of growing size, so that lists keep their lengths. Segments, from 1e3: 1000
 * lines at 320x240, in 1 to 10,000 segments each, so that the picture and its fragments stay as
 * they are. Each method has each scene alone.
 */
void MeasureScaling(const std::vector<Method>& methods, const MeasurementSettings& settings,
  const ScalingLimits& limits, const ScalingProgress& progress);
}
}

#endif
