// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Copies of the colour and depth that the opaque pass left in the current draw framebuffer, as
 * textures with the same number of samples. glsl/vtkOpaqueDepthDec.glsl is the other side.
 *
 * The textures have the formats of the attachments, since a blit between multisampled framebuffers
 * converts nothing. They cover the viewport only.
 */

#ifndef vtkOpaqueLayer_h
#define vtkOpaqueLayer_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses
#include "vtkType.h"

#include <array>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkOpenGLState;
class vtkShaderProgram;

class vtkOpaqueLayer
{
public:
  vtkOpaqueLayer() = default;
  ~vtkOpaqueLayer() = default;
  vtkOpaqueLayer(const vtkOpaqueLayer&) = delete;
  void operator=(const vtkOpaqueLayer&) = delete;

  /** Copy the viewport (x, y, width, height) of the current draw framebuffer. */
  void Copy(vtkOpenGLState* state, const std::array<int, 4>& viewport);

  /** Let a pixel of the stages that come be so many pixels wide and high, which the one in their
   * middle stands for. */
  void SetScale(int scale) { this->Scale = scale; }

  /** Samples of the framebuffer that was copied, at least 1. */
  int GetSamples() const { return this->Layout.Samples; }
  vtkIdType GetBytes() const;

  /** Bind the textures to texture units of their own, until Deactivate. */
  void Activate(vtkOpenGLState* state);
  void Deactivate(vtkOpenGLState* state);

  /** `#define`s for the shaders: the number of samples, and one step of the depth. */
  std::string GetShaderDefinitions() const;

  /** Set those uniforms of glsl/vtkOpaqueDepthDec.glsl that the program uses. */
  void SetUniforms(vtkShaderProgram* program) const;

  void Release();

private:
  struct Format
  {
    GLenum Color = 0;
    GLenum Depth = 0;
    int DepthBits = 0;
    bool DepthIsFloat = false;
    int Samples = 1;
    int Width = 0;
    int Height = 0;

    bool operator==(const Format& other) const;
    GLenum GetTarget() const
    {
      return this->Samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    }
  };
  enum Texture
  {
    ColorTexture,
    DepthTexture,
    NumberOfTextures
  };

  static Format GetFormat(const std::array<int, 4>& viewport);
  void Allocate(vtkOpenGLState* state);
  void AllocateTexture(
    vtkOpenGLState* state, Texture texture, GLenum internalFormat, GLenum attachment);

  Format Layout;
  std::array<int, 2> Origin{};
  int Scale = 1;
  GLuint Framebuffer = 0;
  std::array<GLuint, NumberOfTextures> Textures{};
  std::array<int, NumberOfTextures> Units{ -1, -1 };
};

VTK_ABI_NAMESPACE_END
#endif
