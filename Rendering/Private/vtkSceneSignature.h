// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the fragments of a frame depend on: camera, lights, props and their data, size. As long as
 * it stays the same, so do the fragment lists. Needs no OpenGL.
 */

#ifndef vtkSceneSignature_h
#define vtkSceneSignature_h

#include "vtkFragmentTiles.h" // for vtkPixelRectangle
#include "vtkType.h"

#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkActor;
class vtkMatrix4x4;
class vtkObject;
class vtkProp;
class vtkRenderState;
class vtkRenderer;

class vtkSceneSignature
{
public:
  vtkSceneSignature() = default;

  /** Of what a frame draws into that rectangle. */
  vtkSceneSignature(const vtkRenderState* state, const vtkPixelRectangle& image);

  /**
   * Whether the other frame draws the same. False also where that cannot be known: for props that
   * are neither a plain vtkActor nor ParaView's vtkPVLODActor, with a vtkPolyDataMapper, for
   * textures, image-based lighting, shaders with observers, and a depth buffer that is kept from
   * elsewhere.
   */
  bool IsSame(const vtkSceneSignature& other) const;

private:
  void AddObject(vtkObject* object);
  void AddMatrix(vtkMatrix4x4* matrix);
  void AddView(vtkRenderer* renderer);
  void AddCoincidentTopology();
  bool AddProp(vtkProp* prop);
  bool AddActor(vtkActor* actor);

  bool Certain = false;
  std::vector<std::pair<const vtkObject*, vtkMTimeType>> Objects; ///< compared, never used
  std::vector<double> Numbers;
  std::vector<std::string> Names;
};

VTK_ABI_NAMESPACE_END
#endif
