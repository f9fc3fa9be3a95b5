// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LayerStack_h
#define LayerStack_h

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

/**
 * A stack of unlit squares that cover the view of a parallel camera, and what must be seen of it.
 * Each layer has the opacity of the whole and a colour of its own.
 */
class LayerStack
{
public:
  LayerStack(int layers, double opacity)
    : Opacity(opacity)
    , Colors(layers)
  {
    std::mt19937 random(layers);
    std::uniform_int_distribution<int> byte(0, 255);
    for (auto& color : this->Colors)
    {
      color = { byte(random), byte(random), byte(random) };
    }
  }

  /// Layers in random order; depth 0 of layer 0 is the nearest.
  vtkSmartPointer<vtkActor> MakeActor(unsigned int shuffleSeed) const
  {
    const int layers = static_cast<int>(this->Colors.size());
    std::vector<int> order(layers);
    for (int i = 0; i < layers; ++i)
    {
      order[i] = i;
    }
    std::shuffle(order.begin(), order.end(), std::mt19937(shuffleSeed));

    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> squares;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (int layer : order)
    {
      const double z = -static_cast<double>(layer) / layers;
      const vtkIdType first = points->InsertNextPoint(-2, -2, z);
      points->InsertNextPoint(2, -2, z);
      points->InsertNextPoint(2, 2, z);
      points->InsertNextPoint(-2, 2, z);
      squares->InsertNextCell({ first, first + 1, first + 2, first + 3 });
      colors->InsertNextTuple3(
        this->Colors[layer][0], this->Colors[layer][1], this->Colors[layer][2]);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(squares);
    data->GetCellData()->SetScalars(colors);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetOpacity(this->Opacity);
    return actor;
  }

  static void SetCamera(vtkRenderer* renderer)
  {
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetPosition(0, 0, 1);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(0.5, 2.5);
  }

  /// Front-to-back compositing over a background, in double precision, 0..255.
  std::array<double, 3> GetColor(const std::array<double, 3>& background) const
  {
    std::array<double, 3> color{};
    double transmittance = 1.0;
    for (const auto& layer : this->Colors)
    {
      for (int i = 0; i < 3; ++i)
      {
        color[i] += transmittance * this->Opacity * layer[i];
      }
      transmittance *= 1.0 - this->Opacity;
    }
    for (int i = 0; i < 3; ++i)
    {
      color[i] += transmittance * background[i];
    }
    return color;
  }

private:
  double Opacity;
  std::vector<std::array<int, 3>> Colors;
};

#endif
