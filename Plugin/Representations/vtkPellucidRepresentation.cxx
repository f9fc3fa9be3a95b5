// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPellucidRepresentation.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositeDataSet.h"
#include "vtkCompositeRepresentation.h"
#include "vtkDataArray.h"
#include "vtkExactTransparencyPass.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPVRenderViewDataDeliveryManager.h"
#include "vtkPVServerInformation.h"
#include "vtkPVSession.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProcessModule.h"
#include "vtkSegmentedGeometry.h"
#include "vtkSegmentedTrajectoryMapper.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTransparencyInstaller.h"
#include "vtkTransparencyStatistics.h"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <locale>
#include <set>
#include <sstream>

// Only a ParaView with MPI has it.
#if __has_include("vtkIceTCompositePass.h")
#include "vtkIceTCompositePass.h"
#define PELLUCID_HAS_ICET
#endif

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPellucidRepresentation);

namespace
{
// ParaView's panel has "None" for no array.
std::string ArrayName(const char* name)
{
  return name && std::string(name) != "None" ? name : "";
}

// Of vtkTrajectoryMapper, as a share of the diagonal of the bounds.
constexpr double LargestAutomaticRadius = 1.0 / 200.0;

//------------------------------------------------------------------------------
bool IsSurface(vtkDataObject* geometry)
{
  const auto leaves = vtkCompositeDataSet::GetDataSets<vtkPolyData>(geometry);
  return std::any_of(leaves.begin(), leaves.end(),
    [](vtkPolyData* leaf) { return leaf->GetPointData()->HasArray("SegmentIds"); });
}

//------------------------------------------------------------------------------
// Where the data server renders: the same number in each process of it, and in its client.
int GetNumberOfServerProcesses()
{
  auto* session = vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetSession());
  return session ? session->GetServerInformation()->GetNumberOfProcesses() : 1;
}

//------------------------------------------------------------------------------
// Whether the data come from other processes than those that render, which know nothing of these.
bool HasDataServer()
{
  const auto type = vtkProcessModule::GetProcessType();
  auto* session = vtkPVSession::SafeDownCast(vtkProcessModule::GetProcessModule()->GetSession());
  return type == vtkProcessModule::PROCESS_DATA_SERVER ||
    type == vtkProcessModule::PROCESS_RENDER_SERVER ||
    (session &&
      session->GetController(vtkPVSession::DATA_SERVER) !=
        session->GetController(vtkPVSession::RENDER_SERVER));
}

//------------------------------------------------------------------------------
// Of this process. Never freed: ParaView deletes some after what is static.
std::set<vtkPellucidRepresentation*>& GetAllDisplays()
{
  static auto* displays = new std::set<vtkPellucidRepresentation*>;
  return *displays;
}

//------------------------------------------------------------------------------
// Other geometry that a view shows.
std::vector<vtkGeometryRepresentation*> GetOtherDisplays(vtkPVRenderView* view)
{
  std::vector<vtkGeometryRepresentation*> others;
  for (int i = 0; i < view->GetNumberOfRepresentations(); ++i)
  {
    auto* display = vtkCompositeRepresentation::SafeDownCast(view->GetRepresentation(i));
    auto* shown = display && display->GetVisibility()
      ? vtkGeometryRepresentation::SafeDownCast(display->GetActiveRepresentation())
      : nullptr;
    if (shown && !vtkPellucidRepresentation::SafeDownCast(shown))
    {
      others.push_back(shown);
    }
  }
  return others;
}

//------------------------------------------------------------------------------
// Where that changes for a display, whether each process gets all of its data or its own part,
// forget what has been delivered: ParaView delivers again only what it does not have. Returns
// whether it has changed.
bool ChangeDelivery(vtkPVDataRepresentation* display, vtkPVRenderView* view, bool toAll)
{
  static auto& gathered = *new std::vector<vtkWeakPointer<vtkPVDataRepresentation>>;
  const auto place = std::find(gathered.begin(), gathered.end(), display);
  if (toAll == (place != gathered.end()))
  {
    return false;
  }
  auto* manager = vtkPVRenderViewDataDeliveryManager::SafeDownCast(view->GetDeliveryManager());
  manager->SetDeliverToAllProcesses(display, toAll, false);
  manager->ClearCache(display);
  if (toAll)
  {
    gathered.emplace_back(display);
  }
  else
  {
    gathered.erase(place);
  }
  return true;
}

//------------------------------------------------------------------------------
// On several ranks the pass that composites their pictures holds the one that draws them.
void AddCompositePass()
{
#ifdef PELLUCID_HAS_ICET
  vtkTransparencyInstaller::AddHolder(
    "vtkIceTCompositePass",
    [](vtkRenderPass* holder) -> vtkRenderPass*
    { return vtkIceTCompositePass::SafeDownCast(holder)->GetRenderPass(); },
    [](vtkRenderPass* holder, vtkRenderPass* delegate)
    { vtkIceTCompositePass::SafeDownCast(holder)->SetRenderPass(delegate); });
#endif
}
}

//------------------------------------------------------------------------------
vtkPellucidRepresentation::vtkPellucidRepresentation()
{
  for (vtkMapper** mapper : { &this->Mapper, &this->LODMapper })
  {
    (*mapper)->Delete();
    auto* trajectories = vtkSegmentedTrajectoryMapper::New();
    trajectories->SetCompositeDataDisplayAttributes(vtkNew<vtkCompositeDataDisplayAttributes>());
    *mapper = trajectories;
  }
  this->SetupDefaults();
  AddCompositePass();
  GetAllDisplays().insert(this);
}

//------------------------------------------------------------------------------
vtkPellucidRepresentation::~vtkPellucidRepresentation()
{
  GetAllDisplays().erase(this);
  this->LeaveView();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetRadius(double radius)
{
  for (vtkMapper* mapper : { this->Mapper, this->LODMapper })
  {
    vtkTrajectoryMapper::SafeDownCast(mapper)->SetRadius(radius);
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetRadiusArray(const char* name)
{
  for (vtkMapper* mapper : { this->Mapper, this->LODMapper })
  {
    vtkTrajectoryMapper::SafeDownCast(mapper)->SetRadiusArray(ArrayName(name).c_str());
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetImportanceArray(int, int, int, int, const char* name)
{
  const std::string array = ArrayName(name);
  if (array != this->GetSegments()->GetImportanceArray())
  {
    this->GetSegments()->SetImportanceArray(array);
    this->Superclass::SetSuppressLOD(this->WantsNoLOD || this->HasImportance());
  }
}

//------------------------------------------------------------------------------
vtkSegmentedTrajectoryMapper* vtkPellucidRepresentation::GetMapper()
{
  return vtkSegmentedTrajectoryMapper::SafeDownCast(this->Mapper);
}

//------------------------------------------------------------------------------
vtkSegmentedGeometry* vtkPellucidRepresentation::GetSegments()
{
  return this->GetMapper()->GetSegments();
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::HasImportance()
{
  return !this->GetSegments()->GetImportanceArray().empty();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetNumberOfSegments(int segments)
{
  this->GetSegments()->SetNumberOfSegments(segments);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetSuppressLOD(bool suppress)
{
  this->WantsNoLOD = suppress;
  this->Superclass::SetSuppressLOD(suppress || this->HasImportance());
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetArrayIdNames(const char* points, const char* cells)
{
  if (points || cells)
  {
    vtkWarningMacro("Tubes are selected by the ids of points and cells, not by the arrays \""
      << (points ? points : "") << "\" and \"" << (cells ? cells : "") << "\".");
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetOcclusionWeight(double weight)
{
  this->OwnOptimization->SetOcclusionWeight(weight);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetClutterWeight(double weight)
{
  this->OwnOptimization->SetClutterWeight(weight);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetEmphasis(double emphasis)
{
  this->OwnOptimization->SetEmphasis(emphasis);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetSmoothingIterations(int iterations)
{
  this->OwnOptimization->SetSmoothingIterations(iterations);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetSelfOcclusion(bool occludes)
{
  this->Optimization->SetSelfOcclusion(occludes);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetPenalty(double penalty)
{
  this->Avoidance->SetPenalty(penalty);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetImportanceWeight(double weight)
{
  this->Avoidance->SetImportanceWeight(weight);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetCoverageWeight(double weight)
{
  this->Avoidance->SetCoverageWeight(weight);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetDirectionalVarianceWeight(double weight)
{
  this->Avoidance->SetDirectionalVarianceWeight(weight);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetDepthWeight(double weight)
{
  this->Avoidance->SetDepthWeight(weight);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetImportanceExponent(double exponent)
{
  this->Avoidance->SetImportanceExponent(exponent);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetGlobalOpacity(double opacity)
{
  this->Avoidance->SetGlobalOpacity(opacity);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetSmoothAttributes(bool smooth)
{
  this->Avoidance->SetSmoothAttributes(smooth);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetVisibility(bool visible)
{
  this->Superclass::SetVisibility(visible);
  this->UpdateTransparency();
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::AddToView(vtkView* view)
{
  if (!this->Superclass::AddToView(view))
  {
    return false;
  }
  this->LeaveView();
  this->View = vtkPVRenderView::SafeDownCast(view);
  this->UpdateTransparency();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::RemoveFromView(vtkView* view)
{
  if (this->View == view)
  {
    this->LeaveView();
  }
  return this->Superclass::RemoveFromView(view);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::LeaveView()
{
  if (this->View)
  {
    vtkTransparencyInstaller::Uninstall(this->View->GetRenderer(), this);
    this->ReleaseOtherDisplays();
  }
  this->View = nullptr;
}

//------------------------------------------------------------------------------
// Where the view shows none of this kind any more, ParaView draws the others as ever.
void vtkPellucidRepresentation::ReleaseOtherDisplays()
{
  const auto displays = this->GetDisplays();
  if (std::any_of(displays.begin(), displays.end(),
        [this](vtkPellucidRepresentation* display) { return display != this; }))
  {
    return;
  }
  for (vtkGeometryRepresentation* other : GetOtherDisplays(this->View))
  {
    if (ChangeDelivery(other, this->View, false))
    {
      other->GetActor()->SetVisibility(true);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::UpdateTransparency()
{
  // ParaView keeps one representation of each kind for a source and shows one of them: being in the
  // view does not mean being visible.
  if (!this->View)
  {
    return;
  }
  if (!this->GetVisibility())
  {
    vtkTransparencyInstaller::Uninstall(this->View->GetRenderer(), this);
    this->ReleaseOtherDisplays();
    return;
  }
  vtkTransparencyInstaller::Install(this->View->GetRenderer(), this);
}

//------------------------------------------------------------------------------
vtkExactTransparencyPass* vtkPellucidRepresentation::GetPass()
{
  return this->View ? vtkTransparencyInstaller::GetPass(this->View->GetRenderer()) : nullptr;
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::UpdatePass()
{
  vtkExactTransparencyPass* pass = this->GetPass();
  if (!pass)
  {
    return;
  }
  ViewSettings settings;
  for (vtkPellucidRepresentation* display : this->GetDisplays())
  {
    settings.Merge(display->Settings);
  }
  pass->SetGatherScale(settings.GatherScale);
  pass->SetMemoryLimit(settings.MemoryLimit);
  pass->SetView(settings.PictureView);
  pass->SetLayer(settings.PictureLayer);
  pass->RoundTranslucentLayersOn(); // a client gets the bits of its own picture from a server
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::ViewSettings::Merge(const ViewSettings& other)
{
  const ViewSettings defaults;
  const auto merge = [&](int ViewSettings::*setting)
  {
    if (other.*setting != defaults.*setting)
    {
      this->*setting = this->*setting == defaults.*setting
        ? other.*setting
        : std::max(this->*setting, other.*setting);
    }
  };
  merge(&ViewSettings::GatherScale);
  merge(&ViewSettings::MemoryLimit);
  merge(&ViewSettings::PictureView);
  merge(&ViewSettings::PictureLayer);
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::NeedsOrderedCompositing()
{
  return this->HasImportance() || this->Superclass::NeedsOrderedCompositing();
}

//------------------------------------------------------------------------------
int vtkPellucidRepresentation::ProcessViewRequest(
  vtkInformationRequestKey* type, vtkInformation* input, vtkInformation* output)
{
  const bool blocksChanged = this->BlockAttrChanged; // the superclass forgets it
  if (type == vtkPVView::REQUEST_UPDATE() && this->GetVisibility())
  {
    this->ChooseProcess(input);
  }
  if (!this->Superclass::ProcessViewRequest(type, input, output))
  {
    return 0;
  }
  if (type == vtkPVView::REQUEST_UPDATE())
  {
    vtkPVRenderView::SetDeliverToAllProcesses(input, this, this->DrawsOnFirst);
    this->UpdateBounds(input);
  }
  else if (type == vtkPVView::REQUEST_RENDER())
  {
    this->Actor->SetVisibility(!this->DrawsElsewhere());
    this->BackfaceActor->SetVisibility(
      this->BackfaceActor->GetVisibility() && !this->DrawsElsewhere());
    this->UpdateBlocks(blocksChanged);
    this->UpdateOpacity();
    this->UpdatePass();
    this->WarnOfOtherProcesses();
  }
  return 1;
}

//------------------------------------------------------------------------------
// The same in all processes, client included, or they would wait for each other.
void vtkPellucidRepresentation::ChooseProcess(vtkInformation* input)
{
  const auto displays = this->GetDisplays();
  const bool drawsOnFirst = !HasDataServer() && GetNumberOfServerProcesses() > 1 &&
    std::any_of(displays.begin(), displays.end(),
      [](vtkPellucidRepresentation* display)
      { return display->DrawOnOneProcess && display->NeedsOrderedCompositing(); });
  this->DrawsOnFirst = drawsOnFirst;
  ChangeDelivery(this, this->View, drawsOnFirst);
  for (vtkGeometryRepresentation* other : GetOtherDisplays(this->View))
  {
    if (ChangeDelivery(other, this->View, drawsOnFirst) || drawsOnFirst)
    {
      // Its data have to be known to the view before; a second time, this costs nothing.
      vtkNew<vtkInformation> ignored;
      other->ProcessViewRequest(vtkPVView::REQUEST_UPDATE(), input, ignored);
      vtkPVRenderView::SetDeliverToAllProcesses(input, other, drawsOnFirst);
      other->GetActor()->SetVisibility(!this->DrawsElsewhere());
    }
  }
}

//------------------------------------------------------------------------------
// Those that the view shows, this one among them.
std::vector<vtkPellucidRepresentation*> vtkPellucidRepresentation::GetDisplays()
{
  std::vector<vtkPellucidRepresentation*> displays;
  std::copy_if(GetAllDisplays().begin(), GetAllDisplays().end(), std::back_inserter(displays),
    [this](vtkPellucidRepresentation* display)
    { return this->View && display->View == this->View && display->GetVisibility(); });
  return displays;
}

//------------------------------------------------------------------------------
// With room for the tubes from the first frame on, also in a client that has no data: planes that
// clip, which follow from the bounds, else differ between frames and processes.
void vtkPellucidRepresentation::UpdateBounds(vtkInformation* input)
{
  vtkBoundingBox bounds(this->VisibleDataBounds);
  if (bounds.IsValid())
  {
    bounds.Inflate(this->GetLargestRadius(bounds.GetDiagonalLength()));
    double inflated[6];
    bounds.GetBounds(inflated);
    vtkNew<vtkMatrix4x4> matrix;
    this->Actor->GetMatrix(matrix);
    vtkPVRenderView::SetGeometryBounds(input, this, inflated, matrix);
  }
}

//------------------------------------------------------------------------------
double vtkPellucidRepresentation::GetLargestRadius(double diagonal)
{
  const auto leaves =
    vtkCompositeDataSet::GetDataSets<vtkPolyData>(this->MultiBlockMaker->GetOutputDataObject(0));
  const char* name = this->GetMapper()->GetRadiusArray();
  double largest = 0.0;
  for (vtkPolyData* leaf : leaves)
  {
    vtkDataArray* radii = name ? leaf->GetPointData()->GetArray(name) : nullptr;
    if (leaf->GetNumberOfVerts() + leaf->GetNumberOfLines() == 0)
    {
      continue;
    }
    if (radii)
    {
      largest = std::max(largest, radii->GetRange(0)[1]);
    }
    else
    {
      const double constant = this->GetMapper()->GetRadius();
      largest = std::max(largest, constant > 0.0 ? constant : LargestAutomaticRadius * diagonal);
    }
  }
  return largest;
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::DrawsElsewhere() const
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return this->DrawsOnFirst && controller && controller->GetLocalProcessId() > 0;
}

//------------------------------------------------------------------------------
// What the superclass does for the mapper that it has of its own.
void vtkPellucidRepresentation::UpdateBlocks(bool changed)
{
  const std::array<vtkMapper*, 2> mappers{ this->Mapper, this->LODMapper };
  for (std::size_t i = 0; i < mappers.size(); ++i)
  {
    if (vtkAlgorithm* segments = mappers[i]->GetInputAlgorithm())
    {
      segments->Update();
    }
    vtkDataObject* data = mappers[i]->GetInputDataObject(0, 0);
    this->BlocksOutdated[i] = this->BlocksOutdated[i] || changed;
    if (data && (this->BlocksOutdated[i] || this->BlockTimes[i] < data->GetMTime()))
    {
      this->PopulateBlockAttributes(
        vtkTrajectoryMapper::SafeDownCast(mappers[i])->GetCompositeDataDisplayAttributes(), data);
      this->BlocksOutdated[i] = false;
      this->BlockTimes[i].Modified();
    }
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::UpdateOpacity()
{
  if (!this->HasImportance() || !this->Mapper->GetInputDataObject(0, 0))
  {
    vtkImportanceDrivenOpacity::Attach(this->Actor, nullptr);
    return;
  }
  this->UsedImportanceRange = this->AutomaticImportanceRange
    ? this->GetSegments()->GetImportanceRange()
    : this->ImportanceRange;
  vtkImportanceDrivenOpacity* opacity = this->Optimization;
  if (this->OpacityMethod == OPTIMIZATION)
  {
    this->UpdateOptimization();
  }
  else
  {
    this->Avoidance->SetMode(this->OpacityMethod == PENALTY ? vtkOcclusionAvoidance::PENALTY
                                                            : vtkOcclusionAvoidance::WEIGHTING);
    opacity = this->Avoidance;
  }
  opacity->SetImportanceArray(this->GetSegments()->GetImportanceArray().c_str());
  opacity->SetImportanceRange(this->UsedImportanceRange.data());
  vtkImportanceDrivenOpacity::Attach(this->Actor, opacity);
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::UpdateOptimization()
{
  vtkNew<vtkOpacityOptimization> preset;
  vtkOpacityOptimization* wanted = this->OwnOptimization;
  if (const char* name = vtkOpacityOptimization::GetPresetName(this->OpacityPreset))
  {
    preset->UsePreset(name, IsSurface(this->Mapper->GetInputDataObject(0, 0)));
    wanted = preset;
  }
  const double strength = this->OpacityStrength;
  this->Optimization->SetOcclusionWeight(strength * wanted->GetOcclusionWeight());
  this->Optimization->SetClutterWeight(strength * wanted->GetClutterWeight());
  this->Optimization->SetEmphasis(wanted->GetEmphasis());
  this->Optimization->SetSmoothingIterations(wanted->GetSmoothingIterations());
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::WarnOfOtherProcesses()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  const bool tells = !controller || controller->GetLocalProcessId() == 0;
  const bool isWanted =
    this->HasImportance() || (this->DrawOnOneProcess && this->NeedsOrderedCompositing());
  if (!this->WarnedOfOtherProcesses && tells && isWanted && !this->GetSeesAllFragments())
  {
    vtkWarningMacro("Several processes draw this view, each its own part of the data: layers of "
                    "different parts may be in the wrong order, and importance counts only within "
                    "a part. Switch \"Draw On One Process\" on, and do not use a data server "
                    "apart from the render server.");
    this->WarnedOfOtherProcesses = true;
  }
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::IsDrawnOnServer() const
{
  return this->View && this->View->GetUseDistributedRenderingForRender();
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::GetSeesAllFragments()
{
  const bool isDistributed = this->IsDrawnOnServer() && GetNumberOfServerProcesses() > 1;
  return !isDistributed || this->DrawsOnFirst;
}

//------------------------------------------------------------------------------
vtkTransparencyStatistics* vtkPellucidRepresentation::GetStatistics()
{
  vtkExactTransparencyPass* pass = this->GetPass();
  return pass ? pass->GetStatistics() : nullptr;
}

//------------------------------------------------------------------------------
vtkIdType vtkPellucidRepresentation::GetStatistic(vtkIdType (vtkTransparencyStatistics::*get)())
{
  vtkTransparencyStatistics* statistics = this->GetStatistics();
  return statistics ? (statistics->*get)() : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkPellucidRepresentation::GetFragments()
{
  return this->GetStatistic(&vtkTransparencyStatistics::GetFragments);
}

//------------------------------------------------------------------------------
vtkIdType vtkPellucidRepresentation::GetSolvedFragments()
{
  return this->GetStatistic(&vtkTransparencyStatistics::GetSolvedFragments);
}

//------------------------------------------------------------------------------
vtkIdType vtkPellucidRepresentation::GetLongestList()
{
  return this->GetStatistic(&vtkTransparencyStatistics::GetLongestList);
}

//------------------------------------------------------------------------------
vtkIdType vtkPellucidRepresentation::GetBufferBytes()
{
  return this->GetStatistic(&vtkTransparencyStatistics::GetBufferBytes);
}

//------------------------------------------------------------------------------
const char* vtkPellucidRepresentation::GetStageTimes()
{
  std::ostringstream times;
  times.imbue(std::locale::classic());
  times << std::fixed << std::setprecision(1);
  vtkTransparencyStatistics* statistics = this->GetStatistics();
  const int stages = statistics ? statistics->GetNumberOfStages() : 0;
  for (int stage = 0; stage < stages; ++stage)
  {
    times << (stage > 0 ? ", " : "") << statistics->GetStageName(stage) << " "
          << statistics->GetStageMilliseconds(stage);
  }
  this->StageTimes = times.str();
  return this->StageTimes.c_str();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto* mapper = this->GetMapper();
  const char* radiusArray = mapper->GetRadiusArray();
  os << indent << "View: " << this->View.GetPointer() << "\n";
  os << indent << "Radius: " << mapper->GetRadius() << "\n";
  os << indent << "RadiusArray: " << (radiusArray ? radiusArray : "") << "\n";
  os << indent << "ImportanceRange: " << this->ImportanceRange[0] << ", "
     << this->ImportanceRange[1] << "\n";
  os << indent << "AutomaticImportanceRange: " << this->AutomaticImportanceRange << "\n";
  os << indent << "OpacityMethod: " << this->OpacityMethod << "\n";
  os << indent << "OpacityPreset: " << this->OpacityPreset << "\n";
  os << indent << "OpacityStrength: " << this->OpacityStrength << "\n";
  os << indent << "DrawOnOneProcess: " << this->DrawOnOneProcess << "\n";
  os << indent << "GatherScale: " << this->Settings.GatherScale << "\n";
  os << indent << "MemoryLimit: " << this->Settings.MemoryLimit << "\n";
  os << indent << "PictureView: " << this->Settings.PictureView << "\n";
  os << indent << "PictureLayer: " << this->Settings.PictureLayer << "\n";
  os << indent << "Segments:\n";
  this->GetSegments()->PrintSelf(os, indent.GetNextIndent());
  os << indent << "OwnOptimization:\n";
  this->OwnOptimization->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Optimization:\n";
  this->Optimization->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Avoidance:\n";
  this->Avoidance->PrintSelf(os, indent.GetNextIndent());
}
VTK_ABI_NAMESPACE_END
