// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Readers of trajectories and tractograms, set up as the options say.
 */

#ifndef TrajectoryFiles_h
#define TrajectoryFiles_h

#include "vtkSmartPointer.h"
#include "vtkTrajectoryReader.h"

#include <string> // for the name

namespace pellucid
{
struct RenderOptions;

/** A reader of the file or folder, chosen by its content; null if it holds no trajectories. */
vtkSmartPointer<vtkTrajectoryReader> MakeTrajectoryReader(
  const std::string& fileName, const RenderOptions& options);
}

#endif
