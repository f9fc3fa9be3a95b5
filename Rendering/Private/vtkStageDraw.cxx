// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkStageDraw.h"

#include "vtkFragmentStageVS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkSquarePoints.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkStageDraw::Draw(
  vtkOpenGLRenderWindow* window, const std::string& fragmentShader, const SetUniforms& setUniforms)
{
  this->Run(window, vtkFragmentStageVS, fragmentShader, setUniforms,
    [] { glDrawArrays(GL_TRIANGLES, 0, 3); });
}

//------------------------------------------------------------------------------
void vtkStageDraw::DrawPoints(vtkOpenGLRenderWindow* window, GLsizei points,
  const std::string& vertexShader, const std::string& fragmentShader,
  const SetUniforms& setUniforms)
{
  this->Run(window, vertexShader, fragmentShader, setUniforms,
    [points]
    {
      const vtkProgramPointSize pointSize;
      glDrawArrays(GL_POINTS, 0, points);
    });
}

//------------------------------------------------------------------------------
void vtkStageDraw::Run(vtkOpenGLRenderWindow* window, const std::string& vertexShader,
  const std::string& fragmentShader, const SetUniforms& setUniforms,
  const std::function<void()>& draw)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  vtkShaderProgram* program =
    cache->ReadyShaderProgram(vertexShader.c_str(), fragmentShader.c_str(), "", nullptr);
  if (!program)
  {
    return;
  }
  setUniforms(program);

  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglEnableDisable blendSaver(state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthSaver(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable cullSaver(state, GL_CULL_FACE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_CULL_FACE);

  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  draw();
  glBindVertexArray(0);
  cache->ReleaseCurrentShader();
}

//------------------------------------------------------------------------------
void vtkStageDraw::Release()
{
  glDeleteVertexArrays(1, &this->VertexArray);
  this->VertexArray = 0;
}

VTK_ABI_NAMESPACE_END
