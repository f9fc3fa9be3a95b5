// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSegmentOpacities.h"

#include "Importance.h"
#include "vtkCornerOpacitiesFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOptimizedScene.h"
#include "vtkSegmentFadeFS.h"
#include "vtkSegmentSmoothFS.h"
#include "vtkSegmentTablesDec.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"
#include "vtkStorageBuffer.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
// Bindings behind those of vtkFragmentLists, which stay bound in gather, solve and resolve. The
// steps between those use the bindings of the lists for tables of their own.
constexpr GLuint SegmentsBinding = 6;
constexpr GLuint ActorsBinding = 7;
constexpr GLuint GatherCornersBinding = 6;
constexpr GLuint OpacitiesBinding = 6;
constexpr GLuint FirstNeighborsBinding = 0;
constexpr GLuint NeighborsBinding = 1;
constexpr GLuint SourceBinding = 2;
constexpr GLuint TargetBinding = 3;
constexpr GLuint CornersBinding = 7;
constexpr GLuint PendingBinding = 0;

constexpr std::uint32_t Unseen = 0xffffffffu;
constexpr std::uint32_t TriangleBit = 0x80000000u;
constexpr std::uint32_t FactorBit = 0x40000000u;

// How far a segment moves towards its neighbours in one step. With 1 the opacities of two
// neighbours would be exchanged; 1/2 gives the binomial weights 1/4, 1/2, 1/4 on a line.
constexpr double Relaxation = 0.5;

// Invocations in a row of the framebuffer, which OpenGL lets be 16384 wide and high at least.
constexpr int RowLength = 8192;

// What opacities have left of their way when all jump to its end: 1/3000.
const double NegligibleWay = std::exp(-8.0);
}

//------------------------------------------------------------------------------
std::string vtkSegmentOpacities::GetShaderDefinitions()
{
  vtkShaderDefinitions definitions;
  definitions.Define("SEGMENTS_BINDING", static_cast<int>(SegmentsBinding));
  definitions.Define("ACTORS_BINDING", static_cast<int>(ActorsBinding));
  definitions.Define("GATHER_CORNERS_BINDING", static_cast<int>(GatherCornersBinding));
  definitions.Define("OPACITIES_BINDING", static_cast<int>(OpacitiesBinding));
  definitions.Define("FIRST_NEIGHBORS_BINDING", static_cast<int>(FirstNeighborsBinding));
  definitions.Define("NEIGHBORS_BINDING", static_cast<int>(NeighborsBinding));
  definitions.Define("SOURCE_BINDING", static_cast<int>(SourceBinding));
  definitions.Define("TARGET_BINDING", static_cast<int>(TargetBinding));
  definitions.Define("CORNERS_BINDING", static_cast<int>(CornersBinding));
  definitions.Define("PENDING_BINDING", static_cast<int>(PendingBinding));
  definitions.Define("UNSEEN", Unseen);
  definitions.Define("LEAST_UNIMPORTANCE", pellucid::LeastUnimportance);
  definitions.Define("RELAXATION", Relaxation);
  definitions.Define("NEGLIGIBLE_WAY", NegligibleWay);
  definitions.Define("TRIANGLE", TriangleBit);
  definitions.Define("HAS_FACTOR", FactorBit);
  definitions.Define("FACTOR_OF_ONE", FactorBit | 0x3f800000u);
  definitions.Define("AVOIDING", AvoidingBit);
  return definitions.GetText();
}

//------------------------------------------------------------------------------
bool vtkSegmentOpacities::Allocate(Buffer buffer, vtkIdType bytes, const void* data)
{
  // An empty table cannot be bound.
  const bool allocated =
    vtkAllocateStorage(this->Handles[buffer], std::max<vtkIdType>(bytes, 4), data);
  this->Bytes[buffer] = allocated ? bytes : 0;
  return allocated;
}

//------------------------------------------------------------------------------
template <typename Table>
bool vtkSegmentOpacities::Put(Buffer buffer, const Table& table)
{
  return this->Allocate(
    buffer, static_cast<vtkIdType>(table.size() * sizeof(table.front())), table.data());
}

//------------------------------------------------------------------------------
bool vtkSegmentOpacities::UploadSettings(const vtkOptimizedScene& scene)
{
  return this->Put(Actors, scene.GetParameters());
}

//------------------------------------------------------------------------------
bool vtkSegmentOpacities::Upload(const vtkOptimizedScene& scene)
{
  this->Shown = Source;
  this->HasSolution = false;
  this->NumberOfSegments = scene.GetNumberOfSegments();
  this->NumberOfCorners = static_cast<vtkIdType>(scene.GetCorners().size());
  std::vector<std::uint32_t> segments;
  segments.reserve(2 * this->NumberOfSegments);
  for (const std::uint32_t actor : scene.GetActors())
  {
    segments.insert(segments.end(), { Unseen, actor });
  }
  const auto opacityBytes =
    static_cast<vtkIdType>(sizeof(float)) * (this->NumberOfSegments + this->NumberOfCorners);
  return this->Put(Segments, segments) && this->UploadSettings(scene) &&
    this->Put(FirstNeighbors, scene.GetFirstNeighbors()) &&
    this->Put(Neighbors, scene.GetNeighbors()) && this->Put(Corners, scene.GetCorners()) &&
    this->Allocate(Source, opacityBytes, nullptr) && this->Allocate(Target, opacityBytes, nullptr);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::BindTables() const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SegmentsBinding, this->Handles[Segments]);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, ActorsBinding, this->Handles[Actors]);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::BindCorners() const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GatherCornersBinding, this->Handles[Corners]);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::BindOpacities() const
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, OpacitiesBinding, this->Handles[this->Shown]);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Unbind()
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SegmentsBinding, 0);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, ActorsBinding, 0);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::TakeLeast(vtkOpenGLRenderWindow* window)
{
  this->DrawIterations(window, 0, 0);
  this->HasSolution = true;
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Smooth(vtkOpenGLRenderWindow* window, int iterations)
{
  this->DrawIterations(window, 1, iterations);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::DrawIterations(vtkOpenGLRenderWindow* window, int first, int last)
{
  this->BindTables();
  const auto bind = [this](GLuint binding, Buffer buffer)
  { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, this->Handles[buffer]); };
  bind(FirstNeighborsBinding, FirstNeighbors);
  bind(NeighborsBinding, Neighbors);
  for (int iteration = first; iteration <= last; ++iteration)
  {
    bind(SourceBinding, Source);
    bind(TargetBinding, Target);
    this->DrawStep(window, vtkSegmentSmoothFS, this->NumberOfSegments,
      [iteration](vtkShaderProgram* program) { program->SetUniformi("iteration", iteration); });
    std::swap(this->Handles[Source], this->Handles[Target]);
  }
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Show(vtkOpenGLRenderWindow* window)
{
  if (this->Shown == Faded)
  {
    this->Fade(window, 0.0);
  }
  else
  {
    this->InterpolateCorners(window);
  }
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Forget()
{
  this->Shown = Source;
  this->HasSolution = false;
  this->Fill(Source, -1.0f);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Fill(Buffer buffer, float value)
{
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Handles[buffer]);
  glClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32F, GL_RED, GL_FLOAT, &value);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

//------------------------------------------------------------------------------
bool vtkSegmentOpacities::StartFading()
{
  if (this->Shown == Faded)
  {
    return true;
  }
  if (!this->Allocate(Faded, this->Bytes[Source], nullptr) ||
    !this->Allocate(Pending, sizeof(std::uint32_t), nullptr))
  {
    return false;
  }
  this->Shown = Faded;
  this->HasWayLeft = false;
  if (!this->HasSolution)
  {
    this->Fill(Faded, -1.0f);
    return true;
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_COPY_READ_BUFFER, this->Handles[Source]);
  glBindBuffer(GL_COPY_WRITE_BUFFER, this->Handles[Faded]);
  glCopyBufferSubData(
    GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, static_cast<GLsizeiptr>(this->Bytes[Source]));
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSegmentOpacities::StopFading()
{
  // Those of the corners were interpolated from the faded ones only.
  const bool wasFading = this->Shown == Faded;
  this->Shown = Source;
  return wasFading;
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Fade(vtkOpenGLRenderWindow* window, double share)
{
  this->Fill(Pending, 0.0f);
  this->DrawFade(window, share);
  std::uint32_t pending = 0;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[Pending]);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof(pending), &pending);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  this->HasWayLeft = pending != 0;
  if (!this->HasWayLeft)
  {
    this->DrawFade(window, 1.0);
  }
  this->InterpolateCorners(window);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::DrawFade(vtkOpenGLRenderWindow* window, double share)
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, SourceBinding, this->Handles[Source]);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, TargetBinding, this->Handles[Faded]);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, PendingBinding, this->Handles[Pending]);
  this->DrawStep(window, vtkSegmentFadeFS, this->NumberOfSegments,
    [share](vtkShaderProgram* program)
    { program->SetUniformf("share", static_cast<float>(share)); });
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::InterpolateCorners(vtkOpenGLRenderWindow* window)
{
  if (this->NumberOfCorners == 0)
  {
    return;
  }
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, CornersBinding, this->Handles[Corners]);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, TargetBinding, this->Handles[this->Shown]);
  this->DrawStep(window, vtkCornerOpacitiesFS, this->NumberOfCorners);
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Lower(const std::vector<SegmentOpacity>& opacities)
{
  std::vector<std::uint32_t> segments(2 * this->NumberOfSegments);
  const auto bytes = static_cast<GLsizeiptr>(segments.size() * sizeof(segments.front()));
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[Segments]);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, segments.data());
  for (const SegmentOpacity& opacity : opacities)
  {
    // Floats of that sign order as their bits do.
    std::uint32_t bits = 0;
    std::memcpy(&bits, &opacity.Opacity, sizeof(bits));
    std::uint32_t& least = segments[2 * opacity.Segment];
    least = std::min(least, bits);
  }
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, segments.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
}

//------------------------------------------------------------------------------
std::vector<float> vtkSegmentOpacities::Read() const
{
  std::vector<float> opacities(this->NumberOfSegments + this->NumberOfCorners);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, this->Handles[this->Shown]);
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
    static_cast<GLsizeiptr>(opacities.size() * sizeof(float)), opacities.data());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
  return opacities;
}

//------------------------------------------------------------------------------
double vtkSegmentOpacities::Interpolate(
  const std::vector<float>& opacities, std::uint32_t first, std::uint32_t share)
{
  std::array<double, 3> shares{ { 1.0, 0.0, 0.0 } };
  if ((share & TriangleBit) != 0)
  {
    shares[1] = (share & 32767u) / 32767.0;
    shares[2] = ((share >> 15) & 32767u) / 32767.0;
    shares[0] = std::max(1.0 - shares[1] - shares[2], 0.0);
  }
  else
  {
    float second = 0.0f;
    std::memcpy(&second, &share, sizeof(second));
    shares[1] = second;
    shares[0] = 1.0 - shares[1];
  }
  double sum = 0.0;
  double total = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    if (shares[i] > 0.0 && opacities[first + i] >= 0.0f)
    {
      sum += shares[i] * opacities[first + i];
      total += shares[i];
    }
  }
  return total > 0.0 ? sum / total : 1.0;
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::DrawStep(vtkOpenGLRenderWindow* window, const char* fragmentShader,
  vtkIdType elements, const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  std::string source = fragmentShader;
  vtkShaderProgram::Substitute(
    source, "//VTK::Pellucid::Definitions", vtkSegmentOpacities::GetShaderDefinitions());
  vtkShaderProgram::Substitute(source, "//VTK::Pellucid::Segments", vtkSegmentTablesDec);
  const int width = static_cast<int>(std::min<vtkIdType>(elements, RowLength));
  const int height = static_cast<int>((elements + width - 1) / width);
  const auto setAllUniforms = [&](vtkShaderProgram* program)
  {
    program->SetUniformi("elementCount", static_cast<int>(elements));
    program->SetUniformi("rowLength", width);
    program->SetUniformi("segmentCount", static_cast<int>(this->NumberOfSegments));
    if (setUniforms)
    {
      setUniforms(program);
    }
  };
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewportSaver(state);
  vtkOpenGLState::ScopedglEnableDisable scissorSaver(state, GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglViewport(0, 0, width, height);
  this->Framebuffer.Use(
    window, width, height, [&] { this->Stage.Draw(window, source, setAllUniforms); });
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

//------------------------------------------------------------------------------
vtkIdType vtkSegmentOpacities::GetBytes() const
{
  vtkIdType bytes = 0;
  for (const vtkIdType bufferBytes : this->Bytes)
  {
    bytes += bufferBytes;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkSegmentOpacities::Release()
{
  glDeleteBuffers(NumberOfBuffers, this->Handles.data());
  this->Framebuffer.Release();
  this->Stage.Release();
  this->Handles.fill(0);
  this->Bytes.fill(0);
  this->NumberOfSegments = 0;
  this->NumberOfCorners = 0;
  this->Shown = Source;
  this->HasSolution = false;
}

VTK_ABI_NAMESPACE_END
