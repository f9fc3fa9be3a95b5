// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkLagrantoText.h"

#include "vtkArrayNames.h"
#include "vtkLagrantoConventions.h"
#include "vtkTrajectoryFileError.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
constexpr std::string_view Blanks = " \t\r\v\f";

//------------------------------------------------------------------------------
// Takes the next word from a line; empty at its end.
std::string_view TakeWord(std::string_view& line)
{
  line.remove_prefix(std::min(line.find_first_not_of(Blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(Blanks));
  line.remove_prefix(word.size());
  return word;
}

//------------------------------------------------------------------------------
bool IsBlank(std::string_view line)
{
  return line.find_first_not_of(Blanks) == std::string_view::npos;
}

//------------------------------------------------------------------------------
class LineReader
{
public:
  explicit LineReader(std::string_view text)
    : Text(text)
  {
  }

  bool Next(std::string_view& line)
  {
    if (this->Position >= this->Text.size())
    {
      return false;
    }
    const std::size_t end = std::min(this->Text.find('\n', this->Position), this->Text.size());
    line = this->Text.substr(this->Position, end - this->Position);
    this->Position = end + 1;
    ++this->Number;
    return true;
  }

  /** Of the last line, from 1. */
  std::size_t GetNumber() const { return this->Number; }

  double GetProgress() const
  {
    return static_cast<double>(this->Position) / static_cast<double>(this->Text.size());
  }

private:
  std::string_view Text;
  std::size_t Position = 0;
  std::size_t Number = 0;
};

//------------------------------------------------------------------------------
struct Header
{
  std::string_view Title; // the first line
  std::vector<std::string> Columns;
};

//------------------------------------------------------------------------------
// Up to the line of dashes; without columns if there are no such lines.
Header ReadHeader(LineReader& lines)
{
  Header header;
  std::string_view line;
  std::string_view last;
  while (lines.Next(line))
  {
    if (IsBlank(line))
    {
      continue;
    }
    if (line.find_first_not_of("- \t\r") == std::string_view::npos)
    {
      for (std::string_view name = TakeWord(last); !name.empty(); name = TakeWord(last))
      {
        header.Columns.emplace_back(name);
      }
      break;
    }
    header.Title = header.Title.empty() ? line : header.Title;
    last = line;
  }
  const auto begins = [&header](std::size_t column, const char* name)
  { return vtksys::SystemTools::LowerCase(header.Columns[column]).rfind(name, 0) == 0; };
  if (header.Columns.size() < 4 || header.Columns.size() > vtkArrayNames::GreatestNumber ||
    !begins(0, "time") || !begins(1, "lon") || !begins(2, "lat"))
  {
    header.Columns.clear();
  }
  return header;
}

//------------------------------------------------------------------------------
// Digits in a fixed field of a title, where blanks stand for leading zeros; -1: none.
double ReadField(std::string_view title, std::size_t position, std::size_t length)
{
  std::string_view field = title.substr(std::min(position, title.size()), length);
  field.remove_prefix(std::min(field.find_first_not_of(' '), field.size()));
  int number = -1;
  const auto result = std::from_chars(field.data(), field.data() + field.size(), number);
  return result.ptr == field.data() + field.size() ? number : -1;
}

//------------------------------------------------------------------------------
// "Reference date 20110123_1000 / Time range -14400 min", and in older files
// "time period 2006 131 18 UTC -120.00 h".
struct Title
{
  std::string TimeUnits = "hours";
  bool HasMinutes = true; // the times are hh.mm

  explicit Title(std::string_view text)
  {
    constexpr std::string_view old = "time period ";
    constexpr std::string_view current = "Reference date ";
    text.remove_prefix(std::min(text.find_first_not_of(Blanks), text.size()));
    this->HasMinutes = text.substr(0, old.size()) != old;
    if (!this->HasMinutes || text.substr(0, current.size()) == current)
    {
      const std::size_t date = this->HasMinutes ? current.size() : old.size();
      this->TimeUnits = vtkLagrantoConventions::GetTimeUnits(ReadField(text, date, 4),
        ReadField(text, date + 4, 2), ReadField(text, date + 6, 2), ReadField(text, date + 9, 2),
        this->HasMinutes ? ReadField(text, date + 11, 2) : 0);
    }
  }
};

//------------------------------------------------------------------------------
// A number beyond the range of doubles, which std::from_chars does not read. Closer to 0 than any
// of them it is 0; too large, the largest of them.
double ReadOutOfRange(std::string_view word)
{
  std::istringstream stream{ std::string(word) };
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  return number;
}

//------------------------------------------------------------------------------
// NaN for a missing value, also for the asterisks that Fortran writes where a number is too long.
bool ReadNumber(std::string_view word, double& number)
{
  if (word.find_first_not_of('*') == std::string_view::npos)
  {
    number = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  word.remove_prefix(word[0] == '+' ? 1 : 0);
  const auto result = std::from_chars(word.data(), word.data() + word.size(), number);
  if (result.ec == std::errc::result_out_of_range)
  {
    number = ReadOutOfRange(word);
  }
  if (number == vtkLagrantoConventions::MissingValue)
  {
    number = std::numeric_limits<double>::quiet_NaN();
  }
  return result.ec != std::errc::invalid_argument && result.ptr == word.data() + word.size() &&
    (!std::isfinite(number) || std::abs(number) <= std::numeric_limits<float>::max());
}
}

//------------------------------------------------------------------------------
bool vtkLagrantoText::CanRead(std::string_view text)
{
  LineReader lines(text);
  return !ReadHeader(lines).Columns.empty();
}

//------------------------------------------------------------------------------
vtkLagrantoText::vtkLagrantoText(std::string_view text, const Progress& progress)
  : Blocks(std::make_shared<std::vector<vtkIdType>>(1, 0))
{
  LineReader lines(text);
  const Header header = ReadHeader(lines);
  if (header.Columns.empty())
  {
    throw vtkTrajectoryFileError("is not LAGRANTO's text format: expected the names of columns, "
                                 "beginning with time lon lat, above a line of dashes",
      vtkErrorCode::UnrecognizedFileTypeError);
  }
  vtkArrayNames names;
  names.Take("time");
  for (std::size_t column = 1; column < header.Columns.size(); ++column)
  {
    const std::string name = names.Take(header.Columns[column]);
    this->Variables.push_back({ name, "", vtkLagrantoConventions::GetUnits(name), false });
  }
  const Title title(header.Title);
  this->TimeUnits = title.TimeUnits;

  std::string_view line;
  double nextProgress = 0.01;
  while (lines.Next(line))
  {
    if (!IsBlank(line))
    {
      this->ReadRow(line, lines.GetNumber());
    }
    else if (this->Blocks->back() != this->Times->GetNumberOfValues())
    {
      this->Blocks->push_back(this->Times->GetNumberOfValues());
    }
    if (lines.GetProgress() >= nextProgress)
    {
      nextProgress = lines.GetProgress() + 0.01;
      if (!progress(lines.GetProgress()))
      {
        return;
      }
    }
  }
  if (this->Blocks->back() != this->Times->GetNumberOfValues())
  {
    this->Blocks->push_back(this->Times->GetNumberOfValues());
  }
  if (this->GetNumberOfBlocks() == 0)
  {
    throw vtkTrajectoryFileError(
      "the file holds no positions: its header is complete, but no row of numbers follows",
      vtkErrorCode::PrematureEndOfFileError);
  }
  this->FindOrder();
  if (title.HasMinutes)
  {
    this->TimeWarning = vtkLagrantoConventions::ConvertToHours(this->Times);
  }
}

//------------------------------------------------------------------------------
void vtkLagrantoText::ReadRow(std::string_view line, std::size_t lineNumber)
{
  std::size_t column = 0;
  for (std::string_view word = TakeWord(line); !word.empty(); word = TakeWord(line), ++column)
  {
    double number = 0.0;
    if (column <= this->Variables.size() && !ReadNumber(word, number))
    {
      const std::string name = column == 0 ? "time" : this->Variables[column - 1].Name;
      throw vtkTrajectoryFileError("line " + std::to_string(lineNumber) +
        ": expected a number for '" + name + "', found '" + std::string(word.substr(0, 40)) + "'");
    }
    if (column == 0)
    {
      this->Times->InsertNextValue(number);
    }
    else if (column <= this->Variables.size())
    {
      this->Values->InsertNextValue(static_cast<float>(number));
    }
  }
  if (column != this->Variables.size() + 1)
  {
    throw vtkTrajectoryFileError("line " + std::to_string(lineNumber) + ": expected " +
      std::to_string(this->Variables.size() + 1) + " columns as the header names, found " +
      std::to_string(column));
  }
}

//------------------------------------------------------------------------------
// Files are sorted by trajectories or, then all rows of a block have the same time, by times.
void vtkLagrantoText::FindOrder()
{
  const std::vector<vtkIdType>& blocks = *this->Blocks;
  const auto isOfOneTime = [&](vtkIdType block)
  {
    const double* times = this->Times->GetPointer(0);
    return std::all_of(times + blocks[block], times + blocks[block + 1],
      [&](double time) { return time == times[blocks[block]]; });
  };
  const vtkIdType size = blocks[1];
  this->IsByTime = size > 1 && isOfOneTime(0);
  for (vtkIdType block = 1; this->IsByTime && block < this->GetNumberOfBlocks(); ++block)
  {
    const vtkIdType found = blocks[block + 1] - blocks[block];
    if (found != size || !isOfOneTime(block))
    {
      throw vtkTrajectoryFileError("the file is sorted by times, as its first " +
        std::to_string(size) + " rows are, but time " + std::to_string(block) + " has " +
        std::to_string(found) + " rows or differing times");
    }
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkLagrantoText::GetNumberOfTrajectories() const
{
  return this->IsByTime ? (*this->Blocks)[1] : this->GetNumberOfBlocks();
}

//------------------------------------------------------------------------------
vtkIdType vtkLagrantoText::GetNumberOfSamples(vtkIdType trajectory) const
{
  return this->IsByTime ? this->GetNumberOfBlocks()
                        : (*this->Blocks)[trajectory + 1] - (*this->Blocks)[trajectory];
}

//------------------------------------------------------------------------------
vtkTrajectorySource::Samples vtkLagrantoText::MakeSamples(
  vtkDataArray* values, vtkIdType columns, vtkIdType column) const
{
  if (this->IsByTime)
  {
    return { values, columns, columns * this->GetNumberOfTrajectories(), column };
  }
  Samples samples(values, columns, columns, column);
  samples.SetStarts(this->Blocks);
  return samples;
}

//------------------------------------------------------------------------------
vtkTrajectorySource::Samples vtkLagrantoText::Read(std::size_t variable, int)
{
  return this->MakeSamples(
    this->Values, static_cast<vtkIdType>(this->Variables.size()), static_cast<vtkIdType>(variable));
}

//------------------------------------------------------------------------------
vtkTrajectorySource::Samples vtkLagrantoText::ReadTimes()
{
  return this->MakeSamples(this->Times, 1, 0);
}

VTK_ABI_NAMESPACE_END
