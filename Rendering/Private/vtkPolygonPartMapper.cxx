// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkPolygonPartMapper.h"

#include "vtkBlockDisplayShader.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkRenderer.h"
#include "vtkShaderEdit.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkPolygonPartMapper);

//------------------------------------------------------------------------------
void vtkPolygonPartMapper::SetPointOpacities(vtkFloatArray* factors)
{
  this->PointOpacities = factors;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkPolygonPartMapper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  // The superclass uploads it with its own attributes, and forgets it when it is null.
  this->VBOs->CacheDataArray("pointOpacity", this->PointOpacities, renderer, VTK_FLOAT);
  this->Superclass::BuildBufferObjects(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkPolygonPartMapper::ReplaceShaderColor(
  std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor)
{
  {
    vtkShaderEdit fragment(shaders[vtkShader::Fragment]);
    vtkAddBlockColor(fragment);
  }
  if (this->PointOpacities)
  {
    vtkShaderEdit vertex(shaders[vtkShader::Vertex]);
    vtkShaderEdit geometry(shaders[vtkShader::Geometry]); // of wide lines and edges
    vtkShaderEdit fragment(shaders[vtkShader::Fragment]);
    vertex.Append("//VTK::Color::Dec",
      "in float pointOpacity;\n"
      "out float pointOpacityVSOutput;\n");
    vertex.Append("//VTK::Color::Impl", "  pointOpacityVSOutput = pointOpacity;\n");
    geometry.Append("//VTK::Color::Dec",
      "in float pointOpacityVSOutput[];\n"
      "out float pointOpacityGSOutput;\n");
    geometry.Append("//VTK::Color::Impl", "  pointOpacityGSOutput = pointOpacityVSOutput[i];\n");
    fragment.Append("//VTK::Color::Dec", "in float pointOpacityVSOutput;\n");
    // What cannot be seen cannot be selected either.
    fragment.Append("//VTK::Color::Impl",
      "  opacity *= pointOpacityVSOutput;\n"
      "  if (pointOpacityVSOutput <= 0.0)\n"
      "  {\n"
      "    discard;\n"
      "  }\n");
  }
  this->Superclass::ReplaceShaderColor(shaders, renderer, actor);
}

//------------------------------------------------------------------------------
void vtkPolygonPartMapper::SetPropertyShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetPropertyShaderParameters(cellBO, renderer, actor);
  vtkSetBlockDisplay(cellBO.Program, this->Display, actor);
}

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
