// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorStream.h"

#include <fcntl.h>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace pellucid
{
namespace ErrorStream
{
namespace
{
constexpr int StandardError = 2;

#ifdef _WIN32
constexpr const char* Nowhere = "NUL";
int Open(const char* name)
{
  return _open(name, _O_WRONLY);
}
int Duplicate(int file)
{
  return _dup(file);
}
void Replace(int file, int target)
{
  _dup2(file, target);
}
void Close(int file)
{
  _close(file);
}
bool IsTerminal(int file)
{
  return _isatty(file) != 0;
}
long WriteTo(int file, const char* text, std::size_t size)
{
  return _write(file, text, static_cast<unsigned int>(size));
}
#else
constexpr const char* Nowhere = "/dev/null";
int Open(const char* name)
{
  return open(name, O_WRONLY);
}
int Duplicate(int file)
{
  return dup(file);
}
void Replace(int file, int target)
{
  dup2(file, target);
}
void Close(int file)
{
  close(file);
}
bool IsTerminal(int file)
{
  return isatty(file) != 0;
}
long WriteTo(int file, const char* text, std::size_t size)
{
  return write(file, text, size);
}
#endif

int Original = StandardError; // where the stream leads while it is muted
}

//------------------------------------------------------------------------------
void Mute()
{
  const int nowhere = Open(Nowhere);
  const int original = Duplicate(StandardError);
  if (nowhere >= 0 && original >= 0)
  {
    Replace(nowhere, StandardError);
    Original = original;
  }
  if (nowhere >= 0)
  {
    Close(nowhere);
  }
}

//------------------------------------------------------------------------------
void Unmute()
{
  if (Original != StandardError)
  {
    Replace(Original, StandardError);
    Close(Original);
    Original = StandardError;
  }
}

//------------------------------------------------------------------------------
void Write(const char* text, std::size_t size)
{
  while (size > 0)
  {
    const long written = WriteTo(Original, text, size);
    if (written <= 0)
    {
      return;
    }
    text += written;
    size -= static_cast<std::size_t>(written);
  }
}

//------------------------------------------------------------------------------
bool IsTerminal()
{
  return IsTerminal(Original);
}
}
}
