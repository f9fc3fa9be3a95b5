// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkOcclusionAvoidance.h"

#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkOcclusionAvoidance);

//------------------------------------------------------------------------------
void vtkOcclusionAvoidance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << (this->Mode == PENALTY ? "Penalty" : "Weighting") << "\n";
  os << indent << "Penalty: " << this->Penalty << "\n";
  os << indent << "ImportanceWeight: " << this->ImportanceWeight << "\n";
  os << indent << "CoverageWeight: " << this->CoverageWeight << "\n";
  os << indent << "DirectionalVarianceWeight: " << this->DirectionalVarianceWeight << "\n";
  os << indent << "DepthWeight: " << this->DepthWeight << "\n";
  os << indent << "ImportanceExponent: " << this->ImportanceExponent << "\n";
  os << indent << "GlobalOpacity: " << this->GlobalOpacity << "\n";
  os << indent << "SmoothAttributes: " << this->SmoothAttributes << "\n";
}

VTK_ABI_NAMESPACE_END
