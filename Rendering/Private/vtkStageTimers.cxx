// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkStageTimers.h"

#include "vtkOpenGLError.h" // for OpenGL itself
#include "vtkTimerLog.h"
#include "vtkTransparencyStatistics.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
vtkOpenGLRenderTimer& vtkStageTimers::Start(const char* name)
{
  if (this->Used == this->Stages.size())
  {
    this->Stages.push_back({ name, std::make_unique<vtkOpenGLRenderTimer>() });
  }
  Stage& stage = this->Stages[this->Used];
  ++this->Used;
  stage.Name = name;
  stage.Timer->Reset();
  stage.Timer->Start();
  return *stage.Timer;
}

//------------------------------------------------------------------------------
void vtkStageTimers::Collect(vtkTransparencyStatistics* statistics)
{
  if (this->Used > 0)
  {
    glFinish();
  }
  for (std::size_t i = 0; i < this->Used; ++i)
  {
    const Stage& stage = this->Stages[i];
    statistics->AddStage(
      stage.Name, static_cast<double>(stage.Timer->GetElapsedNanoseconds()) * 1e-6);
    // A timer that holds queries would delete them in its destructor, perhaps without a context.
    stage.Timer->Reset();
  }
  this->Used = 0;
  // Each once, although a stage may have run for several tiles.
  for (int stage = 0; stage < statistics->GetNumberOfStages(); ++stage)
  {
    vtkTimerLog::InsertTimedEvent(("Pellucid " + statistics->GetStageName(stage)).c_str(),
      statistics->GetStageMilliseconds(stage) * 1e-3, 0);
  }
}

VTK_ABI_NAMESPACE_END
