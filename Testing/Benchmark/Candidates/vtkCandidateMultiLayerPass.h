// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCandidateMultiLayerPass
 * @brief   Multi-layer alpha blending: merges the two farthest layers of a full pixel.
 *
 * M. Salvi and K. Vaidyanathan, Multi-Layer Alpha Blending, 2014. Geometry comes in any order. A
 * pixel is exact where no fragment belongs between two that have been merged, so always where it
 * has no more fragments than layers.
 */

#ifndef vtkCandidateMultiLayerPass_h
#define vtkCandidateMultiLayerPass_h

#include "vtkCandidateLayersPass.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkCandidateMultiLayerPass : public vtkCandidateLayersPass
{
public:
  static vtkCandidateMultiLayerPass* New();
  vtkTypeMacro(vtkCandidateMultiLayerPass, vtkCandidateLayersPass);

protected:
  vtkCandidateMultiLayerPass() = default;
  ~vtkCandidateMultiLayerPass() override = default;

  std::string GetOverflowCode() override;

private:
  vtkCandidateMultiLayerPass(const vtkCandidateMultiLayerPass&) = delete;
  void operator=(const vtkCandidateMultiLayerPass&) = delete;
};

VTK_ABI_NAMESPACE_END
#endif
