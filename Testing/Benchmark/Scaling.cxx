// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scaling.h"

#include "Statistics.h"

#include <array>
#include <cmath>
#include <cstddef>

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
    times.push_back(row.IsCold ? 0.0 : row.GetMedian());
    bytes.push_back(static_cast<double>(row.BufferBytes.value_or(0)));
  }
  series.TimeExponent = FitExponent(sizes, times);
  series.MemoryExponent = FitExponent(sizes, bytes);
}

//------------------------------------------------------------------------------
// One series for each method, which grow by a row with each scene.
class Measuring
{
public:
  Measuring(const std::vector<Method>& methods, const MeasurementSettings& settings,
    const ScalingProgress& progress)
    : Methods(methods)
    , Settings(settings)
    , Progress(progress)
  {
    this->Settings.FindsErrors = false;
    // Only a method that is alone has its buffers told apart.
    this->Settings.InterleavedSegments = 0;
  }

  void MeasureFragments(double limit)
  {
    this->Begin("fragments");
    Scene scene = MakeABCFlow("abc-" + std::to_string(ManyLines), ManyLines, SegmentsPerLine);
    for (double wanted = FewestFragments; wanted <= 1.001 * limit; wanted *= Step)
    {
      const double height = std::sqrt(wanted / FragmentsPerPixel / Aspect);
      this->Settings.Size = { static_cast<int>(std::lround(Aspect * height)),
        static_cast<int>(std::lround(height)) };
      this->Add(scene);
    }
  }

  void MeasureSegments(double limit)
  {
    this->Begin("segments");
    this->Settings.Size = Window;
    for (double perLine = 1.0; FewLines * perLine <= 1.001 * limit; perLine *= Step)
    {
      const int segments = static_cast<int>(std::lround(perLine));
      Scene scene = MakeABCFlow("abc-1000-of-" + std::to_string(segments), FewLines, segments);
      this->Add(scene);
    }
  }

private:
  void Begin(const std::string& over)
  {
    for (const Method& method : this->Methods)
    {
      this->All.push_back({ method.Name, over, {} });
    }
  }

  void Add(Scene& scene)
  {
    const auto& size = this->Settings.Size;
    this->Progress.Tell("scaling, " + std::to_string(scene.GetNumberOfSegments()) + " segments, " +
      std::to_string(size[0]) + "x" + std::to_string(size[1]));
    const auto rows = Measure(scene, this->Methods, this->Settings);
    auto series = this->All.end() - static_cast<std::ptrdiff_t>(rows.size());
    for (const Row& row : rows)
    {
      series->Rows.push_back(row);
      Fit(*series++);
    }
    this->Progress.Save(this->All);
  }

  const std::vector<Method>& Methods;
  MeasurementSettings Settings;
  const ScalingProgress& Progress;
  std::vector<Series> All;
};
}

//------------------------------------------------------------------------------
void MeasureScaling(const std::vector<Method>& methods, const MeasurementSettings& settings,
  const ScalingLimits& limits, const ScalingProgress& progress)
{
  Measuring measuring(methods, settings, progress);
  measuring.MeasureFragments(limits.Fragments);
  measuring.MeasureSegments(limits.Segments);
}
}
}
