// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTRXReader.h"

#include "Private/vtkArrayNames.h"
#include "Private/vtkTRXArchive.h"
#include "Private/vtkTRXArray.h"
#include "Private/vtkTractogram.h"
#include "Private/vtkTrajectoryFileError.h"

#include "vtkDataArrayRange.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTRXReader);

namespace
{
constexpr std::uint64_t LargestHeader = 1 << 20;
constexpr std::uint64_t LargestGroups = 16; // bytes for each byte of the file
constexpr std::uint64_t ReadAtOnce = 1 << 20;

struct Header
{
  bool IsFound = false;
  std::uint64_t Lines = 0;
  std::uint64_t Points = 0;
  std::vector<double> Dimensions;
  std::vector<double> VoxelToWorld;
};

using Contents = std::map<std::string, vtkTRXArray>;
using Arrays = std::map<std::string, vtkSmartPointer<vtkDataArray>>;

//------------------------------------------------------------------------------
std::uint64_t ReadCount(const nlohmann::json& values, const char* key)
{
  const auto found = values.find(key);
  if (found == values.end() || !found->is_number_unsigned())
  {
    throw vtkTrajectoryFileError(std::string("expected ") + key +
      " in header.json, a whole number of 0 or more, found " +
      (found == values.end()   ? std::string("none")
          : found->is_number() ? found->dump()
                               : std::string(found->type_name())));
  }
  return found->get<std::uint64_t>();
}

//------------------------------------------------------------------------------
// `count` numbers, in a list or in a list of lists; nothing if there is something else.
std::vector<double> ReadNumbers(const nlohmann::json& values, const char* key, std::size_t count)
{
  std::vector<double> numbers;
  const auto append = [&](const nlohmann::json& item)
  {
    if (item.is_number())
    {
      numbers.push_back(item.get<double>());
    }
  };
  const auto found = values.find(key);
  if (found != values.end())
  {
    for (const nlohmann::json& row : *found)
    {
      if (row.is_array())
      {
        std::for_each(row.begin(), row.end(), append);
      }
      else
      {
        append(row);
      }
    }
  }
  return numbers.size() == count ? numbers : std::vector<double>();
}

//------------------------------------------------------------------------------
Header ReadHeader(std::uint64_t size, const vtkTRXArchive::Source& source)
{
  if (size > LargestHeader)
  {
    throw vtkTrajectoryFileError("expected header.json of at most " +
      std::to_string(LargestHeader) + " bytes, found " + std::to_string(size));
  }
  std::string text(size, ' ');
  if (size > 0)
  {
    source(&text[0], size);
  }
  const auto values = nlohmann::json::parse(text, nullptr, false);
  if (!values.is_object())
  {
    throw vtkTrajectoryFileError("expected a JSON object in header.json, found something else");
  }
  Header header;
  header.IsFound = true;
  header.Lines = ReadCount(values, "NB_STREAMLINES");
  header.Points = ReadCount(values, "NB_VERTICES");
  header.Dimensions = ReadNumbers(values, "DIMENSIONS", 3);
  header.VoxelToWorld = ReadNumbers(values, "VOXEL_TO_RASMM", 16);
  return header;
}

//------------------------------------------------------------------------------
Header FindHeader(const vtkTRXArchive& archive)
{
  Header header;
  archive.VisitOne("header.json",
    [&](const std::string&, std::uint64_t size, const vtkTRXArchive::Source& source)
    {
      header = ReadHeader(size, source);
      return false;
    });
  if (!header.IsFound)
  {
    throw vtkTrajectoryFileError("expected header.json in it, found none; this is no TRX file",
      vtkErrorCode::UnrecognizedFileTypeError);
  }
  return header;
}

//------------------------------------------------------------------------------
Contents FindContents(const vtkTRXArchive& archive)
{
  Contents contents;
  std::size_t arrays = 0;
  archive.Visit(
    [&](const std::string& name, std::uint64_t size, const vtkTRXArchive::Source&)
    {
      const auto [item, isNew] = contents.emplace(name, vtkTRXArray(name, size));
      if (!isNew)
      {
        throw vtkTrajectoryFileError("expected \"" + name + "\" in it once, found it twice");
      }
      arrays += item->second.IsArray();
      vtkArrayNames::RequireNumber(arrays);
      return true;
    });
  return contents;
}

//------------------------------------------------------------------------------
std::uint64_t CountRole(const Contents& contents, vtkTRXArray::Roles role)
{
  return std::count_if(contents.begin(), contents.end(),
    [role](const auto& item) { return item.second.GetRole() == role; });
}

//------------------------------------------------------------------------------
// Compare the size of everything with the header, before any of it is read.
void RequireSizes(const Contents& contents, const Header& header)
{
  for (const auto& item : contents)
  {
    const vtkTRXArray& array = item.second;
    switch (array.GetRole())
    {
      case vtkTRXArray::POSITIONS:
      case vtkTRXArray::POINT_DATA:
        array.RequireTuples(header.Points);
        break;
      case vtkTRXArray::LINE_DATA:
        array.RequireTuples(header.Lines);
        break;
      case vtkTRXArray::OFFSETS:
        // Some writers append where the last line ends.
        array.RequireTuples(header.Lines + (array.GetNumberOfTuples() > header.Lines ? 1 : 0));
        break;
      default:
        break;
    }
  }
  const auto requireOne = [&](vtkTRXArray::Roles role, const char* name, bool isNeeded)
  {
    const std::uint64_t count = CountRole(contents, role);
    if (count > 1 || (isNeeded && count == 0))
    {
      throw vtkTrajectoryFileError(
        std::string("expected one array \"") + name + "\" in it, found " + std::to_string(count));
    }
  };
  requireOne(vtkTRXArray::POSITIONS, "positions", header.Points > 0);
  requireOne(vtkTRXArray::OFFSETS, "offsets", header.Lines > 0);
}

//------------------------------------------------------------------------------
// All arrays, by the names of their files; nothing if the reader is to abort.
Arrays ReadArrays(
  vtkAlgorithm* reader, const vtkTRXArchive& archive, const Contents& contents, bool readGroups)
{
  const auto isRead = [&](const vtkTRXArray& array)
  { return array.IsArray() && (array.GetRole() != vtkTRXArray::GROUP || readGroups); };
  Arrays arrays;
  std::size_t visited = 0;
  archive.Visit(
    [&](const std::string& name, std::uint64_t size, const vtkTRXArchive::Source& source)
    {
      const auto item = contents.find(name);
      if (item == contents.end())
      {
        throw vtkTrajectoryFileError("\"" + name + "\" in it was not there when reading began");
      }
      const vtkTRXArray& array = item->second;
      const double begin = static_cast<double>(visited++);
      const auto read = [&](char* bytes, std::uint64_t count)
      {
        for (std::uint64_t done = 0; done < count; done += ReadAtOnce)
        {
          reader->UpdateProgress((begin + static_cast<double>(done) / static_cast<double>(size)) /
            static_cast<double>(contents.size()));
          if (reader->CheckAbort())
          {
            return false;
          }
          source(bytes + done, std::min(ReadAtOnce, count - done));
        }
        return true;
      };
      if (isRead(array))
      {
        const auto values = array.Read(read);
        if (!values)
        {
          arrays.clear();
          return false;
        }
        arrays[name] = values;
      }
      return true;
    });
  return arrays;
}

//------------------------------------------------------------------------------
// Where the points of each line begin, and where the last one ends.
std::vector<vtkIdType> GetOffsets(vtkDataArray* array, const Header& header)
{
  const auto end = static_cast<vtkIdType>(header.Points);
  std::vector<vtkIdType> offsets(header.Lines + 1, end);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    // Exact up to 2^53 points; a larger offset is beyond them.
    const double offset = array->GetComponent(i, 0);
    const double previous = i > 0 ? static_cast<double>(offsets[i - 1]) : 0.0;
    const bool isLast = i == static_cast<vtkIdType>(header.Lines);
    const double largest = static_cast<double>(end);
    if (offset < previous || offset > largest || (i == 0 && offset != 0) ||
      (isLast && offset != largest))
    {
      throw vtkTrajectoryFileError("expected offsets from 0 to " + std::to_string(end) +
        " that do not decrease, found " + array->GetVariantValue(i).ToString() + " at number " +
        std::to_string(i));
    }
    offsets[i] = static_cast<vtkIdType>(offset);
  }
  if (header.Lines == 0 && end > 0)
  {
    throw vtkTrajectoryFileError(
      "expected no points without lines, found NB_VERTICES " + std::to_string(end));
  }
  return offsets;
}

//------------------------------------------------------------------------------
// 1 for each line of the file that `ids` names, 0 for others.
vtkSmartPointer<vtkDataArray> MakeGroup(vtkDataArray* ids, vtkIdType lines)
{
  auto group = vtkSmartPointer<vtkUnsignedCharArray>::New();
  group->SetName(ids->GetName());
  group->SetNumberOfValues(lines);
  group->FillValue(0);
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const double id = ids->GetComponent(i, 0);
    if (!(0 <= id && id < static_cast<double>(lines)))
    {
      throw vtkTrajectoryFileError(std::string("\"") + ids->GetName() +
        "\" in it: expected ids of lines from 0 to below " + std::to_string(lines) + ", found " +
        std::to_string(id));
    }
    group->SetValue(static_cast<vtkIdType>(id), 1);
  }
  return group;
}

//------------------------------------------------------------------------------
void AddTuple(vtkTractogram& tractogram, const char* name, const std::vector<double>& values)
{
  if (!values.empty())
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(values.size()));
    array->InsertNextTypedTuple(values.data());
    tractogram.AddFieldArray(array);
  }
}
}

//------------------------------------------------------------------------------
int vtkTRXReader::CanReadFile(const char* fileName)
{
  return vtkTractogram::Recognize(
    fileName, [](const std::string& name) { return FindHeader(vtkTRXArchive(name)).IsFound; });
}

//------------------------------------------------------------------------------
void vtkTRXReader::ReadTrajectories(
  const std::string& fileName, vtkInformation*, vtkPolyData* output)
{
  const vtkTRXArchive archive(fileName);
  const Header header = FindHeader(archive);
  const Contents contents = FindContents(archive);
  RequireSizes(contents, header);

  const std::uint64_t groups = CountRole(contents, vtkTRXArray::GROUP);
  const bool readGroups =
    groups == 0 || header.Lines <= archive.GetLength() * LargestGroups / groups;
  if (!readGroups)
  {
    vtkWarningMacro(<< fileName << ": its " << groups << " groups are not read; for "
                    << header.Lines << " lines they would take too much memory.");
  }
  if (const std::uint64_t unknown = CountRole(contents, vtkTRXArray::UNKNOWN))
  {
    const auto first = std::find_if(contents.begin(), contents.end(),
      [](const auto& item) { return item.second.GetRole() == vtkTRXArray::UNKNOWN; });
    vtkWarningMacro(<< fileName << ": " << unknown
                    << " files in it are not of the format and not read, such as \"" << first->first
                    << "\".");
  }

  const Arrays arrays = ReadArrays(this, archive, contents, readGroups);
  if (this->GetAbortOutput())
  {
    return;
  }
  vtkSmartPointer<vtkDataArray> coordinates = vtkSmartPointer<vtkFloatArray>::New();
  coordinates->SetNumberOfComponents(3);
  vtkDataArray* offsets = nullptr;
  for (const auto& item : arrays)
  {
    const auto role = contents.at(item.first).GetRole();
    coordinates = role == vtkTRXArray::POSITIONS ? item.second : coordinates;
    offsets = role == vtkTRXArray::OFFSETS ? item.second.Get() : offsets;
  }
  vtkTractogram tractogram(output, coordinates, GetOffsets(offsets, header));

  for (const auto& item : arrays)
  {
    switch (contents.at(item.first).GetRole())
    {
      case vtkTRXArray::POINT_DATA:
        tractogram.AddPointArray(item.second);
        break;
      case vtkTRXArray::LINE_DATA:
        tractogram.AddLineArray(item.second);
        break;
      case vtkTRXArray::GROUP:
        tractogram.AddLineArray(MakeGroup(item.second, static_cast<vtkIdType>(header.Lines)));
        break;
      case vtkTRXArray::GROUP_DATA:
        tractogram.AddFieldArray(item.second);
        break;
      default:
        break;
    }
  }
  AddTuple(tractogram, "DIMENSIONS", header.Dimensions);
  AddTuple(tractogram, "VOXEL_TO_RASMM", header.VoxelToWorld);
}

VTK_ABI_NAMESPACE_END
