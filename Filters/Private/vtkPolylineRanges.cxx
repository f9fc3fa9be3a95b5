// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPolylineRanges.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr double Missing = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

// Steps of 0.1 in single precision add up to a little more than they should.
constexpr double WindowTolerance = 1e-6;

//------------------------------------------------------------------------------
// The best, in the order `Better`, of the values inside a window that only moves on: each value
// waits in line behind the better ones before it.
template <typename Better>
class WindowExtreme
{
public:
  void Clear()
  {
    this->Candidates.clear();
    this->First = 0;
  }

  void Add(double time, double value)
  {
    while (this->First < this->Candidates.size() && Better()(value, this->Candidates.back().second))
    {
      this->Candidates.pop_back();
    }
    this->Candidates.emplace_back(time, value);
  }

  // Values more than `window` before `time` leave; the last one that was added may not be one.
  void Advance(double time, double window)
  {
    while (time - this->Candidates[this->First].first > window)
    {
      ++this->First;
    }
  }

  double Get() const { return this->Candidates[this->First].second; }

private:
  std::vector<std::pair<double, double>> Candidates;
  std::size_t First = 0;
};

//------------------------------------------------------------------------------
float ToFloat(double range)
{
  const double largest = std::numeric_limits<float>::max();
  return static_cast<float>(range > largest ? largest : range);
}
}

//------------------------------------------------------------------------------
// Memory that a thread uses for one trajectory after another.
struct vtkPolylineRanges::Scratch
{
  std::vector<Sample> Samples;
  WindowExtreme<std::less<double>> Lowest;
  WindowExtreme<std::greater<double>> Highest;
};

//------------------------------------------------------------------------------
vtkPolylineRanges::vtkPolylineRanges(const vtkPolylines& lines,
  const std::vector<vtkIdType>& firstLines, vtkDataArray* values, vtkDataArray* times,
  double window)
  : Lines(lines)
  , FirstLines(firstLines)
  , Values(values)
  , Times(times ? std::make_optional<vtkArrayValues>(times) : std::nullopt)
  , Window(window * (1.0 + WindowTolerance))
{
}

//------------------------------------------------------------------------------
void vtkPolylineRanges::Compute(vtkIdType first, vtkIdType last, float* ranges) const
{
  Scratch scratch;
  for (vtkIdType trajectory = first; trajectory < last; ++trajectory)
  {
    const vtkIdType firstLine = this->FirstLines[trajectory];
    const vtkIdType lastLine = this->FirstLines[trajectory + 1];
    // Lines that follow each other have positions that do.
    const vtkIdType begin = this->Lines.GetBegin(firstLine);
    const vtkIdType end = this->Lines.GetBegin(lastLine);
    const double range =
      this->Times ? this->ComputeInWindow(begin, end, scratch) : this->ComputeWhole(begin, end);
    std::fill(ranges + firstLine, ranges + lastLine, ToFloat(range));
  }
}

//------------------------------------------------------------------------------
double vtkPolylineRanges::ComputeWhole(vtkIdType begin, vtkIdType end) const
{
  double lowest = Infinite;
  double highest = -Infinite;
  for (vtkIdType i = begin; i < end; i += vtkPolylines::BlockSize)
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
double vtkPolylineRanges::ComputeInWindow(vtkIdType begin, vtkIdType end, Scratch& scratch) const
{
  this->GatherSamples(begin, end, scratch.Samples);
  scratch.Lowest.Clear();
  scratch.Highest.Clear();
  double range = scratch.Samples.empty() ? Missing : 0.0;
  for (const Sample& sample : scratch.Samples)
  {
    scratch.Lowest.Add(sample.Time, sample.Value);
    scratch.Highest.Add(sample.Time, sample.Value);
    scratch.Lowest.Advance(sample.Time, this->Window);
    scratch.Highest.Advance(sample.Time, this->Window);
    range = std::max(range, scratch.Highest.Get() - scratch.Lowest.Get());
  }
  return range;
}

//------------------------------------------------------------------------------
// The points at these positions that have a time and a value, in the order of time or of its
// reverse, which has the same windows.
void vtkPolylineRanges::GatherSamples(
  vtkIdType begin, vtkIdType end, std::vector<Sample>& samples) const
{
  samples.clear();
  for (vtkIdType i = begin; i < end; i += vtkPolylines::BlockSize)
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
