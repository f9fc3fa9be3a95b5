// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectoryColors
 * @brief   Colours of trajectory nodes, mapped as vtkMapper maps scalars.
 *
 * Point data colours nodes, cell data all nodes of a cell, field data all nodes or each cell
 * (vtkMapper::SetFieldDataTupleId). Nodes whose leaf lacks the array get a plain colour, or with
 * InterpolateScalarsBeforeMapping the lookup table's colour of NaN.
 */

#ifndef vtkTrajectoryColors_h
#define vtkTrajectoryColors_h

#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkSmartPointer.h" // for the colour map
#include "vtkTrajectoryNodes.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkTrajectoryColors
{
public:
  /** Map the scalars that `mapper` is set to colour by. `plain` is an RGBA colour. */
  void Map(
    vtkMapper* mapper, const vtkTrajectoryNodes& nodes, const std::array<unsigned char, 4>& plain);

  std::vector<unsigned char> Direct; ///< RGBA for each node, or empty
  std::vector<float> Coordinates;    ///< (s, t) in ColorMap for each node, or empty
  vtkSmartPointer<vtkImageData> ColorMap;
  bool UsesPlain = false; ///< some nodes, but not all, have the plain colour
};

VTK_ABI_NAMESPACE_END
#endif
