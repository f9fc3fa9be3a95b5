// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTRXArray.h"

#include "vtkTrajectoryFileError.h"

#include "vtkByteSwap.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkType.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

const vtkTRXArray::Type vtkTRXArray::Types[] = {
  { "int8", VTK_TYPE_INT8, 1 },
  { "int16", VTK_TYPE_INT16, 2 },
  { "int32", VTK_TYPE_INT32, 4 },
  { "int64", VTK_TYPE_INT64, 8 },
  { "uint8", VTK_TYPE_UINT8, 1 },
  { "uint16", VTK_TYPE_UINT16, 2 },
  { "uint32", VTK_TYPE_UINT32, 4 },
  { "uint64", VTK_TYPE_UINT64, 8 },
  { "float16", VTK_FLOAT, 2 },
  { "float32", VTK_FLOAT, 4 },
  { "float64", VTK_DOUBLE, 8 },
  { "bit", VTK_TYPE_UINT8, 1 },
};

namespace
{
//------------------------------------------------------------------------------
// IEEE 754, binary16: 1 bit sign, 5 bits exponent, 10 bits fraction.
float FromHalf(std::uint16_t half)
{
  const std::uint32_t exponent = (half >> 10) & 0x1F;
  const std::uint32_t fraction = half & 0x3FF;
  // binary32: 8 bits exponent, with a bias of 127 instead of 15, and 23 bits fraction.
  const std::uint32_t bits = (exponent == 0x1F ? 0xFF : exponent + 127 - 15) << 23 | fraction << 13;
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  if (exponent == 0)
  {
    value = std::ldexp(static_cast<float>(fraction), -24); // zero, or denormalised
  }
  return half & 0x8000 ? -value : value;
}

//------------------------------------------------------------------------------
void SwapFromLittleEndian(void* values, std::size_t count, unsigned int size)
{
  switch (size)
  {
    case 2:
      vtkByteSwap::Swap2LERange(values, count);
      break;
    case 4:
      vtkByteSwap::Swap4LERange(values, count);
      break;
    case 8:
      vtkByteSwap::Swap8LERange(values, count);
      break;
    default:
      break;
  }
}

//------------------------------------------------------------------------------
vtkTRXArray::Roles FindRole(const std::string& folder, const std::string& base)
{
  if (folder.empty())
  {
    return base == "positions" ? vtkTRXArray::POSITIONS
      : base == "offsets"      ? vtkTRXArray::OFFSETS
                               : vtkTRXArray::UNKNOWN;
  }
  const bool isGroupFolder =
    folder.compare(0, 4, "dpg/") == 0 && folder.find('/', 4) == std::string::npos;
  return folder == "dpv" ? vtkTRXArray::POINT_DATA
    : folder == "dps"    ? vtkTRXArray::LINE_DATA
    : folder == "groups" ? vtkTRXArray::GROUP
    : isGroupFolder      ? vtkTRXArray::GROUP_DATA
                         : vtkTRXArray::UNKNOWN;
}

//------------------------------------------------------------------------------
// Cut the text behind the last `separator` off `text`, which keeps what is before; "" if none.
std::string CutBehind(std::string& text, char separator)
{
  const auto place = text.rfind(separator);
  if (place == std::string::npos)
  {
    return "";
  }
  const std::string behind = text.substr(place + 1);
  text.resize(place);
  return behind;
}
}

//------------------------------------------------------------------------------
vtkTRXArray::vtkTRXArray(const std::string& fileName, std::uint64_t bytes)
  : FileName(fileName)
{
  const auto slash = fileName.rfind('/');
  const std::string folder = slash == std::string::npos ? "" : fileName.substr(0, slash);
  std::string base = slash == std::string::npos ? fileName : fileName.substr(slash + 1);

  this->Role = FindRole(folder, base.substr(0, base.find('.')));
  const std::string typeName = CutBehind(base, '.');
  const bool isNote = typeName == "json" && (this->Role != UNKNOWN || fileName == "header.json");
  this->Role = isNote ? NOTE : this->Role;
  if (!this->IsArray())
  {
    return;
  }

  this->ValueType = std::find_if(
    std::begin(Types), std::end(Types), [&](const Type& type) { return typeName == type.Name; });
  this->RequireType("int8 to int64, uint8 to uint64, float16, float32, float64 or bit",
    this->ValueType != std::end(Types));
  std::string name = base;
  const std::string number = CutBehind(name, '.');
  const bool isNumber =
    !number.empty() && number.find_first_not_of("0123456789") == std::string::npos;
  if (isNumber)
  {
    base = name;
    this->Components = number.size() < 6 ? std::atoi(number.c_str()) : 0;
  }
  if (this->Components < 1)
  {
    throw vtkTrajectoryFileError(
      "\"" + fileName + "\" in it: expected 1 to 99999 components, found " + number);
  }

  const std::uint64_t tupleSize = std::uint64_t(this->ValueType->Size) * this->Components;
  this->Tuples = bytes / tupleSize;
  if (bytes % tupleSize != 0)
  {
    throw vtkTrajectoryFileError("\"" + fileName + "\" in it: expected tuples of " +
      std::to_string(tupleSize) + " bytes, found " + std::to_string(bytes) + " bytes");
  }
  const int id = this->ValueType->Id;
  switch (this->Role)
  {
    case POSITIONS:
      this->RequireType("float16, float32 or float64, with 3 components",
        (id == VTK_FLOAT || id == VTK_DOUBLE) && this->Components == 3);
      break;
    case OFFSETS:
      this->RequireType("uint32 or uint64, with 1 component",
        (id == VTK_TYPE_UINT32 || id == VTK_TYPE_UINT64) && this->Components == 1);
      break;
    case GROUP:
      this->RequireType("an integer, with 1 component",
        id != VTK_FLOAT && id != VTK_DOUBLE && this->Components == 1);
      break;
    case GROUP_DATA:
      // One tuple, even where the name does not tell how many components it has.
      if (this->Tuples < 1 || this->Tuples > 99999u / this->Components)
      {
        throw vtkTrajectoryFileError("\"" + fileName +
          "\" in it: expected 1 to 99999 values, found " + std::to_string(bytes) + " bytes");
      }
      this->Components *= static_cast<int>(this->Tuples);
      this->Tuples = 1;
      break;
    default:
      break;
  }
  this->Name = this->Role == GROUP || this->Role == GROUP_DATA ? folder + "/" + base : base;
}

//------------------------------------------------------------------------------
void vtkTRXArray::RequireType(const std::string& expected, bool isExpected) const
{
  if (!isExpected)
  {
    throw vtkTrajectoryFileError("\"" + this->FileName + "\" in it: expected the type " + expected +
      "; the end of the name tells it");
  }
}

//------------------------------------------------------------------------------
void vtkTRXArray::RequireTuples(std::uint64_t tuples) const
{
  if (this->Tuples != tuples)
  {
    throw vtkTrajectoryFileError("\"" + this->FileName + "\" in it: expected " +
      std::to_string(tuples) + " tuples, which header.json tells, found " +
      std::to_string(this->Tuples));
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkTRXArray::Read(
  const std::function<bool(char*, std::uint64_t)>& read) const
{
  auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(this->ValueType->Id));
  array->SetName(this->Name.c_str());
  array->SetNumberOfComponents(this->Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(this->Tuples));
  const auto count = static_cast<std::size_t>(array->GetNumberOfValues());
  const unsigned int size = this->ValueType->Size;
  const bool isHalf = this->ValueType->Id == VTK_FLOAT && size == 2;
  std::vector<std::uint16_t> halves(isHalf ? count : 0);
  void* values = isHalf ? static_cast<void*>(halves.data()) : array->GetVoidPointer(0);
  if (!read(static_cast<char*>(values), std::uint64_t(count) * size))
  {
    return nullptr;
  }
  SwapFromLittleEndian(values, count, size);
  if (isHalf)
  {
    auto* floats = vtkFloatArray::SafeDownCast(array);
    std::transform(halves.begin(), halves.end(), floats->GetPointer(0), FromHalf);
  }
  return array;
}

VTK_ABI_NAMESPACE_END
