// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   VTK's messages, kept for ours instead of printed.
 */

#ifndef MessageLog_h
#define MessageLog_h

#include <string>  // for messages
#include <utility> // for std::exchange
#include <vector>  // for the log

namespace pellucid
{
/**
 * Takes all errors and warnings of VTK from the first call of GetInstance() on; nothing reaches the
 * terminal by itself.
 */
class MessageLog
{
public:
  static MessageLog& GetInstance();

  void Clear();
  bool HasErrors() const { return !this->Errors.empty(); }
  bool HasWarnings() const { return !this->Warnings.empty(); }

  /** Text of the first error on one short line, without the place in VTK's sources; or empty. */
  std::string GetFirstError() const;

  /** The same of the first warning. */
  std::string GetFirstWarning() const;

  /** Print all warnings since Clear(), one line each, as what the user should know of; then clear.
   */
  void PrintWarnings();

  /** The last warning that was printed since this was called before; or empty. */
  std::string TakePrintedWarning() { return std::exchange(this->PrintedWarning, {}); }

  /**
   * Throw RenderError at every error while this is on. For the making of a window only: VTK
   * ends the process right after some errors there, such as a missing X server.
   */
  void SetThrowing(bool throwing) { this->Throwing = throwing; }

  void AddError(const std::string& text);
  void AddWarning(const std::string& text);

private:
  MessageLog() = default;

  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
  std::string PrintedWarning;
  bool Throwing = false;
};
}

#endif
