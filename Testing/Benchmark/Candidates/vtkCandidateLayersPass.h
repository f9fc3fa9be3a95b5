// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCandidateLayersPass
 * @brief   Keeps a fixed number of entries for each pixel while the geometry is drawn once.
 *
 * Fragments are put among the entries of their pixel by reading and writing them, so those of one
 * pixel must come one after the other, in the order in which they are drawn. That needs
 * GL_ARB_fragment_shader_interlock. Where OpenGL lacks it, the candidate runs on renderers only
 * that work so by themselves: Mesa's llvmpipe, which gives each tile of the picture to one thread,
 * and softpipe, which has one; it refuses others. With the interlock it has not been run.
 *
 * Memory is 12 bytes for each entry and 24 for each pixel, whatever the scene.
 */

#ifndef vtkCandidateLayersPass_h
#define vtkCandidateLayersPass_h

#include "vtkCandidatePass.h"

VTK_ABI_NAMESPACE_BEGIN

class vtkCandidateLayersPass : public vtkCandidatePass
{
public:
  vtkTypeMacro(vtkCandidateLayersPass, vtkCandidatePass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Entries for each pixel, 1 to 64. Default 4. */
  vtkSetClampMacro(Layers, int, 1, 64);
  vtkGetMacro(Layers, int);
  ///@}

  std::string GetReasonUnsupported(vtkOpenGLRenderWindow* window) override;

  /** Why the fragments of one pixel would come at the same time, with this renderer of OpenGL; or
   * an empty string. */
  static std::string GetReasonUnordered(const std::string& renderer, bool hasInterlock);

  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;

protected:
  vtkCandidateLayersPass() = default;
  ~vtkCandidateLayersPass() override = default;

  enum Binding : GLuint
  {
    DepthsBinding = CountersBinding + 1,
    ColorsBinding,
    StatesBinding,
    FrontsBinding,
    NextBinding
  };

  /** Code with pellucidOverflow(); see glsl/vtkCandidateLayersStoreDec.glsl. */
  virtual std::string GetOverflowCode() = 0;

  bool RenderTranslucent(const vtkRenderState* state) override;
  void Define(vtkShaderDefinitions& definitions) override;
  std::string GetDeclarations() override;
  std::string GetStoreCode() override;
  std::string GetStoreFunction() override { return "pellucidStoreInOrder"; }

private:
  vtkCandidateLayersPass(const vtkCandidateLayersPass&) = delete;
  void operator=(const vtkCandidateLayersPass&) = delete;

  int Layers = 4;
  bool HasInterlock = false; ///< of the context of the last frame
};

VTK_ABI_NAMESPACE_END
#endif
