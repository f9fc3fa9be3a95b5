// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRoundedConeMapper
 * @brief   Draw the nodes of trajectories as ray-cast rounded cones.
 *
 * The part of vtkTrajectoryMapper that issues OpenGL calls for lines and vertices. It takes lights,
 * material, the hooks of render passes and the shader cache from vtkOpenGLPolyDataMapper, and
 * replaces the geometry: a vertex shader fetches the nodes from buffer textures and makes one
 * view-aligned quad for each segment, or a point sprite where that is small (vtkNodeGroups); the
 * fragment shader intersects the view ray with it (Gross and Gumhold 2021, section 5). See
 * glsl/vtkRoundedConeVS.glsl.
 *
 * Graphics memory: 16 bytes for each node, 32 where it has a remainder, 4 for its colour, or 8 for
 * a texture coordinate, and 4 for its opacity factor.
 */

#ifndef vtkRoundedConeMapper_h
#define vtkRoundedConeMapper_h

#include "vtkBufferTexture.h"
#include "vtkNew.h"
#include "vtkNodeGroups.h"
#include "vtkNodeView.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLTexture.h" // for the colour map
#include "vtkTrajectoryNodes.h"
#include "vtkTrajectorySegmentNodes.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkImageData;
class vtkInformationIntegerVectorKey;
class vtkShaderEdit;

class vtkRoundedConeMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkRoundedConeMapper* New();
  vtkTypeMacro(vtkRoundedConeMapper, vtkOpenGLPolyDataMapper);

  /** In the property keys of an actor: the first of the nodes to draw, and the end of them. Without
   * it all are drawn. For render passes that draw the nodes part by part, or in another order: all
   * have one shape then. */
  static vtkInformationIntegerVectorKey* DRAWN_NODES();

  /** How nodes get their colour. */
  enum class ColorSource
  {
    Property, ///< the colour of the actor's property
    Direct,   ///< one RGBA for each node
    Texture   ///< one coordinate (s, t) for each node, looked up in the colour map
  };

  /** Draw these nodes, as their leaves are displayed, from now on; the caller keeps them alive and
   * calls this after each change of the nodes. */
  void SetNodes(const vtkTrajectoryNodes* nodes);

  ///@{
  /** Colours from now on. Arrays hold 4 or 2 values for each node. */
  void SetPropertyColors();
  void SetDirectColors(std::vector<unsigned char> colors);
  void SetTextureColors(std::vector<float> coordinates, vtkImageData* colorMap);
  ///@}

  /** Multiply the opacity by the factor of each node in [0,1] from now on; empty: no factors. */
  void SetOpacities(std::vector<float> factors);

  /** Importance and segment of each node from now on; empty where opacities are not optimised. */
  void SetSegments(std::vector<vtkTrajectorySegmentNodes::Node> segments);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkRoundedConeMapper();
  ~vtkRoundedConeMapper() override;

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void UpdateBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void SetCameraShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

  using Shaders = std::map<vtkShader::Type, vtkShader*>;
  void GetShaderTemplate(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderPicking(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override;

  ///@{
  /** What does not apply to quads that stand for something else. */
  void ReplaceShaderNormal(Shaders, vtkRenderer*, vtkActor*) override {}
  void ReplaceShaderTCoord(Shaders, vtkRenderer*, vtkActor*) override {}
  void ReplaceShaderClip(Shaders, vtkRenderer*, vtkActor*) override {}
  void ReplaceShaderCoincidentOffset(Shaders, vtkRenderer*, vtkActor*) override {}
  bool HaveWideLines(vtkRenderer*, vtkActor*) override { return false; }
  bool DrawingEdges(vtkRenderer*, vtkActor*) override { return false; }
  ///@}

private:
  vtkRoundedConeMapper(const vtkRoundedConeMapper&) = delete;
  void operator=(const vtkRoundedConeMapper&) = delete;

  /** The buffer textures that what is drawn now needs. */
  std::vector<vtkBufferTexture*> GetTextures();

  void ReplaceShaderOpacity(vtkShaderEdit& vertex, vtkShaderEdit& fragment);
  void ReplaceShaderNodeColor(vtkShaderEdit& vertex, vtkShaderEdit& fragment);
  void UpdateShaderVariant(vtkActor* actor);
  void UpdateShapes(vtkActor* actor);
  void DrawShape(vtkNodeGroups::Shape shape, vtkRenderer* renderer, vtkActor* actor);
  void DrawNodes(vtkNodeGroups::Shape shape, vtkIdType first, vtkIdType last);
  void SetClipParameters(vtkShaderProgram* program);

  /** Each shape has a shader program of its own. */
  vtkOpenGLHelper& GetHelper(vtkNodeGroups::Shape shape);

  const vtkTrajectoryNodes* Nodes = nullptr;
  vtkNodeView View;
  vtkNodeGroups Groups;
  vtkBufferTexture NodeTexture{ "nodes" };
  vtkBufferTexture RemainderTexture{ "nodeRemainders" };

  ColorSource Source = ColorSource::Property;
  std::vector<unsigned char> DirectColors;
  std::vector<float> TextureCoordinates;
  vtkBufferTexture ColorTexture{ "nodeColors" };
  vtkNew<vtkOpenGLTexture> ColorMap;

  std::vector<float> Opacities;
  vtkBufferTexture OpacityTexture{ "nodeOpacities" };
  std::vector<vtkTrajectorySegmentNodes::Node> Segments;
  vtkBufferTexture SegmentTexture{ "nodeSegments" };

  /** What shaders leave out where it has no effect. */
  struct ShaderVariant
  {
    bool CutOpen = false; ///< the near plane or a clipping plane may show inner walls
    bool Shiny = false;   ///< an actor had specular reflections
    bool HasBlockColors = false;

    bool operator==(const ShaderVariant& other) const
    {
      return this->CutOpen == other.CutOpen && this->Shiny == other.Shiny &&
        this->HasBlockColors == other.HasBlockColors;
    }
  };
  ShaderVariant Variant;
  vtkTimeStamp ShaderVariantTime; ///< of the variant, and of all else that shaders depend on
};

VTK_ABI_NAMESPACE_END
#endif
