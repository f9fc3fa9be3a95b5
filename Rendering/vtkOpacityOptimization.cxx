// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOpacityOptimization.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkOpacityOptimization);

namespace
{
// Patches of surfaces are some six times as large as segments of lines.
constexpr int MostIterationsOnSurfaces = 5;

struct Preset
{
  const char* Name;
  double OcclusionWeight;
  double ClutterWeight;
  double Emphasis;
  int SmoothingIterations;
};

constexpr std::array<Preset, 5> Presets{ { { "clear-front", 400.0, 50.0, 4.0, 5 },
  { "balanced", 50.0, 100.0, 3.0, 5 }, { "focus", 1000.0, 50.0, 3.5, 50 },
  { "clear-back", 50.0, 400.0, 2.0, 15 }, { "points", 200.0, 50.0, 3.0, 0 } } };
}

//------------------------------------------------------------------------------
int vtkOpacityOptimization::GetNumberOfPresets()
{
  return static_cast<int>(Presets.size());
}

//------------------------------------------------------------------------------
const char* vtkOpacityOptimization::GetPresetName(int preset)
{
  return preset >= 0 && preset < vtkOpacityOptimization::GetNumberOfPresets() ? Presets[preset].Name
                                                                              : nullptr;
}

//------------------------------------------------------------------------------
bool vtkOpacityOptimization::UsePreset(const char* name, bool forSurfaces)
{
  const std::string wanted = name ? name : "";
  std::string known;
  for (const Preset& preset : Presets)
  {
    if (wanted == preset.Name)
    {
      this->SetOcclusionWeight(preset.OcclusionWeight);
      this->SetClutterWeight(preset.ClutterWeight);
      this->SetEmphasis(preset.Emphasis);
      this->SetSmoothingIterations(forSurfaces
          ? std::min(preset.SmoothingIterations, MostIterationsOnSurfaces)
          : preset.SmoothingIterations);
      return true;
    }
    known += (known.empty() ? "" : ", ") + std::string(preset.Name);
  }
  vtkErrorMacro("There is no preset \"" << wanted << "\". Use one of: " << known << ".");
  return false;
}

//------------------------------------------------------------------------------
void vtkOpacityOptimization::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OcclusionWeight: " << this->OcclusionWeight << "\n";
  os << indent << "ClutterWeight: " << this->ClutterWeight << "\n";
  os << indent << "Emphasis: " << this->Emphasis << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "SelfOcclusion: " << this->SelfOcclusion << "\n";
}

VTK_ABI_NAMESPACE_END
