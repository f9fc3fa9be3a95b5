// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The lines of a trajectory file counted; then two translucent spheres, one inside the other, and a
// renderer made exact with one call.
#include <vtkActor.h>
#include <vtkExactTransparencyPass.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkTrajectoryReader.h>
#include <vtkTrajectoryReaderFactory.h>
#include <vtkTransparencyInstaller.h>
#include <vtkTransparencyStatistics.h>

#include <cstdlib>
#include <iostream>

namespace
{
vtkIdType CountLines(const char* fileName)
{
  auto reader = vtk::TakeSmartPointer(vtkTrajectoryReaderFactory::CreateReader(fileName));
  if (!reader)
  {
    return 0;
  }
  reader->Update();
  return reader->GetOutput()->GetNumberOfLines();
}

vtkIdType DrawSpheres()
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

  return transparency->GetStatistics()->GetLongestList();
}
}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "Usage: consumer FILE, a file of trajectories" << std::endl;
    return EXIT_FAILURE;
  }
  const vtkIdType lines = CountLines(argv[1]);
  const vtkIdType longestList = DrawSpheres();
  std::cout << "Lines: " << lines << ", longest list: " << longestList << std::endl;
  return lines > 0 && longestList == 4 ? EXIT_SUCCESS : EXIT_FAILURE;
}
