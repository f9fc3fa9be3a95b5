// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HelixScene_h
#define HelixScene_h

#include "OpenGLDebugOutput.h"
#include "ReferenceComparison.h"
#include "SphereScene.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTransparencyInstaller.h"

#include <algorithm>
#include <numeric>
#include <random>

/** Helices about tilted axes, coloured along the line, and a ball for every line's first point. */
inline vtkSmartPointer<vtkPolyData> MakeLines(
  int lines, int pointsPerLine, unsigned int shuffleSeed)
{
  std::vector<int> order(lines);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937(shuffleSeed));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("Value");
  vtkNew<vtkDoubleArray> radii;
  radii->SetName("Radius");
  for (const int line : order)
  {
    cells->InsertNextCell(pointsPerLine);
    for (int i = 0; i < pointsPerLine; ++i)
    {
      const double t = static_cast<double>(i) / (pointsPerLine - 1);
      const double angle = 9.0 * t + line;
      const double turn = 0.4 + 0.3 * std::sin(1.3 * line);
      const vtkIdType point = points->InsertNextPoint(3.0 * (t - 0.5) + 0.3 * std::sin(5.1 * line),
        turn * std::cos(angle) + 0.8 * std::sin(2.2 * line),
        turn * std::sin(angle) + 0.8 * std::cos(3.7 * line));
      cells->InsertCellPoint(point);
      scalars->InsertNextValue(std::sin(7.0 * t + line));
      radii->InsertNextValue(0.03 + 0.025 * std::sin(20.0 * t + line));
      if (i == 0)
      {
        vertices->InsertNextCell({ point });
      }
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->SetLines(cells);
  data->GetPointData()->SetScalars(scalars);
  data->GetPointData()->AddArray(radii);
  return data;
}

inline vtkActor* AddLines(SphereScene& scene, vtkPolyData* data, double radius, double opacity)
{
  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputDataObject(data);
  mapper->SetRadius(radius);
  mapper->SetScalarRange(-1.0, 1.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(opacity);
  scene.Renderer->AddActor(actor);
  return actor;
}

/** Does the exact picture show what the reference shows? */
inline bool Compare(SphereScene& scene, const std::string& name)
{
  OpenGLDebugOutput debugOutput(scene.Window);
  vtkTransparencyInstaller::Install(scene.Renderer);
  scene.Window->Render();
  return ReferenceComparison(scene.Window, scene.Renderer).Passes(name);
}

#endif
