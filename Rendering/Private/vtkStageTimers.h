// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/** GPU time of the named stages of a frame, on VTK's own timer queries. */

#ifndef vtkStageTimers_h
#define vtkStageTimers_h

#include "vtkABINamespace.h"
#include "vtkOpenGLRenderTimer.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkTransparencyStatistics;

class vtkStageTimers
{
public:
  /** Times one stage for the life of the object. */
  class Scope
  {
  public:
    Scope(vtkStageTimers& timers, const char* name)
      : Timer(timers.Start(name))
    {
    }
    ~Scope() { this->Timer.Stop(); }
    Scope(const Scope&) = delete;
    void operator=(const Scope&) = delete;

  private:
    vtkOpenGLRenderTimer& Timer;
  };

  /**
   * Wait for the stages of this frame, add them to the statistics of the frame and start anew.
   * VTK's timer log gets an event for each stage, "Pellucid gather" for example: seconds of GPU
   * time.
   */
  void Collect(vtkTransparencyStatistics* statistics);

private:
  vtkOpenGLRenderTimer& Start(const char* name);

  struct Stage
  {
    std::string Name;
    std::unique_ptr<vtkOpenGLRenderTimer> Timer;
  };
  // Timers are kept from frame to frame; the first `Used` belong to this one.
  std::vector<Stage> Stages;
  std::size_t Used = 0;
};

VTK_ABI_NAMESPACE_END
#endif
