// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPolygonPartMapper
 * @brief   VTK's own mapper for the polygons and strips of a vtkPolyData, without its lines and
 * vertices.
 *
 * The input is the whole vtkPolyData: point and cell ids and cell arrays stay valid.
 */

#ifndef vtkPolygonPartMapper_h
#define vtkPolygonPartMapper_h

#include "vtkDisplayedLeaf.h"
#include "vtkFloatArray.h" // for the opacities
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkSmartPointer.h" // for the opacities

VTK_ABI_NAMESPACE_BEGIN

class vtkPolygonPartMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkPolygonPartMapper* New();
  vtkTypeMacro(vtkPolygonPartMapper, vtkOpenGLPolyDataMapper);

  /** Multiply the opacity by the factor of each point, linear on triangles; null: no factors. */
  void SetPointOpacities(vtkFloatArray* factors);

  /** Draw the polygons as those of that block from now on. */
  void SetDisplay(const vtkBlockDisplay& display) { this->Display = display; }

protected:
  vtkPolygonPartMapper() = default;
  ~vtkPolygonPartMapper() override = default;

  void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void SetPropertyShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderColor(
    std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkPolygonPartMapper(const vtkPolygonPartMapper&) = delete;
  void operator=(const vtkPolygonPartMapper&) = delete;

  vtkSmartPointer<vtkFloatArray> PointOpacities;
  vtkBlockDisplay Display;
};

VTK_ABI_NAMESPACE_END
#endif
