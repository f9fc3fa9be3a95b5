// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProgressLine.h"

#include "vtkCallbackCommand.h"

#include <algorithm>
#include <iostream>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
bool IsErrorStreamTerminal()
{
#ifdef _WIN32
  return _isatty(2) != 0;
#else
  return isatty(2) != 0;
#endif
}
}

//------------------------------------------------------------------------------
ProgressLine::ProgressLine(vtkObject* worker, std::string label)
  : Worker(worker)
  , Label(std::move(label))
  , IsTerminal(IsErrorStreamTerminal())
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long, void* line, void* progress)
    {
      if (progress)
      {
        static_cast<ProgressLine*>(line)->Show(*static_cast<double*>(progress));
      }
    });
  worker->AddObserver(vtkCommand::ProgressEvent, this->Observer);
}

//------------------------------------------------------------------------------
ProgressLine::~ProgressLine()
{
  this->Worker->RemoveObserver(this->Observer);
  if (this->IsTerminal && this->Shown >= 0)
  {
    std::cerr << "\r\033[K" << std::flush;
  }
}

//------------------------------------------------------------------------------
void ProgressLine::Show(double progress)
{
  const int percent = static_cast<int>(100.0 * std::clamp(progress, 0.0, 1.0));
  const auto elapsed = std::chrono::steady_clock::now() - this->Start;
  if (elapsed < std::chrono::seconds(1) || percent < this->Shown + (this->IsTerminal ? 1 : 10))
  {
    return;
  }
  this->Shown = percent;
  std::cerr << (this->IsTerminal ? "\r" : "") << this->Label << ": " << percent << " %"
            << (this->IsTerminal ? "" : "\n") << std::flush;
}
}
