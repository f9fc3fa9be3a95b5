// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderOptions.h"

#include "OpacityOptions.h"
#include "PictureFile.h"
#include "Program.h"
#include "SceneOptions.h"

namespace pellucid
{
namespace
{
constexpr const char* Examples = R"(
Examples:
  pellucid-render combxyz.bin -o combustor.png
  pellucid-render kitchen.vtk -o kitchen.png --seeds 3000 --opacity 0.2
  pellucid-render lines.vtp surface.ply -o scene.png --color-by pressure --size 800x600
  pellucid-render lines.vtp -o both.png --compare --statistics frame.json
  pellucid-render winds.nc --list-arrays
  pellucid-render winds.nc -o rising.png --importance TotalPressureDifference:300:800 \
    --exponent 3 --color-by pressure
  pellucid-render winds.nc -o only.png --select TotalPressureDifference:500: --opacity 1
  pellucid-render winds.nc -o clear.png --optimize
  pellucid-render combxyz.bin -o core.png --preset balanced --importance Density:90%:10%
  pellucid-render lines.vtp -o hint.png --avoid penalty --importance Height:50%:100%
  pellucid-render combxyz.bin -o opacities.png --optimize --view opacity)";

//------------------------------------------------------------------------------
void AddPictureOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Picture");
  group.Add(
    "-o,--output",
    [&options](const std::string& text)
    {
      if (!IsPictureFileName(text))
      {
        Refuse("--output", "a file name ending in " + ListPictureSuffixes(), text);
      }
      options.Output = text;
    },
    "FILE", "Picture to write (" + ListPictureSuffixes() + ")");
  AddFrameOptions(group, options);
  group.AddFlag("--transparent-background", options.TransparentBackground,
    "Write an alpha channel that is 0 where nothing is drawn");
}

//------------------------------------------------------------------------------
void AddRendererOptions(CLI::App& app, RenderOptions& options)
{
  OptionGroup group(app, "Renderer");
  AddMethodOptions(group, options);
  CLI::Option* reference = group.AddFlag("--reference", options.Reference,
    "Draw with the reference renderer on the processor; needs no OpenGL");
  group
    .AddFlag("--compare", options.Compare,
      "Draw side by side: exact, and VTK's default or what --method names")
    ->excludes(reference);
  group.AddText("--statistics", options.StatisticsFile, "FILE",
    "Write counts, memory and times of the frame as JSON");
}

//------------------------------------------------------------------------------
void CheckCombination(const RenderOptions& options)
{
  if (options.Output.empty() && !options.ListArrays)
  {
    throw CLI::RequiredError("--output");
  }
  if (options.Reference && options.RenderMethod != Method::Pellucid)
  {
    throw CLI::ValidationError(
      "--reference", "draws what the method pellucid draws; leave out --method");
  }
}
}

//------------------------------------------------------------------------------
RenderOptions ParseCommandLine(int argc, char* argv[], std::optional<int>& exitCode)
{
  RenderOptions options;
  CLI::App app("Draw trajectories, points and surfaces with exact transparency.", ProgramName);
  app.add_option("input", options.Inputs, "Files to draw")->required()->type_name("INPUT...");
  app.footer(DescribeInputs() + Examples);
  AddPictureOptions(app, options);
  AddSceneOptions(app, options);
  AddRendererOptions(app, options);
  Parse(
    app, argc, argv,
    [&options]
    {
      CheckCombination(options);
      CompleteOpacityOptions(options);
    },
    exitCode);
  return options;
}
}
