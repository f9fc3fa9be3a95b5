// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @brief   What every reader has to keep to, whatever its file holds.
 *
 * A reader takes any bytes without a crash, a hang or a large allocation, which libFuzzer and the
 * sanitizers watch. It ends with an error code and an empty output, or with no error and polygonal
 * data that any filter can walk; `Require` aborts where it does not.
 */

#ifndef FuzzReader_h
#define FuzzReader_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTrajectoryReader.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

//------------------------------------------------------------------------------
inline void Require(bool condition, const char* what)
{
  if (!condition)
  {
    std::fprintf(stderr, "Not kept: %s\n", what);
    std::abort();
  }
}

//------------------------------------------------------------------------------
// A file in memory with these bytes; its name.
inline std::string WriteMemoryFile(const std::uint8_t* data, std::size_t size)
{
  static const int file = memfd_create("fuzz", 0);
  Require(file >= 0 && ftruncate(file, 0) == 0 &&
      pwrite(file, data, size, 0) == static_cast<ssize_t>(size),
    "a file in memory can be written");
  return "/proc/self/fd/" + std::to_string(file);
}

//------------------------------------------------------------------------------
inline void RequireTuples(vtkFieldData* arrays, vtkIdType count, const char* what)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    Require(arrays->GetAbstractArray(i)->GetNumberOfTuples() == count, what);
    Require(arrays->GetAbstractArray(i)->GetName() != nullptr, "every array has a name");
  }
}

//------------------------------------------------------------------------------
inline void RequireWalkable(vtkPolyData* output)
{
  const vtkIdType points = output->GetNumberOfPoints();
  for (vtkIdType i = 0; i < points; ++i)
  {
    double point[3];
    output->GetPoint(i, point);
    Require(std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]),
      "points are finite");
  }
  const vtkIdType lines = output->GetNumberOfLines();
  Require(output->GetNumberOfCells() == lines, "every cell is a line");
  for (vtkIdType line = 0; line < lines; ++line)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    output->GetLines()->GetCellAtId(line, count, ids);
    Require(count > 0, "every line has a point");
    for (vtkIdType i = 0; i < count; ++i)
    {
      Require(0 <= ids[i] && ids[i] < points, "point ids are in range");
    }
  }
  RequireTuples(output->GetPointData(), points, "a point array has a tuple for each point");
  RequireTuples(output->GetCellData(), lines, "a cell array has a tuple for each line");
}

//------------------------------------------------------------------------------
inline void FuzzReader(vtkTrajectoryReader* reader, const std::uint8_t* data, std::size_t size)
{
  vtkObject::GlobalWarningDisplayOff();
  const std::string name = WriteMemoryFile(data, size);
  const bool accepted = reader->CanReadFile(name.c_str());
  reader->SetFileName(name.c_str());
  reader->UpdateInformation();
  reader->UpdateTimeStep(1.0);
  if (reader->GetErrorCode() == vtkErrorCode::NoError)
  {
    Require(accepted, "what can be read is recognised");
    RequireWalkable(reader->GetOutput());
  }
  else
  {
    Require(
      reader->GetOutput()->GetNumberOfPoints() == 0 && reader->GetOutput()->GetNumberOfCells() == 0,
      "the output is empty after an error");
  }
}

#endif
