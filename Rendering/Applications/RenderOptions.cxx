// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderOptions.h"

#include "PictureFile.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>

namespace pellucid
{
namespace
{
constexpr int LargestSide = 65536;

constexpr const char* Examples = R"(Inputs:
  lines, points, surfaces   .vtk .vtp .vtm .ply .stl .obj
  vector fields             .vtk .vts .vti .vtr .vtu .vtm, PLOT3D grid and solution
                            (of combxyz.bin the partner combq.bin is found by its name)
  Streamlines are traced of every field. All inputs are drawn into one picture.

Examples:
  pellucid-render combxyz.bin -o combustor.png
  pellucid-render kitchen.vtk -o kitchen.png --seeds 3000 --opacity 0.2
  pellucid-render lines.vtp surface.ply -o scene.png --color-by pressure --size 800x600
  pellucid-render lines.vtp -o both.png --compare --statistics frame.json)";

//------------------------------------------------------------------------------
[[noreturn]] void Refuse(
  const std::string& option, const std::string& expected, const std::string& found)
{
  throw CLI::ValidationError(option, "expected " + expected + ", found '" + found + "'");
}

//------------------------------------------------------------------------------
// All of the text as one finite number.
std::optional<double> ToNumber(std::string_view text)
{
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  const bool isNumber = result.ec == std::errc() && result.ptr == end && std::isfinite(value);
  return isNumber ? std::optional<double>(value) : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<Vector3> ToVector(const std::string& text)
{
  Vector3 vector;
  std::size_t begin = 0;
  for (int i = 0; i < 3; ++i)
  {
    const std::size_t end = i < 2 ? text.find(',', begin) : text.size();
    const auto number = end == std::string::npos
      ? std::nullopt
      : ToNumber(std::string_view(text).substr(begin, end - begin));
    if (!number)
    {
      return std::nullopt;
    }
    vector[i] = *number;
    begin = end + 1;
  }
  return vector;
}

//------------------------------------------------------------------------------
std::array<int, 2> ToSize(const std::string& text)
{
  const std::size_t cross = text.find('x');
  const auto width = ToNumber(std::string_view(text).substr(0, cross));
  const auto height =
    cross == std::string::npos ? std::nullopt : ToNumber(std::string_view(text).substr(cross + 1));
  const auto isSide = [](const std::optional<double>& side)
  { return side && *side >= 1.0 && *side <= LargestSide && *side == std::floor(*side); };
  if (!isSide(width) || !isSide(height))
  {
    Refuse("--size", "WxH in pixels, each 1 to " + std::to_string(LargestSide), text);
  }
  return { static_cast<int>(*width), static_cast<int>(*height) };
}

//------------------------------------------------------------------------------
// Adds options whose text is checked here, so that messages say what was expected and found.
class OptionGroup
{
public:
  OptionGroup(CLI::App& app, std::string title)
    : App(app)
    , Title(std::move(title))
  {
  }

  void AddNumber(const std::string& name, double& value, double minimum, double maximum,
    const std::string& metavar, const std::string& help)
  {
    this->Add(
      name,
      [&value, name, minimum, maximum](const std::string& text)
      {
        const auto number = ToNumber(text);
        if (!number || *number < minimum || *number > maximum)
        {
          Refuse(name, Range("a number", minimum, maximum), text);
        }
        value = *number;
      },
      metavar, help);
  }

  template <typename Integer>
  void AddInteger(const std::string& name, Integer& value, Integer minimum,
    const std::string& metavar, const std::string& help)
  {
    constexpr auto maximum = static_cast<double>(std::numeric_limits<int>::max());
    this->Add(
      name,
      [&value, name, minimum](const std::string& text)
      {
        const auto number = ToNumber(text);
        if (!number || *number != std::floor(*number) || *number < static_cast<double>(minimum) ||
          *number > maximum)
        {
          Refuse(name, Range("a whole number", static_cast<double>(minimum), maximum), text);
        }
        value = static_cast<Integer>(*number);
      },
      metavar, help);
  }

  void AddVector(const std::string& name, std::optional<Vector3>& value, const std::string& help)
  {
    this->Add(
      name,
      [&value, name](const std::string& text)
      {
        value = ToVector(text);
        if (!value)
        {
          Refuse(name, "three numbers X,Y,Z", text);
        }
      },
      "X,Y,Z", help);
  }

  CLI::Option* Add(const std::string& name, const std::function<void(const std::string&)>& parse,
    const std::string& metavar, const std::string& help)
  {
    return this->App.add_option_function<std::string>(name, parse, help)
      ->type_name(metavar)
      ->group(this->Title);
  }

  template <typename Enumeration>
  void AddChoice(const std::string& name, Enumeration& value,
    const std::vector<std::pair<std::string, Enumeration>>& choices, const std::string& help)
  {
    std::string names;
    for (const auto& choice : choices)
    {
      names += (names.empty() ? "" : "|") + choice.first;
    }
    this->Add(
      name,
      [&value, name, names, choices](const std::string& text)
      {
        for (const auto& choice : choices)
        {
          if (choice.first == text)
          {
            value = choice.second;
            return;
          }
        }
        Refuse(name, names, text);
      },
      names, help);
  }

  void AddText(const std::string& name, std::string& value, const std::string& metavar,
    const std::string& help)
  {
    this->App.add_option(name, value, help)->type_name(metavar)->group(this->Title);
  }

  CLI::Option* AddFlag(const std::string& name, bool& value, const std::string& help)
  {
    return this->App.add_flag(name, value, help)->group(this->Title);
  }

private:
  static std::string Range(const std::string& kind, double minimum, double maximum)
  {
    std::ostringstream text;
    text << kind << " of at least " << minimum;
    if (maximum < std::numeric_limits<int>::max())
    {
      text << " and at most " << maximum;
    }
    return text.str();
  }

  CLI::App& App;
  std::string Title;
};

//------------------------------------------------------------------------------
void AddPictureOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Picture");
  group
    .Add(
      "-o,--output",
      [&options](const std::string& text)
      {
        if (!IsPictureFileName(text))
        {
          Refuse("--output", "a file name ending in " + ListPictureSuffixes(), text);
        }
        options.Output = text;
      },
      "FILE", "Picture to write (" + ListPictureSuffixes() + ")")
    ->required();
  group.Add(
    "--size", [&options](const std::string& text) { options.Size = ToSize(text); }, "WxH",
    "Pixels of the picture; default 1280x960");
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
  group.AddFlag("--transparent-background", options.TransparentBackground,
    "Write an alpha channel that is 0 where nothing is drawn");
}

//------------------------------------------------------------------------------
void AddAppearanceOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Appearance");
  group.AddText("--color-by", options.ColorBy, "ARRAY",
    "Point or cell array that colours, a vector by its length; default: the speed of traced lines, "
    "otherwise the active or first array");
  group.AddNumber(
    "--opacity", options.Opacity, 0.0, 1.0, "A", "Opacity of everything, 0 to 1; default 0.3");
  group.AddNumber("--radius", options.Radius, 0.0, std::numeric_limits<double>::max(), "R",
    "Radius of lines and points in world units; default 0: from the data");
  group.AddChoice("--lighting", options.Lighting,
    std::vector<std::pair<std::string, bool>>{ { "on", true }, { "off", false } },
    "Shade the colours by a light at the camera; default on");
}

//------------------------------------------------------------------------------
void AddCameraOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Camera (what is not given follows from the data)");
  group.AddVector("--camera-position", options.CameraPosition, "Where the camera is");
  group.AddVector("--focal-point", options.FocalPoint, "What the camera looks at");
  group.AddVector("--view-up", options.ViewUp, "Direction that points up in the picture");
  group.AddNumber("--parallel-scale", options.ParallelScale, 0.0,
    std::numeric_limits<double>::max(), "S",
    "Half the height of a parallel projection, world units; default 0: perspective");
}

//------------------------------------------------------------------------------
void AddStreamlineOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Streamlines of fields");
  group.AddInteger("--seeds", options.Seeds, 1ll, "N", "Seeds to place; default 1000");
  group.AddChoice("--seeding", options.SeedingMode,
    { { "volume", Seeding::Volume }, { "points", Seeding::Points }, { "grid", Seeding::Grid },
      { "line", Seeding::Line } },
    "Where: evenly in the volume (default), at points of the data, on a regular grid, on a line");
  group.AddInteger(
    "--seed-offset", options.SeedOffset, 0ll, "N", "Another set of seeds; default 0");
  group.AddVector("--seed-line-first", options.SeedLineFirst, "Where the seeding line begins");
  group.AddVector("--seed-line-last", options.SeedLineLast, "Where the seeding line ends");
  group.AddText(
    "--vectors", options.Vectors, "ARRAY", "Vectors to trace; default: the active or first ones");
  group.AddNumber("--maximum-length", options.MaximumLength, 0.0,
    std::numeric_limits<double>::max(), "L",
    "World units after which a line ends, to each side of its seed; default 0: from the data");
}

//------------------------------------------------------------------------------
void AddRendererOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Renderer");
  group.AddChoice("--method", options.RenderMethod,
    { { "pellucid", Method::Pellucid }, { "vtk", Method::VTK },
      { "vtk-peeling", Method::VTKPeeling } },
    "Exact transparency (default), VTK's default, or VTK's depth peeling");
  CLI::Option* reference = group.AddFlag("--reference", options.Reference,
    "Draw with the reference renderer on the processor; needs no OpenGL");
  group
    .AddFlag("--compare", options.Compare,
      "Draw side by side: exact, and VTK's default or what --method names")
    ->excludes(reference);
  group.AddInteger("--memory-limit", options.MemoryLimit, 1, "MIB",
    "Graphics memory for fragments; the picture is the same for any limit; default 1024");
  group.AddText("--statistics", options.StatisticsFile, "FILE",
    "Write counts, memory and times of the frame as JSON");
}
}

//------------------------------------------------------------------------------
RenderOptions ParseCommandLine(int argc, char* argv[], std::optional<int>& exitCode)
{
  RenderOptions options;
  CLI::App app(
    "Draw trajectories, points and surfaces with exact transparency.", "pellucid-render");
  app.set_version_flag("--version", "pellucid-render " PELLUCID_VERSION);
  app.add_option("input", options.Inputs, "Files to draw")->required()->type_name("INPUT...");
  app.footer(Examples);
  AddPictureOptions(app, options);
  AddAppearanceOptions(app, options);
  AddCameraOptions(app, options);
  AddStreamlineOptions(app, options);
  AddRendererOptions(app, options);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::Success& success)
  {
    exitCode = app.exit(success);
  }
  catch (const CLI::ParseError& error)
  {
    std::cerr << "pellucid-render: " << error.what() << " (see pellucid-render --help)\n";
    exitCode = 2;
  }
  return options;
}
}
