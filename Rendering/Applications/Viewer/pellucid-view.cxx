// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Shows files with exact transparency in a window; see pellucid-view --help.
 *
 * Exit codes: 0 the window was closed, or the picture is written; 1 that could not be done; 2 wrong
 * usage. EmbeddedView.h tells how to use Pellucid in a window of one's own.
 */

#include "MessageLog.h"
#include "Program.h"
#include "ViewOptions.h"
#include "Viewer.h"

const char* const pellucid::ProgramName = "pellucid-view";

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  pellucid::MessageLog::GetInstance();
  std::optional<int> exitCode;
  const auto options = pellucid::ParseViewCommandLine(argc, argv, exitCode);
  if (exitCode)
  {
    return *exitCode;
  }
  return pellucid::RunProgram(
    [&options]
    {
      pellucid::Viewer viewer(options);
      if (options.Output.empty())
      {
        viewer.Run();
      }
      else
      {
        viewer.WriteScreenshot();
      }
    });
}
