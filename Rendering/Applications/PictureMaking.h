// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The ways to draw a scene: exact, stock VTK, side by side, reference.
 */

#ifndef PictureMaking_h
#define PictureMaking_h

#include "FrameStatistics.h"
#include "RenderScene.h"

#include "vtkImageData.h"

class vtkExactTransparencyPass;

namespace pellucid
{
struct Frame
{
  vtkSmartPointer<vtkImageData> Picture; // 3 or 4 components of unsigned char
  FrameStatistics Statistics;
};

/** Install the exact pass with the options' view and limits; again, to give it other options. */
vtkExactTransparencyPass* MakeExact(vtkRenderer* renderer, const RenderOptions& options);

/** Draw the scene as the options say; throw RenderError when that cannot be done. */
Frame MakePicture(const Scene& scene, const RenderOptions& options);
}

#endif
