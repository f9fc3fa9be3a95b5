// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkReferenceScene.h
 * @brief   Takes a VTK scene apart into the primitives of RayScene.h.
 */

#ifndef vtkReferenceScene_h
#define vtkReferenceScene_h

#include "RayScene.h"
#include "vtkOptimizedScene.h"

#include "vtkABINamespace.h" // for the namespace macros
#include "vtkType.h"         // for vtkIdType

#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkLight;
class vtkMapper;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;

/** The scene of a renderer, and what of it cannot be drawn. */
class vtkReferenceScene
{
public:
  /** Take over camera, lights and all visible props of the renderer for an image of that size. */
  vtkReferenceScene(vtkRenderer* renderer, int width, int height);

  const pellucid::Scene<double>& GetScene() const { return this->Scene; }

  /** The actors whose opacities follow from importance. */
  const vtkOptimizedScene& GetOptimizedScene() const { return this->Optimized; }

  /** Kind of what was left out -> how many of it. */
  const std::map<std::string, vtkIdType>& GetOmissions() const { return this->Omissions; }

private:
  void TakeCamera(vtkRenderer* renderer, int width, int height);
  void TakeLights(vtkRenderer* renderer);
  pellucid::Light<double> MakeLight(vtkLight* source) const;
  void TakeProp(vtkProp* prop);
  void TakeActor(vtkActor* actor, vtkMatrix4x4* modelToWorld);
  pellucid::Surface<double> MakeSurface(vtkActor* actor, vtkMapper* mapper);
  glm::dmat3 NormalToView() const;
  void Omit(const std::string& kind, vtkIdType count = 1);

  pellucid::Scene<double> Scene;
  vtkOptimizedScene Optimized;
  glm::dmat4 WorldToView{ 1.0 };
  std::map<std::string, vtkIdType> Omissions;
};

VTK_ABI_NAMESPACE_END
#endif
