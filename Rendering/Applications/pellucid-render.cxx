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
#include "MessageLog.h"
#include "PictureFile.h"
#include "PictureMaking.h"
#include "Program.h"
#include "SceneMaking.h"

#include <iostream>

const char* const pellucid::ProgramName = "pellucid-render";

namespace
{
//------------------------------------------------------------------------------
void Run(const pellucid::RenderOptions& options)
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
  const MadeScene made = MakeScene(MakeDrawables(ReadInputs(options), options), options);
  if (made.IsImportanceChosen)
  {
    std::cout << DescribeChoice(made.Statistics.Importance.Terms.front()) << std::endl;
  }
  const Frame frame = MakePicture(made.Drawn, options);
  WritePicture(frame.Picture, options.Output);
  if (!options.StatisticsFile.empty())
  {
    WriteStatistics(made.Statistics, frame.Statistics, options.StatisticsFile);
  }
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
  return pellucid::RunProgram([&options] { Run(options); });
}
