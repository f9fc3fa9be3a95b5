// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCandidateDepthSlicesPass
 * @brief   A k-buffer whose sorted geometry comes in slices, each culled by what those before hide.
 *
 * M. Gross and S. Gumhold, Advanced Rendering of Line Data with Ambient Occlusion and Transparency,
 * 2021, section 4.3. Between two slices of the segments of a vtkTrajectoryMapper a mip map of the
 * minimum opacity is made of what has been composited. The vertex shader drops a segment where the
 * bounding rectangle of its box lies over pixels in which nothing behind can be seen any more: that
 * is what SetNegligibleTransmittance() says, 0.05 in the paper. Fragments are dropped by the
 * opacity of their own pixel, before their ray is intersected. What is dropped is not counted, nor
 * is its order checked. The mip map is timed as stage `mip map`, which is a part of `gather`. What
 * other mappers draw is neither sliced nor culled.
 *
 * As in the paper each slice is a draw of its part of the order, and the k-buffer goes on from
 * slice to slice. Unlike there, segments are sorted on the CPU, and fragment shaders make the mip
 * map.
 */

#ifndef vtkCandidateDepthSlicesPass_h
#define vtkCandidateDepthSlicesPass_h

#include "vtkCandidateKBufferPass.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkCandidateDepthSlicesPass : public vtkCandidateKBufferPass
{
public:
  static vtkCandidateDepthSlicesPass* New();
  vtkTypeMacro(vtkCandidateDepthSlicesPass, vtkCandidateKBufferPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Slices of equal numbers of segments, 1 to 1000. Default 10, as in the paper. */
  vtkSetClampMacro(Slices, int, 1, 1000);
  vtkGetMacro(Slices, int);
  ///@}

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  vtkMTimeType GetShaderStageMTime() override;

protected:
  vtkCandidateDepthSlicesPass() = default;
  ~vtkCandidateDepthSlicesPass() override = default;

  static constexpr GLuint OpacitiesBinding = OrderBinding + 1;

  bool RenderTranslucent(const vtkRenderState* state) override;
  void Define(vtkShaderDefinitions& definitions) override;
  std::string GetDeclarations() override;
  void DrawNodes(vtkRenderer* renderer, vtkProp* prop, int nodes) override;

private:
  vtkCandidateDepthSlicesPass(const vtkCandidateDepthSlicesPass&) = delete;
  void operator=(const vtkCandidateDepthSlicesPass&) = delete;

  void UpdateOpacities();

  int Slices = 10;
  bool HasDrawn = false;       ///< a slice of the frame
  std::string OpacitiesShader; ///< of the frame
  int Levels = 1;              ///< 2 to their power is at least the longer side of the picture
  vtkTimeStamp LevelsTime;
};

VTK_ABI_NAMESPACE_END
#endif
