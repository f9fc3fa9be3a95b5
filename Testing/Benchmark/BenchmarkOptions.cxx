// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "BenchmarkOptions.h"

#include "OptionGroup.h"
#include "OptionText.h"
#include "Program.h"

#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <iostream>
#include <set>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr const char* Examples = R"(
Examples:
  pellucid-benchmark --list
  pellucid-benchmark --quick --json figures.json
  pellucid-benchmark --scene abc-1000 --method 'vtk-*' --method pellucid --table table.md
  pellucid-benchmark --json figures.json --csv figures.csv --plot plot.png --table table.md
  pellucid-benchmark --scaling --largest-fragments 1e7 --json scaling.json)";

// What belongs to --quick where nothing else is asked for.
const std::vector<std::string> QuickScenes = { "abc-100", "layers-64" };
const std::vector<std::string> UsualScenes = { "abc-100", "abc-1000", "abc-5000", "abc-10000",
  "abc-100000", "combustor", "points-10000", "surfaces-16", "layers-64", "layers-512" };
constexpr std::array<int, 2> QuickSize = { 200, 150 };
constexpr double QuickBudget = 2.0;

//------------------------------------------------------------------------------
// What is asked for twice is measured once.
template <typename Value>
void AppendNew(std::vector<Value>& list, const Value& value)
{
  if (std::find(list.begin(), list.end(), value) == list.end())
  {
    list.push_back(value);
  }
}

//------------------------------------------------------------------------------
double GetMemoryOfMachine()
{
  vtksys::SystemInformation system;
  return 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
}

//------------------------------------------------------------------------------
void AddFiles(CLI::App& app, BenchmarkOptions& options)
{
  OptionGroup group(app, "Results (README.md beside the sources explains all numbers)");
  group.AddText("--json", options.JsonFile, "FILE", "Write everything");
  group.AddText("--csv", options.CsvFile, "FILE", "Write one line for each scene and method");
  group.AddText("--table", options.TableFile, "FILE", "Write tables in Markdown");
  group.Add(
    "--plot",
    [&options](const std::string& text)
    {
      if (text.size() < 4 || text.compare(text.size() - 4, 4, ".png") != 0)
      {
        Refuse("--plot", "a file name ending in .png", text);
      }
      options.PlotFile = text;
    },
    "FILE", "Draw error over time, with the Pareto front of each scene");
}

//------------------------------------------------------------------------------
void AddChoices(CLI::App& app, BenchmarkOptions& options)
{
  OptionGroup group(app, "Choices (each may stand several times)");
  const auto append = [](std::vector<std::string>& list)
  { return [&list](const std::string& text) { list.push_back(text); }; };
  group.AddRepeatable("--scene", append(options.Scenes), "NAME",
    "Scene to draw, or a pattern with * and ? for those that --list names; default: " +
      CLI::detail::join(UsualScenes, ", "));
  group.AddRepeatable("--method", append(options.Methods), "NAME",
    "Method to measure, or a pattern; default: all; with --scaling: pellucid");
  group.AddRepeatable(
    "--size",
    [&options](const std::string& text)
    {
      const auto size = ToSize(text);
      if (!size)
      {
        Refuse("--size", "WxH in pixels, each 1 to " + std::to_string(LargestSide), text);
      }
      AppendNew(options.Sizes, *size);
    },
    "WxH", "Pixels of the window; default 800x600");
  group.AddRepeatable(
    "--alpha",
    [&options](const std::string& text)
    {
      const auto alpha = ToNumber(text);
      if (!alpha || *alpha <= 0.0 || *alpha >= 1.0)
      {
        Refuse("--alpha", "a number above 0 and below 1", text);
      }
      AppendNew(options.Opacities, *alpha);
    },
    "A", "Opacity of everything; default 0.3");
}

//------------------------------------------------------------------------------
// Options that would have no effect beside that one, or show nothing.
void Exclude(CLI::App& app, const std::string& name, const std::vector<std::string>& others)
{
  for (const std::string& other : others)
  {
    app.get_option(name)->excludes(app.get_option(other));
  }
}

//------------------------------------------------------------------------------
void ExcludeAll(CLI::App& app, const std::string& name, const std::string& exception)
{
  for (const CLI::Option* option : app.get_options())
  {
    const std::string other = option->get_name();
    if (other != name && other != exception && other != "--help")
    {
      Exclude(app, name, { other });
    }
  }
}

//------------------------------------------------------------------------------
// A file that another result would replace.
void CheckFileNames(const BenchmarkOptions& options)
{
  std::set<std::string> names;
  for (const std::string* name :
    { &options.JsonFile, &options.CsvFile, &options.TableFile, &options.PlotFile })
  {
    if (!name->empty() && !names.insert(*name).second)
    {
      Refuse("--json, --csv, --table, --plot", "a file of its own for each", *name);
    }
  }
}

//------------------------------------------------------------------------------
// What is not given is what a full, or a quick, run takes.
void Complete(BenchmarkOptions& options, bool isQuick)
{
  if (options.Scenes.empty())
  {
    options.Scenes = isQuick ? QuickScenes : UsualScenes;
  }
  if (options.Methods.empty())
  {
    options.Methods.push_back(options.MeasuresScaling ? "pellucid" : "*");
  }
  if (options.Sizes.empty())
  {
    options.Sizes.push_back(isQuick ? QuickSize : options.Settings.Size);
  }
  if (options.Opacities.empty())
  {
    options.Opacities.push_back(options.Settings.Opacity);
  }
}
}

//------------------------------------------------------------------------------
BenchmarkOptions ParseCommandLine(int argc, char* argv[], std::optional<int>& exitCode)
{
  BenchmarkOptions options;
  options.DataFolder = PELLUCID_DATA_FOLDER;
  bool isQuick = false;
  bool skipsErrors = false;
  std::optional<double> budget;
  std::optional<double> gigabytes;
  CLI::App app("Compare methods to draw translucent geometry: time, memory, error.", ProgramName);
  app.footer(Examples);
  AddFiles(app, options);
  AddChoices(app, options);
  OptionGroup group(app, "Measuring");
  group.AddFlag("--quick", isQuick, "Two small scenes, little time: to see that all methods work");
  group.AddInteger("--frames", options.Settings.Frames, 1, 10000, "N",
    "Frames to time of each method; default 9, an odd number for a median that is one of them");
  group.AddNumber("--budget", budget, 0.0, OptionGroup::Unbounded, "SECONDS",
    "Time after which a method gets no more frames of a scene; default 20");
  group.AddInteger("--interleave", options.Settings.InterleavedSegments, 0,
    OptionGroup::LargestInteger, "N",
    "Segments up to which the methods of a scene take turns; default 500000");
  group.AddNumber("--memory", gigabytes, 0.0, OptionGroup::Unbounded, "GB",
    "Memory that a method may need; default: three quarters of the machine's");
  group.AddFlag("--no-errors", skipsErrors,
    "Measure no errors: the reference takes minutes and gigabytes for 1e8 fragments");
  group.AddText("--data", options.DataFolder, "FOLDER", "Where the samples are; default: Data/");
  group.AddText("--record", options.RecordFile, "FILE",
    "Print why candidates are not in the product, by a file of --json, and end");
  group.AddFlag("--list", options.Lists, "Name all scenes and methods, and end");
  OptionGroup scaling(app, "Scaling");
  scaling.AddFlag("--scaling", options.MeasuresScaling,
    "Measure how time and memory grow, instead of the scenes");
  scaling.AddNumber("--largest-fragments", options.Limits.Fragments, 1e5, 1e9, "N",
    "Fragments of the largest picture; default 1e8");
  scaling.AddNumber("--largest-segments", options.Limits.Segments, 1e3, 1e8, "N",
    "Segments of the largest data; default 1e7");
  Exclude(app, "--scaling",
    { "--scene", "--size", "--alpha", "--quick", "--interleave", "--data", "--no-errors",
      "--plot" });
  Exclude(app, "--no-errors", { "--plot" });
  for (const char* limit : { "--largest-fragments", "--largest-segments" })
  {
    app.get_option(limit)->needs(app.get_option("--scaling"));
  }
  ExcludeAll(app, "--record", "");
  ExcludeAll(app, "--list", "--data");
  try
  {
    app.parse(argc, argv);
    CheckFileNames(options);
  }
  catch (const CLI::Success& success)
  {
    exitCode = app.exit(success);
  }
  catch (const CLI::ParseError& error)
  {
    std::cerr << ProgramName << ": " << error.what() << " (see " << ProgramName << " --help)\n";
    exitCode = 2;
  }
  options.Settings.Budget = budget.value_or(isQuick ? QuickBudget : options.Settings.Budget);
  options.Settings.FindsErrors = !skipsErrors;
  options.Settings.Memory = gigabytes ? 1e9 * *gigabytes : 0.75 * GetMemoryOfMachine();
  Complete(options, isQuick);
  return options;
}
}
}
