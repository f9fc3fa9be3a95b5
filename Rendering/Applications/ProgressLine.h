// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Progress of long work on the terminal.
 */

#ifndef ProgressLine_h
#define ProgressLine_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <chrono> // for the delay
#include <string> // for the label

class vtkCallbackCommand;
class vtkObject;

namespace pellucid
{
/**
 * Writes "label: 40 %" to the standard error stream while an object reports progress: rewriting one
 * line on a terminal; elsewhere in steps of ten per cent, and nothing in the first second.
 */
class ProgressLine
{
public:
  /** Observe ProgressEvent, whose call data is a double in [0, 1], until destroyed. */
  ProgressLine(vtkObject* worker, std::string label);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  void operator=(const ProgressLine&) = delete;

private:
  void Show(double progress);
  void Write(const std::string& text) const;

  vtkSmartPointer<vtkObject> Worker;
  vtkNew<vtkCallbackCommand> Observer;
  std::string Label;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  bool IsTerminal;
  int Shown = -1; // per cent
};
}

#endif
