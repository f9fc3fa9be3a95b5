// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The command line of pellucid-benchmark, as a value.
 */

#ifndef BenchmarkOptions_h
#define BenchmarkOptions_h

#include "Measurement.h"
#include "Scaling.h"

#include <array>    // for sizes
#include <optional> // for the exit code
#include <string>   // for names
#include <vector>   // for choices

namespace pellucid
{
namespace benchmark
{
struct BenchmarkOptions
{
  std::string JsonFile;
  std::string CsvFile;
  std::string PlotFile;
  std::string TableFile;
  std::string DataFolder;
  std::vector<std::string> Scenes;  // names or patterns
  std::vector<std::string> Methods; // names or patterns
  std::vector<std::array<int, 2>> Sizes;
  std::vector<double> Opacities;
  MeasurementSettings Settings; // but for size and opacity
  bool MeasuresScaling = false;
  ScalingLimits Limits;
  bool Lists = false;
  std::string RecordFile; // of which to print why candidates are not in the product
};

/** The options; or an exit code, with help or one line of error already printed. */
BenchmarkOptions ParseCommandLine(int argc, char* argv[], std::optional<int>& exitCode);
}
}

#endif
