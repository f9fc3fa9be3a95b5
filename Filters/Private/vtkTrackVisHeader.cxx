// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrackVisHeader.h"

#include "vtkTrajectoryFileError.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Where the header's values are, in bytes.
constexpr std::uint64_t DimensionsAt = 6;
constexpr std::uint64_t VoxelSizeAt = 12;
constexpr std::uint64_t ScalarsAt = 36;
constexpr std::uint64_t PropertiesAt = 238;
constexpr std::uint64_t MatrixAt = 440;
constexpr std::uint64_t VoxelOrderAt = 948;
constexpr std::uint64_t CountAt = 988;
constexpr std::uint64_t VersionAt = 992;
constexpr std::uint64_t SizeAt = 996;

constexpr const char* What = "the header";

constexpr int NumberOfNames = 10;
constexpr int NameLength = 20;

// Axis of the world, and 1 if voxels count along it, -1 if against it.
struct Direction
{
  int Axis = 0;
  int Sign = 1;
};
using Orientation = std::array<Direction, 3>;

//------------------------------------------------------------------------------
template <typename T>
T ReadAt(vtkBinaryFile& file, std::uint64_t position)
{
  file.Seek(position, What);
  return file.Read<T>(What);
}

//------------------------------------------------------------------------------
template <typename T, std::size_t N>
std::array<T, N> ReadArrayAt(vtkBinaryFile& file, std::uint64_t position)
{
  std::array<T, N> values;
  file.Seek(position, What);
  file.Read(values.data(), N, What);
  return values;
}

//------------------------------------------------------------------------------
// Up to a zero byte. Bytes above 127 are ISO 8859-1; names in VTK are UTF-8.
std::string ToUTF8(const std::string& latin)
{
  std::string text;
  for (const char letter : latin)
  {
    const auto code = static_cast<unsigned char>(letter);
    if (code < 0x80)
    {
      text += letter;
    }
    else
    {
      text += static_cast<char>(0xC0 | (code >> 6));
      text += static_cast<char>(0x80 | (code & 0x3F));
    }
  }
  return text;
}

//------------------------------------------------------------------------------
// The name, and the components where a decimal number follows the name's zero byte.
vtkTrackVisHeader::Values ReadName(const char* bytes)
{
  vtkTrackVisHeader::Values values;
  const char* end = bytes + NameLength;
  const char* nameEnd = std::find(bytes, end, '\0');
  values.Name = ToUTF8(std::string(bytes, nameEnd));
  if (nameEnd != end)
  {
    const std::string number(nameEnd + 1, std::find(nameEnd + 1, end, '\0'));
    const bool isNumber = !number.empty() && number.size() < 6 &&
      number.find_first_not_of("0123456789") == std::string::npos;
    if (isNumber)
    {
      values.Components = std::max(1, std::atoi(number.c_str()));
    }
  }
  return values;
}

//------------------------------------------------------------------------------
// `kind` is "scalars" or "properties". The 10 names follow their number.
std::vector<vtkTrackVisHeader::Values> ReadValues(
  vtkBinaryFile& file, std::uint64_t position, const std::string& kind, int& total)
{
  total = ReadAt<std::int16_t>(file, position);
  if (total < 0)
  {
    throw vtkTrajectoryFileError(
      "expected a number of " + kind + " of 0 or more, found " + std::to_string(total));
  }
  std::array<vtkTrackVisHeader::Values, NumberOfNames> names;
  int used = 0;
  for (int i = 0; i < NumberOfNames; ++i)
  {
    names[i] = ReadName(file.Skip(NameLength, What));
    used = names[i].Name.empty() ? used : i + 1;
  }

  std::vector<vtkTrackVisHeader::Values> arrays;
  int first = 0;
  for (int i = 0; i < used && first < total; ++i)
  {
    vtkTrackVisHeader::Values values = names[i];
    values.First = first;
    if (values.Name.empty())
    {
      values.Name = kind + "_" + std::to_string(first);
      values.Components = 1;
    }
    first += values.Components;
    if (first > total)
    {
      throw vtkTrajectoryFileError("expected names for " + std::to_string(total) + " " + kind +
        ", found \"" + values.Name + "\" with " + std::to_string(values.Components) +
        " components from number " + std::to_string(values.First));
    }
    arrays.push_back(values);
  }
  if (first < total)
  {
    arrays.push_back({ kind, first, total - first });
  }
  return arrays;
}

//------------------------------------------------------------------------------
// Three letters, such as LPS, each the end of an axis that voxels count towards.
Orientation ReadVoxelOrder(vtkBinaryFile& file)
{
  file.Seek(VoxelOrderAt, What);
  const char* letters = file.Skip(4, What);
  std::string order(letters, std::find(letters, letters + 4, '\0'));
  order = order.empty() ? "LPS" : order;

  const std::string ends = "LRPAIS";
  Orientation orientation;
  unsigned int axes = 0;
  for (std::size_t i = 0; i < 3 && i < order.size(); ++i)
  {
    const auto found = ends.find(static_cast<char>(order[i] & ~0x20));
    if (found != std::string::npos)
    {
      orientation[i] = { static_cast<int>(found / 2), found % 2 ? 1 : -1 };
      axes |= 1u << orientation[i].Axis;
    }
  }
  if (axes != 7)
  {
    throw vtkTrajectoryFileError(
      "expected three letters in voxel_order, one each of LR, PA and IS, found \"" + ToUTF8(order) +
      "\"");
  }
  return orientation;
}

//------------------------------------------------------------------------------
// The axis of the world that each axis of the voxels is nearest to: of the rotation nearest to the
// matrix, the largest elements, no two of them in one row.
Orientation FindOrientation(const std::array<float, 16>& matrix)
{
  double axes[3][3] = {};
  for (int column = 0; column < 3; ++column)
  {
    const double length =
      std::hypot(matrix[column], matrix[4 + column], static_cast<double>(matrix[8 + column]));
    for (int row = 0; row < 3; ++row)
    {
      axes[row][column] = length > 0 ? matrix[4 * row + column] / length : 0.0;
    }
  }
  double u[3][3];
  double w[3];
  double vt[3][3];
  vtkMath::SingularValueDecomposition3x3(axes, u, w, vt);
  if (!(std::min({ std::abs(w[0]), std::abs(w[1]), std::abs(w[2]) }) > 1e-6))
  {
    throw vtkTrajectoryFileError(
      "expected three independent axes in vox_to_ras, found a matrix that has no inverse");
  }
  double rotation[3][3] = {};
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      for (int i = 0; i < 3; ++i)
      {
        rotation[row][column] += u[row][i] * (w[i] < 0 ? -1 : 1) * vt[i][column];
      }
    }
  }

  Orientation orientation;
  bool rowTaken[3] = {};
  bool columnTaken[3] = {};
  for (int i = 0; i < 3; ++i)
  {
    int bestRow = -1;
    int bestColumn = -1;
    for (int column = 0; column < 3; ++column)
    {
      for (int row = 0; row < 3; ++row)
      {
        const bool better = !rowTaken[row] && !columnTaken[column] &&
          (bestRow < 0 ||
            std::abs(rotation[row][column]) > std::abs(rotation[bestRow][bestColumn]));
        if (better)
        {
          bestRow = row;
          bestColumn = column;
        }
      }
    }
    rowTaken[bestRow] = true;
    columnTaken[bestColumn] = true;
    orientation[bestColumn] = { bestRow, rotation[bestRow][bestColumn] < 0 ? -1 : 1 };
  }
  return orientation;
}
}

//------------------------------------------------------------------------------
bool vtkTrackVisHeader::IsBeginning(vtkBinaryFile& file)
{
  const std::vector<char>& bytes = file.GetBytes();
  if (bytes.size() < Size || std::string(bytes.data(), 5) != "TRACK")
  {
    return false;
  }
  for (const bool bigEndian : { false, true })
  {
    file.SetBigEndian(bigEndian);
    if (ReadAt<std::int32_t>(file, SizeAt) == static_cast<std::int32_t>(Size))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
vtkTrackVisHeader::vtkTrackVisHeader(vtkBinaryFile& file)
{
  file.Seek(0, What);
  file.Skip(Size, What);
  if (!IsBeginning(file))
  {
    throw vtkTrajectoryFileError(
      "expected \"TRACK\" at the beginning and hdr_size 1000 at byte 996, in either byte order; "
      "this is no TrackVis file",
      vtkErrorCode::UnrecognizedFileTypeError);
  }
  const auto version = ReadAt<std::int32_t>(file, VersionAt);
  if (version < 1 || version > 3)
  {
    throw vtkTrajectoryFileError(
      "expected version 1, 2 or 3 of the format, found " + std::to_string(version));
  }
  this->NumberOfLines = ReadAt<std::int32_t>(file, CountAt);
  if (this->NumberOfLines < 0)
  {
    throw vtkTrajectoryFileError(
      "expected n_count of 0 or more, found " + std::to_string(this->NumberOfLines));
  }
  this->Scalars = ReadValues(file, ScalarsAt, "scalars", this->NumberOfScalars);
  this->Properties = ReadValues(file, PropertiesAt, "properties", this->NumberOfProperties);
  if (version > 1 && ReadAt<float>(file, MatrixAt + 15 * sizeof(float)) != 0)
  {
    this->ReadTransform(file);
  }
  file.Seek(Size, What);
}

//------------------------------------------------------------------------------
// From voxel-millimetres to voxels of the file, to voxels of the matrix, to the world.
void vtkTrackVisHeader::ReadTransform(vtkBinaryFile& file)
{
  const auto dimensions = ReadArrayAt<std::int16_t, 3>(file, DimensionsAt);
  const auto voxelSize = ReadArrayAt<float, 3>(file, VoxelSizeAt);
  const auto matrix = ReadArrayAt<float, 16>(file, MatrixAt);
  const auto isFinite = [](float value) { return std::isfinite(value); };
  if (!std::all_of(matrix.begin(), matrix.end(), isFinite))
  {
    throw vtkTrajectoryFileError("expected finite elements in vox_to_ras, found NaN or infinity");
  }
  const Orientation fileOrientation = ReadVoxelOrder(file);
  const Orientation matrixOrientation = FindOrientation(matrix);

  for (int row = 0; row < 3; ++row)
  {
    this->Transform[row] = { 0, 0, 0, matrix[4 * row + 3] };
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!(voxelSize[axis] > 0) || !isFinite(voxelSize[axis]))
    {
      throw vtkTrajectoryFileError(
        "expected a voxel_size above 0, found " + std::to_string(voxelSize[axis]));
    }
    int target = 0;
    while (matrixOrientation[target].Axis != fileOrientation[axis].Axis)
    {
      ++target;
    }
    const bool flip = matrixOrientation[target].Sign != fileOrientation[axis].Sign;
    if (flip && dimensions[axis] <= 0)
    {
      throw vtkTrajectoryFileError("expected a dim above 0, which voxel_order needs, found " +
        std::to_string(dimensions[axis]));
    }
    const double sign = flip ? -1.0 : 1.0;
    const double shift = flip ? dimensions[axis] - 0.5 : -0.5;
    for (int row = 0; row < 3; ++row)
    {
      const double element = matrix[4 * row + target];
      this->Transform[row][axis] = sign * element / voxelSize[axis];
      this->Transform[row][3] += element * shift;
    }
  }
}

VTK_ABI_NAMESPACE_END
