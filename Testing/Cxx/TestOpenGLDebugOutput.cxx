// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The guard itself: a wrong OpenGL call reaches OpenGLDebugOutput, a right frame leaves it silent.
#include "OpenGLDebugOutput.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtksys/SystemTools.hxx"

#include <iostream>

int TestOpenGLDebugOutput(int, char*[])
{
  // The wrong call below is wanted; Mesa need not complain about it on its own.
  vtksys::SystemTools::PutEnv("MESA_DEBUG=silent");

  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(0.5);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(64, 64);
  window->AddRenderer(renderer);

  OpenGLDebugOutput debugOutput(window);
  window->Render();
  if (debugOutput.GetNumberOfMessages() != 0)
  {
    std::cerr << "ERROR: VTK's own frame is not silent" << std::endl;
    return EXIT_FAILURE;
  }

  debugOutput.SetQuiet(true);
  glBindTexture(GL_ARRAY_BUFFER, 0);
  if (debugOutput.GetNumberOfMessages() == 0)
  {
    std::cerr << "ERROR: a wrong call went unnoticed" << std::endl;
    return EXIT_FAILURE;
  }
  while (glGetError() != GL_NO_ERROR)
  {
  }
  return EXIT_SUCCESS;
}
