// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameStages_h
#define FrameStages_h

#include "vtkExactTransparencyPass.h"

#include <string>

/** The stages that the last frame of a pass has run, with a blank after each. */
inline std::string GetStages(vtkExactTransparencyPass* pass)
{
  vtkTransparencyStatistics* statistics = pass->GetStatistics();
  std::string stages;
  for (int stage = 0; stage < statistics->GetNumberOfStages(); ++stage)
  {
    stages += statistics->GetStageName(stage) + " ";
  }
  return stages;
}

/** Whether the last frame of a pass has run a stage. */
inline bool RanStage(vtkExactTransparencyPass* pass, const std::string& stage)
{
  return (" " + GetStages(pass)).find(" " + stage + " ") != std::string::npos;
}

/** Those of an unchanged view. */
constexpr const char* UnchangedStages = "opaque copy resolve ";

#endif
