// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Hardware selection and picking of vtkTrajectoryMapper return the ids of the input: points, cells
// and blocks, for vertices, lines, polygons and strips in one data set and in composite data.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellPicker.h"
#include "vtkDataObject.h"
#include "vtkHardwareSelector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPropPicker.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrajectoryMapper.h"

#include <array>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace
{
constexpr double Radius = 0.2;

// What is expected at a place on the screen.
struct Probe
{
  std::array<double, 3> Place;
  vtkIdType Cell;
  vtkIdType Point; // -1: not tested
  unsigned int Block;
};

// Cells: 0 one vertex, 1 two vertices, 2 and 3 lines, 4 a triangle, 5 a quad, 6 a strip.
vtkSmartPointer<vtkPolyData> MakeData(double shift)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  const double coordinates[][3] = { { -4, 3, 0 }, { -2, 3, 0 }, { 0, 3, 0 }, { -4, 1, 0 },
    { -1, 1.5, 0 }, { -1, 1.5, 0 }, { 2, 1, 0 }, { -4, -1, 0 }, { 3, -1, 0 }, { -4, -3, 0 },
    { -2.5, -3, 0 }, { -4, -2, 0 }, { -2, -3, 0 }, { -1, -3, 0 }, { -1, -2, 0 }, { -2, -2, 0 },
    { 0, -3, 0 }, { 0, -2, 0 }, { 1, -3, 0 }, { 1, -2, 0 } };
  for (const auto& p : coordinates)
  {
    points->InsertNextPoint(p[0] + shift, p[1], p[2]);
  }
  data->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vertices->InsertNextCell({ 1, 2 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 3, 4, 5, 6 });
  lines->InsertNextCell({ 7, 8 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 9, 10, 11 });
  polygons->InsertNextCell({ 12, 13, 14, 15 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 16, 17, 18, 19 });
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  return data;
}

std::vector<Probe> MakeProbes(double shift, unsigned int block)
{
  std::vector<Probe> probes = { { { { -4, 3, 0 } }, 0, 0, block },
    { { { -2, 3, 0 } }, 1, 1, block }, { { { 0, 3.1, 0 } }, 1, 2, block },
    { { { -3.5, 1.1, 0 } }, 2, 3, block }, { { { -1.5, 1.45, 0 } }, 2, 4, block },
    { { { 0, 1.34, 0 } }, 2, 4, block }, { { { 1.5, 1.1, 0 } }, 2, 6, block },
    { { { -3, -1, 0 } }, 3, 7, block }, { { { 3, -0.9, 0 } }, 3, 8, block },
    { { { -3.7, -2.7, 0 } }, 4, -1, block }, { { { -1.5, -2.5, 0 } }, 5, -1, block },
    { { { 0.3, -2.7, 0 } }, 6, -1, block }, { { { -1.03, -2.03, 0 } }, -1, 14, block },
    { { { 0.93, -2.03, 0 } }, -1, 19, block } };
  for (Probe& probe : probes)
  {
    probe.Place[0] += shift;
  }
  return probes;
}

class Scene
{
public:
  explicit Scene(vtkDataObject* data)
  {
    this->Mapper->SetInputDataObject(data);
    this->Mapper->SetRadius(Radius);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(400, 200);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(4, 0, 30);
    camera->SetFocalPoint(4, 0, 0);
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
  }

  std::array<unsigned int, 2> GetPixel(const Probe& probe)
  {
    this->Renderer->SetWorldPoint(probe.Place[0], probe.Place[1], probe.Place[2], 1.0);
    this->Renderer->WorldToDisplay();
    const double* display = this->Renderer->GetDisplayPoint();
    return { { static_cast<unsigned int>(display[0]), static_cast<unsigned int>(display[1]) } };
  }

  bool CheckSelection(const std::vector<Probe>& probes, int association)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(0, 0, 399, 199);
    selector->SetFieldAssociation(association);
    selector->CaptureBuffers();
    const bool points = association == vtkDataObject::FIELD_ASSOCIATION_POINTS;
    bool right = true;
    for (const Probe& probe : probes)
    {
      const vtkIdType expected = points ? probe.Point : probe.Cell;
      const auto pixel = this->GetPixel(probe);
      const auto info = selector->GetPixelInformation(pixel.data());
      if (expected >= 0 &&
        !(info.Valid && info.Prop == this->Actor && info.AttributeID == expected &&
          info.CompositeID == probe.Block))
      {
        std::cout << "At " << probe.Place[0] << " " << probe.Place[1] << ": "
                  << (points ? "point " : "cell ") << info.AttributeID << " of block "
                  << info.CompositeID << ", expected " << expected << " of " << probe.Block << "\n";
        right = false;
      }
    }
    return right;
  }

  bool CheckPickers(const std::vector<Probe>& probes)
  {
    bool right = true;
    vtkNew<vtkCellPicker> cells;
    cells->SetTolerance(0.005);
    vtkNew<vtkPropPicker> props;
    for (const Probe& probe : probes)
    {
      const auto pixel = this->GetPixel(probe);
      if (!props->Pick(pixel[0], pixel[1], 0.0, this->Renderer) || props->GetActor() != this->Actor)
      {
        std::cout << "No prop picked at " << probe.Place[0] << " " << probe.Place[1] << "\n";
        right = false;
      }
      if (probe.Cell == 5 &&
        (!cells->Pick(pixel[0], pixel[1], 0.0, this->Renderer) || cells->GetCellId() != probe.Cell))
      {
        std::cout << "Cell " << cells->GetCellId() << " picked, expected " << probe.Cell << "\n";
        right = false;
      }
    }
    return right;
  }

private:
  vtkNew<vtkTrajectoryMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};
}

int TestTrajectoryMapperSelection(int, char*[])
{
  bool right = true;
  const auto check = [&right](vtkDataObject* data, const std::vector<Probe>& probes)
  {
    Scene scene(data);
    right = scene.CheckSelection(probes, vtkDataObject::FIELD_ASSOCIATION_CELLS) && right;
    right = scene.CheckSelection(probes, vtkDataObject::FIELD_ASSOCIATION_POINTS) && right;
    right = scene.CheckPickers(probes) && right;
  };
  check(MakeData(0.0), MakeProbes(0.0, 1));

  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeData(0.0));
  blocks->SetBlock(1, vtkNew<vtkPolyData>());
  blocks->SetBlock(3, MakeData(8.0));
  std::vector<Probe> probes = MakeProbes(0.0, 1);
  const std::vector<Probe> others = MakeProbes(8.0, 4);
  probes.insert(probes.end(), others.begin(), others.end());
  check(blocks, probes);
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
