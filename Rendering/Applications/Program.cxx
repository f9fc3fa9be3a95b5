// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Program.h"

#include "PlainText.h"

#include <exception>
#include <iostream>
#include <new>

namespace pellucid
{
//------------------------------------------------------------------------------
void PrintError(const std::string& message)
{
  std::cerr << ProgramName << ": " << MakePrintable(message) << std::endl;
}

//------------------------------------------------------------------------------
int RunProgram(const std::function<void()>& work)
{
  try
  {
    work();
    return 0;
  }
  catch (const std::bad_alloc&)
  {
    PrintError("out of memory; the input may be damaged, or too large for this machine");
  }
  catch (const std::exception& error)
  {
    PrintError(error.what());
  }
  return 1;
}
}
