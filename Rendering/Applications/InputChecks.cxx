// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "InputChecks.h"

#include "RenderError.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <filesystem>
#include <fstream>

namespace pellucid
{
namespace
{
// Bytes of binary STL.
constexpr std::size_t StlHeaderSize = 84;
constexpr std::size_t StlTriangleSize = 50;

//------------------------------------------------------------------------------
void CheckCells(vtkCellArray* cells, vtkIdType pointCount, const std::string& name)
{
  if (!cells || cells->GetNumberOfConnectivityIds() == 0)
  {
    return;
  }
  double range[2];
  cells->GetConnectivityArray()->GetRange(range);
  const double wrong = range[0] < 0.0 ? range[0] : range[1];
  if (wrong < 0.0 || wrong >= static_cast<double>(pointCount))
  {
    throw RenderError(name + ": is damaged, a cell refers to point " +
      std::to_string(static_cast<long long>(wrong)) + " of " + std::to_string(pointCount));
  }
}

//------------------------------------------------------------------------------
void CheckDataSet(vtkDataSet* data, const std::string& name)
{
  if (auto* geometry = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* cells :
      { geometry->GetVerts(), geometry->GetLines(), geometry->GetPolys(), geometry->GetStrips() })
    {
      CheckCells(cells, geometry->GetNumberOfPoints(), name);
    }
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    CheckCells(grid->GetCells(), grid->GetNumberOfPoints(), name);
  }
}
}

//------------------------------------------------------------------------------
void CheckReadable(const std::string& fileName)
{
  if (!std::filesystem::exists(fileName))
  {
    throw RenderError(fileName + ": there is no such file");
  }
  if (std::filesystem::is_directory(fileName))
  {
    return;
  }
  std::ifstream file(fileName, std::ios::binary);
  if (!file)
  {
    throw RenderError(fileName + ": cannot be opened; may you read it?");
  }
  if (file.peek() == std::ifstream::traits_type::eof())
  {
    throw RenderError(fileName + ": the file is empty");
  }
}

//------------------------------------------------------------------------------
void CheckNoFolder(const std::string& fileName)
{
  if (std::filesystem::is_directory(fileName))
  {
    throw RenderError(fileName + ": is a folder, expected a file, or a folder in TRX format");
  }
}

//------------------------------------------------------------------------------
bool IsBinaryStl(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  unsigned char header[StlHeaderSize] = {};
  file.read(reinterpret_cast<char*>(header), StlHeaderSize);
  std::uintmax_t triangles = 0;
  for (int byte = 3; byte >= 0; --byte)
  {
    triangles = 256 * triangles + header[80 + byte];
  }
  return file && triangles > 0 &&
    std::filesystem::file_size(fileName) == StlHeaderSize + triangles * StlTriangleSize;
}

//------------------------------------------------------------------------------
void CheckStlLength(const std::string& fileName)
{
  // The triangle count in the header is not reliable in files of other programs.
  std::ifstream file(fileName, std::ios::binary);
  std::string begin(StlHeaderSize, ' ');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  const bool isText = begin.compare(0, 5, "solid") == 0 && begin.find('\0') == std::string::npos;
  const std::uintmax_t size = std::filesystem::file_size(fileName);
  if (!isText && (size < StlHeaderSize || (size - StlHeaderSize) % StlTriangleSize != 0))
  {
    throw RenderError(fileName + ": is damaged, its " + std::to_string(size) +
      " bytes are not those of whole triangles");
  }
}

//------------------------------------------------------------------------------
void CheckData(vtkDataObject* data, const std::string& name)
{
  const auto leaves = vtkCompositeDataSet::GetDataSets<vtkDataSet>(data);
  if (leaves.empty() && !vtkCompositeDataSet::SafeDownCast(data))
  {
    throw RenderError(
      name + ": holds a " + data->GetClassName() + ", expected lines, points, surfaces or a field");
  }
  vtkIdType points = 0;
  vtkIdType cells = 0;
  for (vtkDataSet* leaf : leaves)
  {
    CheckDataSet(leaf, name);
    points += leaf->GetNumberOfPoints();
    cells += leaf->GetNumberOfCells();
  }
  if (points == 0)
  {
    throw RenderError(name + ": is empty, it holds no points");
  }
  if (cells == 0)
  {
    throw RenderError(name + ": is empty, it holds " + std::to_string(points) +
      " points but no cell (line, vertex, polygon, ...) that could be drawn");
  }
}
}
