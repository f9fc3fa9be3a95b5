// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkExactTransparencyPass.h"

#include "Private/vtkFragmentGather.h"
#include "Private/vtkFragmentStages.h"
#include "Private/vtkFragmentSweep.h"
#include "Private/vtkLongFragmentList.h"
#include "Private/vtkOpaqueLayer.h"
#include "Private/vtkOptimizedScene.h"
#include "Private/vtkPictureView.h"
#include "Private/vtkPixelAttributes.h"
#include "Private/vtkSceneSignature.h"
#include "Private/vtkSegmentOpacities.h"
#include "Private/vtkStageTimers.h"
#include "vtkActor2D.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkExactTransparencyPass);

namespace
{
constexpr vtkIdType BytesPerMiB = 1024 * 1024;

const GLint NeededMajorVersion = 4;
const GLint NeededMinorVersion = 3;

//------------------------------------------------------------------------------
// Those out of view too: where they come and go, segments stay the same.
std::vector<vtkProp*> GetViewProps(vtkRenderer* renderer)
{
  std::vector<vtkProp*> props;
  vtkCollectionSimpleIterator iterator;
  renderer->GetViewProps()->InitTraversal(iterator);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(iterator))
  {
    props.push_back(prop);
  }
  return props;
}

//------------------------------------------------------------------------------
// Whether the frame is a part of a picture that is larger than the window.
bool IsTile(vtkOpenGLRenderWindow* window)
{
  const int* scale = window->GetTileScale();
  return scale[0] > 1 || scale[1] > 1;
}
}

//------------------------------------------------------------------------------
struct vtkExactTransparencyPass::Internals
{
  /** What belongs to one OpenGL context. Destroying it frees nothing: the context may be gone. */
  struct Resources
  {
    vtkFragmentGather Gather;
    vtkFragmentSweep Sweep;
    vtkFragmentStages Stages;
    vtkSegmentOpacities Opacities;
    vtkPixelAttributes Attributes;
    vtkOpaqueLayer Opaque;
    vtkStageTimers Timers;
    vtkNew<vtkOpenGLFXAAFilter> FXAAFilter;

    // What the frames before have left that is still right.
    bool HasSolved = false;  ///< the opacities of all segments
    bool HasWhole = false;   ///< they are of a whole picture, not of a tile of a larger one
    bool HasAvoided = false; ///< the lists have the factors of occlusion avoidance

    vtkIdType GetBytes() const
    {
      return this->Sweep.GetBytes() + this->Opacities.GetBytes() + this->Attributes.GetBytes() +
        this->Opaque.GetBytes();
    }
  };
  std::unique_ptr<Resources> GPU = std::make_unique<Resources>();
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMTimeType ContextTime = 0;

  vtkOptimizedScene Scene;
  vtkSceneSignature Signature;
  int SolvedScale = 1;    ///< GatherScale of the solution
  double FrameTime = 0.0; ///< of the last frame, in seconds

  bool StoresImportance = false;
  vtkOpenGLState* State = nullptr;

  // Each is said once.
  bool WarnedOfOpenGL = false;
  bool WarnedOfBlending = false;
  bool WarnedOfTiles = false;

  bool HasAvoidance() const { return this->StoresImportance && this->Scene.HasAvoidance(); }

  void FollowContext(vtkOpenGLRenderWindow* window)
  {
    if (this->Window != window || this->ContextTime != window->GetContextCreationTime())
    {
      this->Release();
      window->MakeCurrent();
      this->Window = window;
      this->ContextTime = window->GetContextCreationTime();
    }
  }

  void Release()
  {
    if (this->Window && this->ContextTime == this->Window->GetContextCreationTime())
    {
      this->Window->PushContext();
      if (this->Window->IsCurrent())
      {
        this->GPU->Sweep.Release();
        this->GPU->Stages.Release();
        this->GPU->Opacities.Release();
        this->GPU->Attributes.Release();
        this->GPU->Opaque.Release();
        this->GPU->FXAAFilter->ReleaseGraphicsResources();
      }
      this->Window->PopContext();
    }
    this->GPU = std::make_unique<Resources>();
    this->Window = nullptr;
  }
};

//------------------------------------------------------------------------------
vtkExactTransparencyPass::vtkExactTransparencyPass()
  : Internal(std::make_unique<Internals>())
{
}

//------------------------------------------------------------------------------
vtkExactTransparencyPass::~vtkExactTransparencyPass()
{
  this->Internal->Release();
}

//------------------------------------------------------------------------------
vtkTransparencyStatistics* vtkExactTransparencyPass::GetStatistics()
{
  return this->Statistics;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> vtkExactTransparencyPass::GetOptimizedOpacities(vtkProp* actor)
{
  Internals& internal = *this->Internal;
  const vtkOptimizedScene::Member* member = internal.Window &&
      (internal.GPU->HasSolved || internal.GPU->HasWhole) && internal.Scene.HasOptimization()
    ? internal.Scene.Find(actor)
    : nullptr;
  if (!member || member->Avoids)
  {
    return nullptr;
  }
  internal.Window->MakeCurrent();
  const std::vector<float> opacities = internal.GPU->Opacities.Read();
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  for (const vtkOptimizedScene::Part& part : member->Parts)
  {
    for (std::uint32_t segment = 0; segment < part.NumberOfSegments; ++segment)
    {
      result->InsertNextValue(opacities[part.FirstSegment + segment]);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
std::string vtkExactTransparencyPass::GetReasonUnsupported(vtkRenderWindow* window)
{
  if (!vtkOpenGLRenderWindow::SafeDownCast(window))
  {
    return "exact transparency needs an OpenGL render window";
  }
  GLint major = 0;
  GLint minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  if (std::tie(major, minor) >= std::tie(NeededMajorVersion, NeededMinorVersion))
  {
    return std::string();
  }
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  return "exact transparency needs OpenGL " + std::to_string(NeededMajorVersion) + "." +
    std::to_string(NeededMinorVersion) + ", found \"" + (version ? version : "none") + "\"";
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::Render(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  this->Statistics->Reset();
  this->ClearLights(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  if (this->KeepsStockPath(state))
  {
    this->UpdateGeometry(renderer, state->GetFrameBuffer());
    this->NumberOfRenderedProps = renderer->GetNumberOfPropsRendered();
  }
  else
  {
    this->RenderGeometry(state);
  }
  this->Statistics->SetBufferBytes(this->Internal->GPU->GetBytes());
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::KeepsStockPath(const vtkRenderState* state)
{
  vtkRenderer* renderer = state->GetRenderer();
  if (renderer->GetSelector() || renderer->GetUseShadows())
  {
    return true;
  }
  const std::vector<vtkProp*> props = vtkFragmentGather::GetProps(state);
  const bool peelsVolumes =
    renderer->GetUseDepthPeeling() && renderer->GetUseDepthPeelingForVolumes();
  if (peelsVolumes && std::any_of(props.begin(), props.end(), vtkVolume::SafeDownCast))
  {
    return true;
  }
  const bool hasTranslucentGeometry = std::any_of(props.begin(), props.end(),
    [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry() != 0; });
  if (!hasTranslucentGeometry)
  {
    return true;
  }
  const std::string reason =
    vtkExactTransparencyPass::GetReasonUnsupported(renderer->GetRenderWindow());
  if (!reason.empty() && !this->Internal->WarnedOfOpenGL)
  {
    vtkWarningMacro("VTK's own transparency is used, because " << reason << ".");
    this->Internal->WarnedOfOpenGL = true;
  }
  return !reason.empty();
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::RenderGeometry(const vtkRenderState* state)
{
  auto* renderer = static_cast<vtkOpenGLRenderer*>(state->GetRenderer());
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLClearErrorMacro();
  this->Internal->FollowContext(window);
  Internals::Resources& gpu = *this->Internal->GPU;
  this->Internal->State = window->GetState();
  const int renderedBefore = renderer->GetNumberOfPropsRendered();
  {
    vtkStageTimers::Scope stage(gpu.Timers, "opaque");
    renderer->DeviceRenderOpaqueGeometry(state->GetFrameBuffer());
  }
  this->NumberOfRenderedProps = renderer->GetNumberOfPropsRendered() - renderedBefore;
  this->RenderTranslucentGeometry(state);
  this->BlendOtherProps(state);
  gpu.Timers.Collect(this->Statistics);

  if (renderer->GetUseFXAA())
  {
    if (vtkFXAAOptions* options = renderer->GetFXAAOptions())
    {
      gpu.FXAAFilter->UpdateConfiguration(options);
    }
    gpu.FXAAFilter->Execute(renderer);
  }
  for (vtkProp* prop : vtkFragmentGather::GetProps(state))
  {
    this->NumberOfRenderedProps += prop->RenderVolumetricGeometry(renderer);
  }
  for (vtkProp* prop : vtkFragmentGather::GetProps(state))
  {
    this->NumberOfRenderedProps += prop->RenderOverlay(renderer);
  }
  vtkOpenGLCheckErrorMacro("failed after RenderGeometry");
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::RenderTranslucentGeometry(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  std::array<int, 4> viewport{};
  internal.State->vtkglGetIntegerv(GL_VIEWPORT, viewport.data());
  if (viewport[2] < 1 || viewport[3] < 1)
  {
    return;
  }
  {
    vtkStageTimers::Scope stage(gpu.Timers, "copy");
    gpu.Opaque.Copy(internal.State, viewport);
  }
  this->PrepareImportance(state);
  const vtkPixelRectangle picture{ { viewport[0], viewport[1] }, { viewport[2], viewport[3] } };
  this->BeginSweeps(state, picture);
  gpu.Opaque.Activate(internal.State);
  if (internal.StoresImportance)
  {
    this->OptimizeOpacities();
  }
  if (internal.HasAvoidance())
  {
    this->PrepareAvoidance(state->GetRenderer(), picture);
  }
  if (this->View == VIEW_LENGTH)
  {
    gpu.Sweep.Run(1, [] {});
  }
  // Of all tiles: the next sweep counts anew.
  const vtkIdType longestList = gpu.Sweep.GetLongestList();
  gpu.Sweep.Run(1, [this, longestList] { this->Resolve(longestList); });
  if (gpu.Sweep.GetNumberOfGathers() > 0)
  {
    // Now, because what is drawn for the first time changes: lookup tables are built.
    internal.Signature = vtkSceneSignature(state, picture);
  }
  gpu.Opaque.Deactivate(internal.State);
  vtkFragmentLists::Unbind();
  vtkSegmentOpacities::Unbind();
  this->Statistics->SetFragments(gpu.Sweep.GetNumberOfFragments());
  this->Statistics->SetLongestList(gpu.Sweep.GetLongestList());
  this->Statistics->SetGatherPasses(gpu.Sweep.GetNumberOfGathers());
  this->Statistics->SetTiles(gpu.Sweep.GetNumberOfTiles());
  this->NumberOfRenderedProps += static_cast<int>(gpu.Gather.GetRenderedProps().size());
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::PrepareImportance(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkOptimizedScene& scene = internal.Scene;
  const auto change = scene.Update(GetViewProps(state->GetRenderer()));
  for (const std::string& array : scene.TakeMissingArrays())
  {
    vtkWarningMacro(
      "The data of an actor whose opacities follow from importance has no point array \""
      << array
      << "\" of one component: it counts as unimportant. Make one with vtkImportance (ParaView's "
         "filter "
         "Importance), or name another with vtkImportanceDrivenOpacity::SetImportanceArray().");
  }
  for (const std::string& mapper : scene.TakeUnsupportedMappers())
  {
    vtkWarningMacro("An actor whose opacities are to follow from importance has a "
      << mapper
      << ", which cannot bring importances to the pass: it keeps its opacity. Use a "
         "vtkTrajectoryMapper, or a vtkPolyDataMapper for each block or glyph.");
  }
  const bool shows = this->View == VIEW_IMPORTANCE || this->View == VIEW_SEGMENTS;
  internal.StoresImportance =
    scene.HasOptimization() || scene.HasAvoidance() || (shows && scene.HasMembers());
  if (!internal.StoresImportance)
  {
    // The next ones may be of other segments.
    gpu.Opacities.Release();
    gpu.HasSolved = false;
    return;
  }
  using Change = vtkOptimizedScene::Change;
  const bool isFirst = gpu.Opacities.GetBytes() == 0;
  if (isFirst || change != Change::None)
  {
    gpu.HasSolved = false;
    gpu.HasWhole = false;
    gpu.HasAvoided = gpu.HasAvoided && !scene.HasAvoidance();
    scene.MapImportances();
    const bool uploaded = isFirst || change == Change::Segments
      ? gpu.Opacities.Upload(scene)
      : gpu.Opacities.UploadSettings(scene);
    if (!uploaded)
    {
      vtkErrorMacro("OpenGL has no room for the opacities of "
        << scene.GetNumberOfSegments()
        << " segments. This picture is drawn without optimised opacities.");
      gpu.Opacities.Release();
      internal.StoresImportance = false;
    }
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::BeginSweeps(
  const vtkRenderState* state, const vtkPixelRectangle& picture)
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  const vtkMTimeType shaderTime = gpu.Gather.GetShaderTime();
  gpu.Gather.SetFormat(gpu.Opaque, internal.StoresImportance);
  gpu.Stages.SetStoresImportance(internal.StoresImportance);
  // Opacities that are yet to be found may show them, and some views do.
  const bool keepsHidden = internal.StoresImportance || this->View != VIEW_PICTURE;
  gpu.Stages.SetKeepsHidden(keepsHidden);
  // Factors stay in the lists where no others are found.
  const bool hasOldFactors = gpu.HasAvoided && !internal.HasAvoidance();
  const bool isSame = !hasOldFactors && shaderTime == gpu.Gather.GetShaderTime() &&
    vtkSceneSignature(state, picture).IsSame(internal.Signature);
  if (!isSame)
  {
    gpu.Gather.ForgetProps();
  }
  gpu.HasSolved = gpu.HasSolved && isSame && internal.SolvedScale == this->GatherScale;
  internal.SolvedScale = this->GatherScale;

  vtkFragmentSweep::Frame frame;
  frame.Owner = this;
  frame.Window = internal.Window;
  frame.Stages = &gpu.Stages;
  frame.Opaque = &gpu.Opaque;
  frame.Timers = &gpu.Timers;
  frame.Picture = picture;
  frame.LimitBytes = this->MemoryLimit * BytesPerMiB;
  frame.StoresImportance = internal.StoresImportance;
  frame.KeepsHidden = keepsHidden;
  frame.DrawProps = [this, state]
  {
    Internals::Resources& resources = *this->Internal->GPU;
    resources.HasAvoided = false;
    if (this->Internal->StoresImportance)
    {
      resources.Opacities.BindCorners();
    }
    this->PreRender(state);
    resources.Gather.DrawProps(state, resources.Sweep.GetTile(), resources.Sweep.GetLists(),
      resources.Opaque, this->Internal->Scene);
    this->PostRender(state);
  };
  gpu.Sweep.Begin(frame, isSame);
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::OptimizeOpacities()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  if (IsTile(internal.Window) && internal.Scene.HasOptimization())
  {
    if (gpu.HasWhole)
    {
      return;
    }
    this->WarnOfTiles();
  }
  this->FadeOpacities();
  if (!gpu.HasSolved)
  {
    if (internal.Scene.HasOptimization())
    {
      gpu.Sweep.Run(this->GatherScale, [this] { this->Solve(); });
      this->SmoothOpacities();
    }
    else
    {
      gpu.Opacities.Forget();
    }
    gpu.HasSolved = true;
    gpu.HasWhole = !IsTile(internal.Window);
  }
  this->Statistics->SetFading(gpu.Opacities.IsFading());
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::WarnOfTiles()
{
  if (!this->Internal->WarnedOfTiles)
  {
    vtkWarningMacro("The parts of a picture that is larger than the window find opacities of their "
                    "own, which may differ where they meet. Render the window once before, to "
                    "give them those of the whole view.");
    this->Internal->WarnedOfTiles = true;
  }
}

//------------------------------------------------------------------------------
// The opacities of the frame before come nearer to those that were its aim; this frame's are the
// aim of the next.
void vtkExactTransparencyPass::FadeOpacities()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  if (!(this->FadeTime > 0.0) || !gpu.Opacities.StartFading())
  {
    gpu.HasSolved = !gpu.Opacities.StopFading() && gpu.HasSolved;
    return;
  }
  const std::chrono::duration<double> clock = std::chrono::steady_clock::now().time_since_epoch();
  const double now = this->FrameTime >= 0.0 ? this->FrameTime : clock.count();
  const double seconds = std::max(0.0, now - internal.FrameTime); // 0 also where that is NaN
  internal.FrameTime = now;
  if (gpu.Opacities.IsFading())
  {
    vtkStageTimers::Scope stage(gpu.Timers, "fade");
    gpu.Opacities.Fade(internal.Window, 1.0 - std::exp(-seconds / this->FadeTime));
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::PrepareAvoidance(
  vtkRenderer* renderer, const vtkPixelRectangle& picture)
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  if (gpu.Sweep.HasLists() && gpu.HasAvoided)
  {
    return;
  }
  if (!gpu.Attributes.Prepare(renderer, picture, internal.Scene.SmoothsPixels()))
  {
    vtkErrorMacro("OpenGL has no room for the attributes of "
      << picture.GetNumberOfPixels() << " pixels. They are not smoothed in this picture.");
    gpu.Attributes.Prepare(renderer, picture, false);
  }
  if (gpu.Attributes.Smooths())
  {
    gpu.Sweep.Run(1, [this] { this->FindAttributes(); });
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::FindAttributes()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkStageTimers::Scope stage(gpu.Timers, "attributes");
  gpu.Attributes.Bind();
  gpu.Sweep.DrawOffScreen(
    [&] {
      gpu.Stages.FindAttributes(internal.Window, gpu.Opaque, gpu.Sweep.GetTile(), gpu.Attributes);
    });
  if (gpu.Sweep.GetNumberOfLongLists() > 0)
  {
    std::vector<vtkPixelAttributes::Attributes> pixels = gpu.Attributes.Read();
    gpu.Sweep.GetLists().VisitLongLists(gpu.Sweep.GetNumberOfLongLists(), gpu.Opaque.GetSamples(),
      [&](vtkLongFragmentList& list, std::uint32_t pixel)
      {
        pixels[gpu.Attributes.GetIndex(gpu.Sweep.GetTile(), pixel)] =
          list.GetAttributes(&gpu.Attributes);
      });
    gpu.Attributes.Write(pixels);
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::Avoid()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkStageTimers::Scope stage(gpu.Timers, "avoid");
  gpu.Opacities.BindTables();
  gpu.Attributes.Bind();
  gpu.Sweep.DrawOffScreen(
    [&] { gpu.Stages.Avoid(internal.Window, gpu.Opaque, gpu.Sweep.GetTile(), gpu.Attributes); });
  gpu.HasAvoided = true;
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::CollapseLongLists(const vtkPictureView& view)
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  const bool avoids = internal.HasAvoidance();
  const auto attributes = avoids && gpu.Attributes.Smooths()
    ? gpu.Attributes.Read()
    : std::vector<vtkPixelAttributes::Attributes>();
  const auto avoid = [&](vtkLongFragmentList& list, std::uint32_t pixel)
  {
    if (avoids)
    {
      list.Avoid(internal.Scene, gpu.Attributes,
        gpu.Attributes.Smooth(attributes, gpu.Attributes.GetIndex(gpu.Sweep.GetTile(), pixel)));
    }
  };
  gpu.Sweep.GetLists().CollapseLongLists(gpu.Sweep.GetNumberOfLongLists(), gpu.Opaque.GetSamples(),
    view, internal.StoresImportance ? gpu.Opacities.Read() : std::vector<float>(), avoid);
  gpu.Sweep.ForgetLists();
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::Solve()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkStageTimers::Scope stage(gpu.Timers, "solve");
  gpu.Sweep.GetLists().ClearSolvedFragments();
  gpu.Opacities.BindTables();
  gpu.Sweep.DrawOffScreen(
    [&] { gpu.Stages.Solve(internal.Window, gpu.Opaque, gpu.Sweep.GetTile()); });
  vtkIdType solved = gpu.Sweep.GetLists().ReadCounters().SolvedFragments;
  if (gpu.Sweep.GetNumberOfLongLists() > 0)
  {
    const auto opacities = gpu.Sweep.GetLists().SolveLongLists(
      gpu.Sweep.GetNumberOfLongLists(), gpu.Opaque.GetSamples(), internal.Scene);
    gpu.Opacities.Lower(opacities);
    solved += static_cast<vtkIdType>(opacities.size());
  }
  this->Statistics->SetSolvedFragments(this->Statistics->GetSolvedFragments() + solved);
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::SmoothOpacities()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  {
    vtkStageTimers::Scope stage(gpu.Timers, "solve");
    gpu.Opacities.TakeLeast(internal.Window);
  }
  if (const int iterations = internal.Scene.GetSmoothingIterations())
  {
    vtkStageTimers::Scope stage(gpu.Timers, "smooth");
    gpu.Opacities.Smooth(internal.Window, iterations);
  }
  vtkStageTimers::Scope stage(gpu.Timers, "solve");
  gpu.Opacities.Show(internal.Window);
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::Resolve(vtkIdType longestList)
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  if (internal.HasAvoidance() && !gpu.HasAvoided)
  {
    this->Avoid();
  }
  vtkStageTimers::Scope stage(gpu.Timers, "resolve");
  const vtkPictureView view{ this->View, this->Layer, longestList, this->RoundTranslucentLayers };
  if (gpu.Sweep.GetNumberOfLongLists() > 0)
  {
    this->CollapseLongLists(view);
  }
  if (internal.StoresImportance)
  {
    gpu.Opacities.BindOpacities();
  }
  gpu.Stages.Resolve(internal.Window, gpu.Opaque, gpu.Sweep.GetTile(), view);
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::BlendOtherProps(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  const std::set<vtkProp*>& props = internal.GPU->Gather.GetPropsWithoutHooks();
  this->Statistics->SetBlendedProps(0);
  if (props.empty())
  {
    return;
  }
  vtkStageTimers::Scope stage(internal.GPU->Timers, "blend");
  std::vector<vtkProp*> withDepth;
  for (vtkProp* prop : vtkFragmentGather::GetProps(state))
  {
    if (props.count(prop) > 0)
    {
      prop->RenderTranslucentPolygonalGeometry(state->GetRenderer());
      if (!vtkActor2D::SafeDownCast(prop))
      {
        withDepth.push_back(prop);
      }
    }
  }
  this->Statistics->SetBlendedProps(static_cast<int>(withDepth.size()));
  if (!withDepth.empty() && !internal.WarnedOfBlending)
  {
    vtkWarningMacro(<< withDepth.size() << " translucent prop(s), the first a "
                    << withDepth.front()->GetClassName()
                    << ", have a mapper that takes no part in render passes. They are blended over "
                       "the exact result, without regard to depth order.");
    internal.WarnedOfBlending = true;
  }
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string&, vtkAbstractMapper* mapper, vtkProp*)
{
  this->Internal->GPU->Gather.EditVertexShaders(vertexShader, geometryShader, mapper);
  return true;
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  this->Internal->GPU->Gather.EditFragmentShader(
    vertexShader, geometryShader, fragmentShader, mapper);
  return true;
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  this->Internal->GPU->Gather.SetUniforms(program, mapper);
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkExactTransparencyPass::GetShaderStageMTime()
{
  return this->Internal->GPU->Gather.GetShaderTime();
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Superclass::ReleaseGraphicsResources(window);
  if (window == this->Internal->Window)
  {
    this->FreeGraphicsMemory();
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::FreeGraphicsMemory()
{
  this->Internal->Release();
  this->Statistics->SetBufferBytes(0);
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MemoryLimit: " << this->MemoryLimit << " MiB\n";
  os << indent << "View: " << this->View << "\n";
  os << indent << "Layer: " << this->Layer << "\n";
  os << indent << "RoundTranslucentLayers: " << this->RoundTranslucentLayers << "\n";
  os << indent << "GatherScale: " << this->GatherScale << "\n";
  os << indent << "FadeTime: " << this->FadeTime << " s\n";
  os << indent << "FrameTime: " << this->FrameTime << " s\n";
  os << indent << "Statistics:\n";
  this->Statistics->PrintSelf(os, indent.GetNextIndent());
}

VTK_ABI_NAMESPACE_END
