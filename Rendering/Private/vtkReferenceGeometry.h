// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkReferenceGeometry.h
 * @brief   Turns the data of VTK mappers into triangles and tubes of a scene.
 */

#ifndef vtkReferenceGeometry_h
#define vtkReferenceGeometry_h

#include "RayScene.h"
#include "vtkDisplayedLeaf.h"
#include "vtkOptimizedScene.h" // for the members

#include "vtkCompositeDataIterator.h" // for visiting the leaves
#include "vtkCompositeDataSet.h"      // for visiting the leaves
#include "vtkSmartPointer.h"          // for the iterator

VTK_ABI_NAMESPACE_BEGIN
class vtkGlyph3DMapper;
class vtkMapper;
class vtkPolyData;
class vtkProperty;

/** What a mapper's data needs to become primitives of a scene. */
struct vtkReferenceTarget
{
  pellucid::Scene<double>& scene;
  vtkMapper* mapper;
  vtkProperty* property;
  pellucid::Surface<double> surface; ///< all but its colour source, which depends on the data
  glm::dmat4 modelToView;
  const char* opacityArray = nullptr;           ///< name of a point array of factors on the opacity
  const vtkOptimizedScene* optimized = nullptr; ///< where opacities follow from importance
  const vtkOptimizedScene::Member* member = nullptr; ///< the actor's entry there
  vtkBlockDisplay display{}; ///< what the data has in place of the surface's
};

/** What of the data cannot be drawn. */
struct vtkReferenceRejects
{
  vtkIdType invalid = 0; ///< cells, or points of lines, with coordinates that are not finite
  vtkIdType pixels = 0;  ///< vertices and lines that a surface mapper draws one pixel wide

  void operator+=(const vtkReferenceRejects& other)
  {
    this->invalid += other.invalid;
    this->pixels += other.pixels;
  }
};

/** Calls visit(leaf) for every leaf of that type of a composite, or for a plain data set itself. */
template <typename Leaf, typename Visit>
void vtkForEachLeaf(vtkDataObject* data, Visit&& visit)
{
  if (auto* leaf = Leaf::SafeDownCast(data))
  {
    visit(leaf);
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      vtkForEachLeaf<Leaf>(it->GetCurrentDataObject(), visit);
    }
  }
}

/** Add polygons and strips, divided into triangles as VTK's mappers divide them. */
vtkReferenceRejects vtkAddReferencePolygons(vtkReferenceTarget& target, vtkPolyData* data);

/**
 * Add lines as tubes and vertices as spheres, of the radii in the point array `radiusArray` or, if
 * there is no such array, all of `radius`; world units. Polygons and strips are added too. The
 * matrix of the actor moves the points; radii are not scaled by it. The opacity array of the target
 * applies to all of these.
 */
vtkReferenceRejects vtkAddReferenceTrajectories(
  vtkReferenceTarget& target, vtkPolyData* data, double radius, const char* radiusArray);

/** Add the polygons of all glyphs. */
vtkReferenceRejects vtkAddReferenceGlyphs(vtkReferenceTarget& target, vtkGlyph3DMapper* mapper);

VTK_ABI_NAMESPACE_END
#endif
