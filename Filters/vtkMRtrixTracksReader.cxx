// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkMRtrixTracksReader.h"

#include "Private/vtkBinaryFile.h"
#include "Private/vtkTractogram.h"
#include "Private/vtkTrajectoryFileError.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkMRtrixTracksReader);

namespace
{
const std::string Magic = "mrtrix tracks";

struct Header
{
  bool IsDouble = false;
  std::uint64_t Offset = 0;
  bool HasCount = false;
  std::uint64_t Count = 0;
};

//------------------------------------------------------------------------------
std::string Trim(const std::string& text)
{
  const char* blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

//------------------------------------------------------------------------------
// The next line of the header, without its end and blanks around it.
std::string ReadLine(vtkBinaryFile& file)
{
  const std::vector<char>& bytes = file.GetBytes();
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(file.GetPosition());
  const auto end = std::find(begin, bytes.end(), '\n');
  if (end == bytes.end())
  {
    throw vtkTrajectoryFileError("expected a line \"END\" after the header, found none",
      vtkErrorCode::PrematureEndOfFileError);
  }
  file.Skip(static_cast<std::uint64_t>(end - begin) + 1, "the header");
  return Trim(std::string(begin, end));
}

//------------------------------------------------------------------------------
bool IsBeginning(vtkBinaryFile& file)
{
  const std::vector<char>& bytes = file.GetBytes();
  return bytes.size() > Magic.size() && std::equal(Magic.begin(), Magic.end(), bytes.begin()) &&
    std::isspace(static_cast<unsigned char>(bytes[Magic.size()]));
}

//------------------------------------------------------------------------------
// The last value of each key; keys in lower case.
std::map<std::string, std::string> ReadEntries(vtkBinaryFile& file)
{
  ReadLine(file);
  std::map<std::string, std::string> entries;
  for (std::string line = ReadLine(file); line != "END"; line = ReadLine(file))
  {
    const auto colon = line.find(':');
    if (colon != std::string::npos)
    {
      const std::string key = vtksys::SystemTools::LowerCase(Trim(line.substr(0, colon)));
      entries[key] = Trim(line.substr(colon + 1));
    }
  }
  return entries;
}

//------------------------------------------------------------------------------
std::uint64_t ToNumber(const std::string& text, const std::string& expected)
{
  const bool isNumber =
    !text.empty() && text.size() < 20 && text.find_first_not_of("0123456789") == std::string::npos;
  if (!isNumber)
  {
    throw vtkTrajectoryFileError("expected " + expected + ", found \"" + text + "\"");
  }
  return std::strtoull(text.c_str(), nullptr, 10);
}

//------------------------------------------------------------------------------
// Leaves the file's byte order set, and its place at the numbers.
Header ReadHeader(vtkBinaryFile& file)
{
  if (!IsBeginning(file))
  {
    throw vtkTrajectoryFileError(
      "expected \"" + Magic + "\" at the beginning; this is no MRtrix tracks file",
      vtkErrorCode::UnrecognizedFileTypeError);
  }
  std::map<std::string, std::string> entries = ReadEntries(file);

  Header header;
  const std::string type = vtksys::SystemTools::LowerCase(entries["datatype"]);
  const std::string ending = type.substr(std::min<std::size_t>(type.size(), 7));
  header.IsDouble = type.compare(0, 7, "float64") == 0;
  const bool isKnown = (header.IsDouble || type.compare(0, 7, "float32") == 0) &&
    (ending.empty() || ending == "le" || ending == "be");
  if (!isKnown)
  {
    throw vtkTrajectoryFileError("expected \"datatype: Float32LE\", Float32BE, Float64LE or "
                                 "Float64BE in the header, found \"" +
      entries["datatype"] + "\"");
  }
  file.SetBigEndian(ending == "be");

  const std::string place = entries["file"];
  if (place.empty() || place[0] != '.')
  {
    throw vtkTrajectoryFileError(
      "expected \"file: . OFFSET\" in the header, for numbers in the same "
      "file, found \"" +
      place + "\"");
  }
  header.Offset =
    ToNumber(Trim(place.substr(1)), "the offset of the numbers in \"file: . OFFSET\"");
  if (header.Offset < file.GetPosition())
  {
    throw vtkTrajectoryFileError("expected numbers behind the header, which ends at byte " +
      std::to_string(file.GetPosition()) + ", found the offset " + std::to_string(header.Offset));
  }
  file.Seek(header.Offset, "the header and what follows it");

  header.HasCount = !entries["count"].empty();
  if (header.HasCount)
  {
    header.Count = ToNumber(entries["count"], "a number of lines in \"count\"");
  }
  return header;
}

//------------------------------------------------------------------------------
// How many of the three values `is` holds for.
template <typename T, typename Predicate>
int Count(const T (&row)[3], Predicate is)
{
  return static_cast<int>(std::count_if(row, row + 3, is));
}
}

//------------------------------------------------------------------------------
int vtkMRtrixTracksReader::CanReadFile(const char* fileName)
{
  return vtkTractogram::Recognize(fileName,
    [](const std::string& name)
    {
      vtkBinaryFile file(name, Magic.size() + 1);
      return IsBeginning(file);
    });
}

//------------------------------------------------------------------------------
template <typename Array>
std::vector<vtkIdType> vtkMRtrixTracksReader::ReadRows(vtkBinaryFile& file, Array* coordinates)
{
  using T = typename Array::ValueType;
  const auto rows = static_cast<vtkIdType>(file.GetRemaining() / (3 * sizeof(T)));
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(rows);
  std::vector<vtkIdType> offsets = { 0 };
  vtkIdType points = 0;
  const vtkIdType rowsPerReport = rows / 100 + 1;
  for (vtkIdType row = 0; row < rows; ++row)
  {
    if (row % rowsPerReport == 0)
    {
      this->UpdateProgress(static_cast<double>(row) / static_cast<double>(rows));
      if (this->CheckAbort())
      {
        return {};
      }
    }
    T values[3];
    file.Read(values, 3, "a point");
    if (Count(values, [](T value) { return std::isfinite(value); }) == 3)
    {
      coordinates->SetTypedTuple(points++, values);
    }
    else if (Count(values, [](T value) { return std::isnan(value); }) == 3)
    {
      offsets.push_back(points);
    }
    else if (Count(values, [](T value) { return std::isinf(value); }) == 3)
    {
      if (points > offsets.back())
      {
        offsets.push_back(points);
      }
      coordinates->Resize(points);
      coordinates->SetNumberOfTuples(points);
      return offsets;
    }
    else
    {
      throw vtkTrajectoryFileError("expected three finite numbers, three NaN or three infinities, "
                                   "found a mixture of them in row " +
        std::to_string(row));
    }
  }
  throw vtkTrajectoryFileError("expected a row of infinities at the end, found the end of the file "
                               "after " +
      std::to_string(offsets.size() - 1) + " lines; the file is cut off",
    vtkErrorCode::PrematureEndOfFileError);
}

//------------------------------------------------------------------------------
void vtkMRtrixTracksReader::ReadTrajectories(
  const std::string& fileName, vtkInformation*, vtkPolyData* output)
{
  vtkBinaryFile file(fileName);
  const Header header = ReadHeader(file);
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkDoubleArray> doubles;
  const std::vector<vtkIdType> offsets =
    header.IsDouble ? this->ReadRows(file, doubles.Get()) : this->ReadRows(file, floats.Get());
  if (offsets.empty())
  {
    return; // aborted
  }
  if (header.HasCount && header.Count != offsets.size() - 1)
  {
    vtkWarningMacro(<< fileName << ": its header counts " << header.Count
                    << " lines, but there are " << offsets.size() - 1 << ", which are all read.");
  }
  if (file.GetRemaining() > 0)
  {
    vtkWarningMacro(<< fileName << ": " << file.GetRemaining()
                    << " bytes behind the end of the lines are ignored.");
  }
  vtkTractogram(output,
    header.IsDouble ? static_cast<vtkDataArray*>(doubles) : static_cast<vtkDataArray*>(floats),
    offsets);
}

VTK_ABI_NAMESPACE_END
