// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ViewedScene.h"

#include "LineAttributes.h"
#include "PictureMaking.h"
#include "PlainText.h"
#include "SceneArrays.h"
#include "SceneCamera.h"
#include "SceneFilter.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkTrajectoryAttributes.h"
#include "vtkTrajectoryMapper.h"

#include <algorithm>
#include <set>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
std::vector<std::string> FindArrayNames(
  const std::vector<Drawable>& drawables, const RenderOptions& options)
{
  std::set<std::string> names;
  for (const Drawable& drawable : drawables)
  {
    for (const SceneArray& array : GetArrays(drawable))
    {
      names.insert(array.Name);
    }
  }
  for (int i = 0; i < vtkTrajectoryAttributes::GetNumberOfAttributes(); ++i)
  {
    if (AnyPart(drawables,
          [&](vtkPolyData* part)
          { return part->GetNumberOfLines() > 0 && CanCompute(part, i, options); }))
    {
      names.insert(vtkTrajectoryAttributes::GetAttributeName(i));
    }
  }
  return { names.begin(), names.end() };
}

//------------------------------------------------------------------------------
// The options without what only makes sense for the data that they were given for.
RenderOptions ForgetData(const RenderOptions& options)
{
  const RenderOptions defaults;
  RenderOptions result = options;
  result.ColorBy = defaults.ColorBy;
  result.ColorRange = defaults.ColorRange;
  result.Radius = defaults.Radius;
  result.CameraPosition = defaults.CameraPosition;
  result.FocalPoint = defaults.FocalPoint;
  result.ViewUp = defaults.ViewUp;
  result.ParallelScale = defaults.ParallelScale;
  result.Importance = defaults.Importance;
  result.Selections = defaults.Selections;
  result.Pressure = defaults.Pressure;
  result.Height = defaults.Height;
  result.TimeWindow = defaults.TimeWindow;
  result.SeedLineFirst = defaults.SeedLineFirst;
  result.SeedLineLast = defaults.SeedLineLast;
  result.Vectors = defaults.Vectors;
  result.MaximumLength = defaults.MaximumLength;
  return result;
}

//------------------------------------------------------------------------------
std::string ListCoordinates(const double vector[3])
{
  return ToText(vector[0]) + "," + ToText(vector[1]) + "," + ToText(vector[2]);
}
}

//------------------------------------------------------------------------------
ViewedScene::ViewedScene(const RenderOptions& options)
  : Options(options)
{
}

//------------------------------------------------------------------------------
void ViewedScene::Open()
{
  auto drawables = MakeDrawables(ReadInputs(this->Options), this->Options);
  const RenderOptions options = this->GetEffectiveOptions();
  auto made = std::make_unique<MadeScene>(MakeScene(drawables, options));
  auto arrayNames = FindArrayNames(drawables, this->Options);
  this->Show(*made, options, nullptr);
  this->Made = std::move(made);
  this->Drawables = std::move(drawables);
  this->ArrayNames = std::move(arrayNames);
}

//------------------------------------------------------------------------------
void ViewedScene::Open(const std::vector<std::string>& fileNames)
{
  const RenderOptions previous = this->Options;
  this->Options = ForgetData(previous);
  this->Options.Inputs = fileNames;
  try
  {
    this->Open();
  }
  catch (...)
  {
    this->Options = previous;
    throw;
  }
}

//------------------------------------------------------------------------------
void ViewedScene::Update(Change change)
{
  if (!this->Made || change == Change::None)
  {
    return;
  }
  const RenderOptions options = this->GetEffectiveOptions();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (change == Change::Scene)
  {
    auto made = std::make_unique<MadeScene>(MakeScene(this->Drawables, options));
    this->Show(*made, options, camera);
    this->Made = std::move(made);
  }
  else if (change == Change::Appearance && this->Pass)
  {
    SetAppearance(this->Renderer, this->Made->Drawn, options);
    MakeExact(this->Renderer, options);
  }
  else
  {
    this->Show(*this->Made, options, camera);
  }
}

//------------------------------------------------------------------------------
void ViewedScene::ResetCamera()
{
  if (this->Renderer)
  {
    this->Renderer->GetActiveCamera()->ParallelProjectionOff();
    SetUpCamera(this->Renderer, this->Made->Drawn, this->Options, this->GetAspect());
    this->UnmovedCamera = this->DescribeCamera();
  }
}

//------------------------------------------------------------------------------
void ViewedScene::SetSize(int width, int height)
{
  const std::array<int, 2> size = { width, height };
  if (size == this->Options.Size)
  {
    return;
  }
  this->Options.Size = size;
  if (this->Renderer && this->DescribeCamera() == this->UnmovedCamera)
  {
    this->ResetCamera();
  }
}

//------------------------------------------------------------------------------
double ViewedScene::GetRadius() const
{
  vtkActor* actor = this->Renderer ? this->Renderer->GetActors()->GetLastActor() : nullptr;
  auto* mapper = vtkTrajectoryMapper::SafeDownCast(actor ? actor->GetMapper() : nullptr);
  return mapper ? mapper->GetEffectiveRadius() : this->Options.Radius;
}

//------------------------------------------------------------------------------
std::string ViewedScene::DescribeView() const
{
  return "--size " + std::to_string(this->Options.Size[0]) + "x" +
    std::to_string(this->Options.Size[1]) + this->DescribeCamera();
}

//------------------------------------------------------------------------------
std::string ViewedScene::DescribeCamera() const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  std::string text = " --camera-position " + ListCoordinates(camera->GetPosition()) +
    " --focal-point " + ListCoordinates(camera->GetFocalPoint()) + " --view-up " +
    ListCoordinates(camera->GetViewUp());
  if (camera->GetParallelProjection())
  {
    text += " --parallel-scale " + ToText(camera->GetParallelScale());
  }
  return text;
}

//------------------------------------------------------------------------------
// VTK's own methods have no opacities that follow from the view.
RenderOptions ViewedScene::GetEffectiveOptions() const
{
  RenderOptions options = this->Options;
  if (options.RenderMethod != Method::Pellucid)
  {
    options.Opacities.Rule = OpacityRule::Factor;
    options.Opacities.Shown = {};
  }
  return options;
}

//------------------------------------------------------------------------------
void ViewedScene::Show(const MadeScene& made, const RenderOptions& options, vtkCamera* camera)
{
  const auto renderer = MakeRenderer(made.Drawn, options, options.RenderMethod, this->GetAspect());
  if (camera)
  {
    renderer->SetActiveCamera(camera);
  }
  this->Pass = options.RenderMethod == Method::Pellucid ? MakeExact(renderer, options) : nullptr;
  this->Renderer = renderer;
  if (!camera)
  {
    this->UnmovedCamera = this->DescribeCamera();
  }
}

//------------------------------------------------------------------------------
double ViewedScene::GetAspect() const
{
  return static_cast<double>(this->Options.Size[0]) / this->Options.Size[1];
}
}
