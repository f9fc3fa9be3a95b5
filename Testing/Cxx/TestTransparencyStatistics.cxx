// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Stages keep the order in which they first ran and add up; Reset forgets everything.
#include "vtkNew.h"
#include "vtkTransparencyStatistics.h"

#include <iostream>

namespace
{
bool Check(bool condition, const char* what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
  }
  return condition;
}
}

int TestTransparencyStatistics(int, char*[])
{
  vtkNew<vtkTransparencyStatistics> statistics;
  statistics->SetFragments(3);
  statistics->AddStage("gather", 1.5);
  statistics->AddStage("resolve", 4.0);
  statistics->AddStage("gather", 2.0);

  bool passed = Check(statistics->GetNumberOfStages() == 2, "a repeated stage is one stage");
  passed &= Check(statistics->GetStageName(0) == "gather", "stages keep their order");
  passed &= Check(statistics->GetStageMilliseconds(0) == 3.5, "a repeated stage adds up");
  passed &= Check(statistics->GetStageMilliseconds("resolve") == 4.0, "a stage is found by name");
  passed &= Check(statistics->GetStageMilliseconds("sort") == 0.0, "an unknown stage took no time");

  statistics->Reset();
  passed &= Check(statistics->GetFragments() == 0, "Reset forgets the counts");
  passed &= Check(statistics->GetNumberOfStages() == 0, "Reset forgets the stages");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
