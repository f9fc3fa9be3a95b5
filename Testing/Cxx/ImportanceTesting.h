// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    ImportanceTesting.h
 * @brief   Small data sets for the tests of filters, and the messages of an update.
 */

#ifndef ImportanceTesting_h
#define ImportanceTesting_h

#include "ReferenceTesting.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <initializer_list>
#include <limits>
#include <vector>

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** An array of these values, `components` to a tuple. */
inline vtkSmartPointer<vtkDoubleArray> MakeArray(
  const char* name, const std::vector<double>& values, int components = 1)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/** Points at x = 0, 1, 2..., without cells. */
inline vtkSmartPointer<vtkPolyData> MakePoints(vtkIdType count)
{
  vtkNew<vtkPoints> points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(static_cast<double>(i), 0.0, 0.0);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  return data;
}

/** Cells of the point ids in each list. */
inline vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<std::vector<vtkIdType>>& pointIds)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& ids : pointIds)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return cells;
}

/** The numbers of an array of one component; none for nullptr. */
inline std::vector<double> GetValues(vtkDataArray* array)
{
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

/** The point ids of each cell. */
inline std::vector<std::vector<vtkIdType>> GetPointIds(vtkCellArray* cells)
{
  std::vector<std::vector<vtkIdType>> pointIds;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(i, count, points);
    pointIds.emplace_back(points, points + count);
  }
  return pointIds;
}

/** The text of the errors and warnings of the filter while `function` runs. */
template <typename Function>
std::string CollectMessages(vtkAlgorithm* filter, Function&& function)
{
  std::string messages;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&messages);
  observer->SetCallback([](vtkObject*, unsigned long, void* text, void* message)
    { *static_cast<std::string*>(text) += static_cast<const char*>(message); });
  for (vtkObject* object : std::initializer_list<vtkObject*>{ filter, filter->GetExecutive() })
  {
    object->AddObserver(vtkCommand::ErrorEvent, observer);
    object->AddObserver(vtkCommand::WarningEvent, observer);
  }
  function();
  filter->RemoveObserver(observer);
  filter->GetExecutive()->RemoveObserver(observer);
  return messages;
}

/** The update has this message; an empty one means none at all. */
inline void CheckMessage(Checks& checks, vtkAlgorithm* filter, const std::string& expected)
{
  const std::string found = CollectMessages(filter, [filter] { filter->Update(); });
  checks.True("message '" + expected + "' in '" + found + "'",
    expected.empty() ? found.empty() : found.find(expected) != std::string::npos);
}

/** Each value is within `tolerance` of the one expected. */
inline void CheckValues(Checks& checks, const std::string& what, const std::vector<double>& found,
  const std::vector<double>& expected, double tolerance = 1e-6)
{
  checks.True(what + ": " + std::to_string(found.size()) + " values instead of " +
      std::to_string(expected.size()),
    found.size() == expected.size());
  for (std::size_t i = 0; i < std::min(found.size(), expected.size()); ++i)
  {
    checks.Near(what + ", " + std::to_string(i), found[i], expected[i], tolerance);
  }
}

/**
 * Update the modified filter and abort when its progress reaches `abortAt`; returns how often it
 * reported, or 0 if the progress went back.
 */
inline int CountProgress(vtkAlgorithm* filter, double abortAt)
{
  struct Reports
  {
    double AbortAt;
    double Last;
    int Count;
    bool IsSteady;
  };
  Reports reports{ abortAt, 0.0, 0, true };
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&reports);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
      auto* found = static_cast<Reports*>(data);
      found->IsSteady = found->IsSteady && algorithm->GetProgress() >= found->Last;
      found->Last = algorithm->GetProgress();
      ++found->Count;
      if (found->Last >= found->AbortAt)
      {
        algorithm->SetAbortExecute(true);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, observer);
  filter->Modified();
  filter->Update();
  filter->RemoveObserver(observer);
  filter->SetAbortExecute(false);
  return reports.IsSteady ? reports.Count : 0;
}

/** Call `function` with 1, 2 and 3 threads, where VTK has threads. */
template <typename Function>
void ForThreadCounts(Function&& function)
{
  vtkSMPTools::SetBackend("STDThread");
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::Initialize(threads);
    function(threads);
  }
  vtkSMPTools::Initialize();
}

#endif
