// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkRoundedConeMapper.h"

#include "vtkBlockDisplayShader.h"
#include "vtkFloatArray.h"
#include "vtkHardwareSelector.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerVectorKey.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLError.h" // and the OpenGL loader, whose header differs between VTK versions
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShaderEdit.h"
#include "vtkShaderProgram.h"
#include "vtkSquarePoints.h"

#include "vtkRoundedConeDecFS.h"
#include "vtkRoundedConeExitDecFS.h"
#include "vtkRoundedConeExitImplFS.h"
#include "vtkRoundedConeImplFS.h"
#include "vtkRoundedConeImportanceImplFS.h"
#include "vtkRoundedConeVS.h"
#include "vtkTrajectoryNodesDec.h"

#include <algorithm>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkRoundedConeMapper);
vtkInformationKeyRestrictedMacro(vtkRoundedConeMapper, DRAWN_NODES, IntegerVector, 2);

namespace
{
// Quads that one draw call takes: they share one index buffer of this length.
constexpr vtkIdType QuadsPerDraw = 65536;

// VTK's own limit; the array in the shader also holds the near plane.
constexpr int MaximumClippingPlanes = 6;

// A value of each node, in some components of a buffer texture.
struct NodeValue
{
  std::string Name;
  std::string Type;
  std::string Sampler;
  std::string Components;
};

// The vertex shader hands the values at both ends of a segment to the fragment shader. Returns the
// expression for the value there, linear from ball to ball.
std::string PassNodeValue(vtkShaderEdit& vertex, vtkShaderEdit& fragment, const NodeValue& value)
{
  const std::string start = "start" + value.Name;
  const std::string end = "end" + value.Name;
  const auto declare = [&](const std::string& direction)
  {
    return "flat " + direction + " " + value.Type + " " + start + ";\nflat " + direction + " " +
      value.Type + " " + end + ";\n";
  };
  const auto fetch = [&](const std::string& ball)
  { return "texelFetch(" + value.Sampler + ", " + ball + ")." + value.Components + ";\n"; };
  vertex.Prepend("//VTK::NodeValue::Dec",
    std::string("uniform ") + (value.Type[0] == 'i' ? "isamplerBuffer " : "samplerBuffer ") +
      value.Sampler + ";\n" + declare("out"));
  vertex.Prepend("//VTK::NodeValue::Impl",
    start + " = " + fetch("firstBall") + "  " + end + " = " + fetch("lastBall") + "  ");
  fragment.Prepend("//VTK::NodeValue::Dec", declare("in"));
  return "mix(" + start + ", " + end +
    ", clamp(0.5 + 0.5 * hit.w / max(coneShape.x, 1e-30), 0.0, 1.0))";
}

// Segments whose values meet the condition are not drawn.
void SkipSegments(vtkShaderEdit& vertex, const std::string& condition)
{
  vertex.Prepend("//VTK::NodeValue::Impl",
    "if (" + condition +
      ")\n"
      "  {\n"
      "    return;\n"
      "  }\n"
      "  ");
}
}

//------------------------------------------------------------------------------
vtkRoundedConeMapper::vtkRoundedConeMapper()
{
  // The superclass asks its input for points and normals to decide what to draw and light.
  vtkNew<vtkPolyData> placeholder;
  placeholder->SetPoints(vtkNew<vtkPoints>());
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  placeholder->GetPointData()->SetNormals(normals);
  this->SetInputData(placeholder);
  this->SetPopulateSelectionSettings(0);
  this->ColorMap->RepeatOff();
}

//------------------------------------------------------------------------------
vtkRoundedConeMapper::~vtkRoundedConeMapper() = default;

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetNodes(const vtkTrajectoryNodes* nodes)
{
  this->Nodes = nodes;
  this->Groups.Build(*nodes);
  this->NodeTexture.Current = false;
  this->RemainderTexture.Current = false;
  this->ShaderVariantTime.Modified();
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetPropertyColors()
{
  this->DirectColors.clear();
  this->TextureCoordinates.clear();
  this->Source = ColorSource::Property;
  this->ShaderVariantTime.Modified();
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetDirectColors(std::vector<unsigned char> colors)
{
  this->SetPropertyColors();
  this->DirectColors = std::move(colors);
  this->Source = ColorSource::Direct;
  this->ColorTexture.Current = false;
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetTextureColors(std::vector<float> coordinates, vtkImageData* colorMap)
{
  this->SetPropertyColors();
  this->TextureCoordinates = std::move(coordinates);
  this->ColorMap->SetInputData(colorMap);
  this->Source = ColorSource::Texture;
  this->ColorTexture.Current = false;
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetOpacities(std::vector<float> factors)
{
  if (factors.empty() != this->Opacities.empty())
  {
    this->ShaderVariantTime.Modified();
  }
  this->Opacities = std::move(factors);
  this->OpacityTexture.Current = false;
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetSegments(std::vector<vtkTrajectorySegmentNodes::Node> segments)
{
  if (segments.empty() != this->Segments.empty())
  {
    this->ShaderVariantTime.Modified();
  }
  this->Segments = std::move(segments);
  this->SegmentTexture.Current = false;
}

//------------------------------------------------------------------------------
std::vector<vtkBufferTexture*> vtkRoundedConeMapper::GetTextures()
{
  std::vector<vtkBufferTexture*> textures = { &this->NodeTexture };
  if (!this->Nodes->GetRemainders().empty())
  {
    textures.push_back(&this->RemainderTexture);
  }
  if (this->Source != ColorSource::Property)
  {
    textures.push_back(&this->ColorTexture);
  }
  if (!this->Opacities.empty())
  {
    textures.push_back(&this->OpacityTexture);
  }
  if (!this->Segments.empty())
  {
    textures.push_back(&this->SegmentTexture);
  }
  return textures;
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  // Callers need not have made the window's context current.
  auto* renderWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (renderWindow)
  {
    renderWindow->PushContext();
  }
  for (vtkBufferTexture* texture : { &this->NodeTexture, &this->RemainderTexture,
         &this->ColorTexture, &this->OpacityTexture, &this->SegmentTexture })
  {
    texture->Release(window);
  }
  this->ColorMap->ReleaseGraphicsResources(window);
  this->Primitives[PrimitiveTris].IBO->IndexCount = 0;
  this->Superclass::ReleaseGraphicsResources(window);
  if (renderWindow)
  {
    renderWindow->PopContext();
  }
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::UpdateBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (!this->NodeTexture.Current)
  {
    const auto& nodes = this->Nodes->GetNodes();
    this->NodeTexture.Upload(window, nodes.front().data(), nodes.size(), 4);
  }
  const auto& remainders = this->Nodes->GetRemainders();
  if (!remainders.empty() && !this->RemainderTexture.Current)
  {
    this->RemainderTexture.Upload(window, remainders.front().data(), remainders.size(), 4);
  }
  if (this->Source == ColorSource::Direct && !this->ColorTexture.Current)
  {
    this->ColorTexture.Upload(window, this->DirectColors.data(), this->DirectColors.size() / 4, 4);
  }
  if (this->Source == ColorSource::Texture && !this->ColorTexture.Current)
  {
    this->ColorTexture.Upload(
      window, this->TextureCoordinates.data(), this->TextureCoordinates.size() / 2, 2);
  }
  if (!this->Opacities.empty() && !this->OpacityTexture.Current)
  {
    this->OpacityTexture.Upload(window, this->Opacities.data(), this->Opacities.size(), 1);
  }
  if (!this->Segments.empty() && !this->SegmentTexture.Current)
  {
    this->SegmentTexture.Upload(window, this->Segments.front().data(), this->Segments.size(), 4);
  }

  vtkOpenGLIndexBufferObject* indices = this->Primitives[PrimitiveTris].IBO;
  const vtkIdType quads = std::min(this->Nodes->GetNumberOfNodes(), QuadsPerDraw);
  if (indices->IndexCount < static_cast<std::size_t>(6 * quads))
  {
    std::vector<unsigned int> corners;
    corners.reserve(6 * quads);
    for (unsigned int first = 0; first < 4 * quads; first += 4)
    {
      corners.insert(
        corners.end(), { first, first + 1, first + 2, first + 2, first + 1, first + 3 });
    }
    indices->Upload(corners, vtkOpenGLIndexBufferObject::ElementArrayBuffer);
    indices->IndexCount = corners.size();
  }

  this->View.Update(*this->Nodes, renderer, actor);
  this->UpdateShaderVariant(actor);
  this->UpdateShapes(actor);
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::UpdateShaderVariant(vtkActor* actor)
{
  const auto& leaves = this->Nodes->GetLeaves();
  ShaderVariant variant;
  variant.CutOpen = this->GetNumberOfClippingPlanes() > 0 || this->View.MayCutOpen();
  // Stays, since shaders would be made anew in turns where actors share the mapper.
  variant.Shiny = this->Variant.Shiny || actor->GetProperty()->GetSpecular() != 0.0;
  variant.HasBlockColors = std::any_of(
    leaves.begin(), leaves.end(), [](const auto& leaf) { return leaf.Display.Color.has_value(); });
  if (!(variant == this->Variant))
  {
    this->Variant = variant;
    this->ShaderVariantTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  // Quads have no back, and a hardware selection by points must see what hides what.
  vtkOpenGLState::ScopedglEnableDisable culling(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  if (renderer->GetSelector())
  {
    state->vtkglDepthMask(GL_TRUE);
  }

  const std::vector<vtkBufferTexture*> textures = this->GetTextures();
  for (vtkBufferTexture* texture : textures)
  {
    texture->Texture->Activate();
  }
  if (this->Source == ColorSource::Texture)
  {
    this->ColorMap->Load(renderer);
  }

  this->DrawShape(vtkNodeGroups::Shape::Sprite, renderer, actor);
  this->DrawShape(vtkNodeGroups::Shape::Quad, renderer, actor);
  vtkOpenGLCheckErrorMacro("failed after drawing rounded cones");

  if (this->Source == ColorSource::Texture)
  {
    this->ColorMap->PostRender(renderer);
  }
  for (vtkBufferTexture* texture : textures)
  {
    texture->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
// To the superclass, both are surfaces.
vtkOpenGLHelper& vtkRoundedConeMapper::GetHelper(vtkNodeGroups::Shape shape)
{
  return this
    ->Primitives[shape == vtkNodeGroups::Shape::Sprite ? PrimitiveTriStrips : PrimitiveTris];
}

//------------------------------------------------------------------------------
// Neighbours that are displayed alike together.
void vtkRoundedConeMapper::DrawShape(
  vtkNodeGroups::Shape shape, vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->Groups.Has(shape))
  {
    return;
  }
  vtkOpenGLHelper& helper = this->GetHelper(shape);
  this->UpdateShaders(helper, renderer, actor);
  if (!helper.Program)
  {
    return;
  }
  vtkInformation* keys = actor->GetPropertyKeys();
  const int* drawn = keys ? keys->Get(DRAWN_NODES()) : nullptr;
  const vtkIdType begin = drawn ? drawn[0] : 0;
  const vtkIdType end = drawn ? drawn[1] : this->Nodes->GetNumberOfNodes();
  const auto& leaves = this->Nodes->GetLeaves();
  for (std::size_t first = 0, last = 0; first < leaves.size(); first = last)
  {
    const vtkBlockDisplay& display = leaves[first].Display;
    last = std::find_if(leaves.begin() + first, leaves.end(),
             [&display](const auto& leaf) { return !(leaf.Display == display); }) -
      leaves.begin();
    if (display.IsDrawn(renderer->GetSelector() != nullptr))
    {
      vtkSetBlockDisplay(helper.Program, display, actor);
      this->DrawNodes(shape, std::max(begin, this->Nodes->GetFirstNode(first)),
        std::min(end, this->Nodes->GetFirstNode(last)));
    }
  }
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::DrawNodes(vtkNodeGroups::Shape shape, vtkIdType first, vtkIdType last)
{
  if (shape == vtkNodeGroups::Shape::Sprite)
  {
    // For a program without indices VTK has a new vertex array each time, and does not bind it.
    this->GetHelper(shape).VAO->Bind();
    const vtkProgramPointSize pointSize;
    this->Groups.ForEach(shape, first, last,
      [](vtkIdType begin, vtkIdType end)
      { glDrawArrays(GL_POINTS, static_cast<GLint>(begin), static_cast<GLsizei>(end - begin)); });
    return;
  }
  vtkOpenGLIndexBufferObject* indices = this->GetHelper(shape).IBO;
  indices->Bind();
  this->Groups.ForEach(shape, first, last,
    [](vtkIdType begin, vtkIdType end)
    {
      for (; begin < end; begin += QuadsPerDraw)
      {
        const vtkIdType quads = std::min(QuadsPerDraw, end - begin);
        glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(6 * quads), GL_UNSIGNED_INT,
          nullptr, static_cast<GLint>(4 * begin));
      }
    });
  indices->Release();
}

//------------------------------------------------------------------------------
bool vtkRoundedConeMapper::GetNeedToRebuildShaders(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  return this->Superclass::GetNeedToRebuildShaders(cellBO, renderer, actor) ||
    cellBO.ShaderSourceTime < this->ShaderVariantTime;
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::GetShaderTemplate(
  Shaders shaders, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::GetShaderTemplate(shaders, renderer, actor);
  const bool isSprite = this->LastBoundBO == &this->GetHelper(vtkNodeGroups::Shape::Sprite);
  std::string source = vtkRoundedConeVS;
  vtkShaderProgram::Substitute(
    source, "//VTK::Shape::Dec", "#define SPRITES " + std::to_string(isSprite ? 1 : 0));
  shaders[vtkShader::Vertex]->SetSource(source);
  shaders[vtkShader::Geometry]->SetSource("");
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::ReplaceShaderValues(
  Shaders shaders, vtkRenderer* renderer, vtkActor* actor)
{
  {
    vtkShaderEdit vertex(shaders[vtkShader::Vertex]);
    vtkShaderEdit fragment(shaders[vtkShader::Fragment]);
    fragment.Replace("//VTK::PositionVC::Dec", "");
    fragment.Replace("//VTK::PositionVC::Impl", "");
    fragment.Replace("//VTK::Normal::Dec", vtkRoundedConeDecFS);
    fragment.Replace("//VTK::Depth::Impl", vtkRoundedConeImplFS);
    if (this->Variant.CutOpen)
    {
      vertex.Replace("//VTK::Exit::Dec", "flat out int segmentNode;\n");
      vertex.Replace("//VTK::Exit::Impl", "segmentNode = node;\n");
      fragment.Replace(
        "//VTK::Exit::Dec", std::string("//VTK::TrajectoryNodes::Dec\n") + vtkRoundedConeExitDecFS);
      fragment.Replace("//VTK::Exit::Impl", vtkRoundedConeExitImplFS);
    }

    for (vtkShaderEdit* shader : { &vertex, &fragment })
    {
      shader->Replace("//VTK::TrajectoryNodes::Dec", vtkTrajectoryNodesDec);
      if (!this->Nodes->GetRemainders().empty())
      {
        shader->Replace("//VTK::NodeRemainder::Dec",
          "uniform samplerBuffer nodeRemainders;\n"
          "uniform vec3 nodeOrigin;\n");
        shader->Replace("//VTK::NodeRemainder::Impl",
          "node.xyz = (node.xyz - nodeOrigin) + texelFetch(nodeRemainders, index).xyz;\n");
      }
    }
    if (!this->Opacities.empty())
    {
      this->ReplaceShaderOpacity(vertex, fragment);
    }
    if (this->Variant.HasBlockColors)
    {
      vtkAddBlockColor(fragment);
    }
    if (this->Source != ColorSource::Property)
    {
      this->ReplaceShaderNodeColor(vertex, fragment);
    }
    if (!this->Segments.empty())
    {
      PassNodeValue(vertex, fragment, { "Segment", "ivec4", this->SegmentTexture.Sampler, "xyzw" });
      fragment.Prepend("//VTK::NodeValue::Dec",
        "uniform int pellucidFirstSegment;\nuniform bool pellucidAvoids;\n");
      fragment.Prepend("//VTK::DepthPeeling::Impl", vtkRoundedConeImportanceImplFS);
    }
  }
  this->Superclass::ReplaceShaderValues(shaders, renderer, actor);
  if (!this->Variant.Shiny)
  {
    vtkShaderEdit(shaders[vtkShader::Fragment])
      .Replace("uniform float specularIntensity;", "const float specularIntensity = 0.0;");
  }
}

//------------------------------------------------------------------------------
// Before all colours: what is appended first comes last, and multiplies the opacity of the colour.
void vtkRoundedConeMapper::ReplaceShaderOpacity(vtkShaderEdit& vertex, vtkShaderEdit& fragment)
{
  const std::string factor =
    PassNodeValue(vertex, fragment, { "Opacity", "float", this->OpacityTexture.Sampler, "x" });
  SkipSegments(vertex, "max(startOpacity, endOpacity) <= 0.0");
  fragment.Append("//VTK::Color::Impl", "  opacity *= " + factor + ";\n");
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::ReplaceShaderNodeColor(vtkShaderEdit& vertex, vtkShaderEdit& fragment)
{
  const char* sampler = this->ColorTexture.Sampler;
  std::string color;
  if (this->Source == ColorSource::Direct)
  {
    color = PassNodeValue(vertex, fragment, { "Color", "vec4", sampler, "rgba" });
    SkipSegments(vertex, "max(startColor.a, endColor.a) <= 0.0");
  }
  else
  {
    color = "texture(nodeColorMap, " +
      PassNodeValue(vertex, fragment, { "Color", "vec2", sampler, "xy" }) + ")";
    fragment.Replace("//VTK::TMap::Dec", "uniform sampler2D nodeColorMap;\n//VTK::TMap::Dec");
  }
  // The superclass puts its own code in front of this, and this overrides its colours.
  fragment.Append("//VTK::Color::Impl",
    "  vec4 nodeColor = " + color +
      ";\n"
      "  ambientColor = ambientIntensity * nodeColor.rgb;\n"
      "  diffuseColor = diffuseIntensity * nodeColor.rgb;\n"
      "  opacity = opacityUniform * nodeColor.a;\n");
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::ReplaceShaderPicking(Shaders shaders, vtkRenderer*, vtkActor*)
{
  const int pass = this->LastSelectionState;
  if (pass < vtkHardwareSelector::MIN_KNOWN_PASS)
  {
    return;
  }
  vtkShaderEdit vertex(shaders[vtkShader::Vertex]);
  vtkShaderEdit fragment(shaders[vtkShader::Fragment]);
  const bool low =
    pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::CELL_ID_LOW24;
  const bool high =
    pass == vtkHardwareSelector::POINT_ID_HIGH24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
  if (!low && !high)
  {
    fragment.Replace("//VTK::Picking::Dec", "uniform vec3 mapperIndex;\n");
    fragment.Replace("//VTK::Picking::Impl", "gl_FragData[0] = vec4(mapperIndex, 1.0);\n");
    return;
  }
  // Raw ids are nodes; vtkTrajectoryMapper::ProcessSelectorPixelBuffers turns them into the
  // input's.
  const bool points =
    pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  vertex.Replace("//VTK::Picking::Dec", "flat out ivec2 nodeIds;\n");
  vertex.Replace("//VTK::Picking::Impl", "nodeIds = ivec2(firstBall, lastBall);\n");
  fragment.Replace("//VTK::Picking::Dec", "flat in ivec2 nodeIds;\n");
  fragment.Replace("//VTK::Picking::Impl",
    std::string("int id = ") + (points ? "hit.w > 0.0 ? nodeIds.y : nodeIds.x" : "nodeIds.x") +
      (low ? ";\n  gl_FragData[0] = vec4(vec3(id & 255, id >> 8 & 255, id >> 16 & 255) / 255.0, "
             "1.0);\n"
           : ";\n  gl_FragData[0] = vec4(float(id >> 24 & 255) / 255.0, 0.0, 0.0, 1.0);\n"));
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  vtkShaderProgram* program = cellBO.Program;
  for (const vtkBufferTexture* texture : this->GetTextures())
  {
    program->SetUniformi(texture->Sampler, texture->Texture->GetTextureUnit());
  }
  if (this->Source == ColorSource::Texture)
  {
    program->SetUniformi("nodeColorMap", this->ColorMap->GetTextureUnit());
  }
  if (this->Variant.CutOpen)
  {
    this->SetClipParameters(program);
  }
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetClipParameters(vtkShaderProgram* program)
{
  int count = this->GetNumberOfClippingPlanes();
  if (count > MaximumClippingPlanes)
  {
    vtkErrorMacro("A mapper can be cut by at most " << MaximumClippingPlanes
                                                    << " clipping planes, but has " << count
                                                    << ": remove some, or cut the data.");
    count = MaximumClippingPlanes;
  }
  vtkNew<vtkMatrix4x4> viewToWorld;
  vtkMatrix4x4::Invert(this->View.GetWorldToView(), viewToWorld);
  viewToWorld->Transpose();
  float planes[1 + MaximumClippingPlanes][4] = { { 0.0f, 0.0f, -1.0f,
    -static_cast<float>(this->View.GetNearPlane()) } };
  for (int i = 0; i < count; ++i)
  {
    double plane[4];
    this->GetClippingPlaneInDataCoords(viewToWorld, i, plane);
    std::copy(plane, plane + 4, planes[1 + i]);
  }
  program->SetUniformi("clipPlaneCount", 1 + count);
  program->SetUniform4fv("clipPlanesVC", 1 + MaximumClippingPlanes, planes);
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::UpdateShapes(vtkActor* actor)
{
  vtkNodeGroups::View view = this->View.GetGroupView();
  // With samples, a sprite covers some that the quad does not. The box around a slanted quad is up
  // to 1.6 times as wide as its group is taken for.
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLE_BUFFERS, &samples);
  view.HasSprites =
    samples == 0 && vtkGetLargestSquarePoint() >= 1.6 * vtkNodeGroups::LargestSprite;
  vtkInformation* keys = actor->GetPropertyKeys();
  view.HasOneShape = keys && keys->Has(DRAWN_NODES());
  this->Groups.Update(view);
}

//------------------------------------------------------------------------------
void vtkRoundedConeMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetCameraShaderParameters(cellBO, renderer, actor);
  this->View.SetShaderParameters(cellBO.Program);
}

VTK_ABI_NAMESPACE_END
