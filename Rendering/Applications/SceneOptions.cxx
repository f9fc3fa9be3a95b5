// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneOptions.h"

#include "FileKinds.h"
#include "OpacityOptions.h"
#include "OptionText.h"
#include "Program.h"

#include <algorithm>
#include <iostream>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
void AddAppearanceOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Appearance");
  group.AddText("--color-by", options.ColorBy, "ARRAY",
    "Array that colours, a vector by its length: of the points or lines, a computed one, or "
    "Importance; default: the speed of traced lines, otherwise the active or first array; with "
    "--optimize or --avoid, the array that is important by default");
  group.Add(
    "--color-range",
    [&options](const std::string& text)
    {
      options.ColorRange = ToRange(text);
      if (!options.ColorRange)
      {
        Refuse("--color-range", "MINIMUM:MAXIMUM, two numbers, the first below the second", text);
      }
    },
    "MINIMUM:MAXIMUM",
    "Values of the first and the last colour, so that pictures compare; default: from the data, "
    "less 1 % at either end");
  group.AddNumber("--opacity", options.Opacity, 0.0, 1.0, "A",
    "Opacity of everything, 0 to 1, which importance only lessens; default 0.3; 1 for what has "
    "importance, and for everything with --optimize or --avoid");
  group.AddNumber("--radius", options.Radius, 0.0, OptionGroup::Unbounded, "R",
    "Radius of lines and points in world units; default 0: from the data");
  group.AddChoice("--lighting", options.Lighting, { { "on", true }, { "off", false } },
    "Shade the colours by a light at the camera; default on");
}

//------------------------------------------------------------------------------
void AddImportanceOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Importance (arrays are those of the file and the computed ones)");
  group.AddFlag("--list-arrays", options.ListArrays,
    "Print name, range, unit and missing values of every array, and end; needs no --output");
  group.AddRepeatable(
    "--importance",
    [&options](const std::string& text)
    {
      const auto term = ToImportanceTerm(text);
      if (!term)
      {
        Refuse("--importance",
          "NAME:MINIMUM:MAXIMUM or NAME:MINIMUM:MAXIMUM:WEIGHT, the limits numbers or percentiles "
          "such as 5%, the weight -1 to 1",
          text);
      }
      options.Importance.push_back(*term);
    },
    "NAME:MINIMUM:MAXIMUM[:WEIGHT]",
    "Fade what is less important: MINIMUM of the array is importance 0, MAXIMUM 1, either a number "
    "or a percentile such as 5%; a vector counts by its length. Of several arrays the mean "
    "weighted by WEIGHT, -1 to 1, counts; default 1. MINIMUM above MAXIMUM makes small values "
    "important; a negative weight takes away. The importance is a factor on the opacity; with "
    "--optimize or --avoid it only drives these");
  group.AddNumber("--exponent", options.Exponent, 0.0, OptionGroup::Unbounded, "E",
    "Power that the importance is raised to: above 1 more fades; default 1");
  group.AddRepeatable(
    "--select",
    [&options](const std::string& text)
    {
      const auto range = ToSelectionRange(text);
      if (!range)
      {
        Refuse("--select",
          "NAME:MINIMUM:MAXIMUM, the limits numbers or percentiles such as 5%, one of them may be "
          "empty",
          text);
      }
      options.Selections.push_back(*range);
    },
    "NAME:MINIMUM:MAXIMUM",
    "Draw only the lines that have a value of the array in this range; an empty limit is open. Of "
    "several, all must hold");
  group.AddText("--pressure", options.Pressure, "ARRAY",
    "Pressure of computed arrays, of the points; default: the array with a name that is common for "
    "it");
  group.AddText("--height", options.Height, "ARRAY",
    "Height that SegmentHeightDifference compares, of the points; default: the coordinate that "
    "--up "
    "names");
  group.AddChoice("--up", options.UpAxis, { { "x", 0 }, { "y", 1 }, { "z", 2 } },
    "Axis that points up, for computed arrays and the camera; default z");
  group.AddNumber("--time-window", options.TimeWindow, 0.0, OptionGroup::Unbounded, "T",
    "Time within which the pressure differs most, for TotalPressureDifference, in the unit of the "
    "time array; default 0: the whole line");
}

//------------------------------------------------------------------------------
void AddTrajectoryOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Trajectories in longitude and latitude");
  group.AddInteger("--ensemble-member", options.EnsembleMember, 0, OptionGroup::LargestInteger, "N",
    "Member to read, from 0; default 0");
  group.AddChoice("--vertical-axis", options.VerticalAxis,
    { { "pressure", Vertical::LogPressure }, { "height", Vertical::Height } },
    "What z is: ln(1000 hPa / pressure) (default), or the height in km");
  group.AddNumber("--vertical-scale", options.VerticalScale, 0.0, 1e6, "S",
    "Degrees for each unit of that; default 0: 10 with pressure and 1 with height");
  group.AddChoice("--longitudes", options.LongitudeMode,
    { { "unwrap", Longitudes::Unwrap }, { "cut", Longitudes::Cut } },
    "Lines that cross the edge of the map: continued beyond it (default), or cut there");
  group.AddNumber("--central-longitude", options.CentralLongitude, -360.0, 360.0, "DEGREES",
    "Middle of the map where lines are cut; default 0");
}

//------------------------------------------------------------------------------
void AddCameraOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Camera (what is not given follows from the data)");
  group.AddVector("--camera-position", options.CameraPosition, "Where the camera is");
  group.AddVector("--focal-point", options.FocalPoint, "What the camera looks at");
  group.AddVector("--view-up", options.ViewUp, "Direction that points up in the picture");
  group.AddNumber("--parallel-scale", options.ParallelScale, 0.0, OptionGroup::Unbounded, "S",
    "Half the height of a parallel projection, world units; default 0: perspective");
}

//------------------------------------------------------------------------------
void AddStreamlineOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Streamlines of fields");
  group.AddInteger(
    "--seeds", options.Seeds, 1, OptionGroup::LargestInteger, "N", "Seeds to place; default 1000");
  group.AddChoice("--seeding", options.SeedingMode,
    { { "volume", Seeding::Volume }, { "points", Seeding::Points }, { "grid", Seeding::Grid },
      { "line", Seeding::Line } },
    "Where: evenly in the volume (default), at points of the data, on a regular grid, on a line");
  group.AddInteger("--seed-offset", options.SeedOffset, 0, OptionGroup::LargestInteger, "N",
    "Another set of seeds; default 0");
  group.AddVector("--seed-line-first", options.SeedLineFirst, "Where the seeding line begins");
  group.AddVector("--seed-line-last", options.SeedLineLast, "Where the seeding line ends");
  group.AddText(
    "--vectors", options.Vectors, "ARRAY", "Vectors to trace; default: the active or first ones");
  group.AddNumber("--maximum-length", options.MaximumLength, 0.0, OptionGroup::Unbounded, "L",
    "World units after which a line ends, to each side of its seed; default 0: from the data");
}
}

//------------------------------------------------------------------------------
void AddFrameOptions(OptionGroup& group, RenderOptions& options)
{
  group.Add(
    "--size",
    [&options](const std::string& text)
    {
      const auto size = ToSize(text);
      if (!size)
      {
        Refuse("--size", "WxH in pixels, each 1 to " + std::to_string(LargestSide), text);
      }
      options.Size = *size;
    },
    "WxH", "Pixels of the picture; default 1280x960");
  group.Add(
    "--background",
    [&options](const std::string& text)
    {
      const auto color = ToVector(text);
      if (!color ||
        std::any_of(color->begin(), color->end(), [](double c) { return c < 0.0 || c > 1.0; }))
      {
        Refuse("--background", "three numbers R,G,B, each 0 to 1", text);
      }
      options.Background = *color;
    },
    "R,G,B", "Background colour, each 0 to 1; default 0.05,0.06,0.08");
}

//------------------------------------------------------------------------------
void AddMethodOptions(OptionGroup& group, RenderOptions& options)
{
  group.AddChoice("--method", options.RenderMethod,
    { { "pellucid", Method::Pellucid }, { "vtk", Method::VTK },
      { "vtk-peeling", Method::VTKPeeling } },
    "Exact transparency (default), VTK's default, or VTK's depth peeling; VTK's round the opacity "
    "that importance gives to 1/255");
  group.AddInteger("--memory-limit", options.MemoryLimit, 1, OptionGroup::LargestInteger, "MIB",
    "Graphics memory for fragments; the picture is the same for any limit; default 1024");
}

//------------------------------------------------------------------------------
void AddSceneOptions(CLI::App& app, RenderOptions& options)
{
  AddAppearanceOptions(app, options);
  AddImportanceOptions(app, options);
  AddOpacityOptions(app, options.Opacities);
  AddTrajectoryOptions(app, options);
  AddCameraOptions(app, options);
  AddStreamlineOptions(app, options);
}

//------------------------------------------------------------------------------
std::string DescribeInputs()
{
  return "Inputs, recognised by their content:\n" + ListFileKinds() +
    "\n  Streamlines are traced of every field. All inputs are drawn into one picture.\n";
}

//------------------------------------------------------------------------------
void Parse(CLI::App& app, int argc, char* argv[], const std::function<void()>& check,
  std::optional<int>& exitCode)
{
  app.set_version_flag("--version", std::string(ProgramName) + " " PELLUCID_VERSION);
  try
  {
    app.parse(argc, argv);
    check();
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
}
}
