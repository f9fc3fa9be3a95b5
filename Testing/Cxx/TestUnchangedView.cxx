// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// A frame does only what its changes ask for, and shows, byte by byte, what a pass shows that has
// not seen another frame before.
#include "FrameStages.h"
#include "SegmentedScene.h"

#include "vtkAssembly.h"
#include "vtkHardwareSelector.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkPlane.h"
#include "vtkSelection.h"
#include "vtkShaderProperty.h"
#include "vtkUniforms.h"
#include "vtkWindowToImageFilter.h"

namespace
{
const std::string GatheredStages = "opaque copy gather sort solve smooth resolve ";
const std::string SolvedStages = "opaque copy solve smooth resolve ";

/** Everything whose change a frame has to see. */
class Scene : public SphereScene
{
public:
  Scene()
    : SphereScene(120, 90, 0, 0, 0)
  {
    const ImportanceFunction other = [](const double* p) { return 0.5 - 0.4 * std::sin(p[1]); };
    this->LineData = MakeSegmentedLines(12, 100);
    AddImportance(this->LineData, other, "Other");
    this->Lines = AddLines(*this, this->LineData, 0.06, 0.9);
    this->Lines->GetMapper()->SetLookupTable(this->Colors);
    auto sphere = MakeSegmentedSphere(1.3, Wave);
    AddImportance(sphere, other, "Other");
    this->Surface = AddSurface<vtkPolyDataMapper>(*this, sphere, 0.8);
    this->Surface->SetUserMatrix(this->Matrix);
    this->Plane->SetOrigin(-0.7, 0.0, 0.0);
    this->Plane->SetNormal(1.0, 0.0, 0.0);
    this->Surface->GetMapper()->AddClippingPlane(this->Plane);
    this->Opaque = this->AddSphere(3, 1.0);
    for (vtkActor* actor : { this->Lines, this->Surface })
    {
      vtkOpacityOptimization::Attach(actor, this->Optimization);
    }
    this->Light->SetPosition(2.0, 3.0, 4.0);
    this->Light->SetPositional(true);
    this->Renderer->AddLight(this->Light);
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
  }

  vtkSmartPointer<vtkPolyData> LineData;
  vtkActor* Lines;
  vtkActor* Surface;
  vtkActor* Opaque;
  vtkNew<vtkOpacityOptimization> Optimization;
  vtkNew<vtkLookupTable> Colors;
  vtkNew<vtkMatrix4x4> Matrix;
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkLight> Light;
  vtkExactTransparencyPass* Pass;
};

/** Draws one of two mappers, like ParaView's vtkPVLODActor: switching leaves its time as it is. */
class LevelsOfDetail : public vtkActor
{
public:
  vtkTypeMacro(LevelsOfDetail, vtkActor);
  vtkMapper* GetMapper() override { return this->Coarse ? this->CoarseMapper.Get() : this->Mapper; }
  void Render(vtkRenderer* renderer, vtkMapper*) override
  {
    this->Property->Render(this, renderer);
    this->Device->SetProperty(this->Property);
    this->Device->SetPropertyKeys(this->GetPropertyKeys());
    this->Device->SetIsRenderingTranslucentPolygonalGeometry(true);
    this->Device->SetMapper(this->GetMapper());
    this->Device->Render(renderer, this->GetMapper());
  }

  bool Coarse = false;
  vtkSmartPointer<vtkMapper> CoarseMapper;

private:
  vtkNew<vtkActor> Device;
};

/** By the name that the pass knows. */
class vtkPVLODActor : public LevelsOfDetail
{
public:
  static vtkPVLODActor* New() { VTK_STANDARD_NEW_BODY(vtkPVLODActor); }
  vtkTypeMacro(vtkPVLODActor, LevelsOfDetail);
};

/** By a name that the pass cannot know. */
class OtherLevelsOfDetail : public LevelsOfDetail
{
public:
  static OtherLevelsOfDetail* New() { VTK_STANDARD_NEW_BODY(OtherLevelsOfDetail); }
  vtkTypeMacro(OtherLevelsOfDetail, LevelsOfDetail);
};

/** Shows the scene's surface and its opaque sphere as two levels of detail. */
template <typename ActorT>
ActorT* AddLevelsOfDetail(Scene& scene)
{
  vtkNew<ActorT> actor;
  actor->SetMapper(scene.Surface->GetMapper());
  actor->CoarseMapper = scene.Opaque->GetMapper();
  actor->GetProperty()->SetOpacity(0.5);
  scene.Surface->VisibilityOff();
  scene.Opaque->VisibilityOff();
  scene.Renderer->AddActor(actor);
  return actor;
}

/** What is done to a scene, and the stages of the next frame. */
struct Case
{
  std::string Name;
  std::function<void(Scene&)> Do;
  std::string Stages;
};

//------------------------------------------------------------------------------
// Two frames with a change between them.
bool TestChange(
  const Case& change, const std::function<void(Scene&)>& prepare = [](Scene&) {})
{
  Scene scene;
  OpenGLDebugOutput debugOutput(scene.Window);
  prepare(scene);
  const Picture before = Picture::Render(scene.Window);
  change.Do(scene);
  const Picture after = Picture::Render(scene.Window);
  const std::string stages = GetStages(scene.Pass);
  Scene fresh;
  prepare(fresh);
  change.Do(fresh);
  bool passed =
    Check(stages == change.Stages, change.Name + ": \"" + stages + "\" is not \"" + change.Stages);
  passed &= Check(!(after == before), change.Name + " changes nothing");
  passed &= Check(after == Picture::Render(fresh.Window), change.Name + ": not the fresh picture");
  passed &=
    Check(Picture::Render(scene.Window) == after && GetStages(scene.Pass) == UnchangedStages,
      change.Name + ": the third frame runs \"" + GetStages(scene.Pass));
  return passed;
}

//------------------------------------------------------------------------------
bool TestGeometryChanges()
{
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> changes = {
    { "camera", [](Scene& s) { s.Renderer->GetActiveCamera()->Azimuth(20.0); } },
    { "clipping range",
      [](Scene& s)
      {
        const double distance = s.Renderer->GetActiveCamera()->GetDistance();
        s.Renderer->GetActiveCamera()->SetClippingRange(distance - 0.8, distance + 5.0);
      } },
    { "window size", [](Scene& s) { s.Window->SetSize(150, 100); } },
    { "samples", [](Scene& s) { s.Window->SetMultiSamples(4); } },
    { "opacity", [](Scene& s) { s.Lines->GetProperty()->SetOpacity(0.5); } },
    { "colour", [](Scene& s) { s.Surface->GetProperty()->SetColor(0.9, 0.1, 0.2); } },
    { "shading", [](Scene& s) { s.Surface->GetProperty()->SetInterpolationToFlat(); } },
    { "culling", [](Scene& s) { s.Surface->GetProperty()->BackfaceCullingOn(); } },
    { "colour map", [](Scene& s) { s.Colors->SetHueRange(0.1, 0.9); } },
    { "radius",
      [](Scene& s) { vtkTrajectoryMapper::SafeDownCast(s.Lines->GetMapper())->SetRadius(0.1); } },
    { "points",
      [](Scene& s)
      {
        s.LineData->GetPoints()->SetPoint(30, 0.0, 0.0, 1.0);
        s.LineData->GetPoints()->Modified();
      } },
    { "importances",
      [](Scene& s)
      {
        vtkDataArray* array = s.LineData->GetPointData()->GetArray("Importance");
        array->FillComponent(0, 0.9);
        array->Modified();
      } },
    { "name of importance", [](Scene& s) { s.Optimization->SetImportanceArray("Other"); } },
    { "range of importance", [](Scene& s) { s.Optimization->SetImportanceRange(0.3, 0.6); } },
    { "user matrix", [](Scene& s) { s.Matrix->SetElement(0, 3, 0.4); } },
    { "light", [](Scene& s) { s.Light->SetPosition(-4.0, 3.0, 1.0); } },
    { "clipping plane", [](Scene& s) { s.Plane->SetOrigin(0.3, 0.0, 0.0); } },
    { "no clipping plane", [](Scene& s) { s.Surface->GetMapper()->RemoveAllClippingPlanes(); } },
    { "visibility", [](Scene& s) { s.Surface->VisibilityOff(); } },
    { "another mapper",
      [](Scene& s)
      {
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputDataObject(s.Surface->GetMapper()->GetInput());
        mapper->SetScalarVisibility(false);
        s.Surface->SetMapper(mapper);
      } },
    { "another actor", [](Scene& s) { s.AddSphere(2, 0.3); } },
    { "one actor less", [](Scene& s) { s.Renderer->RemoveActor(s.Surface); } },
    { "opaque actor", [](Scene& s) { s.Opaque->SetPosition(0.3, 0.3, 0.5); } },
    { "other kind of parameters", [](Scene& s) { Avoid(s.Surface, 0, false); } },
    { "resolution of the solution", [](Scene& s) { s.Pass->SetGatherScale(2); } },
  };
  bool passed = true;
  for (const auto& [name, change] : changes)
  {
    const bool avoids = name == "other kind of parameters";
    passed &= TestChange({ name, change,
      avoids ? "opaque copy gather sort solve smooth avoid resolve " : GatheredStages });
  }
  return passed;
}

//------------------------------------------------------------------------------
bool TestOtherChanges()
{
  const std::vector<Case> cases = {
    { "q", [](Scene& s) { s.Optimization->SetOcclusionWeight(500.0); }, SolvedStages },
    { "r", [](Scene& s) { s.Optimization->SetClutterWeight(0.0); }, SolvedStages },
    { "lambda", [](Scene& s) { s.Optimization->SetEmphasis(1.0); }, SolvedStages },
    { "s", [](Scene& s) { s.Optimization->SetSmoothingIterations(40); }, SolvedStages },
    { "s = 0", [](Scene& s) { s.Optimization->SetSmoothingIterations(0); },
      "opaque copy solve resolve " },
    { "self-occlusion", [](Scene& s) { s.Optimization->SelfOcclusionOn(); }, SolvedStages },
    { "background", [](Scene& s) { s.Renderer->SetBackground(0.2, 1.0, 0.0); }, UnchangedStages },
    { "view", [](Scene& s) { s.Pass->SetView(vtkExactTransparencyPass::VIEW_IMPORTANCE); },
      UnchangedStages },
    { "number of layers",
      [](Scene& s)
      {
        s.Pass->SetView(vtkExactTransparencyPass::VIEW_FIRST_LAYERS);
        s.Pass->SetLayer(2);
      },
      UnchangedStages },
    // What is stored of a fragment is no longer the same.
    { "no weights",
      [](Scene& s)
      {
        s.Optimization->SetOcclusionWeight(0.0);
        s.Optimization->SetClutterWeight(0.0);
      },
      "opaque copy gather sort resolve " },
  };
  bool passed = true;
  for (const Case& change : cases)
  {
    passed &= TestChange(change);
  }
  return passed;
}

//------------------------------------------------------------------------------
// Of avoidance, beside an actor whose opacities are optimised.
bool TestAvoidanceChanges()
{
  const auto get = [](Scene& s)
  { return vtkOcclusionAvoidance::SafeDownCast(vtkOcclusionAvoidance::Get(s.Lines)); };
  const std::vector<Case> cases = {
    { "penalty", [&](Scene& s) { get(s)->SetPenalty(0.9); },
      "opaque copy solve smooth avoid resolve " },
    { "no penalty", [&](Scene& s) { get(s)->SetPenalty(1.0); }, GatheredStages },
    { "mode", [&](Scene& s) { get(s)->SetModeToWeighting(); },
      "opaque copy solve smooth avoid resolve " },
    { "smoothed attributes", [&](Scene& s) { get(s)->SmoothAttributesOn(); },
      "opaque copy solve smooth attributes avoid resolve " },
  };
  bool passed = true;
  for (const Case& change : cases)
  {
    passed &= TestChange(change, [](Scene& s) { Avoid(s.Lines, 0, false); });
  }
  return passed;
}

//------------------------------------------------------------------------------
bool TestAvoidanceAlone()
{
  const auto prepare = [](Scene& s)
  {
    Avoid(s.Surface, 0, false);
    Avoid(s.Lines, 1, false);
  };
  const std::vector<Case> cases = {
    { "camera alone", [](Scene& s) { s.Renderer->GetActiveCamera()->Azimuth(20.0); },
      "opaque copy gather sort avoid resolve " },
    { "penalty alone",
      [](Scene& s) {
        vtkOcclusionAvoidance::SafeDownCast(vtkOcclusionAvoidance::Get(s.Surface))->SetPenalty(0.9);
      },
      "opaque copy avoid resolve " },
  };
  bool passed = true;
  for (const Case& change : cases)
  {
    passed &= TestChange(change, prepare);
  }
  return passed;
}

//------------------------------------------------------------------------------
// What shaders read beside the scene.
bool TestShaderInput()
{
  const Case uniform{ "custom uniform",
    [](Scene& s)
    { s.Surface->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformf("factor", 0.4f); },
    GatheredStages };
  bool passed = TestChange(uniform,
    [](Scene& s)
    {
      vtkShaderProperty* shader = s.Surface->GetShaderProperty();
      shader->AddFragmentShaderReplacement(
        "//VTK::Color::Impl", true, "//VTK::Color::Impl\n  diffuseColor *= factor;\n", false);
      shader->GetFragmentCustomUniforms()->SetUniformf("factor", 0.9f);
    });
  double factor = 0.0;
  double units = 0.0;
  vtkMapper::GetResolveCoincidentTopologyPolygonOffsetParameters(factor, units);
  const auto setOffset = [](int mode, double offsetFactor, double offsetUnits)
  {
    vtkMapper::SetResolveCoincidentTopology(mode);
    vtkMapper::SetResolveCoincidentTopologyPolygonOffsetParameters(offsetFactor, offsetUnits);
  };
  const auto restore = [&](Scene&) { setOffset(VTK_RESOLVE_OFF, factor, units); };
  const auto offset = [&](Scene&) { setOffset(VTK_RESOLVE_POLYGON_OFFSET, 50.0, 50000.0); };
  passed &= TestChange({ "coincident topology", offset, GatheredStages }, restore);
  setOffset(VTK_RESOLVE_OFF, factor, units);
  return passed;
}

//------------------------------------------------------------------------------
// What leaves a view as it was.
bool TestNothingChanges()
{
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> cases = {
    { "nothing", [](Scene&) {} },
    { "a frame without the renderer",
      [](Scene& s)
      {
        s.Renderer->DrawOff();
        s.Window->Render();
        s.Renderer->DrawOn();
      } },
    { "a screenshot",
      [](Scene& s)
      {
        vtkNew<vtkWindowToImageFilter> screenshot;
        screenshot->SetInput(s.Window);
        screenshot->ReadFrontBufferOff();
        screenshot->Update();
      } },
    { "a selection",
      [](Scene& s)
      {
        vtkNew<vtkHardwareSelector> selector;
        selector->SetRenderer(s.Renderer);
        selector->SetArea(0, 0, 119, 89);
        vtkSmartPointer<vtkSelection>::Take(selector->Select());
      } },
    { "a larger memory limit", [](Scene& s) { s.Pass->SetMemoryLimit(2000); } },
  };
  bool passed = true;
  for (const auto& [name, act] : cases)
  {
    Scene scene;
    OpenGLDebugOutput debugOutput(scene.Window);
    // The view angle of a perspective loses digits in VTK's screenshots.
    scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    const Picture before = Picture::Render(scene.Window);
    act(scene);
    passed &= Check(Picture::Render(scene.Window) == before, name + ": other bytes");
    passed &= Check(GetStages(scene.Pass) == UnchangedStages, name + ": " + GetStages(scene.Pass));
  }
  return passed;
}

//------------------------------------------------------------------------------
// Props that may change without a sign of it.
bool TestUncertainProps()
{
  const std::vector<std::pair<std::string, std::function<void(Scene&)>>> cases = {
    { "glyphs", [](Scene& s) { s.AddGlyphs(); } },
    { "a subclass of vtkActor", [](Scene& s) { AddLevelsOfDetail<OtherLevelsOfDetail>(s); } },
    { "an assembly",
      [](Scene& s)
      {
        vtkNew<vtkAssembly> assembly;
        s.Renderer->RemoveActor(s.Opaque);
        assembly->AddPart(s.AddSphere(2, 0.3));
        s.Renderer->AddActor(assembly);
      } },
  };
  bool passed = true;
  for (const auto& [name, add] : cases)
  {
    Scene scene;
    OpenGLDebugOutput debugOutput(scene.Window);
    add(scene);
    const Picture before = Picture::Render(scene.Window);
    passed &= Check(Picture::Render(scene.Window) == before, name + ": other bytes");
    passed &= Check(GetStages(scene.Pass) == GatheredStages, name + ": " + GetStages(scene.Pass));
  }
  return passed;
}

//------------------------------------------------------------------------------
// Data of the level that is not drawn may change unseen, until it is drawn.
bool TestLevelsOfDetail()
{
  Scene scene;
  OpenGLDebugOutput debugOutput(scene.Window);
  auto* actor = AddLevelsOfDetail<vtkPVLODActor>(scene);
  auto* sphere = vtkSphereSource::SafeDownCast(scene.Opaque->GetMapper()->GetInputAlgorithm());
  const auto show = [&](bool coarse)
  {
    actor->Coarse = coarse;
    return Picture::Render(scene.Window);
  };
  const Picture fine = show(false);
  bool passed = Check(show(false) == fine, "level of detail: other bytes");
  passed &= Check(GetStages(scene.Pass) == UnchangedStages, "level: " + GetStages(scene.Pass));
  const Picture coarse = show(true);
  passed &= Check(!(coarse == fine), "the level of detail changes nothing");
  passed &= Check(GetStages(scene.Pass) == GatheredStages, "other level: " + GetStages(scene.Pass));
  passed &= Check(show(false) == fine, "the former level of detail: other bytes");
  passed &= Check(GetStages(scene.Pass) == GatheredStages, "level again: " + GetStages(scene.Pass));
  sphere->SetRadius(0.8);
  passed &= Check(show(false) == fine, "data of the hidden level changes the picture");
  passed &= Check(
    GetStages(scene.Pass) == UnchangedStages, "hidden level changes: " + GetStages(scene.Pass));
  const Picture larger = show(true);
  passed &= Check(!(larger == coarse), "the level of detail has old data");
  sphere->SetRadius(0.9);
  passed &= Check(!(show(true) == larger), "data of the shown level changes nothing");
  return passed;
}

//------------------------------------------------------------------------------
// Data and parameters that change while nothing is optimised are seen when it is again.
bool TestChangesMeanwhile()
{
  const auto changeSegments = [](Scene& s)
  {
    vtkPolyDataMapper::SafeDownCast(s.Lines->GetMapper())
      ->SetInputData(MakeSegmentedLines(15, 400));
    s.Lines->GetMapper()->SetScalarRange(-0.5, 0.5);
  };
  Scene scene;
  OpenGLDebugOutput debugOutput(scene.Window);
  scene.Window->Render();
  scene.Optimization->SetOcclusionWeight(0.0);
  scene.Optimization->SetClutterWeight(0.0);
  scene.Window->Render();
  changeSegments(scene);
  scene.Window->Render();
  scene.Optimization->SetOcclusionWeight(500.0);
  const Picture picture = Picture::Render(scene.Window);
  Scene fresh;
  changeSegments(fresh);
  fresh.Optimization->SetOcclusionWeight(500.0);
  fresh.Optimization->SetClutterWeight(0.0);
  return Check(picture == Picture::Render(fresh.Window), "data that changed meanwhile");
}
}

//------------------------------------------------------------------------------
int TestUnchangedView(int, char*[])
{
  bool passed = TestGeometryChanges();
  passed &= TestOtherChanges();
  passed &= TestAvoidanceChanges();
  passed &= TestAvoidanceAlone();
  passed &= TestShaderInput();
  passed &= TestNothingChanges();
  passed &= TestUncertainProps();
  passed &= TestLevelsOfDetail();
  passed &= TestChangesMeanwhile();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
