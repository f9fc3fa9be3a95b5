// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The standard error stream, which libraries must not write to.
 */

#ifndef ErrorStream_h
#define ErrorStream_h

#include <cstddef> // for std::size_t

namespace pellucid
{
namespace ErrorStream
{
/** Drop what others write to the stream, as some C libraries do without being asked. */
void Mute();

/** End Mute(). */
void Unmute();

/** Write to the stream, muted or not; may be called in a signal handler. */
void Write(const char* text, std::size_t size);

/** Whether a person reads the stream. */
bool IsTerminal();
}
}

#endif
