// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ArrayTable.h"

#include "PlainText.h"
#include "SceneArrays.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>

namespace pellucid
{
namespace
{
constexpr std::size_t Columns = 8;
using Row = std::array<std::string, Columns>;

const Row Titles = { "name", "on", "components", "minimum", "maximum", "unit", "missing", "from" };

//------------------------------------------------------------------------------
struct Summary
{
  double Minimum = std::numeric_limits<double>::infinity(); // of the finite values
  double Maximum = -std::numeric_limits<double>::infinity();
  vtkIdType Missing = 0;

  void Add(vtkDataArray* array)
  {
    for (vtkIdType id = 0; id < array->GetNumberOfTuples(); ++id)
    {
      const double value = GetNumber(array, id);
      if (std::isfinite(value))
      {
        this->Minimum = std::min(this->Minimum, value);
        this->Maximum = std::max(this->Maximum, value);
      }
      else
      {
        ++this->Missing;
      }
    }
  }
};

//------------------------------------------------------------------------------
Row MakeRow(const SceneArray& array)
{
  vtkDataArray* first = array.Parts.front();
  Summary summary;
  for (vtkDataArray* part : array.Parts)
  {
    summary.Add(part);
  }
  const auto toText = [&](double value)
  {
    return summary.Minimum > summary.Maximum ? "-"
      : first->GetDataType() == VTK_FLOAT    ? ToText(static_cast<float>(value))
                                             : ToText(value);
  };
  const char* unit =
    first->HasInformation() ? first->GetInformation()->Get(vtkDataArray::UNITS_LABEL()) : nullptr;
  return { MakePrintable(array.Name), array.Place, std::to_string(first->GetNumberOfComponents()),
    toText(summary.Minimum), toText(summary.Maximum), unit && *unit ? MakePrintable(unit) : "-",
    std::to_string(summary.Missing), array.IsComputed ? "computed" : "input" };
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
  bool hasMap = false;
  for (const Drawable& drawable : drawables)
  {
    stream << MakePrintable(drawable.Name) << ": " << drawable.GetNumberOfPoints() << " points, "
           << drawable.GetNumberOfLines() << " lines\n";
    hasMap = hasMap || drawable.IsMap;
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
  if (hasMap)
  {
    stream << "Lengths, velocities and angles that are computed in longitude and latitude, and "
              "without --height\ndifferences of height, are those of the map: in degrees, with z "
              "as --vertical-scale says.\n";
  }
}
}
