// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What the programs have in common: a name, and how they end.
 */

#ifndef Program_h
#define Program_h

#include <functional> // for the work
#include <string>     // for messages

namespace pellucid
{
/** Begins the messages. Each program defines its own. */
extern const char* const ProgramName;

/** Write the message after the program's name, in one line, on the standard error stream. */
void PrintError(const std::string& message);

/** Do the work: 0, or 1 after one line on the standard error stream where it throws. */
int RunProgram(const std::function<void()>& work);
}

#endif
