// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The options of opacities that clear the view, and the parameters that they stand for.
 */

#ifndef OpacityOptions_h
#define OpacityOptions_h

#include "RenderOptions.h"

#include "vtkImportanceDrivenOpacity.h"
#include "vtkSmartPointer.h"

namespace CLI
{
class App;
}

namespace pellucid
{
void AddOpacityOptions(CLI::App& app, OpacityOptions& options);

/**
 * Find the rule from the options that were given. Throw CLI::ValidationError where one has no
 * effect beside the others.
 */
void CompleteOpacityOptions(RenderOptions& options);

/**
 * What to attach to the actors of surfaces, or to others; null where the importance is a factor.
 * Surfaces take few of the preset's steps of smoothing.
 */
vtkSmartPointer<vtkImportanceDrivenOpacity> MakeOpacityParameters(
  const OpacityOptions& options, bool isSurface);
}

#endif
