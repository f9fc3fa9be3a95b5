// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderScene.h"

#include "OpacityOptions.h"
#include "SceneCamera.h"
#include "StockActors.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkTrajectoryMapper.h"

#include <limits>

namespace pellucid
{
namespace
{
constexpr double DefaultOpacity = 0.3;

//------------------------------------------------------------------------------
void SetProperty(vtkActor* actor, const Drawable& drawable, const RenderOptions& options)
{
  const double opacity = drawable.HasImportance ? 1.0 : DefaultOpacity;
  actor->GetProperty()->SetOpacity(options.Opacity.value_or(opacity));
  actor->GetProperty()->SetLighting(options.Lighting);
}

//------------------------------------------------------------------------------
void AddTrajectoryActor(vtkRenderer* renderer, const Drawable& drawable, const Coloring& colors)
{
  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputDataObject(drawable.Data);
  mapper->SetOpacityArray(drawable.IsFaded ? ImportanceArray : nullptr);
  colors.Apply(mapper, drawable);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
void AddStockActors(vtkRenderer* renderer, const Drawable& drawable, const Coloring& colors,
  const RenderOptions& options)
{
  vtkNew<vtkTrajectoryMapper> measure;
  measure->SetInputDataObject(drawable.Data);
  measure->SetRadius(options.Radius);
  for (vtkPolyData* part : drawable.GetLeaves())
  {
    for (vtkActor* actor : MakeStockActors(part, measure->GetEffectiveRadius(), drawable, colors))
    {
      SetProperty(actor, drawable, options);
      renderer->AddActor(actor);
    }
  }
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakeRenderer(
  const Scene& scene, const RenderOptions& options, Method method, double aspect)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  for (const Drawable& drawable : scene.Drawables)
  {
    if (method == Method::Pellucid)
    {
      AddTrajectoryActor(renderer, drawable, scene.Colors);
    }
    else
    {
      AddStockActors(renderer, drawable, scene.Colors, options);
    }
  }
  if (method == Method::Pellucid)
  {
    SetAppearance(renderer, scene, options);
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

//------------------------------------------------------------------------------
void SetAppearance(vtkRenderer* renderer, const Scene& scene, const RenderOptions& options)
{
  const auto parameters = MakeOpacityParameters(options.Opacities, false);
  const auto surfaceParameters = MakeOpacityParameters(options.Opacities, true);
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator next;
  actors->InitTraversal(next);
  for (const Drawable& drawable : scene.Drawables)
  {
    vtkActor* actor = actors->GetNextActor(next);
    vtkTrajectoryMapper::SafeDownCast(actor->GetMapper())->SetRadius(options.Radius);
    SetProperty(actor, drawable, options);
    if (drawable.HasImportance)
    {
      vtkImportanceDrivenOpacity::Attach(
        actor, drawable.IsSurface ? surfaceParameters : parameters);
    }
  }
}
}
