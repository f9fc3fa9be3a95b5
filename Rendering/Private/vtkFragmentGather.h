// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The gather stage: draws the translucent geometry of all props once, and lets every mapper's
 * shader append its fragments to the lists. The hooks of vtkOpenGLRenderPass end here.
 */

#ifndef vtkFragmentGather_h
#define vtkFragmentGather_h

#include "vtkFragmentTiles.h" // for vtkPixelRectangle
#include "vtkTimeStamp.h"

#include <set>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkAbstractMapper;
class vtkFragmentLists;
class vtkOpaqueLayer;
class vtkOptimizedScene;
class vtkProp;
class vtkRenderState;
class vtkShaderProgram;

class vtkFragmentGather
{
public:
  vtkFragmentGather() = default;
  ~vtkFragmentGather() = default;
  vtkFragmentGather(const vtkFragmentGather&) = delete;
  void operator=(const vtkFragmentGather&) = delete;

  /** The props of a frame, as its render state has them. */
  static std::vector<vtkProp*> GetProps(const vtkRenderState* state);

  /** What a fragment is compared with and stored for. Mappers make their shaders anew where it
   * changes. */
  void SetFormat(const vtkOpaqueLayer& opaque, bool storesImportance);

  /** Draw all props; the lists and the framebuffer are bound. `scene` has the importances. */
  void DrawProps(const vtkRenderState* state, const vtkPixelRectangle& tile,
    const vtkFragmentLists& lists, const vtkOpaqueLayer& opaque, const vtkOptimizedScene& scene);

  ///@{
  /** Props that drew something since ForgetProps(), and of these those whose mapper ran no hook. */
  void ForgetProps();
  const std::set<vtkProp*>& GetRenderedProps() const { return this->RenderedProps; }
  const std::set<vtkProp*>& GetPropsWithoutHooks() const { return this->PropsWithoutHooks; }
  ///@}

  ///@{
  /** The hooks, while DrawProps() runs. */
  void EditVertexShaders(
    std::string& vertexShader, std::string& geometryShader, vtkAbstractMapper* mapper) const;
  void EditFragmentShader(const std::string& vertexShader, const std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper) const;
  void SetUniforms(vtkShaderProgram* program, vtkAbstractMapper* mapper);
  vtkMTimeType GetShaderTime() const { return this->ShaderTime; }
  ///@}

private:
  /** Whether a mapper's fragments get importances from us. Of actors without importance too: they
   * may share the mapper. */
  bool NeedsImportance(vtkAbstractMapper* mapper) const;

  std::string OpaqueDefinitions;
  bool StoresImportance = false;
  vtkTimeStamp ShaderTime;
  std::set<vtkProp*> RenderedProps;
  std::set<vtkProp*> PropsWithoutHooks;

  // While the props are drawn.
  vtkPixelRectangle Tile;
  const vtkFragmentLists* Lists = nullptr;
  const vtkOpaqueLayer* Opaque = nullptr;
  const vtkOptimizedScene* Scene = nullptr;
  vtkProp* Prop = nullptr;
  bool RanHook = false;
};

VTK_ABI_NAMESPACE_END
#endif
