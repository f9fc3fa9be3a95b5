// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrackVisReader.h"

#include "Private/vtkBinaryFile.h"
#include "Private/vtkTrackVisHeader.h"
#include "Private/vtkTractogram.h"
#include "Private/vtkTrajectoryFileError.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdint>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrackVisReader);

namespace
{
//------------------------------------------------------------------------------
// One array for each entry of the header, which takes its columns from rows of floats.
class Columns
{
public:
  Columns(const std::vector<vtkTrackVisHeader::Values>& columns, vtkIdType tuples)
    : Header(columns)
  {
    for (const vtkTrackVisHeader::Values& values : columns)
    {
      auto array = vtkSmartPointer<vtkFloatArray>::New();
      array->SetName(values.Name.c_str());
      array->SetNumberOfComponents(values.Components);
      array->SetNumberOfTuples(tuples);
      this->Arrays.push_back(array);
    }
  }

  void SetTuple(vtkIdType tuple, const float* row)
  {
    for (std::size_t i = 0; i < this->Arrays.size(); ++i)
    {
      this->Arrays[i]->SetTypedTuple(tuple, row + this->Header[i].First);
    }
  }

  const std::vector<vtkSmartPointer<vtkFloatArray>>& GetArrays() const { return this->Arrays; }

private:
  const std::vector<vtkTrackVisHeader::Values>& Header;
  std::vector<vtkSmartPointer<vtkFloatArray>> Arrays;
};

//------------------------------------------------------------------------------
// Walk over all lines, from one number of points to the next: where the points of each begin.
std::vector<vtkIdType> ReadOffsets(vtkBinaryFile& file, const vtkTrackVisHeader& header)
{
  const std::uint64_t pointSize = (3 + header.NumberOfScalars) * sizeof(float);
  const std::uint64_t lineSize = header.NumberOfProperties * sizeof(float);
  std::vector<vtkIdType> offsets = { 0 };
  const auto isLeft = [&]()
  {
    return header.NumberOfLines == 0
      ? file.GetRemaining() > 0
      : offsets.size() <= static_cast<std::size_t>(header.NumberOfLines);
  };
  while (isLeft())
  {
    const auto points = file.Read<std::int32_t>("the number of points of a line");
    if (points < 0)
    {
      throw vtkTrajectoryFileError("expected a number of points of 0 or more in line " +
        std::to_string(offsets.size() - 1) + ", found " + std::to_string(points));
    }
    file.Skip(points * pointSize + lineSize, "the values of a line");
    offsets.push_back(offsets.back() + points);
  }
  if (file.GetRemaining() > 0)
  {
    throw vtkTrajectoryFileError(
      "expected the end of the file after n_count = " + std::to_string(header.NumberOfLines) +
      " lines, found " + std::to_string(file.GetRemaining()) + " more bytes");
  }
  return offsets;
}
}

//------------------------------------------------------------------------------
int vtkTrackVisReader::CanReadFile(const char* fileName)
{
  return vtkTractogram::Recognize(fileName,
    [](const std::string& name)
    {
      vtkBinaryFile file(name, vtkTrackVisHeader::Size);
      return vtkTrackVisHeader::IsBeginning(file);
    });
}

//------------------------------------------------------------------------------
void vtkTrackVisReader::ReadTrajectories(
  const std::string& fileName, vtkInformation*, vtkPolyData* output)
{
  vtkBinaryFile file(fileName);
  const vtkTrackVisHeader header(file);
  const std::vector<vtkIdType> offsets = ReadOffsets(file, header);
  const auto numberOfLines = static_cast<vtkIdType>(offsets.size() - 1);

  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Points");
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(offsets.back());
  Columns scalars(header.Scalars, offsets.back());
  Columns properties(header.Properties, numberOfLines);

  file.Seek(vtkTrackVisHeader::Size, "the header");
  std::vector<float> row(3 + header.NumberOfScalars);
  std::vector<float> lineRow(header.NumberOfProperties);
  const vtkIdType linesPerReport = numberOfLines / 100 + 1;
  for (vtkIdType line = 0; line < numberOfLines; ++line)
  {
    if (line % linesPerReport == 0)
    {
      this->UpdateProgress(static_cast<double>(line) / numberOfLines);
      if (this->CheckAbort())
      {
        return;
      }
    }
    file.Read<std::int32_t>("the number of points of a line");
    for (vtkIdType point = offsets[line]; point < offsets[line + 1]; ++point)
    {
      file.Read(row.data(), row.size(), "the values of a point");
      float world[3];
      for (int i = 0; i < 3; ++i)
      {
        const auto& factors = header.Transform[i];
        world[i] = static_cast<float>(
          factors[0] * row[0] + factors[1] * row[1] + factors[2] * row[2] + factors[3]);
      }
      coordinates->SetTypedTuple(point, world);
      scalars.SetTuple(point, row.data() + 3);
    }
    file.Read(lineRow.data(), lineRow.size(), "the properties of a line");
    properties.SetTuple(line, lineRow.data());
  }

  vtkTractogram tractogram(output, coordinates, offsets);
  for (vtkFloatArray* array : scalars.GetArrays())
  {
    tractogram.AddPointArray(array);
  }
  for (vtkFloatArray* array : properties.GetArrays())
  {
    tractogram.AddLineArray(array);
  }
}

VTK_ABI_NAMESPACE_END
