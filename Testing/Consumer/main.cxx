// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Two translucent spheres, one inside the other, and a renderer made exact with one call.
#include <vtkActor.h>
#include <vtkExactTransparencyPass.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTransparencyInstaller.h>
#include <vtkTransparencyStatistics.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkRenderer> renderer;
  for (double radius : { 1.0, 0.5 })
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(radius);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(0.5);
    renderer->AddActor(actor);
  }

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->AddRenderer(renderer);
  auto transparency = vtkTransparencyInstaller::Install(renderer);
  window->Render();

  const auto longestList = transparency->GetStatistics()->GetLongestList();
  std::cout << "Longest list: " << longestList << std::endl;
  return longestList == 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
