// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The streamlines of the combustor, coloured by speed, between lit surfaces of it: the picture is
// the reference's, and the baseline.
#include "OpenGLDebugOutput.h"
#include "ReferenceComparison.h"

#include "vtkActor.h"
#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataReader.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTestUtilities.h"
#include "vtkTesting.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTransparencyInstaller.h"

#include <memory>

int TestStreamlinesPicture(int argc, char* argv[])
{
  const std::unique_ptr<char[]> fileName(
    vtkTestUtilities::ExpandDataFileName(argc, argv, "combustor-lines.vtk"));
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName(fileName.get());
  reader->Update();
  vtkDataArray* velocity = reader->GetOutput()->GetPointData()->GetArray("Velocity");
  if (!Check(velocity, "Data/combustor-lines.vtk has no array Velocity"))
  {
    return EXIT_FAILURE;
  }

  vtkNew<vtkLookupTable> speedColors;
  speedColors->SetVectorModeToMagnitude();
  speedColors->SetHueRange(0.6, 0.0);
  vtkNew<vtkTrajectoryMapper> tubes;
  tubes->SetInputConnection(reader->GetOutputPort());
  tubes->SetRadius(0.08);
  tubes->SetLookupTable(speedColors);
  tubes->SetScalarModeToUsePointFieldData();
  tubes->SelectColorArray("Velocity");
  tubes->SetScalarRange(velocity->GetRange(-1));
  vtkNew<vtkActor> lines;
  lines->SetMapper(tubes);
  lines->GetProperty()->SetOpacity(0.4);

  vtkNew<vtkCubeSource> bounds;
  bounds->SetBounds(reader->GetOutput()->GetBounds());
  vtkNew<vtkPolyDataMapper> faces;
  faces->SetInputConnection(bounds->GetOutputPort());
  vtkNew<vtkActor> box;
  box->SetMapper(faces);
  box->GetProperty()->SetOpacity(0.15);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(lines);
  renderer->AddActor(box);
  renderer->SetBackground(0.0, 0.0, 0.2);
  renderer->GetActiveCamera()->SetPosition(-0.6, -1.0, 0.4);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  window->AddRenderer(renderer);

  OpenGLDebugOutput debugOutput(window);
  vtkTransparencyInstaller::Install(renderer);
  const bool exact = ReferenceComparison(window, renderer).Passes("streamlines");
  const bool unchanged = vtkTesting::Test(argc, argv, window, 1.0) == vtkTesting::PASSED;
  return exact && unchanged ? EXIT_SUCCESS : EXIT_FAILURE;
}
