// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkExactTransparencyPass.h"

#include "Private/vtkFragmentLists.h"
#include "Private/vtkFragmentStages.h"
#include "Private/vtkFragmentTiles.h"
#include "Private/vtkOpaqueLayer.h"
#include "Private/vtkOptimizedScene.h"
#include "Private/vtkRoundedConeMapper.h"
#include "Private/vtkSegmentOpacities.h"
#include "Private/vtkStageTimers.h"
#include "vtkFloatArray.h"
#include "vtkFragmentAppendDec.h"
#include "vtkFragmentImportanceDec.h"
#include "vtkFragmentListsDec.h"
#include "vtkObjectFactory.h"
#include "vtkOpaqueDepthDec.h"
#include "vtkOpenGLFXAAFilter.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLRenderer.h"
#include "vtkOpenGLState.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderState.h"
#include "vtkShaderProgram.h"
#include "vtkSurfaceImportanceDec.h"
#include "vtkSurfaceImportanceVS.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <regex>
#include <set>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkExactTransparencyPass);

namespace
{
// Nodes for each pixel before anything is known about a scene.
constexpr vtkIdType FirstNodesPerPixel = 2;

constexpr vtkIdType BytesPerMiB = 1024 * 1024;

// Smaller tiles are not divided when OpenGL has no memory: it would not help.
constexpr vtkIdType LeastPixelsForMemory = 4096;

const GLint NeededMajorVersion = 4;
const GLint NeededMinorVersion = 3;

std::vector<vtkProp*> GetProps(const vtkRenderState* state)
{
  return { state->GetPropArray(), state->GetPropArray() + state->GetPropArrayCount() };
}

// Whether the shader assigns its depth; VTK's template names gl_FragDepth in a comment in any case.
bool WritesDepth(const std::string& fragmentShader)
{
  static const std::regex assignment("gl_FragDepth\\s*=[^=]");
  return std::regex_search(fragmentShader, assignment);
}

// VTK's shader cache begins the shaders of mappers with version 150.
constexpr const char* Extensions = "//VTK::System::Dec\n"
                                   "#extension GL_ARB_shader_storage_buffer_object : require\n"
                                   "#extension GL_ARB_shading_language_420pack : require\n"
                                   "#extension GL_ARB_shader_bit_encoding : require\n";
}

//------------------------------------------------------------------------------
struct vtkExactTransparencyPass::Internals
{
  /** What belongs to one OpenGL context. Destroying it frees nothing: the context may be gone. */
  struct Resources
  {
    vtkFragmentLists Lists;
    vtkFragmentStages Stages;
    vtkSegmentOpacities Opacities;
    vtkOpaqueLayer Opaque;
    vtkStageTimers Timers;
    vtkNew<vtkOpenGLFXAAFilter> FXAAFilter;
    GLuint GatherFramebuffer = 0;

    vtkIdType GetBytes() const
    {
      return this->Lists.GetBytes() + this->Opacities.GetBytes() + this->Opaque.GetBytes();
    }
  };
  std::unique_ptr<Resources> GPU = std::make_unique<Resources>();
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  vtkMTimeType ContextTime = 0;

  vtkFragmentTiles Tiles;
  vtkOptimizedScene Scene;
  std::uint32_t LongLists = 0; ///< of the tile, left to the CPU

  // One frame.
  bool Optimize = false;
  vtkOpenGLState* State = nullptr;
  std::set<vtkProp*> RenderedProps;
  std::set<vtkProp*> PropsToBlend;

  // What the hooks in the mappers' shaders need.
  vtkPixelRectangle Tile;
  vtkProp* Prop = nullptr;
  bool PropTookPart = false;
  int ShaderSamples = 0;
  vtkTimeStamp ShaderTime;

  // Each is said once.
  bool WarnedOfOpenGL = false;
  bool WarnedOfBlending = false;
  bool WarnedOfMemory = false;
  bool ReportedNoMemory = false;

  vtkIdType GetBytesPerNode() const
  {
    return this->Optimize ? vtkFragmentLists::BytesPerOptimizedNode
                          : vtkFragmentLists::BytesPerNode;
  }

  /** The entry of a prop whose opacities are optimised; null for every other. */
  const vtkOptimizedScene::Member* FindOptimized(vtkProp* prop) const
  {
    const vtkOptimizedScene::Member* member = this->Optimize ? this->Scene.Find(prop) : nullptr;
    return member && !member->Avoids ? member : nullptr;
  }

  /** The entry of the prop that is being gathered, for mappers that do not bring their importances
   * themselves; null where the opacities are not optimised. */
  const vtkOptimizedScene::Member* FindMember(vtkAbstractMapper* mapper) const
  {
    const bool brings = vtkRoundedConeMapper::SafeDownCast(mapper) != nullptr;
    return brings ? nullptr : this->FindOptimized(this->Prop);
  }

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
        this->GPU->Lists.Release();
        this->GPU->Stages.Release();
        this->GPU->Opacities.Release();
        this->GPU->Opaque.Release();
        this->GPU->FXAAFilter->ReleaseGraphicsResources();
        glDeleteFramebuffers(1, &this->GPU->GatherFramebuffer);
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
  const vtkOptimizedScene::Member* member =
    internal.Window ? internal.FindOptimized(actor) : nullptr;
  if (!member)
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
  const std::vector<vtkProp*> props = GetProps(state);
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
  for (vtkProp* prop : GetProps(state))
  {
    this->NumberOfRenderedProps += prop->RenderVolumetricGeometry(renderer);
  }
  for (vtkProp* prop : GetProps(state))
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
  internal.RenderedProps.clear();
  internal.PropsToBlend.clear();

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
  const bool optimize = this->PrepareOptimization(state);
  if (internal.ShaderSamples != gpu.Opaque.GetSamples() || internal.Optimize != optimize)
  {
    internal.ShaderSamples = gpu.Opaque.GetSamples();
    internal.Optimize = optimize;
    internal.ShaderTime.Modified();
  }
  gpu.Stages.SetOptimize(optimize);

  if (gpu.Lists.GetBytes() > this->MemoryLimit * BytesPerMiB)
  {
    gpu.Lists.Release();
  }
  const vtkPixelRectangle image{ { viewport[0], viewport[1] }, { viewport[2], viewport[3] } };
  vtkOpenGLState::ScopedglScissor scissorSaver(internal.State);
  vtkOpenGLState::ScopedglEnableDisable scissorTestSaver(internal.State, GL_SCISSOR_TEST);
  internal.State->vtkglEnable(GL_SCISSOR_TEST);
  gpu.Opaque.Activate(internal.State);
  if (optimize)
  {
    this->RenderTiles(state, image, Sweep::Solve);
    this->SmoothOpacities();
  }
  if (!optimize || internal.Tiles.GetNumberOfTiles() > 1)
  {
    this->Statistics->SetFragments(0);
    this->RenderTiles(state, image, Sweep::Resolve);
  }
  else if (internal.Tiles.GetNumberOfTiles() == 1)
  {
    this->Resolve();
  }
  gpu.Opaque.Deactivate(internal.State);
  vtkFragmentLists::Unbind();
  vtkSegmentOpacities::Unbind();
  this->Statistics->SetTiles(internal.Tiles.GetNumberOfTiles());
  this->NumberOfRenderedProps += static_cast<int>(internal.RenderedProps.size());
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::PrepareOptimization(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  vtkOptimizedScene& scene = internal.Scene;
  const bool changed = scene.Update(GetProps(state));
  if (!scene.HasOptimization())
  {
    return false;
  }
  if (changed || internal.GPU->Opacities.GetBytes() == 0)
  {
    scene.MapImportances();
    if (!internal.GPU->Opacities.Upload(scene))
    {
      vtkErrorMacro("OpenGL has no room for the opacities of "
        << scene.GetNumberOfSegments()
        << " segments. This picture is drawn without optimised opacities.");
      internal.GPU->Opacities.Release();
      return false;
    }
  }
  for (const std::string& array : scene.TakeMissingArrays())
  {
    vtkWarningMacro("The data of an actor whose opacities are to be optimised has no point array \""
      << array
      << "\" of one component: it counts as unimportant. Name its importance with "
         "vtkOpacityOptimization::SetImportanceArray().");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::RenderTiles(
  const vtkRenderState* state, const vtkPixelRectangle& image, Sweep sweep)
{
  Internals& internal = *this->Internal;
  internal.Tiles.Begin(image, this->MemoryLimit * BytesPerMiB,
    vtkFragmentLists::GetLargestNodeCapacity(), internal.GetBytesPerNode());
  while (internal.Tiles.Next(internal.Tile))
  {
    internal.State->vtkglScissor(internal.Tile.Origin[0], internal.Tile.Origin[1],
      internal.Tile.Size[0], internal.Tile.Size[1]);
    this->RenderTile(state, sweep);
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::RenderTile(const vtkRenderState* state, Sweep sweep)
{
  const vtkPixelRectangle tile = this->Internal->Tile;
  const vtkIdType pixels = tile.GetNumberOfPixels();
  vtkFragmentTiles& tiles = this->Internal->Tiles;
  vtkFragmentLists& lists = this->Internal->GPU->Lists;

  vtkIdType fragments = 0;
  vtkIdType nodes = std::min(tiles.GetNodeLimit(), FirstNodesPerPixel * pixels);
  do
  {
    if (!lists.Reserve(
          pixels, nodes, this->Internal->GPU->Opaque.GetSamples(), this->Internal->Optimize))
    {
      lists.Release();
      this->DivideForMemory(nodes);
      return;
    }
    fragments = this->Gather(state);
    if (tiles.MustSplit(tile, fragments))
    {
      tiles.Split(tile, fragments);
      return;
    }
    if (fragments > tiles.GetNodeCapacity())
    {
      this->GiveUp(fragments);
      return;
    }
    // A quarter more, so that a slowly turning view does not grow the buffers every frame.
    nodes = std::max(fragments, std::min(fragments + fragments / 4, tiles.GetNodeLimit()));
  } while (fragments > lists.GetNodeCapacity());

  this->WarnOfMemory(fragments);
  this->Sort();
  if (sweep == Sweep::Solve)
  {
    this->Solve();
  }
  else
  {
    this->Resolve();
  }
  tiles.Finish(tile, fragments);
  this->Statistics->SetFragments(this->Statistics->GetFragments() + fragments);
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::DivideForMemory(vtkIdType nodes)
{
  vtkFragmentTiles& tiles = this->Internal->Tiles;
  tiles.LowerNodeCapacity(nodes / 2);
  if (this->Internal->Tile.GetNumberOfPixels() > LeastPixelsForMemory)
  {
    tiles.Split(this->Internal->Tile, nodes);
  }
  else
  {
    this->GiveUp(nodes);
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::GiveUp(vtkIdType nodes)
{
  this->Internal->Tiles.Abandon();
  if (!this->Internal->ReportedNoMemory)
  {
    const vtkPixelRectangle& tile = this->Internal->Tile;
    vtkErrorMacro("OpenGL has no room for the fragment lists of "
      << tile.Size[0] << " x " << tile.Size[1] << " pixels: needed are "
      << nodes * this->Internal->GetBytesPerNode() / BytesPerMiB + 1
      << " MiB. The rest of the picture shows the opaque scene only. Free graphics memory, or draw "
         "fewer translucent layers.");
    this->Internal->ReportedNoMemory = true;
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::WarnOfMemory(vtkIdType fragments)
{
  const bool exceeds = fragments > this->Internal->Tiles.GetNodeLimit();
  if (exceeds && !this->Internal->WarnedOfMemory)
  {
    vtkWarningMacro("One pixel has "
      << fragments << " translucent fragments, which need "
      << fragments * this->Internal->GetBytesPerNode() << " bytes, more than the memory limit of "
      << this->MemoryLimit << " MiB. The limit is exceeded to keep the picture exact.");
    this->Internal->WarnedOfMemory = true;
  }
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::BindGatherFramebuffer()
{
  // A framebuffer without attachments, as large as the tile reaches into the window, so that
  // fragments have the same window coordinates as in the target.
  const vtkPixelRectangle& tile = this->Internal->Tile;
  GLuint& framebuffer = this->Internal->GPU->GatherFramebuffer;
  if (framebuffer == 0)
  {
    glGenFramebuffers(1, &framebuffer);
  }
  this->Internal->State->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  this->Internal->State->vtkglDrawBuffer(GL_NONE);
  glFramebufferParameteri(
    GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, tile.Origin[0] + tile.Size[0]);
  glFramebufferParameteri(
    GL_DRAW_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, tile.Origin[1] + tile.Size[1]);
}

//------------------------------------------------------------------------------
vtkIdType vtkExactTransparencyPass::Gather(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkStageTimers::Scope stage(gpu.Timers, "gather");
  this->Statistics->SetGatherPasses(this->Statistics->GetGatherPasses() + 1);
  gpu.Lists.Clear(internal.Tile.GetNumberOfPixels());
  gpu.Lists.Bind();
  if (internal.Optimize)
  {
    gpu.Opacities.BindCorners();
  }
  internal.State->PushFramebufferBindings();
  this->BindGatherFramebuffer();
  this->PreRender(state);
  // All props, as VTK does: some draw translucent geometry without saying so before.
  for (vtkProp* prop : GetProps(state))
  {
    internal.Prop = prop;
    internal.PropTookPart = false;
    if (prop->RenderTranslucentPolygonalGeometry(state->GetRenderer()) > 0)
    {
      internal.RenderedProps.insert(prop);
      if (!internal.PropTookPart)
      {
        internal.PropsToBlend.insert(prop);
      }
    }
  }
  internal.Prop = nullptr;
  this->PostRender(state);
  internal.State->PopFramebufferBindings();
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  return gpu.Lists.ReadCounters().GetFragments();
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::Sort()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkIdType longest = 0;
  {
    vtkStageTimers::Scope stage(gpu.Timers, "sort");
    internal.State->PushFramebufferBindings();
    this->BindGatherFramebuffer();
    gpu.Stages.Sort(internal.Window, gpu.Opaque, internal.Tile);
    internal.State->PopFramebufferBindings();
    const vtkFragmentLists::Counters counters = gpu.Lists.ReadCounters();
    longest = counters.LongestList;
    internal.LongLists = counters.LongLists;
    if (internal.LongLists > 0 && !internal.Optimize)
    {
      longest = gpu.Lists.CollapseLongLists(internal.LongLists, gpu.Opaque.GetSamples(), {});
    }
  }
  this->Statistics->SetLongestList(std::max(this->Statistics->GetLongestList(), longest));
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::Solve()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkStageTimers::Scope stage(gpu.Timers, "solve");
  internal.State->PushFramebufferBindings();
  this->BindGatherFramebuffer();
  gpu.Opacities.BindTables();
  gpu.Stages.Solve(internal.Window, gpu.Opaque, internal.Tile);
  internal.State->PopFramebufferBindings();
  vtkIdType solved = gpu.Lists.ReadCounters().SolvedFragments;
  if (internal.LongLists > 0)
  {
    const auto opacities =
      gpu.Lists.SolveLongLists(internal.LongLists, gpu.Opaque.GetSamples(), internal.Scene);
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
  vtkStageTimers::Scope stage(gpu.Timers, "smooth");
  internal.State->PushFramebufferBindings();
  gpu.Opacities.Smooth(internal.Window, internal.Scene.GetSmoothingIterations());
  internal.State->PopFramebufferBindings();
  gpu.Lists.Bind();
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::Resolve()
{
  Internals& internal = *this->Internal;
  Internals::Resources& gpu = *internal.GPU;
  vtkStageTimers::Scope stage(gpu.Timers, "resolve");
  if (internal.Optimize)
  {
    if (internal.LongLists > 0)
    {
      const vtkIdType longest = gpu.Lists.CollapseLongLists(
        internal.LongLists, gpu.Opaque.GetSamples(), gpu.Opacities.Read());
      this->Statistics->SetLongestList(std::max(this->Statistics->GetLongestList(), longest));
    }
    gpu.Opacities.BindOpacities();
  }
  gpu.Stages.Resolve(internal.Window, gpu.Opaque, internal.Tile);
}

//------------------------------------------------------------------------------
void vtkExactTransparencyPass::BlendOtherProps(const vtkRenderState* state)
{
  Internals& internal = *this->Internal;
  this->Statistics->SetBlendedProps(static_cast<int>(internal.PropsToBlend.size()));
  if (internal.PropsToBlend.empty())
  {
    return;
  }
  vtkStageTimers::Scope stage(internal.GPU->Timers, "blend");
  const char* firstClass = nullptr;
  for (vtkProp* prop : GetProps(state))
  {
    if (internal.PropsToBlend.count(prop) > 0)
    {
      firstClass = firstClass ? firstClass : prop->GetClassName();
      prop->RenderTranslucentPolygonalGeometry(state->GetRenderer());
    }
  }
  if (!internal.WarnedOfBlending)
  {
    vtkWarningMacro(<< internal.PropsToBlend.size() << " translucent prop(s), the first a "
                    << firstClass
                    << ", have a mapper that takes no part in render passes. They are blended over "
                       "the exact result, without regard to depth order.");
    internal.WarnedOfBlending = true;
  }
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::PreReplaceShaderValues(
  std::string& vertexShader, std::string&, std::string&, vtkAbstractMapper* mapper, vtkProp*)
{
  if (this->Internal->FindMember(mapper))
  {
    vtkShaderProgram::Substitute(vertexShader, "//VTK::PositionVC::Dec",
      std::string(vtkSurfaceImportanceVS) + "//VTK::PositionVC::Dec", false);
    vtkShaderProgram::Substitute(vertexShader, "//VTK::PositionVC::Impl",
      "pellucidPassImportance();\n//VTK::PositionVC::Impl", false);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  const bool optimize = this->Internal->Optimize;
  const bool takesPart = this->Internal->FindMember(mapper) != nullptr;
  const std::string depth = WritesDepth(fragmentShader) ? "gl_FragDepth" : "gl_FragCoord.z";
  const std::string declarations =
    vtkFragmentLists::GetShaderDefinitions(this->Internal->ShaderSamples, optimize) +
    vtkSegmentOpacities::GetShaderDefinitions() + vtkFragmentListsDec + vtkOpaqueDepthDec +
    (optimize ? vtkFragmentImportanceDec : "") + vtkFragmentAppendDec +
    (takesPart ? vtkSurfaceImportanceDec : "");
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::System::Dec", Extensions, false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Dec", declarations, false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::PreColor",
    "if (pellucidIsHidden(" + depth + ")) { discard; }\n", false);
  vtkShaderProgram::Substitute(fragmentShader, "//VTK::DepthPeeling::Impl",
    std::string(takesPart ? "pellucidSetImportance();\n" : "") + "pellucidAppend(gl_FragData[0], " +
      depth + ");\n",
    false);
  return true;
}

//------------------------------------------------------------------------------
bool vtkExactTransparencyPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  Internals& internal = *this->Internal;
  if (program->IsUniformUsed("pellucidNodeCapacity"))
  {
    internal.PropTookPart = true;
    vtkFragmentStages::SetTile(program, internal.Tile);
    internal.GPU->Opaque.SetUniforms(program);
    program->SetUniformi(
      "pellucidNodeCapacity", static_cast<int>(internal.GPU->Lists.GetNodeCapacity()));
    const vtkOptimizedScene::Member* member = internal.FindOptimized(internal.Prop);
    if (member && program->IsUniformUsed("pellucidFirstSegment"))
    {
      const vtkOptimizedScene::Part& part = member->FindPart(mapper);
      program->SetUniformi("pellucidFirstSegment", static_cast<int>(part.FirstSegment));
      program->SetUniformi(
        "pellucidFirstCorner", part.HasCorners ? static_cast<int>(part.FirstCorner) : -1);
      program->SetUniformi("pellucidFirstCornerOpacity",
        static_cast<int>(internal.Scene.GetNumberOfSegments() + part.FirstCorner));
    }
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkExactTransparencyPass::GetShaderStageMTime()
{
  return this->Internal->ShaderTime;
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
  os << indent << "GatherScale: " << this->GatherScale << "\n";
  os << indent << "FadeTime: " << this->FadeTime << " s\n";
  os << indent << "FrameTime: " << this->FrameTime << " s\n";
  os << indent << "Statistics:\n";
  this->Statistics->PrintSelf(os, indent.GetNextIndent());
}

VTK_ABI_NAMESPACE_END
