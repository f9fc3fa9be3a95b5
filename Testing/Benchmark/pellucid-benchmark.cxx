// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Compares methods to draw translucent geometry; see pellucid-benchmark --help.
 *
 * Exit codes: 0 everything is measured and written, 1 it is not, 2 wrong usage. Errors are one line
 * on the standard error stream.
 */

#include "BenchmarkOptions.h"
#include "Choices.h"
#include "ErrorTimePlot.h"
#include "MessageLog.h"
#include "ParetoFront.h"
#include "PictureFile.h"
#include "PictureWindow.h"
#include "PlainText.h"
#include "Program.h"
#include "Record.h"
#include "RenderError.h"
#include "Reports.h"
#include "ResultFile.h"

#include "vtkVersion.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>
#include <thread>

const char* const pellucid::ProgramName = "pellucid-benchmark";

namespace
{
using namespace pellucid;
using namespace pellucid::benchmark;

//------------------------------------------------------------------------------
std::string GetDate()
{
  const std::time_t now = std::time(nullptr);
  std::ostringstream text;
  text << std::put_time(std::gmtime(&now), "%Y-%m-%dT%H:%M:%SZ");
  return text.str();
}

//------------------------------------------------------------------------------
Machine DescribeMachine()
{
  PictureWindow window({ 1, 1 });
  window.CheckExactTransparency();
  vtksys::SystemInformation system;
  system.RunCPUCheck();
  return { GetDate(), PELLUCID_VERSION, window.GetProperty("OpenGL renderer string"),
    window.GetProperty("OpenGL version string"), vtkVersion::GetVTKVersion(), system.GetModelName(),
    static_cast<int>(std::thread::hardware_concurrency()) };
}

//------------------------------------------------------------------------------
void CheckFiles(const BenchmarkOptions& options)
{
  for (const std::string* file :
    { &options.JsonFile, &options.CsvFile, &options.PlotFile, &options.TableFile })
  {
    if (!file->empty())
    {
      CheckReplaceable(*file);
    }
  }
}

//------------------------------------------------------------------------------
void Tell(const std::string& step)
{
  std::cerr << step << std::endl;
}

//------------------------------------------------------------------------------
// What the plot has a place for.
std::vector<Row> GetComparedRows(const Figures& figures)
{
  std::vector<Row> rows;
  std::copy_if(figures.Rows.begin(), figures.Rows.end(), std::back_inserter(rows),
    [](const Row& row)
    { return row.Error && !std::isnan(row.Error->RootMeanSquare) && !row.Milliseconds.empty(); });
  return rows;
}

//------------------------------------------------------------------------------
// After each scene, so that a long run that is ended keeps what it has measured.
void WriteFiles(const Figures& figures, const BenchmarkOptions& options)
{
  if (!options.JsonFile.empty())
  {
    WriteJson(figures, options.JsonFile);
  }
  if (!options.CsvFile.empty())
  {
    WriteCsv(figures, options.CsvFile);
  }
  if (!options.TableFile.empty())
  {
    WriteTables(figures, options.TableFile);
  }
  if (!options.PlotFile.empty())
  {
    ReplaceFile(options.PlotFile,
      [&figures](const std::string& newName)
      { WritePicture(DrawErrorTimePlot(GetComparedRows(figures)), newName); });
  }
}

//------------------------------------------------------------------------------
void MeasureScenes(const BenchmarkOptions& options, const std::vector<SceneChoice>& scenes,
  const std::vector<Method>& methods, Figures& figures)
{
  for (const SceneChoice& choice : scenes)
  {
    Scene scene = choice.Make();
    for (const auto& size : options.Sizes)
    {
      for (const double opacity : options.Opacities)
      {
        Tell(choice.Name + ", " + std::to_string(size[0]) + "x" + std::to_string(size[1]) +
          ", opacity " + ToText(opacity));
        MeasurementSettings settings = options.Settings;
        settings.Size = size;
        settings.Opacity = opacity;
        for (const Row& row : Measure(scene, ChooseSuitable(methods, scene), settings))
        {
          if (!row.Skipped.empty())
          {
            Tell("  " + row.Method + ": " + row.Skipped);
          }
          figures.Rows.push_back(row);
        }
        MarkFronts(figures.Rows);
        WriteFiles(figures, options);
      }
    }
  }
}

//------------------------------------------------------------------------------
void Run(const BenchmarkOptions& options)
{
  if (options.Lists)
  {
    WriteList(std::cout, options.DataFolder);
    return;
  }
  if (!options.RecordFile.empty())
  {
    PrintRecord(options.RecordFile, std::cout);
    return;
  }
  const auto scenes = ChooseScenes(options.Scenes, options.DataFolder);
  const auto methods = ChooseMethods(options.Methods);
  CheckFiles(options);
  Figures figures;
  figures.Where = DescribeMachine();
  if (options.MeasuresScaling)
  {
    const auto save = [&figures, &options](const std::vector<Series>& measured)
    {
      figures.Scaling = measured;
      WriteFiles(figures, options);
    };
    MeasureScaling(methods, options.Settings, options.Limits, { Tell, save });
  }
  else
  {
    MeasureScenes(options, scenes, methods, figures);
  }
  if (options.TableFile.empty())
  {
    PrintTables(figures, std::cout);
  }
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  MessageLog::GetInstance();
  std::optional<int> exitCode;
  const auto options = ParseCommandLine(argc, argv, exitCode);
  if (exitCode)
  {
    return *exitCode;
  }
  bool isWrongUsage = false;
  const int result = RunProgram(
    [&]
    {
      try
      {
        Run(options);
      }
      catch (const UnknownName&)
      {
        isWrongUsage = true;
        throw;
      }
    });
  return isWrongUsage ? 2 : result;
}
