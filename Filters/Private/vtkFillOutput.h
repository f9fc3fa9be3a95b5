// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkFillOutput.h
 * @brief   The frame of a filter's RequestData().
 *
 * Private to the module.
 */

#ifndef vtkFillOutput_h
#define vtkFillOutput_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"

#include <stdexcept> // for errors

VTK_ABI_NAMESPACE_BEGIN

/**
 * Call `fill()`, which returns false when aborted and throws a std::logic_error with a message for
 * the user; either leaves `output` empty. Returns what RequestData() does: 0 after an error,
 * else 1.
 */
template <typename Function>
int vtkFillOutput(vtkAlgorithm* filter, vtkDataObject* output, Function&& fill)
{
  try
  {
    if (!fill())
    {
      output->Initialize();
    }
    return 1;
  }
  catch (const std::logic_error& error)
  {
    output->Initialize();
    vtkErrorWithObjectMacro(filter, << error.what());
    return 0;
  }
}

VTK_ABI_NAMESPACE_END
#endif
