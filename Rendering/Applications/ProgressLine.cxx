// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ProgressLine.h"

#include "ErrorStream.h"

#include "vtkCallbackCommand.h"

#include <algorithm>

namespace pellucid
{
//------------------------------------------------------------------------------
ProgressLine::ProgressLine(vtkObject* worker, std::string label)
  : Worker(worker)
  , Label(std::move(label))
  , IsTerminal(ErrorStream::IsTerminal())
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
    this->Write("\r\033[K");
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
  const std::string text = this->Label + ": " + std::to_string(percent) + " %";
  this->Write(this->IsTerminal ? "\r" + text : text + "\n");
}

//------------------------------------------------------------------------------
void ProgressLine::Write(const std::string& text) const
{
  ErrorStream::Write(text.data(), text.size());
}
}
