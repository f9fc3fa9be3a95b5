// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Reports.h"

#include "PlainText.h"
#include "RenderError.h"
#include "ResultFile.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace pellucid
{
namespace benchmark
{
namespace
{
using Json = nlohmann::ordered_json;

//------------------------------------------------------------------------------
template <typename Value>
Json ToJson(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json();
}

//------------------------------------------------------------------------------
// One key for each column; numbers that are not finite are written as null.
Json ToJson(const Row& row)
{
  Json stages = Json::object();
  for (const auto& [name, milliseconds] : row.Stages)
  {
    stages[name] = milliseconds;
  }
  const auto& error = row.Error;
  return {
    { "scene", row.Scene },
    { "method", row.Method },
    { "family", row.Family },
    { "parameter", ToJson(row.Parameter) },
    { "shape", row.Shape },
    { "width", row.Width },
    { "height", row.Height },
    { "alpha", row.Opacity },
    { "segments", row.Segments },
    { "optimized", row.HasOptimizedOpacities },
    { "fragments", ToJson(row.Fragments) },
    { "longest_list", ToJson(row.LongestList) },
    { "frames", row.Milliseconds.size() },
    { "cold", row.IsCold },
    { "interleaved", row.IsInterleaved },
    { "median_ms", row.GetMedian() },
    { "min_ms", row.GetTime(0.0) },
    { "lower_quartile_ms", row.GetTime(0.25) },
    { "upper_quartile_ms", row.GetTime(0.75) },
    { "max_ms", row.GetTime(1.0) },
    { "stages", stages },
    { "bytes", ToJson(row.Bytes) },
    { "buffer_bytes", ToJson(row.BufferBytes) },
    { "rmse", error ? Json(error->RootMeanSquare) : Json() },
    { "max_error", error ? Json(error->Maximum) : Json() },
    { "psnr", error ? Json(error->PeakSignalToNoise) : Json() },
    { "ssim", error ? Json(error->StructuralSimilarity) : Json() },
    { "rmse_covered", error ? Json(error->Covered.RootMeanSquare) : Json() },
    { "rmse_all_pixels", error ? Json(error->All.RootMeanSquare) : Json() },
    { "max_error_all_pixels", error ? Json(error->All.Maximum) : Json() },
    { "covered_pixels", error ? Json(error->CoveredPixels) : Json() },
    { "edge_pixels", error ? Json(error->EdgePixels) : Json() },
    { "order_pixels", error ? Json(error->OrderPixels) : Json() },
    { "skipped", row.Skipped.empty() ? Json() : Json(row.Skipped) },
    { "on_front", row.IsOnFront },
  };
}

//------------------------------------------------------------------------------
Json ToJson(const std::vector<Row>& rows)
{
  Json list = Json::array();
  for (const Row& row : rows)
  {
    list.push_back(ToJson(row));
  }
  return list;
}

//------------------------------------------------------------------------------
// RFC 4180, where it is needed.
std::string Quote(const std::string& text)
{
  if (text.find_first_of(",;\"\n") == std::string::npos)
  {
    return text;
  }
  std::ostringstream quoted;
  quoted << std::quoted(text, '"', '"');
  return quoted.str();
}

//------------------------------------------------------------------------------
// Numbers as the JSON file has them, "inf", "a=1;b=2" for an object, nothing for null.
std::string ToCsv(const Json& value)
{
  if (value.is_number_float() && std::isinf(value.get<double>()))
  {
    return "inf";
  }
  if (value.is_object())
  {
    std::string text;
    for (const auto& [name, number] : value.items())
    {
      text += (text.empty() ? "" : ";") + name + "=" + number.dump();
    }
    return text;
  }
  if (value.is_string())
  {
    return Quote(value.get<std::string>());
  }
  const std::string text = value.dump();
  return text == "null" ? "" : text;
}

//------------------------------------------------------------------------------
std::string ToFixed(double value, int digits)
{
  if (!std::isfinite(value))
  {
    return std::isnan(value) ? "" : "inf";
  }
  std::ostringstream text;
  text << std::fixed;
  text.precision(digits);
  text << value;
  return text.str();
}

//------------------------------------------------------------------------------
// Three significant digits.
std::string ToMilliseconds(double value)
{
  return ToFixed(value, value < 10.0 ? 2 : value < 100.0 ? 1 : 0);
}

//------------------------------------------------------------------------------
std::string ToMebibytes(const std::optional<vtkIdType>& bytes)
{
  return bytes ? ToFixed(*bytes / 1048576.0, 1) : "";
}

//------------------------------------------------------------------------------
std::string ToText(const std::optional<vtkIdType>& count)
{
  return count ? std::to_string(*count) : "";
}

//------------------------------------------------------------------------------
bool HaveSameTable(const Row& a, const Row& b)
{
  return a.Scene == b.Scene && a.Width == b.Width && a.Height == b.Height && a.Opacity == b.Opacity;
}

//------------------------------------------------------------------------------
// Two columns.
std::string DescribeTime(const Row& row)
{
  if (row.Milliseconds.empty())
  {
    return "skipped | ";
  }
  return ToMilliseconds(row.GetMedian()) +
    (row.IsCold
        ? " | cold"
        : " | " + ToMilliseconds(row.GetTime(0.25)) + " - " + ToMilliseconds(row.GetTime(0.75)));
}

//------------------------------------------------------------------------------
std::string DescribeExponent(double exponent)
{
  return std::isnan(exponent) ? "unknown" : ToFixed(exponent, 2);
}

//------------------------------------------------------------------------------
void WriteRow(std::ostream& file, const Row& row)
{
  file << "| " << (row.IsOnFront ? "**" + row.Method + "**" : row.Method) << " | "
       << DescribeTime(row) << " | " << ToText(row.Fragments) << " | " << ToMebibytes(row.Bytes)
       << " | ";
  if (row.Error)
  {
    file << ToFixed(row.Error->RootMeanSquare, 2) << " | " << ToFixed(row.Error->Maximum, 0)
         << " | " << ToFixed(row.Error->PeakSignalToNoise, 1) << " | "
         << ToFixed(row.Error->StructuralSimilarity, 4) << " | "
         << ToFixed(100.0 * row.Error->EdgePixels / row.Error->CoveredPixels, 1) << " |\n";
  }
  else
  {
    file << "| | | | |\n";
  }
}

//------------------------------------------------------------------------------
void WriteSeries(std::ostream& file, const Series& series)
{
  file << "\n`" << series.Method << "` over " << series.Over << ": exponent of time "
       << DescribeExponent(series.TimeExponent) << ", of memory "
       << DescribeExponent(series.MemoryExponent) << ".\n\n"
       << "| window | segments | fragments | longest list | ms | MiB |\n"
       << "| --- | --- | --- | --- | --- | --- |\n";
  for (const Row& row : series.Rows)
  {
    file << "| " << row.Width << "x" << row.Height << " | " << row.Segments << " | "
         << ToText(row.Fragments) << " | " << ToText(row.LongestList) << " | "
         << ToMilliseconds(row.GetMedian()) << " | " << ToMebibytes(row.BufferBytes) << " |\n";
  }
}

//------------------------------------------------------------------------------
template <typename Write>
void WriteFile(const std::string& fileName, Write write)
{
  ReplaceFile(fileName,
    [&write](const std::string& newName)
    {
      std::ofstream file(newName);
      write(file);
      if (!file.flush())
      {
        throw RenderError(newName + ": cannot be written");
      }
    });
}
}

//------------------------------------------------------------------------------
void WriteJson(const Figures& figures, const std::string& fileName)
{
  const Machine& machine = figures.Where;
  Json document = {
    { "machine",
      { { "date", machine.Date }, { "pellucid", machine.Pellucid },
        { "renderer", machine.Renderer }, { "opengl", machine.OpenGL }, { "vtk", machine.VTK },
        { "processor", machine.Processor }, { "threads", machine.Threads } } },
    { "rows", ToJson(figures.Rows) },
  };
  for (const Series& series : figures.Scaling)
  {
    document["scaling"].push_back({ { "method", series.Method }, { "over", series.Over },
      { "time_exponent", series.TimeExponent }, { "memory_exponent", series.MemoryExponent },
      { "rows", ToJson(series.Rows) } });
  }
  WriteFile(fileName, [&document](std::ostream& file) { file << document.dump(2) << "\n"; });
}

//------------------------------------------------------------------------------
void WriteCsv(const Figures& figures, const std::string& fileName)
{
  WriteFile(fileName,
    [&figures](std::ostream& file)
    {
      std::vector<Row> rows = figures.Rows;
      for (const Series& series : figures.Scaling)
      {
        rows.insert(rows.end(), series.Rows.begin(), series.Rows.end());
      }
      const char* separator = "";
      const Json columns = ToJson(Row());
      for (const auto& column : columns.items())
      {
        file << separator << column.key();
        separator = ",";
      }
      for (const Row& row : rows)
      {
        separator = "\n";
        const Json values = ToJson(row);
        for (const auto& column : values.items())
        {
          file << separator << ToCsv(column.value());
          separator = ",";
        }
      }
      file << "\n";
    });
}

//------------------------------------------------------------------------------
void WriteTables(const Figures& figures, const std::string& fileName)
{
  WriteFile(fileName, [&figures](std::ostream& file) { PrintTables(figures, file); });
}

//------------------------------------------------------------------------------
void PrintTables(const Figures& figures, std::ostream& stream)
{
  const Machine& machine = figures.Where;
  stream
    << machine.Date << ", Pellucid " << machine.Pellucid << ", " << machine.Renderer << ", VTK "
    << machine.VTK << ", " << machine.Processor << ", " << machine.Threads
    << " threads. Bold: no other method is as fast with an error as small. Left out: pixels at "
       "edges or of no order, which errors say nothing of, as a part of those with anything "
       "translucent.\n";
  const Row* previous = nullptr;
  for (const Row& row : figures.Rows)
  {
    if (!previous || !HaveSameTable(row, *previous))
    {
      stream << "\n"
             << row.Scene << ", " << row.Width << "x" << row.Height << ", opacity "
             << pellucid::ToText(row.Opacity) << ":\n\n"
             << "| method | ms | quartiles | fragments | MiB | RMSE | max | PSNR, dB | SSIM | left "
                "out, % |\n"
             << "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    }
    WriteRow(stream, row);
    previous = &row;
  }
  for (const Series& series : figures.Scaling)
  {
    WriteSeries(stream, series);
  }
}
}
}
