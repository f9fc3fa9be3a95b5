// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Keeps a crash of a file reader from being the last word.
 */

#ifndef ReaderGuard_h
#define ReaderGuard_h

#include <string> // for the message

namespace pellucid
{
/**
 * While one lives, a fault or an abort ends the program with exit code 1 and `message` on the
 * standard error stream: some of VTK's readers end the process on damaged files, by assertions,
 * failed allocations or reading beyond their data. One at a time.
 */
class ReaderGuard
{
public:
  explicit ReaderGuard(const std::string& message);
  ~ReaderGuard();
  ReaderGuard(const ReaderGuard&) = delete;
  void operator=(const ReaderGuard&) = delete;
};
}

#endif
