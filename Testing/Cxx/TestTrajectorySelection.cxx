// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkTrajectorySelection: which lines stay, by point and cell arrays, values and percentiles; that
 * their points and all data stay with them in order, and with everything that is not a line;
 * trajectories of several lines, missing values, odd lines, composite data, threads, progress,
 * messages.
 */

#include "ImportanceTesting.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTrajectorySelection.h"

#include <algorithm>
#include <random>
#include <set>

namespace
{
using Cells = std::vector<std::vector<vtkIdType>>;
using Values = std::vector<double>;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTrajectorySelection> MakeFilter(
  vtkDataObject* data, const char* arrayName, double minimum, double maximum = Infinity)
{
  auto filter = vtkSmartPointer<vtkTrajectorySelection>::New();
  filter->SetInputData(data);
  filter->SetArrayName(arrayName);
  filter->SetMinimum(minimum);
  filter->SetMaximum(maximum);
  return filter;
}

//------------------------------------------------------------------------------
void AddText(vtkDataSetAttributes* attributes, vtkIdType count)
{
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  for (vtkIdType i = 0; i < count; ++i)
  {
    text->InsertNextValue(std::to_string(i));
  }
  attributes->AddArray(text);
}

//------------------------------------------------------------------------------
// Vertices, lines (shared and closed ones, one of a single point, one of none), a polygon, a strip,
// and the point 14 that nothing uses.
vtkSmartPointer<vtkPolyData> MakeMixedData()
{
  auto data = MakePoints(15);
  data->SetVerts(MakeCells({ { 13 }, { 2 } }));
  data->SetLines(MakeCells({ { 0, 1, 2 }, { 2, 3, 4, 2 }, { 5 }, {}, { 1, 6, 7 } }));
  data->SetPolys(MakeCells({ { 7, 8, 9 } }));
  data->SetStrips(MakeCells({ { 9, 10, 11, 12 } }));
  Values x(15);
  for (int i = 0; i < 15; ++i)
  {
    x[i] = i;
  }
  data->GetPointData()->AddArray(MakeArray("x", x));
  data->GetPointData()->SetActiveScalars("x");
  data->GetPointData()->SetGlobalIds(MakeArray("id", x));
  data->GetCellData()->AddArray(MakeArray("c", { 0, 1, 2, 3, 4, 5, 6, 7, 8 }));
  AddText(data->GetPointData(), 15);
  AddText(data->GetCellData(), 9);
  return data;
}

//------------------------------------------------------------------------------
// The output consists of exactly these lines, points and cells of the mixed data.
void CheckOutput(Checks& checks, const std::string& what, vtkTrajectorySelection* filter,
  const Cells& lines, const Values& points, const Values& cells)
{
  CheckMessage(checks, filter, "");
  auto* output = filter->GetPolyDataOutput();
  checks.True(what + ": numbers of lines",
    filter->GetNumberOfLines() == 5 &&
      filter->GetNumberOfSelectedLines() == static_cast<vtkIdType>(lines.size()));
  checks.True(what + ": lines", GetPointIds(output->GetLines()) == lines);
  CheckValues(checks, what + ": points", GetValues(output->GetPoints()->GetData()), points, 0.0);
  CheckValues(
    checks, what + ": point data", GetValues(output->GetPointData()->GetScalars()), points, 0.0);
  CheckValues(
    checks, what + ": global ids", GetValues(output->GetPointData()->GetGlobalIds()), points, 0.0);
  CheckValues(
    checks, what + ": cell data", GetValues(output->GetCellData()->GetArray("c")), cells, 0.0);
  const auto checkText = [&](vtkDataSetAttributes* attributes, const Values& ids)
  {
    auto* text = vtkStringArray::SafeDownCast(attributes->GetAbstractArray("text"));
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      checks.True(what + ": text",
        text->GetValue(static_cast<vtkIdType>(i)) == std::to_string(static_cast<int>(ids[i])));
    }
  };
  checkText(output->GetPointData(), points);
  checkText(output->GetCellData(), cells);
  checks.True(what + ": other cells",
    output->GetNumberOfVerts() == 2 && output->GetNumberOfPolys() == 1 &&
      output->GetNumberOfStrips() == 1);
  // The x coordinate of a point was its id.
  const auto first = [&](vtkCellArray* array)
  { return output->GetPoint(GetPointIds(array).back().front())[0]; };
  checks.True(what + ": points of other cells",
    first(output->GetVerts()) == 2.0 && first(output->GetPolys()) == 7.0 &&
      first(output->GetStrips()) == 9.0);
}

//------------------------------------------------------------------------------
void TestMixedData(Checks& checks)
{
  const auto data = MakeMixedData();
  const Cells allLines = GetPointIds(data->GetLines());
  // The line of no points has no value in the point array, but one in the cell array.
  CheckOutput(checks, "points 3 and on", MakeFilter(data, "x", 3),
    { { 1, 2, 3, 1 }, { 4 }, { 0, 5, 6 } }, { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 },
    { 0, 1, 3, 4, 6, 7, 8 });
  CheckOutput(checks, "both ends belong to it", MakeFilter(data, "x", 5, 6), { { 2 }, { 0, 3, 4 } },
    { 1, 2, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 }, { 0, 1, 4, 6, 7, 8 });
  CheckOutput(checks, "cells", MakeFilter(data, "c", 4, 5), { { 1 }, {} },
    { 2, 5, 7, 8, 9, 10, 11, 12, 13, 14 }, { 0, 1, 4, 5, 7, 8 });
  CheckOutput(checks, "nothing", MakeFilter(data, "x", 100), {}, { 2, 7, 8, 9, 10, 11, 12, 13, 14 },
    { 0, 1, 7, 8 });
  CheckOutput(checks, "the wrong way round", MakeFilter(data, "x", 8, 2), {},
    { 2, 7, 8, 9, 10, 11, 12, 13, 14 }, { 0, 1, 7, 8 });
  const auto allPoints = MakeFilter(data, "x", 2);
  allPoints->AllPointsOn();
  CheckOutput(checks, "all points 2 and on", allPoints, { { 0, 1, 2, 0 }, { 3 } },
    { 2, 3, 4, 5, 7, 8, 9, 10, 11, 12, 13, 14 }, { 0, 1, 3, 4, 7, 8 });

  const auto everything = MakeFilter(data, "c", 2, 6);
  CheckOutput(checks, "everything", everything, allLines,
    GetValues(data->GetPointData()->GetScalars()), GetValues(data->GetCellData()->GetArray("c")));
  auto* output = everything->GetPolyDataOutput();
  checks.True("by reference",
    output->GetPoints() == data->GetPoints() && output->GetLines() == data->GetLines() &&
      output->GetPointData()->GetScalars() == data->GetPointData()->GetScalars());

  checks.True("the input stays as it is",
    data->GetNumberOfPoints() == 15 && GetPointIds(data->GetLines()) == allLines &&
      data->GetPointData()->GetArray("x")->GetNumberOfTuples() == 15);
}

//------------------------------------------------------------------------------
void TestMissingValues(Checks& checks)
{
  const auto data = MakePoints(8);
  data->SetLines(MakeCells({ { 0, 1 }, { 2, 3 }, { 4, 5 }, { 6, 7 } }));
  data->GetPointData()->AddArray(
    MakeArray("a", { 1, NotANumber, NotANumber, NotANumber, Infinity, 1, -Infinity, 2 }));
  data->GetCellData()->AddArray(MakeArray("c", { NotANumber, 1, Infinity, -Infinity }));
  const auto check =
    [&](const char* name, double minimum, double maximum, bool all, vtkIdType expected)
  {
    const auto filter = MakeFilter(data, name, minimum, maximum);
    filter->SetAllPoints(all);
    CheckMessage(checks, filter, "");
    checks.True(std::string(name) + ": " + std::to_string(filter->GetNumberOfSelectedLines()) +
        " lines instead of " + std::to_string(expected),
      filter->GetNumberOfSelectedLines() == expected);
  };
  check("a", -Infinity, Infinity, false, 3);
  check("a", -Infinity, Infinity, true, 2);
  check("a", 1, 1, false, 2);
  check("a", -10, 10, true, 0);
  check("c", -Infinity, Infinity, false, 3);
  check("c", 0, Infinity, true, 2);
  check("c", 0, 10, false, 1);
}

//------------------------------------------------------------------------------
// Trajectories in parts, after a vertex with the id of the first one.
void TestTrajectoriesInParts(Checks& checks)
{
  const auto data = MakePoints(11);
  data->SetVerts(MakeCells({ { 10 } }));
  data->SetLines(MakeCells({ { 0, 1 }, {}, { 2, 3 }, { 4, 5 }, { 6, 7 }, { 8, 9 } }));
  data->GetPointData()->AddArray(MakeArray("a", { 1, 1, 1, 5, 1, 1, 5, 5, 1, 1, 9 }));
  data->GetCellData()->AddArray(MakeArray("c", { 9, 1, 5, 5, 1, 5, 1 }));
  const auto check = [&](const char* name, double minimum, bool all, const Values& expected)
  {
    const auto filter = MakeFilter(data, name, minimum, 5);
    filter->SetAllPoints(all);
    CheckMessage(checks, filter, "");
    const Values points = GetValues(filter->GetPolyDataOutput()->GetPoints()->GetData());
    CheckValues(checks, std::string("points of parts by ") + name, points, expected, 0.0);
  };
  // The last two lines have one id, the fourth the same as the first three but not next to them.
  data->GetCellData()->AddArray(MakeArray("TrajectoryId", { 7, 7, 7, 7, 3, 7, 7 }));
  check("a", 5, false, { 0, 1, 2, 3, 6, 7, 8, 9, 10 });
  check("a", 5, true, { 10 });
  check("a", 1, true, { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10 });
  check("c", 5, false, { 0, 1, 2, 3, 6, 7, 8, 9, 10 });
  check("c", 5, true, { 10 });

  // Without ids, or where some are missing, each line is for itself.
  for (const Values& ids : { Values{ 7, 7 }, Values{} })
  {
    data->GetCellData()->AddArray(MakeArray("TrajectoryId", ids));
    const auto filter = MakeFilter(data, "a", 5, 5);
    filter->Update();
    checks.True("single lines", filter->GetNumberOfSelectedLines() == 2);
  }
}

//------------------------------------------------------------------------------
void TestCellLinks(Checks& checks)
{
  const auto data = MakePoints(7);
  data->SetLines(MakeCells({ { 0, 1 }, { 2, 3 }, { 4, 5, 6 } }));
  data->GetCellData()->AddArray(MakeArray("c", { 1, 0, 1 }));
  data->BuildLinks();
  const auto filter = MakeFilter(data, "c", 1);
  filter->Update();
  vtkNew<vtkIdList> cells;
  filter->GetPolyDataOutput()->GetPointCells(4, cells);
  checks.True("cells of a point", cells->GetNumberOfIds() == 1 && cells->GetId(0) == 1);
}

//------------------------------------------------------------------------------
void TestPercentiles(Checks& checks)
{
  const auto data = MakePoints(5);
  data->SetLines(MakeCells({ { 0 }, { 1 }, { 2 }, { 3 }, { 4 } }));
  data->GetPointData()->AddArray(MakeArray("a", { 3, 1, NotANumber, 2, 10 }));
  const auto filter = MakeFilter(data, "a", 50, 90);
  filter->MinimumIsPercentileOn();
  CheckMessage(checks, filter, "");
  CheckValues(checks, "from the median on",
    GetValues(filter->GetPolyDataOutput()->GetPoints()->GetData()), { 0, 4 }, 0.0);
  filter->MaximumIsPercentileOn();
  CheckMessage(checks, filter, "");
  CheckValues(checks, "effective range",
    { filter->GetEffectiveMinimum(), filter->GetEffectiveMaximum() }, { 2.5, 7.9 }, 1e-14);
  checks.True("one line between", filter->GetNumberOfSelectedLines() == 1);

  data->GetPointData()->AddArray(MakeArray("b", Values(5, NotANumber)));
  filter->SetArrayName("b");
  CheckMessage(checks, filter, "There is no finite value to take percentiles of in the array 'b'");
  checks.True("none", filter->GetNumberOfSelectedLines() == 0 && filter->GetNumberOfLines() == 5);
}

//------------------------------------------------------------------------------
// Random lines over shared points, of which the data says where they come from.
vtkSmartPointer<vtkPolyData> MakeRandomLines(vtkIdType pointCount, int lineCount)
{
  std::mt19937 generator(11);
  std::uniform_int_distribution<vtkIdType> point(0, pointCount - 1);
  std::uniform_int_distribution<int> length(1, 12);
  Cells lines(lineCount);
  for (auto& line : lines)
  {
    const vtkIdType first = point(generator);
    for (vtkIdType i = length(generator); i > 0; --i)
    {
      line.push_back(i % 5 == 0 ? point(generator) : (first + i) % pointCount);
    }
  }
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Values a(pointCount);
  std::generate(a.begin(), a.end(), [&] { return unit(generator); });
  auto data = MakePoints(pointCount);
  data->SetLines(MakeCells(lines));
  data->GetPointData()->AddArray(MakeArray("a", a));
  Values ids(lineCount);
  for (int i = 0; i < lineCount; ++i)
  {
    ids[i] = i;
  }
  data->GetCellData()->AddArray(MakeArray("line", ids));
  return data;
}

//------------------------------------------------------------------------------
void TestRandomLines(Checks& checks)
{
  const auto data = MakeRandomLines(40000, 30000);
  const Values a = GetValues(data->GetPointData()->GetArray("a"));
  const Cells before = GetPointIds(data->GetLines());
  Values expectedLines;
  std::set<vtkIdType> kept;
  std::set<vtkIdType> discarded;
  for (std::size_t line = 0; line < before.size(); ++line)
  {
    const bool isKept = std::any_of(
      before[line].begin(), before[line].end(), [&](vtkIdType point) { return a[point] >= 0.95; });
    (isKept ? kept : discarded).insert(before[line].begin(), before[line].end());
    if (isKept)
    {
      expectedLines.push_back(static_cast<double>(line));
    }
  }
  Values expectedPoints;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    if (kept.count(point) > 0 || discarded.count(point) == 0)
    {
      expectedPoints.push_back(static_cast<double>(point));
    }
  }

  ForThreadCounts(
    [&](int threads)
    {
      const std::string what = std::to_string(threads) + " threads";
      const auto filter = MakeFilter(data, "a", 0.95);
      CheckMessage(checks, filter, "");
      auto* output = filter->GetPolyDataOutput();
      const Values points = GetValues(output->GetPoints()->GetData());
      checks.True(what + ": points", points == expectedPoints);
      checks.True(
        what + ": lines", GetValues(output->GetCellData()->GetArray("line")) == expectedLines);
      const Cells after = GetPointIds(output->GetLines());
      for (std::size_t line = 0; line < std::min(after.size(), expectedLines.size()); ++line)
      {
        const auto& old = before[static_cast<std::size_t>(expectedLines[line])];
        checks.True(what + ": points of a line",
          std::equal(after[line].begin(), after[line].end(), old.begin(), old.end(),
            [&](vtkIdType found, vtkIdType expected)
            { return points[found] == static_cast<double>(expected); }));
      }
      const Values values = GetValues(output->GetPointData()->GetArray("a"));
      checks.True(what + ": point data",
        std::equal(values.begin(), values.end(), expectedPoints.begin(), expectedPoints.end(),
          [&](double value, double point) { return value == a[static_cast<std::size_t>(point)]; }));
    });
}

//------------------------------------------------------------------------------
void TestComposite(Checks& checks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int block = 0; block < 3; ++block)
  {
    const auto data = MakePoints(4);
    data->SetLines(MakeCells({ { 0, 1 }, { 2, 3 } }));
    if (block < 2)
    {
      data->GetCellData()->AddArray(MakeArray("c", { 2.0 * block, 2.0 * block + 1.0 }));
    }
    blocks->SetBlock(block, data);
  }
  blocks->SetBlock(4, vtkSmartPointer<vtkImageData>::New());
  const auto filter = MakeFilter(blocks, "c", 33);
  filter->MinimumIsPercentileOn();
  CheckMessage(checks, filter, "");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  const auto countLines = [output](unsigned int block)
  { return vtkPolyData::SafeDownCast(output->GetBlock(block))->GetNumberOfLines(); };
  checks.Near("percentile of all leaves", filter->GetEffectiveMinimum(), 0.99, 1e-14);
  checks.True("lines of all leaves",
    filter->GetNumberOfLines() == 6 && filter->GetNumberOfSelectedLines() == 3);
  checks.True("lines of each leaf, none of that without the array",
    countLines(0) == 1 && countLines(1) == 2 && countLines(2) == 0);
  checks.True(
    "others pass", !output->GetBlock(3) && vtkImageData::SafeDownCast(output->GetBlock(4)));
}

//------------------------------------------------------------------------------
// Arrays that cannot be copied stay behind, with one warning for all leaves.
void TestShortArrays(Checks& checks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int block = 0; block < 2; ++block)
  {
    const auto data = MakeMixedData();
    data->GetPointData()->AddArray(MakeArray("short", { 1, 2, 3 }));
    data->GetPointData()->AddArray(MakeArray("long", Values(20, 1.0)));
    data->GetPointData()->SetActiveScalars("short");
    data->GetCellData()->AddArray(MakeArray("none", {}));
    blocks->SetBlock(block, data);
  }
  const auto filter = MakeFilter(blocks, "x", 3);
  const std::string messages = CollectMessages(filter, [&filter] { filter->Update(); });
  const std::string expected =
    "These arrays do not have a tuple for each point or cell, and are left out: 'none', 'short'.";
  const std::size_t position = messages.find(expected);
  checks.True("one warning in " + messages,
    position != std::string::npos && messages.find("arrays", position + 10) == std::string::npos);
  for (unsigned int block = 0; block < 2; ++block)
  {
    auto* leaf = vtkPolyData::SafeDownCast(
      vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput())->GetBlock(block));
    checks.True("without the short arrays",
      !leaf->GetPointData()->HasArray("short") && !leaf->GetCellData()->HasArray("none") &&
        !leaf->GetPointData()->GetScalars());
    CheckValues(checks, "the others", GetValues(leaf->GetPointData()->GetArray("x")),
      { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 }, 0.0);
    CheckValues(checks, "as long as the points", GetValues(leaf->GetPointData()->GetArray("long")),
      Values(14, 1.0), 0.0);
    checks.True("cell data", leaf->GetCellData()->GetArray("c")->GetNumberOfTuples() == 7);
  }
}

//------------------------------------------------------------------------------
void TestMessages(Checks& checks)
{
  const auto data = MakeMixedData();
  data->GetCellData()->AddArray(MakeArray("short", { 1 }));
  const auto check = [&](vtkTrajectorySelection* filter, const std::string& message)
  {
    CheckMessage(checks, filter, message);
    checks.True("nothing after an error", filter->GetPolyDataOutput()->GetNumberOfPoints() == 0);
  };
  check(MakeFilter(data, "y", 0),
    "There is no array named 'y'. The input has the arrays (association, components): "
    "c (cells, 1), id (points, 1), short (cells, 1), text (cells, 1), text (points, 1), "
    "x (points, 1).");
  check(MakeFilter(data, nullptr, 0), "There is no array named ''");
  check(MakeFilter(data, "text", 0), "The array 'text' holds strings instead of numbers");
  check(MakeFilter(data, "short", 0), "The array 'short' has 1 tuples for 9 cells");
  check(MakeFilter(data, "x", NotANumber), "A bound for the array 'x' is not a number");
  const auto percentile = MakeFilter(data, "x", -1);
  percentile->MinimumIsPercentileOn();
  check(percentile, "percentile -1");

  for (const vtkIdType badId : { -1, 15 })
  {
    const auto bad = MakeMixedData();
    bad->SetLines(MakeCells({ { 0, 1 }, { 2, badId }, { 3 }, { 4 }, { 5 } }));
    check(MakeFilter(bad, "x", 2), "Line 1 uses the point " + std::to_string(badId));
    check(MakeFilter(bad, "c", 0), "Line 1 uses the point " + std::to_string(badId));
  }

  const auto empty = MakeFilter(vtkSmartPointer<vtkPolyData>::New(), "x", 0);
  check(empty, "");
  checks.True("no lines", empty->GetNumberOfLines() == 0);
}

//------------------------------------------------------------------------------
void TestProgress(Checks& checks)
{
  // Many cells of two kinds.
  const auto data = MakeRandomLines(100000, 50000);
  data->SetPolys(data->GetLines());
  data->GetCellData()->Initialize();
  const auto filter = MakeFilter(data, "a", 0.95);
  const int all = CountProgress(filter, 2.0);
  checks.True("progress is steady", all > 40);
  for (const double abortAt : { 0.05, 0.15, 0.22, 0.32, 0.38, 0.5, 0.76, 0.79, 0.95 })
  {
    checks.True("an abort at " + std::to_string(abortAt), CountProgress(filter, abortAt) < all);
    checks.True("nothing after an abort", filter->GetPolyDataOutput()->GetNumberOfPoints() == 0);
  }
}
}

//------------------------------------------------------------------------------
int TestTrajectorySelection(int, char*[])
{
  Checks checks;
  TestMixedData(checks);
  TestMissingValues(checks);
  TestTrajectoriesInParts(checks);
  TestCellLinks(checks);
  TestPercentiles(checks);
  TestRandomLines(checks);
  TestComposite(checks);
  TestShortArrays(checks);
  TestMessages(checks);
  TestProgress(checks);
  return checks.Result();
}
