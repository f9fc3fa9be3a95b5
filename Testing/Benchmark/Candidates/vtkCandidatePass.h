// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCandidatePass
 * @brief   What the methods that were weighed against vtkExactTransparencyPass have in common.
 *
 * Candidates are measured by the benchmark and are no part of the product. Each is a leaf of a
 * chain of render passes, the delegate of a vtkCameraPass: it draws lights, opaque geometry and
 * translucent geometry, the last over a copy of the opaque scene as the product does. They know
 * neither volumes nor selections, multisampled windows or props whose mapper takes no part in
 * render passes, and they draw every frame anew.
 *
 * A candidate that is not exact says so: GetLossyPixels() counts the pixels in which the fragments
 * that can be seen were not all composited in their order; how their colours are rounded is not in
 * it. Where a candidate cannot run (GetReasonUnsupported()), it reports an error once and shows the
 * opaque scene alone, with all pixels counted as lossy.
 *
 * @sa Candidates.h
 */

#ifndef vtkCandidatePass_h
#define vtkCandidatePass_h

#include "vtkCandidateBuffers.h"
#include "vtkEmptyFramebuffer.h"
#include "vtkNew.h"
#include "vtkOpaqueLayer.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkStageDraw.h"
#include "vtkStageTimers.h"
#include "vtkTransparencyStatistics.h"
#include "vtkWeakPointer.h"

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkProp;
class vtkRenderer;
class vtkShaderDefinitions;

class vtkCandidatePass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkCandidatePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The threshold of vtkExactTransparencyPass: what weighs less cannot be seen. */
  static constexpr double ExactTransmittance = 1.0 / 8192.0;

  ///@{
  /**
   * Compositing stops where what is behind weighs no more than this, in [0,1]. Default
   * ExactTransmittance. 0.01 is Bandle's threshold (2016, section 2.4.4), 0.05 that of Gross
   * and Gumhold (2021, section 4.3).
   */
  vtkSetClampMacro(NegligibleTransmittance, double, 0.0, 1.0);
  vtkGetMacro(NegligibleTransmittance, double);
  ///@}

  ///@{
  /** Of the last frame: translucent fragments in front of the opaque scene, the most that were kept
   * of one pixel at a time, and the pixels that are not exact. */
  vtkIdType GetFragments() { return this->Statistics->GetFragments(); }
  vtkIdType GetLongestList() { return this->Statistics->GetLongestList(); }
  vtkGetMacro(LossyPixels, vtkIdType);
  ///@}

  /** Bytes of graphics memory that the candidate holds, copies of the opaque scene included. */
  vtkIdType GetBytes() { return this->Statistics->GetBufferBytes(); }

  /** These figures, and the time of each stage. */
  vtkTransparencyStatistics* GetStatistics() { return this->Statistics; }

  /** Why the candidate cannot run in the window, whose context is current; or an empty string. */
  virtual std::string GetReasonUnsupported(vtkOpenGLRenderWindow* window);

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /** The hooks of mappers, while props are drawn. */
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* array = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->GetMTime(); }
  ///@}

protected:
  vtkCandidatePass() = default;
  ~vtkCandidatePass() override = default;

  /** The first binding; those of a candidate follow. */
  static constexpr GLuint CountersBinding = 0;

  struct Counters
  {
    std::uint32_t Fragments = 0;
    std::uint32_t LongestList = 0;
    std::uint32_t LossyPixels = 0;
    std::uint32_t HasTies = 0;
  };

  ///@{
  /** What makes a candidate. RenderTranslucent() may call everything below; it returns false when
   * OpenGL has no room for the number of bytes in NeededBytes. */
  virtual bool RenderTranslucent(const vtkRenderState* state) = 0;
  /** Constants of its shaders. */
  virtual void Define(vtkShaderDefinitions& definitions) = 0;
  /** Code of all its fragment shaders: its buffers. */
  virtual std::string GetDeclarations() = 0;
  /** Code with `void pellucidStore(vec4 color, float depth)`, which takes a mapper's fragment; or
   * with another function that the second names. */
  virtual std::string GetStoreCode() = 0;
  virtual std::string GetStoreFunction() { return "pellucidStore"; }
  /** Uniforms of that. */
  virtual void SetStoreUniforms(vtkShaderProgram* vtkNotUsed(program)) {}
  ///@}

  /** The props of a frame in the order in which they are drawn; that of the renderer. */
  virtual std::vector<vtkProp*> GetDrawnProps(const vtkRenderState* state);

  /** Draw one prop, with the hooks in place. */
  virtual void DrawProp(vtkRenderer* renderer, vtkProp* prop);

  /** Room for a buffer; false, with the bytes remembered for the message, when there is none. */
  bool Reserve(GLuint binding, vtkIdType bytes);

  /** Draw all props, each fragment of which comes to the code of GetStoreCode(). */
  void DrawProps(const vtkRenderState* state);

  /** The shader with its //VTK::Pellucid::Definitions, Declarations and Blend replaced. */
  std::string AssembleShader(
    const std::string& fragmentShader, const std::string& moreDefinitions = "");

  /** Draw every pixel of the picture with a shader that AssembleShader() has made. */
  void DrawPixels(const std::string& shader, const vtkStageDraw::SetUniforms& setUniforms = {});

  /** Call `draw` without colour output. */
  void DrawOffScreen(const std::function<void()>& draw);

  /** Constants that all shaders of a candidate begin with. */
  std::string GetDefinitions();

  Counters ReadCounters() const;
  vtkIdType GetNumberOfPixels() const;

  vtkWeakPointer<vtkOpenGLRenderWindow> Window; ///< of the last frame
  std::array<int, 4> Viewport{};                ///< of the frame: x, y, width, height
  vtkCandidateBuffers Buffers;
  vtkStageTimers Timers;

private:
  vtkCandidatePass(const vtkCandidatePass&) = delete;
  void operator=(const vtkCandidatePass&) = delete;

  void DrawFrame(const vtkRenderState* state);
  void SetPixelUniforms(vtkShaderProgram* program);
  void ReportOnce(const std::string& reason);

  double NegligibleTransmittance = ExactTransmittance;
  vtkNew<vtkTransparencyStatistics> Statistics;
  vtkIdType LossyPixels = 0;
  vtkIdType NeededBytes = 0;
  bool HasReported = false;
  vtkOpaqueLayer Opaque;
  vtkEmptyFramebuffer Framebuffer;
  vtkStageDraw Stage;
};

VTK_ABI_NAMESPACE_END
#endif
