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
struct Scene;

/**
 * Place the renderer's camera as the options say. What they leave open: look slightly from above,
 * the longer horizontal side of the scene across the picture, the up axis up, and so near that the
 * points fill a picture of width / height = `aspect`; a flat scene is seen from the front.
 */
void SetUpCamera(
  vtkRenderer* renderer, const Scene& scene, const RenderOptions& options, double aspect);
}

#endif
