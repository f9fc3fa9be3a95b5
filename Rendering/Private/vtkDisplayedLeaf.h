// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    vtkDisplayedLeaf.h
 * @brief   The leaves of composite data, and what vtkCompositeDataDisplayAttributes says of each.
 *
 * What is set for a block holds for all below it for which it is not set anew, as in
 * vtkCompositePolyDataMapper: also a visible block within an invisible one is drawn. Needs no
 * OpenGL.
 */

#ifndef vtkDisplayedLeaf_h
#define vtkDisplayedLeaf_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h" // for the leaves

#include <array>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkCompositeDataDisplayAttributes;

/** How a block looks. */
struct vtkBlockDisplay
{
  bool Visible = true;
  bool Pickable = true;
  std::optional<double> Opacity;              ///< in place of that of the property
  std::optional<std::array<double, 3>> Color; ///< in place of those of scalars and property

  /** Whether a picture, or a selection, shows the block. */
  bool IsDrawn(bool selecting) const { return this->Visible && (this->Pickable || !selecting); }

  bool operator==(const vtkBlockDisplay& other) const
  {
    return this->Visible == other.Visible && this->Pickable == other.Pickable &&
      this->Opacity == other.Opacity && this->Color == other.Color;
  }
};

/** One vtkPolyData, and its flat index in the composite data (1: not composite). */
struct vtkDisplayedLeaf
{
  vtkSmartPointer<vtkPolyData> Data;
  unsigned int FlatIndex;
  vtkBlockDisplay Display;
};

/** All vtkPolyData with points in some data, or that itself; `attributes` may be null. */
std::vector<vtkDisplayedLeaf> vtkFindDisplayedLeaves(
  vtkDataObject* data, vtkCompositeDataDisplayAttributes* attributes);

VTK_ABI_NAMESPACE_END
#endif
