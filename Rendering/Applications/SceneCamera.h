// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The camera of a picture.
 */

#ifndef SceneCamera_h
#define SceneCamera_h

class vtkRenderer;

namespace pellucid
{
struct RenderOptions;

/**
 * Place the renderer's camera as the options say. What they leave open: look slightly from above at
 * the middle of the scene, its longer horizontal side across a picture of width / height =
 * `aspect`, z up, and near enough to fill the picture; flat scenes are seen from the front.
 */
void SetUpCamera(vtkRenderer* renderer, const RenderOptions& options, double aspect);
}

#endif
