// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNetCDFHeader.h"

#include "vtkTrajectoryFileError.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
// Sizes are doubles: exact as far as files are long, and without overflow where a header lies.
double Pad(double size)
{
  return 4.0 * std::ceil(size / 4.0);
}

//------------------------------------------------------------------------------
class ClassicHeader
{
public:
  ClassicHeader(std::istream& stream, std::uint64_t length, int version)
    : Stream(stream)
    , Length(length)
    , NumberSize(version == 5 ? 8 : 4)
    , OffsetSize(version == 1 ? 4 : 8)
  {
  }

  // From behind the magic bytes.
  void Check()
  {
    this->NumberOfRecords = static_cast<double>(this->ReadNumber());
    this->ReadList([this] { this->ReadDimension(); });
    this->ReadList([this] { this->ReadAttribute(); });
    this->ReadList([this] { this->ReadVariable(); });

    // Records are padded unless there is only one record variable.
    double recordSize = 0.0;
    const auto recordVariables = std::count_if(this->Variables.begin(), this->Variables.end(),
      [](const Variable& variable) { return variable.IsRecord; });
    for (const Variable& variable : this->Variables)
    {
      recordSize +=
        variable.IsRecord ? (recordVariables > 1 ? Pad(variable.Size) : variable.Size) : 0.0;
    }
    for (const Variable& variable : this->Variables)
    {
      const bool isEmpty = variable.IsRecord && this->NumberOfRecords == 0.0;
      const double end = variable.Begin + variable.Size +
        (variable.IsRecord ? (this->NumberOfRecords - 1.0) * recordSize : 0.0);
      if (!isEmpty && variable.Size > 0.0 && end > static_cast<double>(this->Length))
      {
        throw vtkTrajectoryFileError(
          "the file is cut off or its header is damaged: the values of '" + variable.Name +
            "' should end at byte " + vtkNetCDFHeader::FormatSize(end) + ", but the file has " +
            std::to_string(this->Length) + " bytes",
          vtkErrorCode::PrematureEndOfFileError);
      }
    }
  }

private:
  struct Variable
  {
    std::string Name;
    bool IsRecord = false;
    double Size = 0.0; // bytes; of one record where it is a record variable
    double Begin = 0.0;
  };

  void Require(double size)
  {
    if (size > static_cast<double>(this->Length - this->Position))
    {
      throw vtkTrajectoryFileError("the file is cut off or damaged: its header should go on beyond "
                                   "the file's " +
          std::to_string(this->Length) + " bytes",
        vtkErrorCode::PrematureEndOfFileError);
    }
  }

  std::uint64_t ReadInteger(int size)
  {
    this->Require(size);
    this->Position += size;
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i)
    {
      value = value << 8 | static_cast<unsigned char>(this->Stream.get());
    }
    return value;
  }

  std::uint64_t ReadNumber() { return this->ReadInteger(this->NumberSize); }

  std::string ReadName()
  {
    const double length = static_cast<double>(this->ReadNumber());
    this->Require(Pad(length));
    std::string name(static_cast<std::size_t>(length), '\0');
    this->Stream.read(&name[0], static_cast<std::streamsize>(length));
    this->Position += static_cast<std::uint64_t>(length);
    this->Skip(Pad(length) - length);
    return name;
  }

  void Skip(double size)
  {
    this->Require(size);
    this->Position += static_cast<std::uint64_t>(size);
    this->Stream.seekg(static_cast<std::streamoff>(this->Position));
  }

  double ReadTypeSize()
  {
    // NC_BYTE, NC_CHAR, NC_SHORT, NC_INT, NC_FLOAT, NC_DOUBLE, NC_UBYTE ... NC_UINT64
    constexpr double sizes[] = { 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
    const std::uint64_t type = this->ReadInteger(4);
    if (type < 1 || type > 11)
    {
      throw vtkTrajectoryFileError(
        "the NetCDF header is damaged: expected a type from 1 to 11, found " +
        std::to_string(type));
    }
    return sizes[type - 1];
  }

  // Each element has at least one byte in the file: a lying count soon meets the end.
  template <typename ReadElement>
  void ReadList(ReadElement&& readElement)
  {
    this->ReadInteger(4); // the tag; 0 where there is no list
    const std::uint64_t count = this->ReadNumber();
    for (std::uint64_t i = 0; i < count; ++i)
    {
      readElement();
    }
  }

  void ReadDimension()
  {
    this->ReadName();
    this->Dimensions.push_back(static_cast<double>(this->ReadNumber()));
  }

  void ReadAttribute()
  {
    this->ReadName();
    const double typeSize = this->ReadTypeSize();
    this->Skip(Pad(typeSize * static_cast<double>(this->ReadNumber())));
  }

  void ReadVariable()
  {
    Variable variable;
    variable.Name = this->ReadName();
    variable.Size = 1.0;
    const std::uint64_t rank = this->ReadNumber();
    for (std::uint64_t i = 0; i < rank; ++i)
    {
      const std::uint64_t dimension = this->ReadNumber();
      if (dimension >= this->Dimensions.size())
      {
        throw vtkTrajectoryFileError("the NetCDF header is damaged: '" + variable.Name +
          "' has a dimension that does not exist");
      }
      // The dimension of length 0 is the one that counts records.
      const double length = this->Dimensions[dimension];
      variable.IsRecord = variable.IsRecord || (i == 0 && length == 0.0);
      variable.Size *= i == 0 && length == 0.0 ? 1.0 : length;
    }
    this->ReadList([this] { this->ReadAttribute(); });
    variable.Size *= this->ReadTypeSize();
    this->ReadNumber(); // the size again, but not for large variables
    variable.Begin = static_cast<double>(this->ReadInteger(this->OffsetSize));
    this->Variables.push_back(variable);
  }

  std::istream& Stream;
  std::uint64_t Length;
  std::uint64_t Position = 4;
  int NumberSize;
  int OffsetSize;
  double NumberOfRecords = 0.0;
  std::vector<double> Dimensions;
  std::vector<Variable> Variables;
};
}

//------------------------------------------------------------------------------
std::uint64_t vtkNetCDFHeader::Check(const std::string& fileName)
{
  const std::uint64_t length = vtksys::SystemTools::FileLength(fileName);
  vtksys::ifstream stream(fileName.c_str(), std::ios::in | std::ios::binary);
  std::string magic(8, '\0');
  stream.read(&magic[0], 4);
  const int version = static_cast<unsigned char>(magic[3]);
  if (stream && magic.compare(0, 3, "CDF") == 0 && (version == 1 || version == 2 || version == 5))
  {
    ClassicHeader(stream, length, version).Check();
    return length;
  }
  stream.read(&magic[4], 4);
  if (!stream || magic != "\x89HDF\r\n\x1a\n")
  {
    throw vtkTrajectoryFileError(
      "is not a NetCDF file: it begins with neither 'CDF' nor HDF5's signature",
      vtkErrorCode::UnrecognizedFileTypeError);
  }
  return length;
}

//------------------------------------------------------------------------------
std::string vtkNetCDFHeader::FormatSize(double size)
{
  return size < 1e15 ? std::to_string(static_cast<std::uint64_t>(size)) : "10^15 or more";
}

VTK_ABI_NAMESPACE_END
