// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewOptions.h"

#include "OpacityOptions.h"
#include "PictureFile.h"
#include "Program.h"
#include "SceneOptions.h"

namespace pellucid
{
const char* const Controls =
  R"(Mouse: left turns, middle (or Shift and left) shifts, right or the wheel zooms.
Keys:  R resets the view, S saves the picture, Tab hides the panel, Q or Escape ends.)";

namespace
{
constexpr const char* Examples = R"(
Files that are dropped onto the window are opened in place of what is there.

Examples:
  pellucid-view combxyz.bin
  pellucid-view winds.nc --optimize --importance TotalPressureDifference:200:550
  pellucid-view lines.vtp surface.ply --screenshot scene.png --size 800x600)";
}

//------------------------------------------------------------------------------
RenderOptions ParseViewCommandLine(int argc, char* argv[], std::optional<int>& exitCode)
{
  RenderOptions options;
  CLI::App app("Look at trajectories, points and surfaces with exact transparency.", ProgramName);
  app.add_option("input", options.Inputs, "Files to draw")->type_name("[INPUT...]");
  app.footer(DescribeInputs() + "\n" + Controls + Examples);
  OptionGroup window(app, "Window");
  AddFrameOptions(window, options);
  AddMethodOptions(window, options);
  window.Add(
    "--screenshot",
    [&options](const std::string& text)
    {
      if (!IsPictureFileName(text))
      {
        Refuse("--screenshot", "a file name ending in " + ListPictureSuffixes(), text);
      }
      options.Output = text;
    },
    "FILE",
    "Draw one picture without the panel, write it (" + ListPictureSuffixes() +
      ") and end; needs a display, but shows no window");
  AddSceneOptions(app, options);
  Parse(
    app, argc, argv,
    [&options]
    {
      if (options.Inputs.empty() && !options.Output.empty())
      {
        throw CLI::RequiredError("input");
      }
      CompleteOpacityOptions(options);
    },
    exitCode);
  return options;
}
}
