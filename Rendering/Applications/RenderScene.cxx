// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderScene.h"

#include "SceneCamera.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTubeFilter.h"

#include <limits>

namespace pellucid
{
namespace
{
constexpr int TubeSides = 8;

//------------------------------------------------------------------------------
vtkProperty* AddActor(vtkRenderer* renderer, vtkMapper* mapper, const RenderOptions& options)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(options.Opacity);
  actor->GetProperty()->SetLighting(options.Lighting);
  renderer->AddActor(actor);
  return actor->GetProperty();
}

//------------------------------------------------------------------------------
// Stock VTK: the lines of a part as tubes, and everything else as it is. Of the tubes the inner
// walls are left out, so that the layers are those of a vtkTrajectoryMapper.
void AddStockActors(vtkRenderer* renderer, vtkPolyData* part, double radius,
  const Drawable& drawable, const Coloring& colors, const RenderOptions& options)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(part);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(TubeSides);
  tubes->CappingOn();
  tubes->Update();
  vtkNew<vtkPolyData> others;
  others->ShallowCopy(part);
  others->SetLines(nullptr);

  for (vtkPolyData* geometry : { tubes->GetOutput(), others.Get() })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(geometry);
    colors.Apply(mapper, drawable);
    AddActor(renderer, mapper, options)->SetBackfaceCulling(geometry != others);
  }
}
}

//------------------------------------------------------------------------------
vtkIdType Scene::GetNumberOfPoints() const
{
  vtkIdType points = 0;
  for (const Drawable& drawable : this->Drawables)
  {
    points += drawable.Data->GetNumberOfElements(vtkDataObject::POINT);
  }
  return points;
}

//------------------------------------------------------------------------------
vtkIdType Scene::GetNumberOfLines() const
{
  vtkIdType lines = 0;
  for (const Drawable& drawable : this->Drawables)
  {
    for (vtkPolyData* leaf : drawable.GetLeaves())
    {
      lines += leaf->GetNumberOfLines();
    }
  }
  return lines;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakeRenderer(
  const Scene& scene, const RenderOptions& options, Method method, double aspect)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  for (const Drawable& drawable : scene.Drawables)
  {
    vtkNew<vtkTrajectoryMapper> mapper;
    mapper->SetInputDataObject(drawable.Data);
    mapper->SetRadius(options.Radius);
    if (method == Method::Pellucid)
    {
      scene.Colors.Apply(mapper, drawable);
      AddActor(renderer, mapper, options);
      continue;
    }
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      AddStockActors(renderer, part, mapper->GetEffectiveRadius(), drawable, scene.Colors, options);
    }
  }
  renderer->SetBackground(options.Background.data());
  if (options.TransparentBackground)
  {
    // Black adds nothing to the colours, so that dividing by alpha gives them back.
    renderer->SetBackground(0.0, 0.0, 0.0);
    renderer->SetBackgroundAlpha(0.0);
  }
  if (method == Method::VTKPeeling)
  {
    renderer->UseDepthPeelingOn();
    renderer->SetMaximumNumberOfPeels(std::numeric_limits<int>::max());
    renderer->SetOcclusionRatio(0.0);
  }
  SetUpCamera(renderer, scene, options, aspect);
  return renderer;
}
}
