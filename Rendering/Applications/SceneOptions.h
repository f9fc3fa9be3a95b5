// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The options that the programs share, and how a command line is parsed.
 */

#ifndef SceneOptions_h
#define SceneOptions_h

#include "OptionGroup.h"

namespace pellucid
{
/** Size and background. */
void AddFrameOptions(OptionGroup& group, RenderOptions& options);

/** Method and memory limit. */
void AddMethodOptions(OptionGroup& group, RenderOptions& options);

/** What is drawn and how it looks: groups of their own, from appearance to streamlines. */
void AddSceneOptions(CLI::App& app, RenderOptions& options);

/** The kinds of files that are read, for the foot of a help. */
std::string DescribeInputs();

/**
 * Parse, then check what was given together; `check` may throw CLI::ParseError. Where the program
 * has nothing left to do (help, version, or an error, which is printed), `exitCode` is set: 0, or 2
 * for wrong usage.
 */
void Parse(CLI::App& app, int argc, char* argv[], const std::function<void()>& check,
  std::optional<int>& exitCode);
}

#endif
