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
constexpr int Lines = 1000;
constexpr int LineSegments = 99;
constexpr std::array<int, 2> SegmentWindow = { 320, 240 };

// Three sizes in each power of ten.
const double Step = std::cbrt(10.0);

// What 1000 lines make at 320x240, about; windows of other sizes follow from it.
constexpr double FragmentsOfSegmentWindow = 1.3e5;
constexpr double FewestFragments = 1e5;

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
  Scene scene = MakeABCFlow("abc-1000", Lines, LineSegments);
  for (double wanted = FewestFragments; wanted <= 1.001 * limit; wanted *= Step)
  {
    const double scale = std::sqrt(wanted / FragmentsOfSegmentWindow);
    for (int i = 0; i < 2; ++i)
    {
      settings.Size[i] = static_cast<int>(std::lround(scale * SegmentWindow[i]));
    }
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
  settings.Size = SegmentWindow;
  for (double perLine = 1.0; Lines * perLine <= 1.001 * limit; perLine *= Step)
  {
    const int segments = static_cast<int>(std::lround(perLine));
    tell("scaling, " + std::to_string(Lines * segments) + " segments");
    Scene scene = MakeABCFlow("abc-1000-of-" + std::to_string(segments), Lines, segments);
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
