// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SphereScene_h
#define SphereScene_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkConeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <cmath>

/** Overlapping lit spheres, translucent but for the opaque ones, in one off-screen window. */
struct SphereScene
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;

  SphereScene(int width, int height, int samples, int translucentSpheres, int opaqueSpheres)
  {
    this->Window->SetMultiSamples(samples);
    this->Window->SetSize(width, height);
    this->Window->OffScreenRenderingOn();
    this->Window->AddRenderer(this->Renderer);
    // Colours that 8 bits hold exactly, so that the background adds no rounding of its own.
    this->Renderer->SetBackground(0.8, 0.6, 1.0);
    for (int i = 0; i < translucentSpheres; ++i)
    {
      this->AddSphere(i, 0.1 + 0.05 * (i % 8));
    }
    for (int i = 0; i < opaqueSpheres; ++i)
    {
      this->AddSphere(7 * i + 3, 1.0);
    }
    this->Renderer->ResetCamera(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
  }

  vtkActor* AddSphere(int number, double opacity)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.5);
    sphere->SetCenter(
      1.2 * std::sin(1.7 * number), 1.2 * std::cos(2.3 * number), std::sin(3.1 * number));
    sphere->SetThetaResolution(24);
    sphere->SetPhiResolution(16);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.5 + 0.5 * std::sin(number), 0.5 + 0.5 * std::sin(2.0 * number),
      0.5 + 0.5 * std::cos(3.0 * number));
    actor->GetProperty()->SetOpacity(opacity);
    this->Renderer->AddActor(actor);
    return actor;
  }

  /// An opaque sphere, of a colour that 8 bits hold exactly, and a translucent one in the same
  /// place fill the view and the depths.
  void AddCoatedSphere()
  {
    this->AddSphere(0, 0.5);
    vtkProperty* opaque = this->AddSphere(0, 1.0)->GetProperty();
    opaque->SetColor(1.0, 0.0, 0.0);
    opaque->LightingOff();
    this->Renderer->ResetCamera();
  }

  /// Translucent cones on a slanted grid through the spheres.
  void AddGlyphs()
  {
    vtkNew<vtkPlaneSource> grid;
    grid->SetOrigin(-1.5, -1.5, 0.3);
    grid->SetPoint1(1.5, -1.5, 0.6);
    grid->SetPoint2(-1.5, 1.5, -0.4);
    grid->SetResolution(5, 5);
    vtkNew<vtkConeSource> cone;
    cone->SetHeight(0.5);
    cone->SetRadius(0.2);
    cone->SetResolution(12);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputConnection(grid->GetOutputPort());
    mapper->SetSourceConnection(cone->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.1, 0.7, 0.4);
    actor->GetProperty()->SetOpacity(0.35);
    this->Renderer->AddActor(actor);
  }
};

#endif
