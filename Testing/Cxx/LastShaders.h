// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LastShaders_h
#define LastShaders_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkRenderer.h"
#include "vtkShader.h"
#include "vtkShaderProgram.h"

#include <string>

/** The sources of the shaders that are the last to draw in a frame of a renderer. */
inline std::string GetLastShaders(vtkRenderer* renderer)
{
  std::string sources;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&sources);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* data, void*)
    {
      auto* window =
        static_cast<vtkOpenGLRenderWindow*>(vtkRenderer::SafeDownCast(caller)->GetRenderWindow());
      vtkShaderProgram* program = window->GetShaderCache()->GetLastShaderBound();
      *static_cast<std::string*>(data) = program
        ? program->GetVertexShader()->GetSource() + program->GetFragmentShader()->GetSource()
        : "";
    });
  const unsigned long tag = renderer->AddObserver(vtkCommand::EndEvent, command);
  renderer->GetRenderWindow()->Render();
  renderer->RemoveObserver(tag);
  return sources;
}

#endif
