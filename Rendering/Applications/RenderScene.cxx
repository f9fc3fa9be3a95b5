// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderScene.h"

#include "OpacityOptions.h"
#include "SceneCamera.h"
#include "StockActors.h"

#include "vtkActor.h"
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
void AddActor(
  vtkRenderer* renderer, vtkActor* actor, const Drawable& drawable, const RenderOptions& options)
{
  const double opacity = drawable.HasImportance ? 1.0 : DefaultOpacity;
  actor->GetProperty()->SetOpacity(options.Opacity.value_or(opacity));
  actor->GetProperty()->SetLighting(options.Lighting);
  renderer->AddActor(actor);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakeRenderer(
  const Scene& scene, const RenderOptions& options, Method method, double aspect)
{
  const auto parameters = MakeOpacityParameters(options.Opacities, false);
  const auto surfaceParameters = MakeOpacityParameters(options.Opacities, true);
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  for (const Drawable& drawable : scene.Drawables)
  {
    vtkNew<vtkTrajectoryMapper> mapper;
    mapper->SetInputDataObject(drawable.Data);
    mapper->SetRadius(options.Radius);
    if (method == Method::Pellucid)
    {
      scene.Colors.Apply(mapper, drawable);
      mapper->SetOpacityArray(drawable.IsFaded ? ImportanceArray : nullptr);
      vtkNew<vtkActor> actor;
      actor->SetMapper(mapper);
      if (drawable.HasImportance)
      {
        vtkImportanceDrivenOpacity::Attach(
          actor, drawable.IsSurface ? surfaceParameters : parameters);
      }
      AddActor(renderer, actor, drawable, options);
      continue;
    }
    for (vtkPolyData* part : drawable.GetLeaves())
    {
      for (vtkActor* actor :
        MakeStockActors(part, mapper->GetEffectiveRadius(), drawable, scene.Colors))
      {
        AddActor(renderer, actor, drawable, options);
      }
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
