// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "MessageLog.h"

#include "PlainText.h"
#include "Program.h"
#include "RenderError.h"

#include "vtkLogger.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"

#include <iostream>
#include <regex>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
// Hands VTK's messages to the log.
class LogWindow : public vtkOutputWindow
{
public:
  static LogWindow* New();
  vtkTypeMacro(LogWindow, vtkOutputWindow);

  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override { MessageLog::GetInstance().AddError(text); }
  void DisplayWarningText(const char* text) override { MessageLog::GetInstance().AddWarning(text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }
  void DisplayDebugText(const char*) override {}
};

vtkStandardNewMacro(LogWindow);

constexpr std::size_t LongestMessage = 300;

//------------------------------------------------------------------------------
// "ERROR: In file, line n\nvtkClass (0x1234): text\n\n" becomes "text"; the pipeline's own error, a
// dump of a failed request, becomes nothing.
std::string Strip(const std::string& message)
{
  static const std::regex place("^[A-Za-z ]+: In [^\n]*, line [0-9]+\n");
  static const std::regex object("^vtk[A-Za-z0-9_]+ \\(0x[0-9a-f]+\\): ");
  static const std::regex executive("^Algorithm vtk.* returned failure for request:[^]*");
  static const std::regex space("\\s+");
  std::string text = std::regex_replace(message, place, "");
  text = std::regex_replace(text, object, "");
  text = std::regex_replace(text, executive, "");
  text = std::regex_replace(text, space, " ");
  text.erase(text.find_last_not_of(' ') + 1);
  return text.size() <= LongestMessage ? text : text.substr(0, LongestMessage) + "...";
}
}

//------------------------------------------------------------------------------
MessageLog& MessageLog::GetInstance()
{
  static MessageLog log;
  static const bool isInstalled = []
  {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(vtkNew<LogWindow>());
    return true;
  }();
  static_cast<void>(isInstalled);
  return log;
}

//------------------------------------------------------------------------------
void MessageLog::Clear()
{
  this->Errors.clear();
  this->Warnings.clear();
}

//------------------------------------------------------------------------------
std::string MessageLog::GetFirstError() const
{
  return this->Errors.empty() ? std::string() : this->Errors.front();
}

//------------------------------------------------------------------------------
std::string MessageLog::GetFirstWarning() const
{
  return this->Warnings.empty() ? std::string() : this->Warnings.front();
}

//------------------------------------------------------------------------------
void MessageLog::PrintWarnings()
{
  for (const std::string& warning : this->Warnings)
  {
    std::cerr << ProgramName << ": warning: " << MakePrintable(warning) << "\n";
    this->PrintedWarning = warning;
  }
  this->Clear();
}

//------------------------------------------------------------------------------
void MessageLog::AddError(const std::string& text)
{
  this->Errors.push_back(Strip(text));
  if (this->Throwing)
  {
    throw RenderError(this->Errors.back());
  }
}

//------------------------------------------------------------------------------
void MessageLog::AddWarning(const std::string& text)
{
  this->Warnings.push_back(Strip(text));
}
}
