// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws the whole viewport, or point sprites in it, with a fragment shader of ours: how every stage
 * that works on pixels, or on elements of a buffer, runs. Needs a current OpenGL 4.3 context.
 */

#ifndef vtkStageDraw_h
#define vtkStageDraw_h

#include "vtkOpenGLError.h" // for OpenGL itself, through the loader that this VTK uses

#include <functional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkStageDraw
{
public:
  vtkStageDraw() = default;
  ~vtkStageDraw() = default;
  vtkStageDraw(const vtkStageDraw&) = delete;
  void operator=(const vtkStageDraw&) = delete;

  using SetUniforms = std::function<void(vtkShaderProgram*)>;

  ///@{
  /**
   * Draw one triangle over the viewport, or as many point sprites as `vertexShader` places by their
   * gl_VertexID, without blending, depth test and culling. Viewport, scissor and framebuffer are
   * those of the caller; a shader that does not compile is VTK's error, and draws nothing.
   */
  void Draw(vtkOpenGLRenderWindow* window, const std::string& fragmentShader,
    const SetUniforms& setUniforms);
  void DrawPoints(vtkOpenGLRenderWindow* window, GLsizei points, const std::string& vertexShader,
    const std::string& fragmentShader, const SetUniforms& setUniforms);
  ///@}

  void Release();

private:
  void Run(vtkOpenGLRenderWindow* window, const std::string& vertexShader,
    const std::string& fragmentShader, const SetUniforms& setUniforms,
    const std::function<void()>& draw);

  GLuint VertexArray = 0;
};

VTK_ABI_NAMESPACE_END
#endif
