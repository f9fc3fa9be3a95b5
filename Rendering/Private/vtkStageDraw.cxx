// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkStageDraw.h"

#include "vtkFragmentStageVS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

VTK_ABI_NAMESPACE_BEGIN

//------------------------------------------------------------------------------
void vtkStageDraw::Draw(vtkOpenGLRenderWindow* window, const std::string& fragmentShader,
  const std::function<void(vtkShaderProgram*)>& setUniforms)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  vtkShaderProgram* program =
    cache->ReadyShaderProgram(vtkFragmentStageVS, fragmentShader.c_str(), "", nullptr);
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
  glDrawArrays(GL_TRIANGLES, 0, 3);
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
