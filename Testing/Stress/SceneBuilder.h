// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    SceneBuilder.h
 * @brief   Makes the props, lights and camera of a SceneDescription.
 */

#ifndef SceneBuilder_h
#define SceneBuilder_h

#include "SceneDescription.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace pellucid
{
/** In which order a scene is put together; the picture is the same. Opaque props keep their order
 * in a scene that does not keep its depths: OpenGL shows one of those of equal depth. */
enum class BuildOrder
{
  Forward,
  Shuffled
};

/** Whether the description makes an actor that nothing shines through. */
bool IsOpaque(const PropDescription& prop);

/** Whether depths in single precision tell apart what lies in the scene. */
bool KeepsDepths(const SceneDescription& scene);

vtkSmartPointer<vtkPolyData> MakeData(
  const SceneDescription& scene, const PropDescription& prop, BuildOrder order);

vtkSmartPointer<vtkActor> MakeActor(
  const SceneDescription& scene, const PropDescription& prop, BuildOrder order);

/** All of it, the camera with the clipping range for a window of the scene's size included. */
vtkSmartPointer<vtkRenderer> MakeRenderer(const SceneDescription& scene, BuildOrder order);
}

#endif
