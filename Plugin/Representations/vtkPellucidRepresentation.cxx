// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPellucidRepresentation.h"

#include "vtkCompositeDataSet.h"
#include "vtkExactTransparencyPass.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"
#include "vtkPVLODActor.h"
#include "vtkPVRenderView.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSegmentedGeometry.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTransparencyInstaller.h"
#include "vtkTransparencyStatistics.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkPellucidRepresentation);

namespace
{
// ParaView's panel has "None" for no array.
std::string ArrayName(const char* name)
{
  return name && std::string(name) != "None" ? name : "";
}

//------------------------------------------------------------------------------
bool IsSurface(vtkDataObject* geometry)
{
  const auto leaves = vtkCompositeDataSet::GetDataSets<vtkPolyData>(geometry);
  return std::any_of(leaves.begin(), leaves.end(),
    [](vtkPolyData* leaf) { return leaf->GetPointData()->HasArray("SegmentIds"); });
}
}

//------------------------------------------------------------------------------
vtkPellucidRepresentation::vtkPellucidRepresentation()
{
  this->Mapper->Delete();
  this->LODMapper->Delete();
  this->Mapper = vtkTrajectoryMapper::New();
  this->LODMapper = vtkTrajectoryMapper::New();
  this->SetupDefaults();
  this->Segments->SetInputConnection(this->GeometryFilter->GetOutputPort());
  this->MultiBlockMaker->SetInputConnection(this->Segments->GetOutputPort());
}

//------------------------------------------------------------------------------
vtkPellucidRepresentation::~vtkPellucidRepresentation() = default;

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
  if (array != this->Segments->GetImportanceArray())
  {
    this->Segments->SetImportanceArray(array);
    this->Superclass::SetSuppressLOD(this->WantsNoLOD || this->HasImportance());
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::HasImportance() const
{
  return !this->Segments->GetImportanceArray().empty();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetNumberOfSegments(int segments)
{
  if (segments != this->Segments->GetNumberOfSegments())
  {
    this->Segments->SetNumberOfSegments(segments);
    this->MarkModified();
  }
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetSuppressLOD(bool suppress)
{
  this->WantsNoLOD = suppress;
  this->Superclass::SetSuppressLOD(suppress || this->HasImportance());
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
void vtkPellucidRepresentation::SetGatherScale(int scale)
{
  this->GatherScale = scale;
  this->UpdatePass();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetMemoryLimit(int mebibytes)
{
  this->MemoryLimit = mebibytes;
  this->UpdatePass();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetPictureView(int view)
{
  this->PictureView = view;
  this->UpdatePass();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::SetPictureLayer(int layer)
{
  this->PictureLayer = layer;
  this->UpdatePass();
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
  this->View = vtkPVRenderView::SafeDownCast(view);
  this->UpdateTransparency();
  return true;
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::RemoveFromView(vtkView* view)
{
  if (this->View == view)
  {
    vtkTransparencyInstaller::Uninstall(this->View->GetRenderer(), this);
  }
  this->View = nullptr;
  return this->Superclass::RemoveFromView(view);
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
    return;
  }
  const bool isFirst = this->GetPass() == nullptr;
  vtkTransparencyInstaller::Install(this->View->GetRenderer(), this);
  if (isFirst)
  {
    this->UpdatePass();
  }
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
  if (pass && this->GetVisibility())
  {
    pass->SetGatherScale(this->GatherScale);
    pass->SetMemoryLimit(this->MemoryLimit);
    pass->SetView(this->PictureView);
    pass->SetLayer(this->PictureLayer);
  }
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
  if (!this->Superclass::ProcessViewRequest(type, input, output))
  {
    return 0;
  }
  if (type == vtkPVView::REQUEST_RENDER())
  {
    this->UpdateOpacity(vtkPVView::GetDeliveredPiece(input, this));
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::UpdateOpacity(vtkDataObject* geometry)
{
  if (!this->HasImportance() || !geometry)
  {
    vtkImportanceDrivenOpacity::Attach(this->Actor, nullptr);
    return;
  }
  this->UsedImportanceRange = this->ImportanceRange;
  if (this->AutomaticImportanceRange)
  {
    vtkSegmentedGeometry::GetImportanceRange(geometry, this->UsedImportanceRange.data());
  }
  vtkImportanceDrivenOpacity* opacity = this->Optimization;
  if (this->OpacityMethod == OPTIMIZATION)
  {
    this->UpdateOptimization(geometry);
  }
  else
  {
    this->Avoidance->SetMode(this->OpacityMethod == PENALTY ? vtkOcclusionAvoidance::PENALTY
                                                            : vtkOcclusionAvoidance::WEIGHTING);
    opacity = this->Avoidance;
  }
  opacity->SetImportanceArray(this->Segments->GetImportanceArray().c_str());
  // opacity->SetImportanceRange(this->UsedImportanceRange.data());
  vtkImportanceDrivenOpacity::Attach(this->Actor, opacity);
  this->WarnOfOtherProcesses();
}

//------------------------------------------------------------------------------
void vtkPellucidRepresentation::UpdateOptimization(vtkDataObject* geometry)
{
  vtkNew<vtkOpacityOptimization> preset;
  vtkOpacityOptimization* wanted = this->OwnOptimization;
  if (const char* name = vtkOpacityOptimization::GetPresetName(this->OpacityPreset))
  {
    preset->UsePreset(name, IsSurface(geometry));
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
  if (!this->WarnedOfOtherProcesses && !this->GetSeesAllFragments())
  {
    vtkWarningMacro("Each of the "
      << vtkMultiProcessController::GetGlobalController()->GetNumberOfProcesses()
      << " processes finds opacities from the importance of its own fragments: what another one "
         "draws is neither preferred nor faded for it. Render with one process for a picture in "
         "which all fragments count.");
    this->WarnedOfOtherProcesses = true;
  }
}

//------------------------------------------------------------------------------
bool vtkPellucidRepresentation::GetSeesAllFragments()
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  return !controller || controller->GetNumberOfProcesses() == 1;
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
  auto* mapper = vtkTrajectoryMapper::SafeDownCast(this->Mapper);
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
  os << indent << "GatherScale: " << this->GatherScale << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "PictureView: " << this->PictureView << "\n";
  os << indent << "PictureLayer: " << this->PictureLayer << "\n";
  os << indent << "Segments:\n";
  this->Segments->PrintSelf(os, indent.GetNextIndent());
  os << indent << "OwnOptimization:\n";
  this->OwnOptimization->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Optimization:\n";
  this->Optimization->PrintSelf(os, indent.GetNextIndent());
  os << indent << "Avoidance:\n";
  this->Avoidance->PrintSelf(os, indent.GetNextIndent());
}
VTK_ABI_NAMESPACE_END
