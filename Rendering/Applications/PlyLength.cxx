// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PlyLength.h"

#include "RenderError.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace pellucid
{
namespace
{
struct PlyProperty
{
  int CountBytes = 0; // of the number of values in front of a list; 0: a single value
  int ValueBytes = 0;
};

struct PlyElement
{
  std::int64_t Count = 0;
  std::vector<PlyProperty> Properties;
};

struct PlyHeader
{
  bool IsBinary = false;
  bool IsBigEndian = false;
  std::vector<PlyElement> Elements;
};

//------------------------------------------------------------------------------
int GetBytes(const std::string& type)
{
  static const std::map<std::string, int> bytes = { { "char", 1 }, { "uchar", 1 }, { "int8", 1 },
    { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 }, { "int", 4 },
    { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 },
    { "double", 8 }, { "float64", 8 } };
  const auto found = bytes.find(type);
  return found == bytes.end() ? 0 : found->second;
}

//------------------------------------------------------------------------------
// The header; the file is left behind it.
PlyHeader ReadHeader(std::ifstream& file)
{
  PlyHeader header;
  for (std::string line; std::getline(file, line) && line.rfind("end_header", 0) != 0;)
  {
    std::istringstream words(line);
    std::string word;
    std::string type;
    words >> word >> type;
    if (word == "format")
    {
      header.IsBinary = type.rfind("binary", 0) == 0;
      header.IsBigEndian = type == "binary_big_endian";
    }
    else if (word == "element")
    {
      header.Elements.emplace_back();
      words >> header.Elements.back().Count;
    }
    else if (word == "property" && !header.Elements.empty())
    {
      PlyProperty property;
      if (type == "list")
      {
        words >> word >> type;
        property.CountBytes = GetBytes(word);
      }
      property.ValueBytes = GetBytes(type);
      header.Elements.back().Properties.push_back(property);
    }
  }
  return header;
}

//------------------------------------------------------------------------------
// Whether every element has properties, all of known types.
bool IsComplete(const PlyHeader& header)
{
  return std::all_of(header.Elements.begin(), header.Elements.end(),
    [](const PlyElement& element)
    {
      return !element.Properties.empty() &&
        std::all_of(element.Properties.begin(), element.Properties.end(),
          [](const PlyProperty& property) { return property.ValueBytes > 0; });
    });
}

//------------------------------------------------------------------------------
std::int64_t ReadCount(std::ifstream& file, int bytes, bool isBigEndian)
{
  std::int64_t count = 0;
  for (int i = 0; i < bytes; ++i)
  {
    const std::int64_t byte = file.get() & 0xff;
    count |= byte << (8 * (isBigEndian ? bytes - 1 - i : i));
  }
  return count;
}

//------------------------------------------------------------------------------
// Go on behind the values of one property; whether the file has them all.
bool SkipBytes(std::ifstream& file, const PlyProperty& property, bool isBigEndian)
{
  const std::int64_t count =
    property.CountBytes > 0 ? ReadCount(file, property.CountBytes, isBigEndian) : 1;
  const std::int64_t bytes = count * property.ValueBytes;
  file.ignore(bytes);
  return file.good() && file.gcount() == bytes;
}

//------------------------------------------------------------------------------
// The same in text form.
bool SkipWords(std::ifstream& file, const PlyProperty& property)
{
  std::int64_t count = 1;
  if (property.CountBytes > 0)
  {
    file >> count;
  }
  std::string word;
  for (std::int64_t i = 0; i < count && file; ++i)
  {
    file >> word;
  }
  return !file.fail();
}
}

//------------------------------------------------------------------------------
void CheckPlyLength(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  const PlyHeader header = ReadHeader(file);
  if (!IsComplete(header))
  {
    return;
  }
  for (const PlyElement& element : header.Elements)
  {
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      for (const PlyProperty& property : element.Properties)
      {
        if (!(header.IsBinary ? SkipBytes(file, property, header.IsBigEndian)
                              : SkipWords(file, property)))
        {
          throw RenderError(fileName + ": is damaged, it ends before its last element");
        }
      }
    }
  }
}
}
