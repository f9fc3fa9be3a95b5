// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What ends the program: a one-line message for the user.
 */

#ifndef RenderError_h
#define RenderError_h

#include <stdexcept> // for the base class

namespace pellucid
{
/** Thrown when the picture cannot be made; what() is one line that says why and what to do. */
class RenderError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
}

#endif
