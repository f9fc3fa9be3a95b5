// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The command line of pellucid-view.
 */

#ifndef ViewOptions_h
#define ViewOptions_h

#include "RenderOptions.h"

namespace pellucid
{
/** What the mouse and the keys do, in lines. */
extern const char* const Controls;

/**
 * The options of a command line; the output is empty where a window is to be shown. Where the
 * program has nothing left to do (help, version, or an error, which is printed), `exitCode` is set:
 * 0, or 2 for wrong usage.
 */
RenderOptions ParseViewCommandLine(int argc, char* argv[], std::optional<int>& exitCode);
}

#endif
