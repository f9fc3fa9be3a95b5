// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Program.h"

#include "PlainText.h"

#include <exception>
#include <iostream>
#include <new>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
int Fail(const std::string& message)
{
  std::cerr << ProgramName << ": " << MakePrintable(message) << "\n";
  return 1;
}
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
    return Fail("out of memory; the input may be damaged, or too large for this machine");
  }
  catch (const std::exception& error)
  {
    return Fail(error.what());
  }
}
}
