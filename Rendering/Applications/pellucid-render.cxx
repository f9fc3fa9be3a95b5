// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Draws files into a picture with exact transparency; see pellucid-render --help.
 *
 * Exit codes: 0 the picture is written, 1 it could not be made, 2 wrong usage. Errors are one line
 * on the standard error stream.
 */

#include "ArrayTable.h"
#include "LineAttributes.h"
#include "LineSelection.h"
#include "MessageLog.h"
#include "PictureFile.h"
#include "PictureMaking.h"
#include "PlainText.h"
#include "RenderError.h"
#include "SceneImportance.h"
#include "SceneSegments.h"

#include <exception>
#include <iostream>
#include <new>

namespace
{
//------------------------------------------------------------------------------
void Run(pellucid::RenderOptions options)
{
  using namespace pellucid;
  if (options.ListArrays)
  {
    auto drawables = MakeDrawables(ReadInputs(options), options);
    AddAllAttributes(drawables, options);
    WriteArrayTable(std::cout, drawables);
    return;
  }
  CheckWritable(options.Output);
  if (!options.StatisticsFile.empty())
  {
    CheckWritable(options.StatisticsFile);
  }
  SceneStatistics statistics;
  auto drawables = MakeDrawables(ReadInputs(options), options);
  const bool isChosen = ChooseImportance(drawables, options);
  AddNamedAttributes(drawables, options);
  for (const Drawable& drawable : drawables)
  {
    statistics.InputPoints += drawable.GetNumberOfPoints();
    statistics.InputLines += drawable.GetNumberOfLines();
  }
  SelectLines(drawables, options);
  for (const Drawable& drawable : drawables)
  {
    statistics.SelectedLines += drawable.GetNumberOfLines();
  }
  statistics.Importance = AddImportance(drawables, options);
  if (isChosen)
  {
    std::cout << DescribeChoice(statistics.Importance.Terms.front()) << std::endl;
  }
  const Coloring colors(drawables, options);
  statistics.ColorBy = colors.GetName();
  if (options.Opacities.Rule == OpacityRule::Optimization)
  {
    AddSegments(drawables);
  }
  const Scene scene{ std::move(drawables), colors };
  const Frame frame = MakePicture(scene, options);
  WritePicture(frame.Picture, options.Output);
  if (!options.StatisticsFile.empty())
  {
    WriteStatistics(statistics, frame.Statistics, options.StatisticsFile);
  }
}

//------------------------------------------------------------------------------
int Fail(const std::string& message)
{
  std::cerr << "pellucid-render: " << pellucid::MakePrintable(message) << "\n";
  return 1;
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  pellucid::MessageLog::GetInstance();
  std::optional<int> exitCode;
  const auto options = pellucid::ParseCommandLine(argc, argv, exitCode);
  if (exitCode)
  {
    return *exitCode;
  }
  try
  {
    Run(options);
    return 0;
  }
  catch (const std::bad_alloc&)
  {
    return Fail("out of memory; the input may be damaged, or too large for this machine");
  }
  catch (const std::exception& error)
  {
    return Fail(error.what());
  }
}
