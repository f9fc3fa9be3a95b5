// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkTrajectoryAttributes as a filter: which arrays it takes and makes, shared points, other cells,
 * trajectories of several lines, composite data, every error's message, progress, abort, and the
 * same bits with any number of threads.
 */

#include "ReferenceTesting.h"
#include "TrajectoryTesting.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTrajectoryAttributes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
using Attributes = vtkTrajectoryAttributes;

//------------------------------------------------------------------------------
std::string GetUnit(vtkDataArray* array)
{
  const char* unit = array->GetInformation()->Get(vtkDataArray::UNITS_LABEL());
  return unit ? unit : "";
}

//------------------------------------------------------------------------------
void TestArrays(Checks& checks)
{
  const auto data = MakeTrajectories({ { { 0, 0, 0 }, { 3, 4, 0 } } });
  AddPointArray(data, "AIR_PRESSURE", { 900, 800 });
  AddPointArray(data, "p", { 1, 2, 3 })->SetNumberOfComponents(3); // not usable, passed over
  AddPointArray(data, "level", { 700, 600.5 })
    ->GetInformation()
    ->Set(vtkDataArray::UNITS_LABEL(), "hPa");
  AddPointArray(data, "altitude", { 10, 12 })
    ->GetInformation()
    ->Set(vtkDataArray::UNITS_LABEL(), "m");
  AddPointArray(data, "IntegrationTime", { 5, 3 });
  AddPointArray(data, "seconds", { 0, 5 });
  AddPointArray(data, "SegmentLength", { -1, -1 });

  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(data);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const auto ofPoint = [&](const char* name)
  { return output->GetPointData()->GetArray(name)->GetTuple1(0); };
  const auto ofCell = [&](const char* name)
  { return output->GetCellData()->GetArray(name)->GetTuple1(0); };
  checks.Near("pressure by its name", ofPoint("SegmentPressureDifference"), 100.0, 0.0);
  checks.Near("time by its name", ofPoint("Velocity"), 2.5, 0.0);
  checks.Near("an array is replaced", ofPoint("SegmentLength"), 5.0, 0.0);
  checks.True("the input is as before",
    data->GetPointData()->GetArray("SegmentLength")->GetTuple1(0) == -1.0 &&
      data->GetPointData()->GetNumberOfArrays() == 7);
  checks.True("the geometry is not copied",
    output->GetPoints() == data->GetPoints() && output->GetLines() == data->GetLines());

  filter->SetPressureArray("level");
  filter->SetHeightArray("altitude");
  filter->SetTimeArray("seconds");
  filter->Update();
  checks.Near("chosen pressure", ofCell("TotalPressureDifference"), 99.5, 0.0);
  checks.Near("chosen height", ofPoint("SegmentHeightDifference"), 2.0, 0.0);
  checks.Near("ascent of the coordinates", ofPoint("AngleOfAscent"), 0.0, 0.0);
  checks.Near("chosen time", ofPoint("Velocity"), 1.0, 0.0);
  for (int attribute = 0; attribute < Attributes::GetNumberOfAttributes(); ++attribute)
  {
    const char* name = Attributes::GetAttributeName(attribute);
    const bool ofPoints = Attributes::GetAttributeAssociation(attribute) == vtkDataObject::POINT;
    vtkDataArray* array =
      ofPoints ? output->GetPointData()->GetArray(name) : output->GetCellData()->GetArray(name);
    const std::vector<std::string> units = { "hPa", "hPa", "m", "degree", "", "", "", "degree" };
    checks.True(std::string("type and unit of ") + name,
      vtkFloatArray::SafeDownCast(array) && GetUnit(array) == units[attribute]);
    checks.True("index by name", Attributes::GetAttributeIndex(name) == attribute);
  }

  filter->SetAllAttributeStatuses(Attributes::OFF);
  filter->SetAttributeStatus("Velocity", Attributes::ON);
  filter->Update();
  checks.True("only what is on",
    output->GetPointData()->HasArray("Velocity") &&
      !output->GetPointData()->HasArray("Curvature") &&
      !output->GetCellData()->HasArray("TotalPressureDifference"));
  checks.True("no such attribute",
    !Attributes::GetAttributeName(-1) && !Attributes::GetAttributeName(8) &&
      Attributes::GetAttributeIndex("velocity") == -1 &&
      Attributes::GetAttributeIndex(nullptr) == -1);
  std::ostringstream text;
  filter->Print(text);
  checks.True("statuses are printed", Contains(text.str(), "Velocity: 1"));
}

//------------------------------------------------------------------------------
// A square that ends at its first point, a line that leaves it there, and cells that are not lines.
vtkSmartPointer<vtkPolyData> MakeSharedPoints()
{
  vtkNew<vtkPoints> points;
  for (const TrajectoryPoint& point :
    Trajectory{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 2 }, { 9, 9, 9 } })
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> lines;
  lines->Use32BitStorage();
  lines->InsertNextCell({ 0, 1, 2, 3, 0 });
  lines->InsertNextCell({ 1, 0, 4 });
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 5 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2 });
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(polygons);
  AddPointArray(data, "p", { 10, 11, 12, 13, 14, 15 });
  return data;
}

//------------------------------------------------------------------------------
void TestSharedPoints(Checks& checks)
{
  const auto data = MakeSharedPoints();
  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(data);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const auto expect = [&](const char* name, const std::vector<double>& values)
  {
    vtkDataArray* array = output->GetPointData()->GetArray(name);
    checks.Near(std::string("tuples of ") + name, array->GetNumberOfTuples(), values.size(), 0);
    for (vtkIdType i = 0; i < std::min<vtkIdType>(array->GetNumberOfTuples(), 9); ++i)
    {
      const double found = array->GetTuple1(i);
      checks.True(name + (" of point " + std::to_string(i)) + " is " + std::to_string(found),
        std::isnan(values[i]) ? std::isnan(found) : std::abs(found - values[i]) < 1e-5);
    }
  };
  // Copies: the end of the square, then the first two points of the other line.
  expect("p", { 10, 11, 12, 13, 14, 15, 10, 11, 10 });
  expect("TurningAngle", { 0, 90, 90, 90, 0, MissingValue, 0, 0, 90 });
  expect("SegmentLength", { 1, 1, 1, 1, 2, MissingValue, 1, 1, 2 });
  expect("SegmentPressureDifference", { -1, -1, -1, 3, -4, MissingValue, 3, 1, -4 });
  vtkDataArray* total = output->GetCellData()->GetArray("TotalPressureDifference");
  checks.True("cells that are not lines have no value",
    std::isnan(total->GetTuple1(0)) && total->GetTuple1(1) == 3 && total->GetTuple1(2) == 4 &&
      std::isnan(total->GetTuple1(3)));
  double copy[3];
  output->GetPoint(7, copy);
  checks.True("a copy is in the same place", copy[0] == 1.0 && copy[1] == 0.0);
  checks.True("the input is as before",
    data->GetNumberOfPoints() == 6 && !data->GetPointData()->HasArray("TurningAngle"));

  data->BuildLinks();
  filter->Modified();
  filter->Update();
  vtkNew<vtkIdList> cells;
  output->GetPointCells(output->GetNumberOfPoints() - 1, cells);
  checks.True(
    "links are those of the output", cells->GetNumberOfIds() == 1 && cells->GetId(0) == 2);

  // The same points in another order are not shared.
  vtkNew<vtkCellArray> reversed;
  reversed->InsertNextCell({ 3, 2, 1, 0 });
  data->SetLines(reversed);
  filter->Update();
  checks.True("not shared, not copied", output->GetPoints() == data->GetPoints());
  expect("SegmentPressureDifference", { 1, 1, 1, 1, MissingValue, MissingValue });
}

//------------------------------------------------------------------------------
// Arrays of the input that an attribute replaces, or that are too short, where points are copied.
void TestArraysOfSharedPoints(Checks& checks)
{
  const auto data = MakeSharedPoints();
  AddPointArray(data, "SegmentLength", { 10, 11, 12, 13, 14, 15 });
  AddPointArray(data, "Velocity", { 0, 1, 2, 3, 4, 5 });
  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(data);
  filter->SetPressureArray("SegmentLength");
  filter->SetTimeArray("Velocity");
  filter->SetTimeWindow(1.0);
  filter->Update();
  vtkDataArray* total = filter->GetOutput()->GetCellData()->GetArray("TotalPressureDifference");
  checks.True("pressure and time named after an attribute",
    total->GetTuple1(1) == 1.0 && total->GetTuple1(2) == 1.0);

  AddPointArray(data, "first", { 1 });
  AddPointArray(data, "second", { 1, 2, 3, 4, 5 });
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->Update();
  const std::string warning = observer->GetWarningMessage();
  checks.True("arrays that are too short: " + warning,
    Contains(warning,
      "These arrays do not have a tuple for each point or cell, and are left out: 'first', "
      "'second'.") &&
      warning.find("Warning:") == warning.rfind("Warning:"));
  vtkPointData* pointData = filter->GetOutput()->GetPointData();
  checks.True("only these are left out",
    !pointData->HasArray("first") && !pointData->HasArray("second") && pointData->HasArray("p"));
}

//------------------------------------------------------------------------------
// A gap, or an edge of the map, divides a trajectory into several lines; a vertex comes before.
void TestParts(Checks& checks)
{
  const auto data = MakeTrajectories({ { { 0, 0, 0 }, { 1, 0, 0 } }, { { 5, 0, 0 } }, {},
    { { 6, 0, 0 }, { 7, 0, 0 } }, { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } } });
  AddPointArray(data, "pressure", { 900, 850, 700, MissingValue, 300, 500, 480, 440 });
  AddPointArray(data, "time", { 0, 1, 2, 3, 4, 0, 1, 2 });
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  data->SetVerts(vertices);
  const auto expect = [&](const char* what, double window, const std::vector<double>& values)
  {
    vtkNew<vtkTrajectoryAttributes> filter;
    filter->SetInputData(data);
    filter->SetTimeWindow(window);
    filter->Update();
    vtkDataArray* total = filter->GetOutput()->GetCellData()->GetArray("TotalPressureDifference");
    for (std::size_t line = 0; line < values.size(); ++line)
    {
      const double found = total->GetTuple1(static_cast<vtkIdType>(line + 1));
      checks.True(std::string(what) + " " + std::to_string(line) + ": " + std::to_string(found),
        std::isnan(values[line]) ? std::isnan(found) : found == values[line]);
    }
  };
  expect("without ids, line", 0.0, { 50, 0, MissingValue, 0, 60 });

  vtkNew<vtkDoubleArray> ids;
  ids->SetName("TrajectoryId");
  data->GetCellData()->AddArray(ids);
  for (const double id : { 4, 4, 4, 4, 4, 9 })
  {
    ids->InsertNextValue(id);
  }
  expect("all parts, line", 0.0, { 600, 600, 600, 600, 60 });
  expect("window over parts, line", 2.0, { 400, 400, 400, 400, 60 });
  expect("short window over parts, line", 1.0, { 150, 150, 150, 150, 40 });
}

//------------------------------------------------------------------------------
void TestErrors(Checks& checks)
{
  const auto data = MakeTrajectories({ { { 0, 0, 0 }, { 3, 4, 0 } } });
  AddPointArray(data, "humidity", { 1, 2 });
  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(data);
  const auto expect = [&](const std::string& message)
  {
    const std::string found = GetUpdateErrors(filter);
    checks.True("'" + message + "' in '" + found + "'", Contains(found, message));
    checks.True("no output after " + message, filter->GetOutput()->GetNumberOfPoints() == 0);
  };
  checks.True("no error", GetUpdateErrors(filter).empty());
  filter->SetAttributeStatus(Attributes::TOTAL_PRESSURE_DIFFERENCE, Attributes::ON);
  expect("TotalPressureDifference needs the pressure of each point, and no array has a name that "
         "tells it. Choose one with SetPressureArray(), or switch the attribute off. The input has "
         "the arrays (association, components): humidity (points, 1).");
  filter->SetPressureArray("humidity");
  filter->SetTimeWindow(2.0);
  expect("A TimeWindow needs the time of each point, and no array has a name that tells it. Choose "
         "one with SetTimeArray(), or set TimeWindow to 0.");
  filter->SetTimeWindow(0.0);
  filter->SetAttributeStatus(Attributes::VELOCITY, Attributes::ON);
  expect("Velocity needs the time of each point");
  filter->SetAttributeStatus(Attributes::VELOCITY, Attributes::AUTOMATIC);
  filter->SetHeightArray("altitude");
  expect("No point array named 'altitude' has one component and a value for each point, as the "
         "height needs. The input has the arrays");
  AddPointArray(data, "altitude", { 1 });
  expect("No point array named 'altitude' has one component and a value for each point");
  filter->SetHeightArray(nullptr);
  checks.True("no error any more", GetUpdateErrors(filter).empty());

  data->GetLines()->InsertNextCell({ 1, 2 });
  expect("Line 1 uses the point 2, but the input has the points 0 to 1.");

  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->SetHeightArray("altitude");
  filter->SetTimeWindow(2.0);
  filter->SetAllAttributeStatuses(Attributes::ON);
  checks.True("an empty input is no error", GetUpdateErrors(filter).empty());

  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetAttributeStatus("Speed", Attributes::ON);
  filter->SetAttributeStatus(99, Attributes::ON);
  checks.True("wrong attributes are named",
    Contains(observer->GetErrorMessage(),
      "There is no attribute named 'Speed'; they are TotalPressureDifference, SegmentPressure") &&
      Contains(observer->GetErrorMessage(), "There is no attribute number 99; they are 0 to 7."));
}

//------------------------------------------------------------------------------
void TestPipeline(Checks& checks)
{
  std::mt19937 random(7);
  const int size = 400000;
  const auto data =
    MakeTrajectories({ MakeRandomWalk(size, random), MakeRandomWalk(size, random) });
  std::vector<double> pressure(2 * size);
  std::uniform_real_distribution<double> uniform(0.0, 1000.0);
  std::generate(pressure.begin(), pressure.end(), [&]() { return uniform(random); });
  AddPointArray(data, "pressure", pressure);
  AddPointArray(data, "time", pressure);

  vtkNew<vtkTrajectoryAttributes> filter;
  filter->SetInputData(data);
  UpdateWithThreads(filter, 1);
  vtkNew<vtkPolyData> ofOneThread;
  ofOneThread->ShallowCopy(filter->GetOutput());
  for (const int threads : { 2, 3 })
  {
    UpdateWithThreads(filter, threads);
    checks.True("same bits",
      HaveSameBits(filter->GetOutput()->GetPointData(), ofOneThread->GetPointData()) &&
        HaveSameBits(filter->GetOutput()->GetCellData(), ofOneThread->GetCellData()));
  }

  const std::vector<double> progress = GetProgress(filter, false);
  checks.True("progress goes from 0 to 1 in small steps",
    progress.size() > 5 && progress.front() == 0.0 && progress.back() == 1.0 &&
      std::is_sorted(progress.begin(), progress.end()));
  const std::vector<double> aborted = GetProgress(filter, true);
  checks.True("an abort stops the work, and leaves nothing half done",
    aborted.size() <= 2 && filter->GetOutput()->GetNumberOfPoints() == 0);
  filter->Modified();
  filter->Update();
  checks.True("the next update is whole",
    HaveSameBits(filter->GetOutput()->GetPointData(), ofOneThread->GetPointData()));

  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkPolyData> empty;
  blocks->SetBlock(0, MakeTrajectories({ { { 0, 0, 0 }, { 0, 0, 1 } } }));
  blocks->SetBlock(1, empty);
  blocks->SetBlock(3, MakeTrajectories({ { { 0, 0, 0 }, { 0, 0, 4 } } }));
  vtkNew<vtkTrajectoryAttributes> ofBlocks;
  ofBlocks->SetInputDataObject(blocks);
  ofBlocks->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(ofBlocks->GetOutputDataObject(0));
  const auto length = [&](unsigned int block)
  {
    return vtkPolyData::SafeDownCast(output->GetBlock(block))
      ->GetPointData()
      ->GetArray("SegmentLength")
      ->GetTuple1(0);
  };
  checks.True("block by block", output && length(0) == 1.0 && length(3) == 4.0);
}
}

//------------------------------------------------------------------------------
int TestTrajectoryAttributesPipeline(int, char*[])
{
  Checks checks;
  TestArrays(checks);
  TestSharedPoints(checks);
  TestArraysOfSharedPoints(checks);
  TestParts(checks);
  TestErrors(checks);
  TestPipeline(checks);
  return checks.Result();
}
