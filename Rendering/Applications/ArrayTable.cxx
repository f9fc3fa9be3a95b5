// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ArrayTable.h"

#include "SceneArrays.h"

#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iomanip>

namespace pellucid
{
namespace
{
constexpr std::size_t Columns = 8;
using Row = std::array<std::string, Columns>;

const Row Titles = { "name", "on", "components", "minimum", "maximum", "unit", "missing", "from" };

//------------------------------------------------------------------------------
// The shortest text that gives the number of the array's precision back.
std::string ToText(double value, bool isFloat)
{
  std::array<char, 32> text;
  char* end = text.data() + text.size();
  const auto result = isFloat ? std::to_chars(text.data(), end, static_cast<float>(value))
                              : std::to_chars(text.data(), end, value);
  return { text.data(), result.ptr };
}

//------------------------------------------------------------------------------
vtkIdType CountMissing(vtkDataArray* array)
{
  vtkIdType missing = 0;
  for (const auto tuple : vtk::DataArrayTupleRange(array))
  {
    missing +=
      !std::all_of(tuple.begin(), tuple.end(), [](double value) { return std::isfinite(value); });
  }
  return missing;
}

//------------------------------------------------------------------------------
Row MakeRow(const SceneArray& array)
{
  vtkDataArray* first = array.Parts.front();
  double minimum = VTK_DOUBLE_MAX;
  double maximum = VTK_DOUBLE_MIN;
  vtkIdType missing = 0;
  for (vtkDataArray* part : array.Parts)
  {
    constexpr int length = -1;
    double range[2];
    part->GetFiniteRange(range, length);
    minimum = std::min(minimum, range[0]);
    maximum = std::max(maximum, range[1]);
    missing += CountMissing(part);
  }
  const bool isFloat = first->GetDataType() == VTK_FLOAT;
  const bool isEmpty = minimum > maximum;
  const char* unit =
    first->HasInformation() ? first->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : nullptr;
  return { array.Name, array.Place, std::to_string(first->GetNumberOfComponents()),
    isEmpty ? "-" : ToText(minimum, isFloat), isEmpty ? "-" : ToText(maximum, isFloat),
    unit && *unit ? unit : "-", std::to_string(missing), array.IsComputed ? "computed" : "input" };
}

//------------------------------------------------------------------------------
void WriteRows(std::ostream& stream, const std::vector<Row>& rows)
{
  std::array<std::size_t, Columns> widths = {};
  for (const Row& row : rows)
  {
    std::transform(row.begin(), row.end(), widths.begin(), widths.begin(),
      [](const std::string& text, std::size_t width) { return std::max(text.size(), width); });
  }
  for (const Row& row : rows)
  {
    for (std::size_t column = 0; column + 1 < Columns; ++column)
    {
      stream << std::left << std::setw(static_cast<int>(widths[column])) << row[column] << "  ";
    }
    stream << row.back() << "\n";
  }
}
}

//------------------------------------------------------------------------------
void WriteArrayTable(std::ostream& stream, const std::vector<Drawable>& drawables)
{
  bool hasVectors = false;
  for (const Drawable& drawable : drawables)
  {
    stream << drawable.Name << ": " << drawable.GetNumberOfPoints() << " points, "
           << drawable.GetNumberOfLines() << " lines\n";
    std::vector<Row> rows = { Titles };
    for (const SceneArray& array : GetArrays(drawable))
    {
      rows.push_back(MakeRow(array));
      hasVectors = hasVectors || array.Parts.front()->GetNumberOfComponents() > 1;
    }
    WriteRows(stream, rows);
    stream << "\n";
  }
  if (hasVectors)
  {
    stream << "Of arrays with several components, minimum and maximum are those of the length.\n";
  }
}
}
