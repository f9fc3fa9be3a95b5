// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// A whole application: translucent lines in the right order, in a window, or in a picture.
//   translucent-lines FILE.vtk [--importance ARRAY] [--output PICTURE.png]
#include <vtkActor.h>
#include <vtkImportance.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkOpacityOptimization.h>
#include <vtkPNGWriter.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTrajectoryMapper.h>
#include <vtkTrajectorySegments.h>
#include <vtkTransparencyInstaller.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

int main(int argc, char* argv[])
{
  std::map<std::string, std::string> options = { { "--importance", "" }, { "--output", "" } };
  int next = 2;
  for (; next + 1 < argc && options.count(argv[next]) == 1; next += 2)
  {
    options[argv[next]] = argv[next + 1];
  }
  if (argc < 2 || next < argc)
  {
    std::cerr << "Usage: translucent-lines FILE.vtk [--importance ARRAY] [--output PICTURE.png]\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  if (reader->GetOutput()->GetNumberOfLines() == 0)
  {
    std::cerr << argv[1] << ": expected a legacy VTK file of poly data with lines\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkTrajectoryMapper> mapper; // lines as tubes, ray-cast; any mapper of VTK works too
  mapper->SetInputConnection(reader->GetOutputPort());
  mapper->SetScalarRange(reader->GetOutput()->GetScalarRange()); // of the active array, in colours
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(options["--importance"].empty() ? 0.4 : 1.0);
  // Optional: what hides the larger values of an array fades, found anew for every view.
  vtkNew<vtkImportance> importance;
  vtkNew<vtkTrajectorySegments> segments;
  vtkNew<vtkOpacityOptimization> optimization;
  if (!options["--importance"].empty())
  {
    importance->SetInputConnection(reader->GetOutputPort());
    importance->AddCriterion(options["--importance"].c_str(), 50, 99, 1, true, true); // percentiles
    segments->SetInputConnection(importance->GetOutputPort());
    segments->Update();
    if (segments->GetTotalNumberOfSegments() == 0)
    {
      return EXIT_FAILURE; // vtkImportance has said why
    }
    mapper->SetInputConnection(segments->GetOutputPort());
    vtkImportanceDrivenOpacity::Attach(actor, optimization);
  }
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->SetBackground(1, 1, 1);
  vtkTransparencyInstaller::Install(renderer); // the one call that makes the renderer exact
  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 480);
  window->SetOffScreenRendering(!options["--output"].empty());
  window->AddRenderer(renderer);
  window->Render();
  if (options["--output"].empty())
  {
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    interactor->SetInteractorStyle(vtkNew<vtkInteractorStyleTrackballCamera>());
    interactor->Start();
    return EXIT_SUCCESS;
  }
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(options["--output"].c_str());
  vtkObject::GlobalWarningDisplayOff(); // VTK calls every failure a full disk
  writer->Write();
  const bool isWritten = writer->GetErrorCode() == 0;
  std::cerr << (isWritten ? "" : options["--output"] + ": cannot be written\n");
  return isWritten ? EXIT_SUCCESS : EXIT_FAILURE;
}
