// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReferenceScene.h"

#include "vtkReferenceGeometry.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataSetMapper.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTrajectoryMapper.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper2.h"
#else
#include "vtkCompositePolyDataMapper.h"
#endif

#include <glm/gtc/type_ptr.hpp>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Vec3 = pellucid::Vector3<double>;
using Vec4 = pellucid::Vector4<double>;

Vec3 ToVector(const double* v)
{
  return { v[0], v[1], v[2] };
}

glm::dmat4 ToMatrix(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

pellucid::Material<double> ToMaterial(vtkProperty* property)
{
  pellucid::Material<double> material;
  material.ambientColor = ToVector(property->GetAmbientColor());
  material.diffuseColor = ToVector(property->GetDiffuseColor());
  material.specularColor = ToVector(property->GetSpecularColor());
  material.ambient = property->GetAmbient();
  material.diffuse = property->GetDiffuse();
  material.specular = property->GetSpecular();
  material.specularPower = property->GetSpecularPower();
  material.opacity = property->GetOpacity();
  return material;
}

pellucid::OpacityParameters<double> ToParameters(vtkOpacityOptimization* optimization)
{
  return { optimization->GetOcclusionWeight(), optimization->GetClutterWeight(),
    optimization->GetEmphasis(), !optimization->GetSelfOcclusion() };
}

pellucid::OcclusionAvoidance<double> ToParameters(vtkOcclusionAvoidance* source)
{
  using Avoidance = pellucid::OcclusionAvoidance<double>;
  Avoidance avoidance;
  avoidance.mode = source->GetMode() == vtkOcclusionAvoidance::WEIGHTING ? Avoidance::WEIGHTING
                                                                         : Avoidance::PENALTY;
  avoidance.penalty = source->GetPenalty();
  avoidance.importanceWeight = source->GetImportanceWeight();
  avoidance.coverageWeight = source->GetCoverageWeight();
  avoidance.varianceWeight = source->GetDirectionalVarianceWeight();
  avoidance.depthWeight = source->GetDepthWeight();
  avoidance.lambda = source->GetImportanceExponent();
  avoidance.globalOpacity = source->GetGlobalOpacity();
  avoidance.smoothAttributes = source->GetSmoothAttributes();
  return avoidance;
}

// What came with VTK 9.3.
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 3, 0)
using BlockMapper = vtkCompositePolyDataMapper2;

bool HasVerticalGradient(vtkRenderer*)
{
  return true;
}
#else
using BlockMapper = vtkCompositePolyDataMapper;

bool HasVerticalGradient(vtkRenderer* renderer)
{
  return !renderer->GetGradientBackground() ||
    renderer->GetGradientMode() == vtkViewport::GradientModes::VTK_GRADIENT_VERTICAL;
}
#endif

/** Whether single blocks of a composite input look different from the rest. */
bool HasBlockAttributes(vtkCompositeDataDisplayAttributes* attributes)
{
  return attributes &&
    (attributes->HasBlockVisibilities() || attributes->HasBlockColors() ||
      attributes->HasBlockOpacities());
}
}

//------------------------------------------------------------------------------
vtkReferenceScene::vtkReferenceScene(vtkRenderer* renderer, int width, int height)
{
  this->TakeCamera(renderer, width, height);
  this->TakeLights(renderer);
  this->Omit("background texture", renderer->GetTexturedBackground());
  this->Omit("background gradient that is not vertical", !HasVerticalGradient(renderer));
  std::vector<vtkProp*> visibleProps;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (prop->GetVisibility())
    {
      visibleProps.push_back(prop);
    }
  }
  this->Optimized.Update(visibleProps);
  for (vtkProp* prop : visibleProps)
  {
    this->TakeProp(prop);
  }
}

//------------------------------------------------------------------------------
void vtkReferenceScene::Omit(const std::string& kind, vtkIdType count)
{
  if (count > 0)
  {
    this->Omissions[kind] += count;
  }
}

//------------------------------------------------------------------------------
void vtkReferenceScene::TakeCamera(vtkRenderer* renderer, int width, int height)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double* pixelAspect = renderer->GetPixelAspect();
  const double aspect = pixelAspect[0] * width / (pixelAspect[1] * height);
  this->WorldToView = ToMatrix(camera->GetModelViewTransformMatrix());
  this->Scene.view.projection = ToMatrix(camera->GetProjectionTransformMatrix(aspect, -1, 1));
  this->Scene.view.width = width;
  this->Scene.view.height = height;
  this->Scene.view.parallel = camera->GetParallelProjection() != 0;
}

//------------------------------------------------------------------------------
void vtkReferenceScene::TakeLights(vtkRenderer* renderer)
{
  renderer->UpdateLightsGeometryToFollowCamera();
  auto& lighting = this->Scene.lighting;
  bool general = false;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (light->GetSwitch())
    {
      lighting.lights.push_back(this->MakeLight(light));
    }
    // As in vtkOpenGLRenderer::UpdateLights(), lights that are off take part in this decision.
    general = general || light->GetPositional() || lighting.lights.size() > 1 ||
      (lighting.lights.size() == 1 && !light->LightTypeIsHeadlight());
  }
  if (lighting.lights.empty() && renderer->GetAutomaticLightCreation())
  {
    lighting.lights.emplace_back();
    general = false;
  }
  lighting.loneHeadlight = !general && !lighting.lights.empty();
}

//------------------------------------------------------------------------------
pellucid::Light<double> vtkReferenceScene::MakeLight(vtkLight* source) const
{
  double position[3];
  double focus[3];
  source->GetTransformedPosition(position);
  source->GetTransformedFocalPoint(focus);
  const Vec3 direction = ToVector(focus) - ToVector(position);
  const double length = glm::length(direction);

  pellucid::Light<double> light;
  light.color = source->GetIntensity() * ToVector(source->GetDiffuseColor());
  light.direction = this->NormalToView() * (length > 0 ? direction / length : direction);
  light.position = Vec3(this->WorldToView * Vec4(ToVector(position), 1.0));
  light.attenuation = ToVector(source->GetAttenuationValues());
  light.exponent = source->GetExponent();
  light.coneAngle = source->GetConeAngle();
  light.positional = source->GetPositional() != 0;
  return light;
}

//------------------------------------------------------------------------------
glm::dmat3 vtkReferenceScene::NormalToView() const
{
  return glm::transpose(glm::inverse(glm::dmat3(this->WorldToView)));
}

//------------------------------------------------------------------------------
void vtkReferenceScene::TakeProp(vtkProp* prop)
{
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* leaf = path->GetLastNode();
    if (!leaf)
    {
      continue;
    }
    bool visible = true;
    vtkCollectionSimpleIterator iterator;
    path->InitTraversal(iterator);
    while (vtkAssemblyNode* node = path->GetNextNode(iterator))
    {
      visible = visible && node->GetViewProp()->GetVisibility();
    }
    if (!visible)
    {
      continue;
    }
    if (auto* actor = vtkActor::SafeDownCast(leaf->GetViewProp()))
    {
      this->TakeActor(actor, leaf->GetMatrix());
    }
    else
    {
      this->Omit(leaf->GetViewProp()->GetClassName());
    }
  }
}

//------------------------------------------------------------------------------
pellucid::Surface<double> vtkReferenceScene::MakeSurface(vtkActor* actor, vtkMapper* mapper)
{
  vtkProperty* property = actor->GetProperty();
  pellucid::Surface<double> surface;
  surface.front = ToMaterial(property);
  surface.back =
    actor->GetBackfaceProperty() ? ToMaterial(actor->GetBackfaceProperty()) : surface.front;
  surface.opaque = !actor->HasTranslucentPolygonalGeometry();
  surface.lit = property->GetLighting();
  if (const vtkOptimizedScene::Member* member = this->Optimized.Find(actor))
  {
    if (auto* optimization = vtkOpacityOptimization::SafeDownCast(member->Settings))
    {
      surface.optimization = ToParameters(optimization);
    }
    if (auto* avoidance = vtkOcclusionAvoidance::SafeDownCast(member->Settings))
    {
      surface.avoidance = ToParameters(avoidance);
    }
  }
  surface.cullBack = property->GetBackfaceCulling() != 0;
  surface.cullFront = property->GetFrontfaceCulling() && !surface.cullBack;
  if (vtkPlaneCollection* planes = mapper->GetClippingPlanes())
  {
    vtkCollectionSimpleIterator iterator;
    planes->InitTraversal(iterator);
    while (vtkPlane* plane = planes->GetNextPlane(iterator))
    {
      surface.clipping.push_back(
        { Vec3(this->WorldToView * Vec4(ToVector(plane->GetOrigin()), 1.0)),
          this->NormalToView() * ToVector(plane->GetNormal()) });
    }
  }
  return surface;
}

//------------------------------------------------------------------------------
void vtkReferenceScene::TakeActor(vtkActor* actor, vtkMatrix4x4* modelToWorld)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper)
  {
    return;
  }
  vtkProperty* property = actor->GetProperty();
  if (vtkOptimizedScene::DrawsImpostors(mapper) || actor->GetCoordinateSystem() != vtkProp3D::WORLD)
  {
    this->Omit(mapper->GetClassName());
    return;
  }
  if (property->GetRepresentation() != VTK_SURFACE)
  {
    this->Omit("wireframe or point representation");
    return;
  }
  this->Omit("edges or vertices drawn over surfaces",
    property->GetEdgeVisibility() || property->GetVertexVisibility());
  this->Omit("texture", actor->GetTexture() || property->GetNumberOfTextures() > 0);
  this->Omit("physically based shading (drawn as Phong)", property->GetInterpolation() == VTK_PBR);

  mapper->Update();
  vtkReferenceTarget target{ this->Scene, mapper, property, this->MakeSurface(actor, mapper),
    this->WorldToView * ToMatrix(modelToWorld), nullptr, &this->Optimized,
    this->Optimized.Find(actor) };
  vtkReferenceRejects rejects;
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    this->Omit("block attributes", HasBlockAttributes(glyphs->GetBlockAttributes()));
    rejects = vtkAddReferenceGlyphs(target, glyphs);
  }
  else if (auto* trajectories = vtkTrajectoryMapper::SafeDownCast(mapper))
  {
    const double radius = trajectories->GetEffectiveRadius();
    target.opacityArray = trajectories->GetOpacityArray();
    for (const vtkDisplayedLeaf& leaf : vtkFindDisplayedLeaves(
           mapper->GetInputDataObject(0, 0), trajectories->GetCompositeDataDisplayAttributes()))
    {
      if (leaf.Display.Visible)
      {
        target.display = leaf.Display;
        rejects +=
          vtkAddReferenceTrajectories(target, leaf.Data, radius, trajectories->GetRadiusArray());
      }
    }
  }
  else if (mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper"))
  {
    auto* blocks = BlockMapper::SafeDownCast(mapper);
    this->Omit("block attributes",
      blocks && HasBlockAttributes(blocks->GetCompositeDataDisplayAttributes()));
    vtkForEachLeaf<vtkPolyData>(mapper->GetInputDataObject(0, 0),
      [&target, &rejects](vtkPolyData* data) { rejects += vtkAddReferencePolygons(target, data); });
  }
  else if (auto* dataSets = vtkDataSetMapper::SafeDownCast(mapper))
  {
    vtkSmartPointer<vtkPolyData> data = vtkPolyData::SafeDownCast(dataSets->GetInput());
    if (!data)
    {
      vtkNew<vtkDataSetSurfaceFilter> filter;
      filter->SetInputData(dataSets->GetInput());
      filter->Update();
      data = filter->GetOutput();
    }
    rejects += vtkAddReferencePolygons(target, data);
  }
  else
  {
    this->Omit(mapper->GetClassName());
  }
  this->Omit("cell or point with coordinates that are not finite", rejects.invalid);
  this->Omit("vertex or line of one pixel", rejects.pixels);
}
VTK_ABI_NAMESPACE_END
