// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOptimizedScene.h"

#include "Importance.h"
#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDisplayedLeaf.h"
#include "vtkFieldData.h"
#include "vtkMapper.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRoundedConeMapper.h"
#include "vtkTrajectoryMapper.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>

VTK_ABI_NAMESPACE_BEGIN

namespace
{
//------------------------------------------------------------------------------
vtkDataArray* GetLineSegments(vtkPolyData* data)
{
  vtkDataArray* first = data->GetCellData()->GetArray("FirstSegment");
  const bool complete = data->GetPointData()->GetArray("SegmentBase") &&
    data->GetPointData()->GetArray("SegmentWeight") &&
    data->GetCellData()->GetArray("NumberOfSegments");
  return complete ? first : nullptr;
}

//------------------------------------------------------------------------------
// Of surfaces; null unless all that is needed is there.
vtkDataArray* GetSurfaceNeighbors(vtkPolyData* data)
{
  vtkDataArray* ids = data->GetPointData()->GetArray("SegmentIds");
  vtkDataArray* weights = data->GetPointData()->GetArray("SegmentWeights");
  const bool complete = ids && weights &&
    ids->GetNumberOfComponents() == weights->GetNumberOfComponents() &&
    ids->GetNumberOfComponents() <= 4;
  return complete
    ? vtkDataArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("SegmentNeighbors"))
    : nullptr;
}

//------------------------------------------------------------------------------
// The helpers of VTK's mappers of composite data, of glyphs and of impostors get no vertex
// attributes.
bool BringsImportance(vtkMapper* mapper)
{
  return vtkTrajectoryMapper::SafeDownCast(mapper) ||
    (vtkPolyDataMapper::SafeDownCast(mapper) && !vtkOptimizedScene::DrawsImpostors(mapper) &&
      vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)));
}

//------------------------------------------------------------------------------
// NaN, which setters do not clamp, counts as 0.
float ToFloat(double value)
{
  const double largest = std::numeric_limits<float>::max();
  return static_cast<float>(value > 0.0 ? std::min(value, largest) : 0.0);
}

//------------------------------------------------------------------------------
vtkOptimizedScene::Parameters MakeParameters(vtkImportanceDrivenOpacity* settings)
{
  vtkOptimizedScene::Parameters actor;
  if (auto* optimization = vtkOpacityOptimization::SafeDownCast(settings))
  {
    actor.OcclusionWeight = ToFloat(optimization->GetOcclusionWeight());
    actor.ClutterWeight = ToFloat(optimization->GetClutterWeight());
    actor.Exponent = ToFloat(2.0 * optimization->GetEmphasis());
    actor.SmoothingIterations = static_cast<std::uint32_t>(optimization->GetSmoothingIterations());
    actor.SelfOcclusion = optimization->GetSelfOcclusion() ? 1 : 0;
  }
  else if (auto* avoidance = vtkOcclusionAvoidance::SafeDownCast(settings))
  {
    actor.Avoids = avoidance->GetMode() == vtkOcclusionAvoidance::PENALTY
      ? vtkOptimizedScene::AvoidsByPenalty
      : vtkOptimizedScene::AvoidsByWeighting;
    if (avoidance->GetSmoothAttributes())
    {
      actor.Avoids |= vtkOptimizedScene::SmoothsAttributes;
    }
    actor.Penalty = ToFloat(avoidance->GetPenalty());
    actor.ImportanceWeight = ToFloat(avoidance->GetImportanceWeight());
    actor.CoverageWeight = ToFloat(avoidance->GetCoverageWeight());
    actor.VarianceWeight = ToFloat(avoidance->GetDirectionalVarianceWeight());
    actor.DepthWeight = ToFloat(avoidance->GetDepthWeight());
    actor.Lambda = ToFloat(avoidance->GetImportanceExponent());
    actor.GlobalOpacity = ToFloat(avoidance->GetGlobalOpacity());
  }
  return actor;
}

//------------------------------------------------------------------------------
// Whether the factors of an actor with occlusion avoidance can differ from 1.
bool CanAvoid(const vtkOptimizedScene::Parameters& actor)
{
  const bool byPenalty = (actor.Avoids & vtkOptimizedScene::AvoidsByPenalty) != 0;
  const bool byWeighting = (actor.Avoids & vtkOptimizedScene::AvoidsByWeighting) != 0;
  return (actor.Avoids != 0 && actor.GlobalOpacity < 1.0f) || (byPenalty && actor.Penalty < 1.0f) ||
    (byWeighting &&
      (actor.ImportanceWeight > 0.0f || actor.CoverageWeight > 0.0f ||
        actor.VarianceWeight > 0.0f || actor.DepthWeight > 0.0f));
}
}

//------------------------------------------------------------------------------
bool vtkOptimizedScene::Source::HasSegmentsOf(const Source& other) const
{
  return std::tie(this->Prop, this->Mapper, this->Optimizes, this->Leaves, this->LeafTimes) ==
    std::tie(other.Prop, other.Mapper, other.Optimizes, other.Leaves, other.LeafTimes);
}

//------------------------------------------------------------------------------
vtkOptimizedScene::Change vtkOptimizedScene::Update(const std::vector<vtkProp*>& props)
{
  std::vector<Source> sources;
  std::set<std::string> unsupported;
  for (vtkProp* prop : props)
  {
    vtkImportanceDrivenOpacity* settings = vtkImportanceDrivenOpacity::Get(prop);
    auto* actor = vtkActor::SafeDownCast(prop);
    if (!settings || !actor || !prop->GetVisibility() || !actor->GetMapper() ||
      actor->GetMapper()->GetNumberOfInputConnections(0) == 0)
    {
      continue;
    }
    actor->GetMapper()->Update();
    if (!BringsImportance(actor->GetMapper()))
    {
      unsupported.insert(actor->GetMapper()->GetClassName());
      continue;
    }
    const bool optimizes = vtkOpacityOptimization::SafeDownCast(settings) != nullptr;
    Source source{ prop, actor->GetMapper(), settings, settings->GetMTime(), optimizes, {}, {} };
    // Also those that are not visible: opacities keep their numbers.
    for (const vtkDisplayedLeaf& leaf :
      vtkFindDisplayedLeaves(actor->GetMapper()->GetInputDataObject(0, 0), nullptr))
    {
      source.Leaves.push_back(leaf.Data);
      source.LeafTimes.push_back(leaf.Data->GetMTime());
    }
    if (!source.Leaves.empty())
    {
      sources.push_back(source);
    }
  }
  const bool sameSegments =
    std::equal(sources.begin(), sources.end(), this->Sources.begin(), this->Sources.end(),
      [](const Source& source, const Source& before) { return source.HasSegmentsOf(before); });
  const bool sameSettings = sameSegments &&
    std::equal(sources.begin(), sources.end(), this->Sources.begin(),
      [](const Source& source, const Source& before)
      { return source.Settings == before.Settings && source.SettingsTime == before.SettingsTime; });
  this->Sources = std::move(sources);
  this->UnsupportedMappers.Set(unsupported);
  if (!sameSegments)
  {
    this->ClearSegments();
    for (const Source& source : this->Sources)
    {
      this->AddActor(source);
    }
    this->FirstNeighbors.push_back(static_cast<std::uint32_t>(this->Neighbors.size()));
  }
  if (!sameSettings)
  {
    this->AddSettings();
  }
  return sameSettings ? Change::None : (sameSegments ? Change::Settings : Change::Segments);
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::ClearSegments()
{
  this->Members.clear();
  this->ActorOfSegment.assign(1, 0);
  this->FirstNeighbors.assign(1, 0);
  this->Neighbors.clear();
  this->Corners.clear();
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddSettings()
{
  this->ActorParameters.assign(1, Parameters());
  std::set<std::string> missing;
  this->FirstImportance.reset();
  this->ImportancesDiffer = false;
  for (const Source& source : this->Sources)
  {
    this->ActorParameters.push_back(MakeParameters(source.Settings));
    this->Members[source.Prop].Settings = source.Settings;
    this->AddImportances(source, missing);
  }
  this->MissingArrays.Set(missing);
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddActor(const Source& source)
{
  const auto actor = static_cast<std::uint32_t>(this->Members.size() + 1);
  Member& member = this->Members[source.Prop];
  member.Avoids = !source.Optimizes;
  for (vtkPolyData* leaf : source.Leaves)
  {
    Part part;
    part.Data = leaf;
    if (member.Avoids)
    {
      this->AddLoneSegment(actor, part);
    }
    else
    {
      this->AddSegments(leaf, actor, part);
    }
    member.Parts.push_back(part);
  }
}

//------------------------------------------------------------------------------
bool vtkOptimizedScene::DrawsImpostors(vtkMapper* mapper)
{
  return mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper") ||
    mapper->IsA("vtkPointGaussianMapper") || mapper->IsA("vtkOpenGLFluidMapper");
}

//------------------------------------------------------------------------------
bool vtkOptimizedScene::HasLineSegments(vtkPolyData* data)
{
  return GetLineSegments(data) != nullptr;
}

//------------------------------------------------------------------------------
std::uint32_t vtkOptimizedScene::CountSegments(vtkPolyData* data)
{
  if (vtkDataArray* first = GetLineSegments(data))
  {
    vtkDataArray* counts = data->GetCellData()->GetArray("NumberOfSegments");
    double segments = 0.0;
    for (vtkIdType cell = 0; cell < first->GetNumberOfTuples(); ++cell)
    {
      segments = std::max(segments, first->GetComponent(cell, 0) + counts->GetComponent(cell, 0));
    }
    return std::max(1u, static_cast<std::uint32_t>(segments));
  }
  if (vtkDataArray* neighbors = GetSurfaceNeighbors(data))
  {
    return std::max(1u, static_cast<std::uint32_t>(neighbors->GetNumberOfTuples()));
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddSegments(vtkPolyData* data, std::uint32_t actor, Part& part)
{
  const bool alongLines = GetLineSegments(data) != nullptr;
  if (!alongLines && !GetSurfaceNeighbors(data))
  {
    this->AddLoneSegment(actor, part);
    return;
  }
  part.FirstSegment = static_cast<std::uint32_t>(this->ActorOfSegment.size());
  const std::uint32_t count = vtkOptimizedScene::CountSegments(data);
  part.NumberOfSegments = count;
  this->ActorOfSegment.resize(part.FirstSegment + count, actor);
  if (alongLines)
  {
    this->AddLineNeighbors(data, count, part.FirstSegment);
  }
  else
  {
    this->AddSurfaceNeighbors(data, count, part.FirstSegment);
    this->AddCorners(data, part);
  }
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddLoneSegment(std::uint32_t actor, Part& part)
{
  part.FirstSegment = static_cast<std::uint32_t>(this->ActorOfSegment.size());
  part.NumberOfSegments = 1;
  this->ActorOfSegment.push_back(actor);
  this->FirstNeighbors.push_back(static_cast<std::uint32_t>(this->Neighbors.size()));
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddLineNeighbors(
  vtkPolyData* data, std::uint32_t count, std::uint32_t first)
{
  // Whether a segment is followed by another one of its line.
  std::vector<bool> joined(count, false);
  vtkDataArray* firsts = data->GetCellData()->GetArray("FirstSegment");
  vtkDataArray* counts = data->GetCellData()->GetArray("NumberOfSegments");
  for (vtkIdType cell = 0; cell < firsts->GetNumberOfTuples(); ++cell)
  {
    const double begin = firsts->GetComponent(cell, 0);
    const double length = counts->GetComponent(cell, 0);
    if (begin < 0.0 || length < 2.0)
    {
      continue;
    }
    const auto firstJoined = joined.begin() + static_cast<std::ptrdiff_t>(begin);
    std::fill(firstJoined, firstJoined + static_cast<std::ptrdiff_t>(length) - 1, true);
  }
  for (std::uint32_t segment = 0; segment < count; ++segment)
  {
    this->FirstNeighbors.push_back(static_cast<std::uint32_t>(this->Neighbors.size()));
    if (segment > 0 && joined[segment - 1])
    {
      this->Neighbors.push_back(first + segment - 1);
    }
    if (joined[segment])
    {
      this->Neighbors.push_back(first + segment + 1);
    }
  }
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddSurfaceNeighbors(
  vtkPolyData* data, std::uint32_t count, std::uint32_t first)
{
  vtkDataArray* neighbors = GetSurfaceNeighbors(data);
  for (std::uint32_t segment = 0; segment < count; ++segment)
  {
    this->FirstNeighbors.push_back(static_cast<std::uint32_t>(this->Neighbors.size()));
    for (int i = 0; i < neighbors->GetNumberOfComponents(); ++i)
    {
      const double neighbor = neighbors->GetComponent(segment, i);
      if (neighbor >= 0.0)
      {
        this->Neighbors.push_back(first + static_cast<std::uint32_t>(neighbor));
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddCorners(vtkPolyData* data, Part& part)
{
  part.HasCorners = true;
  part.FirstCorner = static_cast<std::uint32_t>(this->Corners.size());
  vtkDataArray* ids = data->GetPointData()->GetArray("SegmentIds");
  vtkDataArray* weights = data->GetPointData()->GetArray("SegmentWeights");
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    Corner corner{};
    for (int i = 0; i < ids->GetNumberOfComponents(); ++i)
    {
      const double id = ids->GetComponent(point, i);
      const bool used = id >= 0.0;
      corner.Segments[i] = used ? part.FirstSegment + static_cast<std::uint32_t>(id) : 0;
      corner.Weights[i] = used ? static_cast<float>(weights->GetComponent(point, i)) : 0.0f;
    }
    this->Corners.push_back(corner);
  }
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::AddImportances(const Source& source, std::set<std::string>& missing)
{
  const char* name = source.Settings->GetImportanceArray();
  const pellucid::ImportanceRange<double> range(source.Settings->GetImportanceRange());
  auto part = this->Members[source.Prop].Parts.begin();
  for (vtkPolyData* leaf : source.Leaves)
  {
    vtkDataArray* array = name ? leaf->GetPointData()->GetArray(name) : nullptr;
    if (array && array->GetNumberOfComponents() != 1)
    {
      array = nullptr;
    }
    (part++)->HasImportance = array != nullptr;
    if (!array)
    {
      missing.insert(name ? name : "");
    }
    const vtkIdType points = source.Optimizes ? leaf->GetNumberOfPoints() : 0;
    for (vtkIdType point = 0; point < points && !this->ImportancesDiffer; ++point)
    {
      const double importance = array ? range.Map(array->GetComponent(point, 0)) : 0.0;
      this->FirstImportance = this->FirstImportance.value_or(importance);
      this->ImportancesDiffer = importance != *this->FirstImportance;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkOptimizedScene::HasOptimization() const
{
  return this->ImportancesDiffer &&
    std::any_of(this->ActorParameters.begin(), this->ActorParameters.end(),
      [](const Parameters& actor)
      { return actor.OcclusionWeight > 0.0f || actor.ClutterWeight > 0.0f; });
}

//------------------------------------------------------------------------------
bool vtkOptimizedScene::HasAvoidance() const
{
  return std::any_of(this->ActorParameters.begin(), this->ActorParameters.end(), CanAvoid);
}

//------------------------------------------------------------------------------
bool vtkOptimizedScene::SmoothsPixels() const
{
  return std::any_of(this->ActorParameters.begin(), this->ActorParameters.end(),
    [](const Parameters& actor) { return (actor.Avoids & SmoothsAttributes) != 0; });
}

//------------------------------------------------------------------------------
const vtkOptimizedScene::Member* vtkOptimizedScene::Find(vtkProp* prop) const
{
  const auto member = this->Members.find(prop);
  return member == this->Members.end() ? nullptr : &member->second;
}

//------------------------------------------------------------------------------
vtkOptimizedScene::Part vtkOptimizedScene::Member::FindPart(vtkAbstractMapper* mapper) const
{
  if (vtkRoundedConeMapper::SafeDownCast(mapper))
  {
    return this->Parts.front(); // it counts segments through all parts
  }
  auto* drawing = vtkPolyDataMapper::SafeDownCast(mapper);
  vtkPolyData* data = drawing ? drawing->GetInput() : nullptr;
  const auto part = std::find_if(this->Parts.begin(), this->Parts.end(),
    [data](const Part& candidate) { return candidate.Data == data; });
  return part == this->Parts.end() ? Part() : *part;
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::MapImportances()
{
  for (const Source& source : this->Sources)
  {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(source.Mapper);
    const char* name = source.Settings->GetImportanceArray();
    const std::string array = name ? name : "";
    std::string& mappedArray = this->Members[source.Prop].MappedArray;
    if (mapper && !vtkTrajectoryMapper::SafeDownCast(mapper) && mappedArray != array)
    {
      mapper->MapDataArrayToVertexAttribute(
        "pellucidImportanceMC", name, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
      mappedArray = array;
    }
  }
}

//------------------------------------------------------------------------------
void vtkOptimizedScene::Complaints::Set(const std::set<std::string>& names)
{
  this->Names = names;
  // What is gone may be told again when it comes back.
  std::set<std::string> told;
  std::set_intersection(names.begin(), names.end(), this->Told.begin(), this->Told.end(),
    std::inserter(told, told.end()));
  this->Told = told;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkOptimizedScene::Complaints::Take()
{
  std::vector<std::string> news;
  std::set_difference(this->Names.begin(), this->Names.end(), this->Told.begin(), this->Told.end(),
    std::back_inserter(news));
  this->Told = this->Names;
  return news;
}

//------------------------------------------------------------------------------
int vtkOptimizedScene::GetSmoothingIterations() const
{
  std::uint32_t most = 0;
  for (const Parameters& actor : this->ActorParameters)
  {
    most = std::max(most, actor.SmoothingIterations);
  }
  return static_cast<int>(most);
}

VTK_ABI_NAMESPACE_END
