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

#include "vtkOpenGLPolyDataMapper.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkPolygonPartMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkPolygonPartMapper* New();
  vtkTypeMacro(vtkPolygonPartMapper, vtkOpenGLPolyDataMapper);

protected:
  vtkPolygonPartMapper() = default;
  ~vtkPolygonPartMapper() override = default;

  void BuildIBO(vtkRenderer* renderer, vtkActor* actor, vtkPolyData* data) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkPolygonPartMapper(const vtkPolygonPartMapper&) = delete;
  void operator=(const vtkPolygonPartMapper&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
