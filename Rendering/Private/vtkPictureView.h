// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the resolve shows of the sorted lists; see vtkExactTransparencyPass::Views.
 */

#ifndef vtkPictureView_h
#define vtkPictureView_h

#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN

struct vtkPictureView
{
  int Kind = 0;              ///< vtkExactTransparencyPass::Views
  int Layer = 1;             ///< counted from 1, the nearest
  vtkIdType LongestList = 0; ///< of the picture
  bool RoundsLayers = false; ///< vtkExactTransparencyPass::RoundTranslucentLayers
};

VTK_ABI_NAMESPACE_END
#endif
