// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scaling.h"

#include "Statistics.h"

#include <cmath>

namespace pellucid
{
namespace benchmark
{
namespace
{
// Three sizes in each power of ten.
const double Step = std::cbrt(10.0);

// Over fragments: what the lines make at the aspect of the windows, about.
constexpr int ManyLines = 5000;
constexpr int SegmentsPerLine = 99;
constexpr double FragmentsPerPixel = 3.4;
constexpr double Aspect = 4.0 / 3.0;
constexpr double FewestFragments = 1e5;

// Over segments.
constexpr int FewLines = 1000;
constexpr std::array<int, 2> Window = { 320, 240 };

//------------------------------------------------------------------------------
void Append(std::vector<Series>& series, const std::vector<Row>& rows)
{
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    series[i].Rows.push_back(rows[i]);
  }
}

//------------------------------------------------------------------------------
std::vector<Series> Begin(const std::vector<Method>& methods, const std::string& over)
{
  std::vector<Series> series;
  for (const Method& method : methods)
  {
    series.push_back({ method.Name, over, {} });
  }
  return series;
}

//------------------------------------------------------------------------------
std::vector<Series> MeasureFragments(const std::vector<Method>& methods,
  MeasurementSettings settings, double limit, const std::function<void(const std::string&)>& tell)
{
  auto series = Begin(methods, "fragments");
  Scene scene = MakeABCFlow("abc-" + std::to_string(ManyLines), ManyLines, SegmentsPerLine);
  for (double wanted = FewestFragments; wanted <= 1.001 * limit; wanted *= Step)
  {
    const double height = std::sqrt(wanted / FragmentsPerPixel / Aspect);
    settings.Size = { static_cast<int>(std::lround(Aspect * height)),
      static_cast<int>(std::lround(height)) };
    tell("scaling, " + std::to_string(settings.Size[0]) + "x" + std::to_string(settings.Size[1]));
    Append(series, Measure(scene, methods, settings));
  }
  return series;
}

//------------------------------------------------------------------------------
std::vector<Series> MeasureSegments(const std::vector<Method>& methods,
  MeasurementSettings settings, double limit, const std::function<void(const std::string&)>& tell)
{
  auto series = Begin(methods, "segments");
  settings.Size = Window;
  for (double perLine = 1.0; FewLines * perLine <= 1.001 * limit; perLine *= Step)
  {
    const int segments = static_cast<int>(std::lround(perLine));
    tell("scaling, " + std::to_string(FewLines * segments) + " segments");
    Scene scene = MakeABCFlow("abc-1000-of-" + std::to_string(segments), FewLines, segments);
    Append(series, Measure(scene, methods, settings));
  }
  return series;
}

//------------------------------------------------------------------------------
double GetSize(const Row& row, const std::string& over)
{
  return static_cast<double>(over == "segments" ? row.Segments : row.Fragments.value_or(0));
}

//------------------------------------------------------------------------------
void Fit(Series& series)
{
  std::vector<double> sizes;
  std::vector<double> times;
  std::vector<double> bytes;
  for (const Row& row : series.Rows)
  {
    sizes.push_back(GetSize(row, series.Over));
    times.push_back(row.GetMedian());
    bytes.push_back(static_cast<double>(row.Bytes.value_or(0)));
  }
  series.TimeExponent = FitExponent(sizes, times);
  series.MemoryExponent = FitExponent(sizes, bytes);
}
}

//------------------------------------------------------------------------------
std::vector<Series> MeasureScaling(const std::vector<Method>& methods,
  const MeasurementSettings& settings, const ScalingLimits& limits,
  const std::function<void(const std::string&)>& tell)
{
  MeasurementSettings untested = settings;
  untested.FindsErrors = false;
  auto all = MeasureFragments(methods, untested, limits.Fragments, tell);
  const auto segments = MeasureSegments(methods, untested, limits.Segments, tell);
  all.insert(all.end(), segments.begin(), segments.end());
  for (Series& series : all)
  {
    Fit(series);
  }
  return all;
}
}
}
