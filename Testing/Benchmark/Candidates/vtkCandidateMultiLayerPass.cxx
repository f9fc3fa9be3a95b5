// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkCandidateMultiLayerPass.h"

#include "vtkCandidateMultiLayerDec.h"
#include "vtkObjectFactory.h"

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkCandidateMultiLayerPass);

//------------------------------------------------------------------------------
std::string vtkCandidateMultiLayerPass::GetOverflowCode()
{
  return vtkCandidateMultiLayerDec;
}

VTK_ABI_NAMESPACE_END
