// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    TrajectoryTesting.h
 * @brief   Lines for the tests of the trajectory filters, and the errors and progress of a filter.
 */

#ifndef TrajectoryTesting_h
#define TrajectoryTesting_h

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkTestErrorObserver.h"

#include <array>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

using TrajectoryPoint = std::array<double, 3>;
using Trajectory = std::vector<TrajectoryPoint>;

constexpr double MissingValue = std::numeric_limits<double>::quiet_NaN();

/** Lines in double precision that share no points. */
inline vtkSmartPointer<vtkPolyData> MakeTrajectories(const std::vector<Trajectory>& trajectories)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const Trajectory& trajectory : trajectories)
  {
    lines->InsertNextCell(static_cast<int>(trajectory.size()));
    for (const TrajectoryPoint& point : trajectory)
    {
      lines->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/** A random walk in which some points coincide with the one before and some are missing. */
inline Trajectory MakeRandomWalk(int points, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Trajectory trajectory;
  TrajectoryPoint position = { 0.0, 0.0, 0.0 };
  bool rests = false;
  for (int i = 0; i < points; ++i)
  {
    rests = uniform(random) < (rests ? 0.7 : 0.02);
    for (double& coordinate : position)
    {
      coordinate += rests ? 0.0 : uniform(random) - 0.5;
    }
    trajectory.push_back(position);
    if (uniform(random) < 0.01)
    {
      trajectory.back()[i % 3] = i % 2 ? MissingValue : std::numeric_limits<double>::infinity();
    }
  }
  return trajectory;
}

inline vtkDataArray* AddPointArray(
  vtkPolyData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(array);
  return array;
}

/** What an update says in errors; empty if it succeeds. */
inline std::string GetUpdateErrors(vtkAlgorithm* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Modified();
  filter->Update();
  filter->RemoveObserver(observer);
  filter->GetExecutive()->RemoveObserver(observer);
  return observer->GetErrorMessage();
}

inline bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/** The progress that a filter reports in an update, which is aborted at the first report if asked.
 */
inline std::vector<double> GetProgress(vtkAlgorithm* filter, bool abort)
{
  struct Reports
  {
    std::vector<double> Progress;
    bool Abort;
  } reports{ {}, abort };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&reports);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* clientData, void*)
    {
      auto* received = static_cast<Reports*>(clientData);
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      received->Progress.push_back(algorithm->GetProgress());
      if (received->Abort)
      {
        algorithm->SetAbortExecute(1);
      }
    });
  const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Modified();
  filter->Update();
  filter->RemoveObserver(tag);
  filter->SetAbortExecute(0);
  return reports.Progress;
}

inline bool HaveSameBits(vtkDataSetAttributes* a, vtkDataSetAttributes* b)
{
  bool same = a->GetNumberOfArrays() == b->GetNumberOfArrays();
  for (int i = 0; same && i < a->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* first = a->GetArray(i);
    vtkDataArray* second = b->GetArray(i);
    same = first->GetNumberOfValues() == second->GetNumberOfValues() &&
      !std::memcmp(first->GetVoidPointer(0), second->GetVoidPointer(0),
        first->GetNumberOfValues() * first->GetDataTypeSize());
  }
  return same;
}

/** Update with a number of threads. */
inline void UpdateWithThreads(vtkAlgorithm* filter, int threads)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false),
    [filter]()
    {
      filter->Modified();
      filter->Update();
    });
}

#endif
