// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSceneSignature.h"

#include "Importance.h"
#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkCompositeDataSet.h"
#include "vtkImportanceDrivenOpacity.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"
#include "vtkVolume.h"

#include <array>
#include <initializer_list>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Whether all that an actor draws is the mapper of GetMapper(), with the actor's own properties.
// That may be another one in each frame: ParaView's actor chooses a level of detail, without any
// sign in its time. By name: ParaView's class is not known here, and subclasses may do anything.
bool DrawsItsMapper(vtkActor* actor)
{
  const std::string name = actor->GetClassName();
  return name == "vtkOpenGLActor" || name == "vtkPVLODActor";
}
}

//------------------------------------------------------------------------------
vtkSceneSignature::vtkSceneSignature(const vtkRenderState* state, const vtkPixelRectangle& image)
  : Numbers{ static_cast<double>(image.Origin[0]), static_cast<double>(image.Origin[1]),
    static_cast<double>(image.Size[0]), static_cast<double>(image.Size[1]) }
{
  this->AddView(state->GetRenderer());
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    this->Certain = this->AddProp(state->GetPropArray()[i]) && this->Certain;
  }
}

//------------------------------------------------------------------------------
bool vtkSceneSignature::IsSame(const vtkSceneSignature& other) const
{
  return this->Certain && other.Certain && this->Objects == other.Objects &&
    this->Numbers == other.Numbers && this->Names == other.Names;
}

//------------------------------------------------------------------------------
void vtkSceneSignature::AddObject(vtkObject* object)
{
  this->Objects.emplace_back(object, object ? object->GetMTime() : 0);
}

//------------------------------------------------------------------------------
void vtkSceneSignature::AddMatrix(vtkMatrix4x4* matrix)
{
  this->Numbers.insert(this->Numbers.end(), matrix->GetData(), matrix->GetData() + 16);
}

//------------------------------------------------------------------------------
void vtkSceneSignature::AddView(vtkRenderer* renderer)
{
  // Not the renderer's time: picking and screenshots change it.
  this->Objects.emplace_back(renderer, 0);
  this->Certain = !renderer->GetUseImageBasedLighting() && !renderer->GetPreserveDepthBuffer();
  this->Numbers.insert(this->Numbers.end(), renderer->GetAmbient(), renderer->GetAmbient() + 3);
  this->Numbers.push_back(renderer->GetTwoSidedLighting());
  this->Numbers.push_back(renderer->GetUseHiddenLineRemoval());
  this->AddCoincidentTopology();
  vtkCamera* camera = renderer->GetActiveCamera();
  this->AddMatrix(camera->GetModelViewTransformMatrix());
  this->AddMatrix(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0));
  vtkCollectionSimpleIterator iterator;
  vtkLightCollection* lights = renderer->GetLights();
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    this->AddObject(light);
  }
}

//------------------------------------------------------------------------------
// Of all mappers; their own are in their times.
void vtkSceneSignature::AddCoincidentTopology()
{
  this->Numbers.push_back(vtkMapper::GetResolveCoincidentTopology());
  std::array<double, 5> offsets{};
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(offsets[0], offsets[1]);
  vtkMapper::GetResolveCoincidentTopologyLineOffsetParameters(offsets[2], offsets[3]);
  vtkMapper::GetResolveCoincidentTopologyPointOffsetParameter(offsets[4]);
  this->Numbers.insert(this->Numbers.end(), offsets.begin(), offsets.end());
}

//------------------------------------------------------------------------------
bool vtkSceneSignature::AddProp(vtkProp* prop)
{
  // Neither leaves a trace in fragments or opaque depth.
  if (vtkActor2D::SafeDownCast(prop) || vtkVolume::SafeDownCast(prop))
  {
    return true;
  }
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor && DrawsItsMapper(actor) && this->AddActor(actor);
}

//------------------------------------------------------------------------------
bool vtkSceneSignature::AddActor(vtkActor* actor)
{
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0 ||
    mapper->HasObserver(vtkCommand::UpdateShaderEvent) || actor->GetTexture() ||
    actor->GetProperty()->GetNumberOfTextures() > 0)
  {
    return false;
  }
  mapper->Update();
  this->AddObject(actor);
  actor->ComputeMatrix();
  this->AddMatrix(actor->GetMatrix());
  vtkShaderProperty* shader = actor->GetShaderProperty();
  for (vtkObject* object :
    std::initializer_list<vtkObject*>{ shader, shader->GetVertexCustomUniforms(),
      shader->GetGeometryCustomUniforms(), shader->GetFragmentCustomUniforms() })
  {
    this->AddObject(object);
  }
  this->AddObject(mapper);
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  this->AddObject(input);
  for (vtkPolyData* leaf : vtkCompositeDataSet::GetDataSets<vtkPolyData>(input))
  {
    this->AddObject(leaf);
  }
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    this->AddObject(planes->GetItem(i));
  }
  vtkImportanceDrivenOpacity* parameters = vtkImportanceDrivenOpacity::Get(actor);
  const char* importance = parameters ? parameters->GetImportanceArray() : nullptr;
  this->Names.emplace_back(importance ? importance : "");
  if (parameters)
  {
    // NaN would never be the same.
    const pellucid::ImportanceRange<double> range(parameters->GetImportanceRange());
    this->Numbers.insert(this->Numbers.end(), { range.direction, range.first, range.last });
  }
  return true;
}

VTK_ABI_NAMESPACE_END
