// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkNetCDFFile.h"

#include "vtkNetCDFHeader.h"
#include "vtkTrajectoryFileError.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtk_netcdf.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// The greatest ratio of deflate, the densest of the usual filters.
constexpr double GreatestCompression = 1032.0;

// Attributes longer than this are not what they are read for: names, units, numbers.
constexpr std::size_t GreatestAttribute = 65536;

constexpr std::size_t ListedVariables = 20;

//------------------------------------------------------------------------------
void Check(int status, const std::string& what)
{
  if (status != NC_NOERR)
  {
    throw vtkTrajectoryFileError(what + ": the NetCDF library says '" + nc_strerror(status) + "'",
      vtkErrorCode::FileFormatError);
  }
}

//------------------------------------------------------------------------------
bool IsNumeric(nc_type type)
{
  return type >= NC_BYTE && type <= NC_UINT64 && type != NC_CHAR;
}

//------------------------------------------------------------------------------
// What the library fills unwritten values with; none for bytes, of which every value may be meant.
std::vector<double> GetDefaultFill(nc_type type)
{
  switch (type)
  {
    case NC_SHORT:
      return { NC_FILL_SHORT };
    case NC_USHORT:
      return { NC_FILL_USHORT };
    case NC_INT:
      return { NC_FILL_INT };
    case NC_UINT:
      return { NC_FILL_UINT };
    case NC_INT64:
      return { static_cast<double>(NC_FILL_INT64) };
    case NC_UINT64:
      return { static_cast<double>(NC_FILL_UINT64) };
    case NC_FLOAT:
      return { NC_FILL_FLOAT };
    case NC_DOUBLE:
      return { NC_FILL_DOUBLE };
    default:
      return {};
  }
}

//------------------------------------------------------------------------------
template <typename Value>
Value Narrow(double value)
{
  using Limits = std::numeric_limits<Value>;
  return std::abs(value) > static_cast<double>(Limits::max())
    ? static_cast<Value>(std::copysign(Limits::infinity(), value))
    : static_cast<Value>(value);
}

//------------------------------------------------------------------------------
std::string Trim(const std::string& text)
{
  constexpr const char* blanks = " \t\r\n\v\f";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

//------------------------------------------------------------------------------
double GetFirst(const std::vector<double>& numbers, double otherwise)
{
  return numbers.empty() ? otherwise : numbers[0];
}
}

//------------------------------------------------------------------------------
vtkNetCDFFile::vtkNetCDFFile(const std::string& fileName)
  : FileLength(vtkNetCDFHeader::Check(fileName))
{
  Check(nc_open(fileName.c_str(), NC_NOWRITE, &this->Id), "the file cannot be opened");
  int count = 0;
  nc_inq_nvars(this->Id, &count);
  for (int id = 0; id < count; ++id)
  {
    char name[NC_MAX_NAME + 1] = "";
    nc_type type = NC_NAT;
    int rank = 0;
    if (nc_inq_var(this->Id, id, name, &type, &rank, nullptr, nullptr) == NC_NOERR &&
      IsNumeric(type))
    {
      std::vector<int> dimensions(rank);
      nc_inq_vardimid(this->Id, id, dimensions.data());
      this->Variables.push_back({ id, name, type, dimensions });
    }
  }
}

//------------------------------------------------------------------------------
vtkNetCDFFile::~vtkNetCDFFile()
{
  nc_close(this->Id);
}

//------------------------------------------------------------------------------
std::size_t vtkNetCDFFile::GetLength(int dimension) const
{
  std::size_t length = 0;
  Check(nc_inq_dimlen(this->Id, dimension, &length), "a dimension cannot be read");
  return length;
}

//------------------------------------------------------------------------------
std::string vtkNetCDFFile::GetDimensionName(int dimension) const
{
  char name[NC_MAX_NAME + 1] = "";
  Check(nc_inq_dimname(this->Id, dimension, name), "a dimension cannot be read");
  return name;
}

//------------------------------------------------------------------------------
std::string vtkNetCDFFile::ListVariables() const
{
  std::string list;
  for (std::size_t i = 0; i < std::min(this->Variables.size(), ListedVariables); ++i)
  {
    list += (i == 0 ? "" : ", ") + this->Variables[i].Name + "(";
    for (std::size_t k = 0; k < this->Variables[i].Dimensions.size(); ++k)
    {
      list += (k == 0 ? "" : ", ") + this->GetDimensionName(this->Variables[i].Dimensions[k]);
    }
    list += ")";
  }
  return this->Variables.empty()               ? "none"
    : this->Variables.size() > ListedVariables ? list + ", ..."
                                               : list;
}

//------------------------------------------------------------------------------
std::string vtkNetCDFFile::GetText(int variable, const char* attribute) const
{
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(this->Id, variable, attribute, &type, &length) != NC_NOERR || length == 0 ||
    length > GreatestAttribute)
  {
    return "";
  }
  std::string text;
  if (type == NC_CHAR)
  {
    text.resize(length);
    Check(nc_get_att_text(this->Id, variable, attribute, &text[0]), "an attribute cannot be read");
    text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
  }
  else if (type == NC_STRING)
  {
    std::vector<char*> strings(length, nullptr);
    Check(nc_get_att_string(this->Id, variable, attribute, strings.data()),
      "an attribute cannot be read");
    text = strings[0] ? strings[0] : "";
    nc_free_string(length, strings.data());
  }
  return Trim(text);
}

//------------------------------------------------------------------------------
std::vector<double> vtkNetCDFFile::GetNumbers(int variable, const char* attribute) const
{
  nc_type type = NC_NAT;
  std::size_t length = 0;
  if (nc_inq_att(this->Id, variable, attribute, &type, &length) != NC_NOERR || !IsNumeric(type) ||
    length > GreatestAttribute)
  {
    return {};
  }
  std::vector<double> numbers(length);
  Check(nc_get_att_double(this->Id, variable, attribute, numbers.data()),
    "an attribute cannot be read");
  return numbers;
}

//------------------------------------------------------------------------------
void vtkNetCDFFile::CheckSize(const std::vector<Variable>& variables) const
{
  const double limit = GreatestCompression * static_cast<double>(this->FileLength);
  double size = 0.0;
  for (const Variable& variable : variables)
  {
    std::size_t typeSize = 0;
    Check(nc_inq_type(this->Id, variable.Type, nullptr, &typeSize), "a type cannot be read");
    double variableSize = static_cast<double>(typeSize);
    for (const int dimension : variable.Dimensions)
    {
      variableSize *= static_cast<double>(this->GetLength(dimension));
    }
    size += variableSize;

    std::vector<std::size_t> chunk(variable.Dimensions.size(), 1);
    int storage = NC_CONTIGUOUS;
    nc_inq_var_chunking(this->Id, variable.Id, &storage, chunk.data());
    const double chunkSize = storage == NC_CHUNKED
      ? std::accumulate(
          chunk.begin(), chunk.end(), static_cast<double>(typeSize), std::multiplies<double>())
      : 0.0;
    if (size > limit || chunkSize > limit)
    {
      throw vtkTrajectoryFileError("the file claims more than it can hold: " +
        vtkNetCDFHeader::FormatSize(std::max(size, chunkSize)) + " bytes up to its variable '" +
        variable.Name + "', in a file of " + std::to_string(this->FileLength) + " bytes");
    }
  }
}

//------------------------------------------------------------------------------
template <typename Array, typename ReadFunction>
vtkSmartPointer<vtkDataArray> vtkNetCDFFile::ReadAs(ReadFunction read, const Variable& variable,
  const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
  const std::vector<double>& missing) const
{
  using Value = typename Array::ValueType;
  const auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfValues(std::accumulate(
    count.begin(), count.end(), vtkIdType(1), [](vtkIdType a, std::size_t b) { return a * b; }));
  if (array->GetNumberOfValues() == 0)
  {
    return array;
  }
  Value* begin = array->GetPointer(0);
  Value* end = begin + array->GetNumberOfValues();
  Check(read(this->Id, variable.Id, start.data(), count.data(), begin),
    "the variable '" + variable.Name + "' cannot be read");

  const double scale = GetFirst(this->GetNumbers(variable.Id, "scale_factor"), 1.0);
  const double offset = GetFirst(this->GetNumbers(variable.Id, "add_offset"), 0.0);
  const bool isPacked = scale != 1.0 || offset != 0.0;
  std::vector<Value> marks(missing.size());
  std::transform(missing.begin(), missing.end(), marks.begin(), Narrow<Value>);
  std::transform(begin, end, begin,
    [&](Value value)
    {
      if (std::find(marks.begin(), marks.end(), value) != marks.end())
      {
        return std::numeric_limits<Value>::quiet_NaN();
      }
      return isPacked ? Narrow<Value>(scale * value + offset) : value;
    });
  return array;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> vtkNetCDFFile::Read(const Variable& variable,
  const std::vector<std::size_t>& start, const std::vector<std::size_t>& count,
  std::vector<double> missing) const
{
  auto fill = this->GetNumbers(variable.Id, "_FillValue");
  fill = fill.empty() ? GetDefaultFill(variable.Type) : fill;
  const auto marks = this->GetNumbers(variable.Id, "missing_value");
  missing.insert(missing.end(), fill.begin(), fill.end());
  missing.insert(missing.end(), marks.begin(), marks.end());

  const bool isSingle = variable.Type == NC_FLOAT || variable.Type == NC_BYTE ||
    variable.Type == NC_UBYTE || variable.Type == NC_SHORT || variable.Type == NC_USHORT;
  return isSingle
    ? this->ReadAs<vtkFloatArray>(nc_get_vara_float, variable, start, count, missing)
    : this->ReadAs<vtkDoubleArray>(nc_get_vara_double, variable, start, count, missing);
}

VTK_ABI_NAMESPACE_END
