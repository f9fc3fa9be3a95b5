// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTransparencyStatistics.h"

#include "vtkObjectFactory.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTransparencyStatistics);

//------------------------------------------------------------------------------
void vtkTransparencyStatistics::Reset()
{
  this->Fragments = 0;
  this->SolvedFragments = 0;
  this->LongestList = 0;
  this->BufferBytes = 0;
  this->Tiles = 0;
  this->GatherPasses = 0;
  this->BlendedProps = 0;
  this->Fading = false;
  this->Stages.clear();
}

//------------------------------------------------------------------------------
void vtkTransparencyStatistics::AddStage(const std::string& name, double milliseconds)
{
  const auto stage = std::find_if(this->Stages.begin(), this->Stages.end(),
    [&name](const auto& candidate) { return candidate.first == name; });
  if (stage == this->Stages.end())
  {
    this->Stages.emplace_back(name, milliseconds);
  }
  else
  {
    stage->second += milliseconds;
  }
}

//------------------------------------------------------------------------------
int vtkTransparencyStatistics::GetNumberOfStages()
{
  return static_cast<int>(this->Stages.size());
}

//------------------------------------------------------------------------------
std::string vtkTransparencyStatistics::GetStageName(int stage)
{
  return stage >= 0 && stage < this->GetNumberOfStages() ? this->Stages[stage].first
                                                         : std::string();
}

//------------------------------------------------------------------------------
double vtkTransparencyStatistics::GetStageMilliseconds(int stage)
{
  return stage >= 0 && stage < this->GetNumberOfStages() ? this->Stages[stage].second : 0.0;
}

//------------------------------------------------------------------------------
double vtkTransparencyStatistics::GetStageMilliseconds(const std::string& name)
{
  double milliseconds = 0.0;
  for (const auto& stage : this->Stages)
  {
    milliseconds += stage.first == name ? stage.second : 0.0;
  }
  return milliseconds;
}

//------------------------------------------------------------------------------
void vtkTransparencyStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fragments: " << this->Fragments << "\n";
  os << indent << "LongestList: " << this->LongestList << "\n";
  os << indent << "BufferBytes: " << this->BufferBytes << "\n";
  os << indent << "Tiles: " << this->Tiles << "\n";
  os << indent << "GatherPasses: " << this->GatherPasses << "\n";
  os << indent << "BlendedProps: " << this->BlendedProps << "\n";
  os << indent << "Fading: " << this->Fading << "\n";
  for (const auto& stage : this->Stages)
  {
    os << indent << "Stage " << stage.first << ": " << stage.second << " ms\n";
  }
}

VTK_ABI_NAMESPACE_END
