// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "RenderScene.h"

#include "SceneCamera.h"

#include "vtkActor.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
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
void AddActor(vtkRenderer* renderer, vtkMapper* mapper, const RenderOptions& options)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(options.Opacity);
  actor->GetProperty()->SetLighting(options.Lighting);
  renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTrajectoryMapper> MakeTrajectoryMapper(
  const Drawable& drawable, const RenderOptions& options)
{
  auto mapper = vtkSmartPointer<vtkTrajectoryMapper>::New();
  mapper->SetInputDataObject(drawable.Data);
  mapper->SetRadius(options.Radius);
  return mapper;
}

//------------------------------------------------------------------------------
// Stock VTK: the lines as tubes, everything else as it is.
vtkSmartPointer<vtkMultiBlockDataSet> Tessellate(const Drawable& drawable, double radius)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (vtkPolyData* leaf : drawable.GetLeaves())
  {
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(leaf);
    tubes->SetRadius(radius);
    tubes->SetNumberOfSides(TubeSides);
    tubes->CappingOn();
    tubes->Update();
    blocks->SetBlock(blocks->GetNumberOfBlocks(), tubes->GetOutput());

    vtkNew<vtkPolyData> others;
    others->ShallowCopy(leaf);
    others->SetLines(nullptr);
    blocks->SetBlock(blocks->GetNumberOfBlocks(), others);
  }
  return blocks;
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
    vtkSmartPointer<vtkMapper> mapper = MakeTrajectoryMapper(drawable, options);
    if (method != Method::Pellucid)
    {
      const double radius = vtkTrajectoryMapper::SafeDownCast(mapper)->GetEffectiveRadius();
      mapper = vtkSmartPointer<vtkCompositePolyDataMapper2>::New();
      mapper->SetInputDataObject(Tessellate(drawable, radius));
    }
    scene.Colors.Apply(mapper, drawable);
    AddActor(renderer, mapper, options);
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
