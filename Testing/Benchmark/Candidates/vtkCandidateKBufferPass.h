// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCandidateKBufferPass
 * @brief   A k-buffer that composites its nearest entry when it is full, for sorted geometry.
 *
 * M. Gross and S. Gumhold, Advanced Rendering of Line Data with Ambient Occlusion and Transparency,
 * 2021, sections 4.1 and 4.2. The segments of a vtkTrajectoryMapper are drawn front to back by the
 * least distance of their axis to the eye, the cells of other vtkPolyDataMappers by the middle of
 * their bounds, and the props by the least distance of their bounds. Sorting happens on the CPU in
 * every frame and is timed as stage `order`, a part of `gather`. Blocks of composite data are
 * sorted each for itself; what other mappers draw is not.
 *
 * A pixel is exact where no fragment comes after more than k that are behind it. Fragments behind
 * what is opaque are dropped. Where the threshold of what is negligible lets them be seen, the
 * pixel counts as lossy.
 */

#ifndef vtkCandidateKBufferPass_h
#define vtkCandidateKBufferPass_h

#include "vtkCandidateLayersPass.h"
#include "vtkSmartPointer.h"
#include "vtkTrajectoryNodes.h"

#include <map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkActor;
class vtkPolyDataMapper;
class vtkTrajectoryMapper;

class vtkCandidateKBufferPass : public vtkCandidateLayersPass
{
public:
  static vtkCandidateKBufferPass* New();
  vtkTypeMacro(vtkCandidateKBufferPass, vtkCandidateLayersPass);

  std::string GetReasonUnsupported(vtkOpenGLRenderWindow* window) override;

  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;

protected:
  vtkCandidateKBufferPass() = default;
  ~vtkCandidateKBufferPass() override = default;

  static constexpr GLuint OrderBinding = NextBinding;

  std::string GetOverflowCode() override;
  void Define(vtkShaderDefinitions& definitions) override;
  std::vector<vtkProp*> GetDrawnProps(const vtkRenderState* state) override;
  void DrawProp(vtkRenderer* renderer, vtkProp* prop) override;

  /** Draw the first `nodes` nodes of the order, those with a segment or a ball. */
  virtual void DrawNodes(vtkRenderer* renderer, vtkProp* prop, int nodes);

  /** Draw this part of the order, and nothing of the others. */
  void DrawSlice(vtkRenderer* renderer, vtkProp* prop, int first, int end);

private:
  vtkCandidateKBufferPass(const vtkCandidateKBufferPass&) = delete;
  void operator=(const vtkCandidateKBufferPass&) = delete;

  /** The nodes that a mapper draws, as long as its input is the same. */
  struct MapperNodes
  {
    vtkMTimeType Time = 0;
    vtkTrajectoryNodes Nodes;
  };

  const vtkTrajectoryNodes& GetNodes(vtkTrajectoryMapper* mapper);
  void DrawTrajectories(vtkRenderer* renderer, vtkActor* actor, vtkTrajectoryMapper* mapper);
  void DrawCells(vtkRenderer* renderer, vtkActor* actor, vtkPolyDataMapper* mapper);

  void AddOrderTime(double start);

  /** Of a mapper that is gone, too: times do not repeat, so that another at its address has its
   * own. */
  std::map<vtkTrajectoryMapper*, MapperNodes> Nodes;
};

VTK_ABI_NAMESPACE_END
#endif
