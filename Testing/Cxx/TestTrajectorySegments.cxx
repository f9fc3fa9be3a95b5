// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkTrajectorySegments: counts in proportion to length and by default, weights against an
 * interpolation that is written down plainly, lines of every degenerate kind, ids beyond 2^24,
 * vertices, surfaces, shared points, composite data, errors, progress, abort, and the same bits
 * with any number of threads.
 */

#include "ReferenceTesting.h"
#include "TrajectoryTesting.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTrajectorySegments.h"

#include <algorithm>
#include <cmath>

namespace
{
/** What the filter made of a point or a cell. */
struct Result
{
  explicit Result(vtkPolyData* data)
    : Data(data)
  {
  }

  vtkIdType Base(vtkIdType point) const
  {
    return this->Get(this->Data->GetPointData(), "SegmentBase", point);
  }
  vtkIdType First(vtkIdType cell) const
  {
    return this->Get(this->Data->GetCellData(), "FirstSegment", cell);
  }
  vtkIdType Count(vtkIdType cell) const
  {
    return this->Get(this->Data->GetCellData(), "NumberOfSegments", cell);
  }
  double Weight(vtkIdType point) const
  {
    return this->Data->GetPointData()->GetArray("SegmentWeight")->GetTuple1(point);
  }

private:
  static vtkIdType Get(vtkFieldData* data, const char* name, vtkIdType i)
  {
    return vtkIdTypeArray::SafeDownCast(data->GetArray(name))->GetValue(i);
  }

  vtkPolyData* Data;
};

double GetLength(const Trajectory& line)
{
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    length += std::sqrt(vtkMath::Distance2BetweenPoints(line[i - 1].data(), line[i].data()));
  }
  return length;
}

//------------------------------------------------------------------------------
// Interpolates a value that is different at each segment, in the middle of it, in two ways.
void TestWeights(Checks& checks)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Trajectory> lines;
  double lengthOfAll = 0.0;
  for (int line = 0; line < 60; ++line)
  {
    TrajectoryPoint position = { 6.4e6, 0.0, 0.0 };
    lines.push_back({ position });
    for (int i = 0; i < line * line; ++i)
    {
      for (double& coordinate : position)
      {
        coordinate += i % 7 == 0 ? 0.0 : uniform(random) - 0.5;
      }
      lines.back().push_back(position);
    }
    lengthOfAll += GetLength(lines.back());
  }
  for (const vtkIdType wanted : { 1, 100, 5000, 1000000 })
  {
    vtkNew<vtkTrajectorySegments> filter;
    filter->SetInputData(MakeTrajectories(lines));
    filter->SetNumberOfSegments(wanted);
    filter->Update();
    const Result result(filter->GetPolyDataOutput());
    const double target = lengthOfAll / static_cast<double>(wanted);
    vtkIdType total = 0;
    vtkIdType point = 0;
    int wrong = 0;
    for (std::size_t line = 0; line < lines.size(); ++line)
    {
      const auto cell = static_cast<vtkIdType>(line);
      const double length = GetLength(lines[line]);
      const vtkIdType count = result.Count(cell);
      const double exact = length / target;
      checks.True("a line's segments are near the target length",
        exact < 1.0 ? count == 1 : std::abs(static_cast<double>(count) - exact) <= 0.5 + 1e-6);
      checks.True("segments are numbered along the lines", result.First(cell) == total);
      std::vector<double> values(count);
      std::generate(values.begin(), values.end(), [&]() { return uniform(random); });
      Trajectory sofar;
      double previous = -1.0;
      for (const TrajectoryPoint& position : lines[line])
      {
        sofar.push_back(position);
        const double where = count == 1
          ? 0.0
          : std::clamp(GetLength(sofar) * static_cast<double>(count) / length - 0.5, 0.0,
              static_cast<double>(count - 1));
        const auto below = std::min<vtkIdType>(static_cast<vtkIdType>(where), count - 1);
        const auto above = std::min<vtkIdType>(below + 1, count - 1);
        const double expected =
          values[below] + (where - static_cast<double>(below)) * (values[above] - values[below]);

        const vtkIdType base = result.Base(point) - total;
        const double weight = result.Weight(point);
        const bool inside = base >= 0 && base < count && weight >= 0.0 && weight < 1.0 &&
          (weight == 0.0 || base + 1 < count);
        const double found = !inside ? -1.0
          : weight > 0.0             ? (1.0 - weight) * values[base] + weight * values[base + 1]
                                     : values[base];
        const double along = static_cast<double>(base) + weight;
        wrong += !(std::abs(found - expected) < 1e-5) || along < previous;
        previous = along;
        ++point;
        if (sofar.size() > 200) // enough of the long lines
        {
          point += static_cast<vtkIdType>(lines[line].size() - sofar.size());
          break;
        }
      }
      total += count;
    }
    checks.Near("wrong weights of " + std::to_string(wanted) + " segments", wrong, 0, 0);
    checks.True("the total is known",
      filter->GetTotalNumberOfSegments() == total &&
        filter->GetPolyDataOutput()
            ->GetFieldData()
            ->GetArray("TotalNumberOfSegments")
            ->GetTuple1(0) == total);
    checks.True("about as many as wanted",
      std::abs(static_cast<double>(total - wanted)) <= static_cast<double>(lines.size()));
  }
}

//------------------------------------------------------------------------------
// Without a number: about 20000 segments, none shorter than 1/128 of the diagonal of the lines.
void TestUsualLength(Checks& checks)
{
  const auto countSegments = [](vtkDataObject* data)
  {
    vtkNew<vtkTrajectorySegments> filter;
    filter->SetInputDataObject(data);
    filter->Update();
    return filter->GetTotalNumberOfSegments();
  };
  const auto few = MakeTrajectories({
    { { 0, 0, 0 }, { 3, 4, 0 } },
    { { 900, 900, 900 }, { 900, 900, 900 } },
    { { MissingValue, 0, 0 }, { -900, 0, 0 } },
  });
  few->GetPoints()->InsertNextPoint(-900.0, 0.0, 0.0);
  checks.Near("a few lines; those without length do not count", countSegments(few), 130, 0);

  std::vector<Trajectory> lines;
  for (int i = 0; i < 1000; ++i)
  {
    lines.push_back({ { 0, 0.1 * i, 0 }, { 100, 0.1 * i, 0 } });
  }
  const auto many = MakeTrajectories(lines);
  checks.Near("many lines", countSegments(many), 20000, 0);

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeTrajectories({ { { 0, 0, 0 }, { 32, 0, 0 } } }));
  blocks->SetBlock(1, MakeTrajectories({ { { 128, 0, 0 }, { 96, 0, 0 } } }));
  checks.Near("the bounds are those of all leaves", countSegments(blocks), 64, 0);

  checks.Near("a line of one point", countSegments(MakeTrajectories({ { { 1, 2, 3 } } })), 1, 0);
}

//------------------------------------------------------------------------------
// Two lines of 1.5 segments, and three too short to change the sum of the lengths one by one.
void TestOrderOfLines(Checks& checks)
{
  std::vector<Trajectory> lines(2, { { 0, 0, 0 }, { 1, 0, 0 } });
  lines.insert(lines.end(), 3, { { 0, 0, 0 }, { 1.5e-16, 0, 0 } });
  const auto countSegments = [&]()
  {
    vtkNew<vtkTrajectorySegments> filter;
    filter->SetInputDataObject(MakeTrajectories(lines));
    filter->SetNumberOfSegments(3);
    filter->Update();
    return filter->GetTotalNumberOfSegments();
  };
  const vtkIdType forward = countSegments();
  std::reverse(lines.begin(), lines.end());
  checks.Near("segments in another order of the lines", countSegments(), forward, 0);
}

//------------------------------------------------------------------------------
void TestSpecialCells(Checks& checks)
{
  const auto data = MakeTrajectories({
    { { 0, 0, 0 }, { 1, 0, 0 }, { 4, 0, 0 } },              // 0 to 2
    { { 5, 5, 5 } },                                        // 3
    { { 6, 6, 6 }, { 6, 6, 6 } },                           // 4, 5
    { { 0, 0, 0 }, { MissingValue, 0, 0 }, { 100, 0, 0 } }, // 6 to 8
    { { 0, 1, 0 }, { 2, 1, 0 } },                           // 9, 10
  });
  for (int i = 0; i < 3; ++i)
  {
    data->GetPoints()->InsertNextPoint(i, i, i); // 11 to 13
  }
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 11, 12 });
  vertices->InsertNextCell({ 0 }); // shared with a line
  data->SetVerts(vertices);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 3, 4, 5 });
  data->SetPolys(polygons);
  data->GetLines()->InsertNextCell(0);
  data->GetLines()->InsertNextCell({ 13, 9, 13 }); // 15, 16 are copies

  vtkNew<vtkTrajectorySegments> filter;
  filter->SetInputData(data);
  filter->SetSegmentLength(1.0);
  filter->Update();
  const Result result(filter->GetPolyDataOutput());
  // Cells: two of vertices, the lines, the polygon.
  const std::vector<vtkIdType> counts = { 2, 1, 4, 1, 1, 1, 2, 0 };
  vtkIdType total = 0;
  for (std::size_t cell = 0; cell < counts.size(); ++cell)
  {
    const auto id = static_cast<vtkIdType>(cell);
    checks.Near("segments of cell " + std::to_string(cell), result.Count(id), counts[cell], 0);
    checks.Near("first segment of cell " + std::to_string(cell), result.First(id), total, 0);
    total += counts[cell];
  }
  checks.True("surfaces have no segments", result.Count(9) == 0 && result.First(9) == -1);
  const std::vector<vtkIdType> bases = { 3, 3, 6, 7, 8, 8, 9, 9, 9, 10, 11, 0, 1 };
  for (std::size_t i = 0; i < bases.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    checks.Near("base of point " + std::to_string(i), result.Base(id), bases[i], 0);
    checks.Near("weight of point " + std::to_string(i), result.Weight(id), i == 1 ? 0.5 : 0.0, 0);
  }
  vtkPolyData* output = filter->GetPolyDataOutput();
  checks.Near("points with copies", output->GetNumberOfPoints(), 17, 0);
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  output->GetVerts()->GetCellAtId(1, size, ids);
  checks.True("a vertex on a line is a segment of its own",
    ids[0] == 16 && result.Base(16) == 2 && result.Weight(16) == 0.0);
  checks.Near(
    "all segments", filter->GetTotalNumberOfSegments(), result.First(8) + result.Count(8), 0);
}

//------------------------------------------------------------------------------
// One target for all leaves, ids of each; a leaf of another class passes.
void TestComposite(Checks& checks)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkImageData> image;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeTrajectories({ { { 0, 0, 0 }, { 3, 0, 0 } }, { { 0, 0, 0 } } }));
  blocks->SetBlock(1, empty);
  blocks->SetBlock(2, image);
  blocks->SetBlock(4, MakeTrajectories({ { { 0, 0, 0 }, { 5, 0, 0 } } }));
  vtkNew<vtkTrajectorySegments> filter;
  filter->SetInputDataObject(blocks);
  filter->SetNumberOfSegments(16);
  filter->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  const auto getLeaf = [&](unsigned int block)
  { return vtkPolyData::SafeDownCast(output->GetBlock(block)); };
  const auto getTotal = [&](unsigned int block)
  { return getLeaf(block)->GetFieldData()->GetArray("TotalNumberOfSegments")->GetTuple1(0); };
  const Result first(getLeaf(0));
  const Result last(getLeaf(4));
  checks.True(
    "segments have one length", first.Count(0) == 6 && first.Count(1) == 1 && last.Count(0) == 10);
  checks.True("segments are numbered from 0 in each leaf",
    first.First(0) == 0 && first.First(1) == 6 && last.First(0) == 0 && last.Base(1) == 9);
  checks.True("totals of each leaf, and of all",
    getTotal(0) == 7 && getTotal(1) == 0 && getTotal(4) == 10 &&
      filter->GetTotalNumberOfSegments() == 17);
  checks.True("other leaves pass", vtkImageData::SafeDownCast(output->GetBlock(2)) != nullptr);
  checks.True("the input is as before",
    !vtkPolyData::SafeDownCast(blocks->GetBlock(0))->GetPointData()->HasArray("SegmentBase"));
  const std::vector<double> progress = GetProgress(filter, false);
  checks.True("progress does not go back",
    progress.back() == 1.0 && std::is_sorted(progress.begin(), progress.end()));

  // Each leaf could be numbered, but not both.
  filter->SetSegmentLength(5.0 / 2e9);
  checks.True("too many segments of all leaves",
    Contains(GetUpdateErrors(filter), "would be 3.2e+09, but at most 2147483647 are possible."));
}

//------------------------------------------------------------------------------
void TestLimits(Checks& checks)
{
  // Two segments meet beyond 2^24 and are told apart.
  vtkNew<vtkTrajectorySegments> filter;
  filter->SetInputData(MakeTrajectories({ { { 0, 0, 0 }, { 1e8, 0, 0 } },
    { { 0, 0, 0 }, { 1.25, 0, 0 }, { 1.75, 0, 0 }, { 2, 0, 0 } } }));
  filter->SetSegmentLength(1.0);
  filter->Update();
  const Result result(filter->GetPolyDataOutput());
  checks.True("bases are exact",
    result.Base(1) == 99999999 && result.Base(3) == 100000000 && result.Base(4) == 100000001 &&
      result.Base(5) == 100000001);
  checks.True("weights are exact",
    result.Weight(1) == 0.0 && result.Weight(3) == 0.75 && result.Weight(4) == 0.0);

  filter->SetSegmentLength(1e-3);
  const std::string message = GetUpdateErrors(filter);
  checks.True("too many segments: " + message,
    Contains(message,
      "Segments of length 0.001 would be 1e+11, but at most 2147483647 are possible. Set a greater "
      "SegmentLength.") &&
      filter->GetTotalNumberOfSegments() == 0);
  filter->SetSegmentLength(1e-300);
  checks.True("far too many segments", Contains(GetUpdateErrors(filter), "are possible"));
  filter->SetSegmentLength(1.0);

  const auto broken = MakeTrajectories({ { { 0, 0, 0 }, { 1, 0, 0 } } });
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ -1 });
  broken->SetVerts(vertices);
  filter->SetInputData(broken);
  checks.True("a point that does not exist",
    Contains(GetUpdateErrors(filter),
      "Vertex cell 0 uses the point -1, but the input has the points 0 to 1."));

  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  checks.True("an empty input is no error",
    GetUpdateErrors(filter).empty() && filter->GetTotalNumberOfSegments() == 0);
}

//------------------------------------------------------------------------------
void TestPipeline(Checks& checks)
{
  std::mt19937 random(9);
  std::vector<Trajectory> lines;
  for (int line = 0; line < 3000; ++line)
  {
    lines.push_back(MakeRandomWalk(line % 100, random));
  }
  lines.push_back(Trajectory(1000001));
  for (std::size_t i = 0; i < lines.back().size(); ++i)
  {
    lines.back()[i] = { 0.1 * static_cast<double>(i), 0.0, 0.0 };
  }
  vtkNew<vtkTrajectorySegments> filter;
  filter->SetInputData(MakeTrajectories(lines));
  filter->SetSegmentLength(1e5);
  filter->Update();
  const Result result(filter->GetPolyDataOutput());
  checks.Near("a long line is as long as its parts", result.Count(3000), 1, 0);
  filter->SetSegmentLength(1e-2);
  filter->Update();
  checks.Near("a long line is as long as its parts", result.Count(3000), 10000000, 0);

  filter->SetSegmentLength(0.0);
  UpdateWithThreads(filter, 1);
  vtkNew<vtkPolyData> ofOneThread;
  ofOneThread->ShallowCopy(filter->GetPolyDataOutput());
  for (const int threads : { 2, 3 })
  {
    UpdateWithThreads(filter, threads);
    checks.True("same bits",
      HaveSameBits(filter->GetPolyDataOutput()->GetPointData(), ofOneThread->GetPointData()) &&
        HaveSameBits(filter->GetPolyDataOutput()->GetCellData(), ofOneThread->GetCellData()));
  }
  const std::vector<double> progress = GetProgress(filter, false);
  checks.True("progress goes from 0 to 1",
    progress.size() > 5 && progress.front() == 0.0 && progress.back() == 1.0 &&
      std::is_sorted(progress.begin(), progress.end()));
  const std::vector<double> aborted = GetProgress(filter, true);
  checks.True("an abort stops the work, and leaves nothing half done",
    aborted.size() <= 2 && filter->GetPolyDataOutput()->GetNumberOfPoints() == 0);
}
}

//------------------------------------------------------------------------------
int TestTrajectorySegments(int, char*[])
{
  Checks checks;
  TestWeights(checks);
  TestUsualLength(checks);
  TestOrderOfLines(checks);
  TestSpecialCells(checks);
  TestComposite(checks);
  TestLimits(checks);
  TestPipeline(checks);
  return checks.Result();
}
