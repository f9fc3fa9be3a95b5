// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPolygonPartMapper.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPolygonPartMapper);

//------------------------------------------------------------------------------
void vtkPolygonPartMapper::BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data)
{
  this->Superclass::BuildIBO(renderer, actor, data);
  this->Primitives[PrimitivePoints].IBO->IndexCount = 0;
  this->Primitives[PrimitiveLines].IBO->IndexCount = 0;
}

//------------------------------------------------------------------------------
void vtkPolygonPartMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  // What the superclass does after drawing the lines: cell ids and colours start at the polygons.
  this->PrimitiveIDOffset = this->CellCellMap->GetPrimitiveOffsets()[PrimitiveTris];
  this->Superclass::RenderPieceDraw(renderer, actor);
}

VTK_ABI_NAMESPACE_END
