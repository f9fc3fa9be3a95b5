// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCandidateKBufferPass.h"

#include "vtkActor.h"
#include "vtkAlgorithmOutput.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCandidateDrawOrderDec.h"
#include "vtkCandidateDrawOrderImpl.h"
#include "vtkCandidateKBufferDec.h"
#include "vtkDepthSortPolyData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerVectorKey.h"
#include "vtkInformationKeyLookup.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkShaderDefinitions.h"
#include "vtkShaderProgram.h"
#include "vtkTimerLog.h"
#include "vtkTrajectoryMapper.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkCandidateKBufferPass);

namespace
{
using Point = std::array<double, 3>;

/** How far things are from the eye: squared, or in parallel projection along the view. */
class EyeDistance
{
public:
  explicit EyeDistance(vtkCamera* camera)
    : Parallel(camera->GetParallelProjection() != 0)
  {
    camera->GetPosition(this->Eye.data());
    camera->GetDirectionOfProjection(this->Direction.data());
  }

  double To(const Point& a, const Point& b) const
  {
    if (this->Parallel)
    {
      return std::min(vtkMath::Dot(a.data(), this->Direction.data()),
        vtkMath::Dot(b.data(), this->Direction.data()));
    }
    double t;
    Point nearest;
    return vtkLine::DistanceToLine(this->Eye.data(), a.data(), b.data(), t, nearest.data());
  }

  double To(const vtkBoundingBox& box) const
  {
    Point nearest;
    for (int i = 0; i < 3; ++i)
    {
      // In parallel projection the corner that comes first.
      const bool isHigh = this->Parallel && this->Direction[i] < 0.0;
      const double low = box.GetMinPoint()[i];
      const double high = box.GetMaxPoint()[i];
      nearest[i] = this->Parallel ? (isHigh ? high : low) : std::clamp(this->Eye[i], low, high);
    }
    return this->To(nearest, nearest);
  }

private:
  bool Parallel;
  Point Eye;
  Point Direction;
};

/** vtkRoundedConeMapper::DRAWN_NODES() of the shared library, which does not export it. */
vtkInformationIntegerVectorKey* FindDrawnNodesKey()
{
  return vtkInformationIntegerVectorKey::SafeDownCast(
    vtkInformationKeyLookup::Find("DRAWN_NODES", "vtkRoundedConeMapper"));
}

/** The nodes of one leaf that draw something, nearest first, then the others. Returns the number of
 * the first ones. */
int SortNodes(const vtkTrajectoryNodes& nodes, vtkIdType first, vtkIdType end,
  const EyeDistance& distance, vtkMatrix4x4* dataToWorld, std::vector<std::uint32_t>& order)
{
  const auto& values = nodes.GetNodes();
  const auto getPoint = [&](vtkIdType node)
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    for (int i = 0; i < 3; ++i)
    {
      point[i] = values[node][i] + nodes.GetCenter()[i];
    }
    dataToWorld->MultiplyPoint(point, point);
    return Point{ point[0], point[1], point[2] };
  };
  constexpr double nothing = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, std::uint32_t>> keys(end - first);
  vtkSMPTools::For(first, end,
    [&](vtkIdType begin, vtkIdType stop)
    {
      for (vtkIdType node = begin; node < stop; ++node)
      {
        const bool isSegment = values[node][3] < 0.0f;
        const bool isEnd = !isSegment && node > first && values[node - 1][3] < 0.0f;
        const double key =
          isEnd ? nothing : distance.To(getPoint(node), getPoint(isSegment ? node + 1 : node));
        keys[node - first] = { key, static_cast<std::uint32_t>(node) };
      }
    });
  vtkSMPTools::Sort(keys.begin(), keys.end());
  std::transform(keys.begin(), keys.end(), std::back_inserter(order),
    [](const auto& key) { return key.second; });
  return static_cast<int>(
    std::count_if(keys.begin(), keys.end(), [](const auto& key) { return key.first < nothing; }));
}
}

//------------------------------------------------------------------------------
std::string vtkCandidateKBufferPass::GetReasonUnsupported(vtkOpenGLRenderWindow* window)
{
  GLint buffers = 0;
  glGetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &buffers);
  const std::string reason = this->Superclass::GetReasonUnsupported(window);
  return reason.empty() && buffers < 1 ? "OpenGL has no storage buffers for vertex shaders"
                                       : reason;
}

//------------------------------------------------------------------------------
std::string vtkCandidateKBufferPass::GetOverflowCode()
{
  return vtkCandidateKBufferDec;
}

//------------------------------------------------------------------------------
void vtkCandidateKBufferPass::Define(vtkShaderDefinitions& definitions)
{
  this->Superclass::Define(definitions);
  definitions.Define("ORDER_BINDING", static_cast<int>(OrderBinding));
}

//------------------------------------------------------------------------------
bool vtkCandidateKBufferPass::PreReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  if (mapper->IsA("vtkRoundedConeMapper"))
  {
    vtkShaderProgram::Substitute(vertexShader, "//VTK::System::Dec",
      "//VTK::System::Dec\n"
      "#extension GL_ARB_shader_storage_buffer_object : require\n"
      "#extension GL_ARB_shading_language_420pack : require\n",
      false);
    vtkShaderProgram::Substitute(vertexShader, "//VTK::DrawOrder::Dec",
      this->GetDefinitions() + vtkCandidateDrawOrderDec, false);
    vtkShaderProgram::Substitute(
      vertexShader, "//VTK::DrawOrder::Impl", vtkCandidateDrawOrderImpl, false);
  }
  return this->Superclass::PreReplaceShaderValues(
    vertexShader, geometryShader, fragmentShader, mapper, prop);
}

//------------------------------------------------------------------------------
std::vector<vtkProp*> vtkCandidateKBufferPass::GetDrawnProps(const vtkRenderState* state)
{
  const EyeDistance distance(state->GetRenderer()->GetActiveCamera());
  std::vector<std::pair<double, vtkProp*>> keys;
  for (vtkProp* prop : this->Superclass::GetDrawnProps(state))
  {
    const double* bounds = prop->GetBounds();
    const bool hasBounds = bounds && vtkMath::AreBoundsInitialized(bounds);
    keys.emplace_back(hasBounds ? distance.To(vtkBoundingBox(bounds)) : 0.0, prop);
  }
  std::stable_sort(
    keys.begin(), keys.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<vtkProp*> props;
  std::transform(keys.begin(), keys.end(), std::back_inserter(props),
    [](const auto& key) { return key.second; });
  return props;
}

//------------------------------------------------------------------------------
const vtkTrajectoryNodes& vtkCandidateKBufferPass::GetNodes(vtkTrajectoryMapper* mapper)
{
  mapper->GetInputAlgorithm()->Update();
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  const vtkMTimeType time = std::max(mapper->GetMTime(), data->GetMTime());
  MapperNodes& nodes = this->Nodes[mapper];
  if (nodes.Time < time)
  {
    nodes.Nodes.Build(
      vtkFindDisplayedLeaves(data, mapper->GetCompositeDataDisplayAttributes()), 1.0, "");
    nodes.Time = time;
  }
  return nodes.Nodes;
}

//------------------------------------------------------------------------------
void vtkCandidateKBufferPass::DrawProp(vtkRenderer* renderer, vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkMapper* mapper =
    actor && actor->HasTranslucentPolygonalGeometry() ? actor->GetMapper() : nullptr;
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    this->Superclass::DrawProp(renderer, prop);
  }
  else if (auto* trajectories = vtkTrajectoryMapper::SafeDownCast(mapper))
  {
    this->DrawTrajectories(renderer, actor, trajectories);
  }
  else if (auto* surfaces = vtkPolyDataMapper::SafeDownCast(mapper))
  {
    this->DrawCells(renderer, actor, surfaces);
  }
  else
  {
    this->Superclass::DrawProp(renderer, prop);
  }
}

//------------------------------------------------------------------------------
void vtkCandidateKBufferPass::DrawTrajectories(
  vtkRenderer* renderer, vtkActor* actor, vtkTrajectoryMapper* mapper)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const vtkTrajectoryNodes& nodes = this->GetNodes(mapper);
  const EyeDistance distance(renderer->GetActiveCamera());
  const std::size_t leaves = nodes.GetLeaves().size();
  std::vector<std::uint32_t> order;
  int drawn = 0;
  for (std::size_t leaf = 0; leaf < leaves; ++leaf)
  {
    drawn = SortNodes(nodes, nodes.GetFirstNode(leaf), nodes.GetFirstNode(leaf + 1), distance,
      actor->GetMatrix(), order);
  }
  const auto bytes = static_cast<vtkIdType>(order.size() * sizeof(order[0]));
  if (order.empty() || !this->Reserve(OrderBinding, bytes))
  {
    return;
  }
  this->Buffers.Write(OrderBinding, bytes, order.data());
  this->Buffers.Bind();
  this->AddOrderTime(start);
  // Of several leaves each has nodes that draw nothing.
  this->DrawNodes(renderer, actor, leaves == 1 ? drawn : static_cast<int>(order.size()));
}

//------------------------------------------------------------------------------
void vtkCandidateKBufferPass::AddOrderTime(double start)
{
  this->GetStatistics()->AddStage("order", 1e3 * (vtkTimerLog::GetUniversalTime() - start));
}

//------------------------------------------------------------------------------
void vtkCandidateKBufferPass::DrawNodes(vtkRenderer* renderer, vtkProp* prop, int nodes)
{
  this->DrawSlice(renderer, prop, 0, nodes);
}

//------------------------------------------------------------------------------
void vtkCandidateKBufferPass::DrawSlice(vtkRenderer* renderer, vtkProp* prop, int first, int end)
{
  vtkInformation* keys = prop->GetPropertyKeys(); // which has at least that of the passes
  vtkInformationIntegerVectorKey* drawnNodes = FindDrawnNodesKey();
  const int range[2] = { first, end };
  keys->Set(drawnNodes, range, 2);
  prop->RenderTranslucentPolygonalGeometry(renderer);
  keys->Remove(drawnNodes);
}

//------------------------------------------------------------------------------
void vtkCandidateKBufferPass::DrawCells(
  vtkRenderer* renderer, vtkActor* actor, vtkPolyDataMapper* mapper)
{
  const double start = vtkTimerLog::GetUniversalTime();
  mapper->GetInputAlgorithm()->Update();
  vtkPolyData* input = mapper->GetInput();
  if (!input)
  {
    this->Superclass::DrawProp(renderer, actor);
    return;
  }
  vtkNew<vtkDepthSortPolyData> sort;
  sort->SetInputData(input);
  sort->SetDirectionToFrontToBack();
  sort->SetDepthSortModeToBoundsCenter();
  sort->SetCamera(renderer->GetActiveCamera());
  sort->SetProp3D(actor);
  sort->Update();
  this->AddOrderTime(start);
  vtkAlgorithmOutput* connection = mapper->GetInputConnection(0, 0);
  const vtkSmartPointer<vtkAlgorithm> producer = connection->GetProducer();
  mapper->SetInputDataObject(sort->GetOutput());
  actor->RenderTranslucentPolygonalGeometry(renderer);
  mapper->SetInputConnection(connection);
}

VTK_ABI_NAMESPACE_END
