// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryFileError
 * @brief   Why a trajectory file cannot be read; thrown and caught inside the readers.
 *
 * The message says what was expected, what was found and, where it helps, what to do. It does not
 * name the file: vtkTrajectoryReader puts the name before it. What it quotes of a damaged file may
 * be any bytes; those that are not printable ASCII become question marks.
 */

#ifndef vtkTrajectoryFileError_h
#define vtkTrajectoryFileError_h

#include "vtkErrorCode.h"

#include <algorithm>
#include <stdexcept>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkTrajectoryFileError : public std::runtime_error
{
public:
  explicit vtkTrajectoryFileError(
    const std::string& message, unsigned long code = vtkErrorCode::FileFormatError)
    : std::runtime_error(MakePrintable(message))
    , Code(code)
  {
  }

  /** vtkErrorCode::ErrorIds */
  unsigned long GetCode() const { return this->Code; }

private:
  static std::string MakePrintable(std::string text)
  {
    std::replace_if(
      text.begin(), text.end(), [](char byte) { return byte < ' ' || byte > '~'; }, '?');
    return text;
  }

  unsigned long Code;
};

VTK_ABI_NAMESPACE_END
#endif
