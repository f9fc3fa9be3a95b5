// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPolylineRanges.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

// Steps of 0.1 in single precision add up to a little more than they should.
constexpr double WindowTolerance = 1e-6;

//------------------------------------------------------------------------------
// The greatest, in the order `Better`, of the values that are inside a window that only moves on:
// each value waits in line behind the better ones before it.
template <typename Better>
class WindowExtreme
{
public:
  void Add(double time, double value)
  {
    while (!this->Candidates.empty() && Better()(value, this->Candidates.back().second))
    {
      this->Candidates.pop_back();
    }
    this->Candidates.emplace_back(time, value);
  }

  void RemoveBefore(double time, double tolerated)
  {
    while (time - this->Candidates.front().first > tolerated)
    {
      this->Candidates.pop_front();
    }
  }

  double Get() const { return this->Candidates.front().second; }

private:
  std::deque<std::pair<double, double>> Candidates;
};

//------------------------------------------------------------------------------
float ToFloat(double range)
{
  const double largest = std::numeric_limits<float>::max();
  return static_cast<float>(range > largest ? largest : range);
}
}

//------------------------------------------------------------------------------
vtkPolylineRanges::vtkPolylineRanges(
  const vtkPolylines& lines, vtkDataArray* values, vtkDataArray* times, double window)
  : Lines(lines)
  , Values(values)
  , Times(times ? std::make_optional<vtkArrayValues>(times) : std::nullopt)
  , Window(window * (1.0 + WindowTolerance))
{
}

//------------------------------------------------------------------------------
void vtkPolylineRanges::Compute(vtkIdType first, vtkIdType last, float* ranges) const
{
  std::vector<Sample> samples;
  for (vtkIdType line = first; line < last; ++line)
  {
    ranges[line] =
      ToFloat(this->Times ? this->ComputeInWindow(line, samples) : this->ComputeOfLine(line));
  }
}

//------------------------------------------------------------------------------
double vtkPolylineRanges::ComputeOfLine(vtkIdType line) const
{
  double lowest = Infinite;
  double highest = -Infinite;
  const vtkIdType end = this->Lines.GetEnd(line);
  for (vtkIdType i = this->Lines.GetBegin(line); i < end; i += vtkPolylines::BlockSize)
  {
    vtkIdType ids[vtkPolylines::BlockSize];
    double values[vtkPolylines::BlockSize];
    const vtkIdType count = std::min(vtkPolylines::BlockSize, end - i);
    this->Lines.CopyIds(i, i + count, ids);
    this->Values.Gather(ids, count, 0, values);
    for (vtkIdType j = 0; j < count; ++j)
    {
      lowest = values[j] < lowest ? values[j] : lowest;
      highest = values[j] > highest ? values[j] : highest;
    }
  }
  return lowest <= highest ? highest - lowest : Missing;
}

//------------------------------------------------------------------------------
double vtkPolylineRanges::ComputeInWindow(vtkIdType line, std::vector<Sample>& samples) const
{
  this->GatherSamples(line, samples);
  double range = Missing;
  WindowExtreme<std::less<double>> lowest;
  WindowExtreme<std::greater<double>> highest;
  for (const Sample& sample : samples)
  {
    lowest.Add(sample.Time, sample.Value);
    highest.Add(sample.Time, sample.Value);
    lowest.RemoveBefore(sample.Time, this->Window);
    highest.RemoveBefore(sample.Time, this->Window);
    range = std::fmax(range, highest.Get() - lowest.Get());
  }
  return range;
}

//------------------------------------------------------------------------------
// The points of a line that have a time and a value, in the order of time or of its reverse, which
// has the same windows.
void vtkPolylineRanges::GatherSamples(vtkIdType line, std::vector<Sample>& samples) const
{
  samples.clear();
  const vtkIdType end = this->Lines.GetEnd(line);
  for (vtkIdType i = this->Lines.GetBegin(line); i < end; i += vtkPolylines::BlockSize)
  {
    vtkIdType ids[vtkPolylines::BlockSize];
    double values[vtkPolylines::BlockSize];
    double times[vtkPolylines::BlockSize];
    const vtkIdType count = std::min(vtkPolylines::BlockSize, end - i);
    this->Lines.CopyIds(i, i + count, ids);
    this->Values.Gather(ids, count, 0, values);
    this->Times->Gather(ids, count, 0, times);
    for (vtkIdType j = 0; j < count; ++j)
    {
      if (!std::isnan(values[j]) && !std::isnan(times[j]))
      {
        samples.push_back({ times[j], values[j] });
      }
    }
  }
  if (!samples.empty() && samples.back().Time < samples.front().Time)
  {
    for (Sample& sample : samples)
    {
      sample.Time = -sample.Time;
    }
  }
  const auto isEarlier = [](const Sample& a, const Sample& b) { return a.Time < b.Time; };
  if (!std::is_sorted(samples.begin(), samples.end(), isEarlier))
  {
    std::sort(samples.begin(), samples.end(), isEarlier);
  }
}

VTK_ABI_NAMESPACE_END
