// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ReaderGuard.h"

#include "ErrorStream.h"
#include "Program.h"

#include <csignal>
#include <cstdlib>

namespace pellucid
{
namespace
{
// A signal handler may neither allocate nor use streams.
std::string LastWords;

extern "C" void EndProgram(int)
{
  ErrorStream::Write(LastWords.data(), LastWords.size());
  std::_Exit(1);
}

constexpr int Signals[] = { SIGABRT, SIGFPE, SIGSEGV };
}

//------------------------------------------------------------------------------
ReaderGuard::ReaderGuard(const std::string& message)
{
  LastWords = std::string(ProgramName) + ": " + message + "\n";
  ErrorStream::Mute();
  for (const int signal : Signals)
  {
    std::signal(signal, EndProgram);
  }
}

//------------------------------------------------------------------------------
ReaderGuard::~ReaderGuard()
{
  for (const int signal : Signals)
  {
    std::signal(signal, SIG_DFL);
  }
  ErrorStream::Unmute();
}
}
