// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Unlit colours of vtkTrajectoryMapper where VTK's lookup tables say what they have to be.

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrajectoryMapper.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>

namespace
{
using Color = std::array<double, 3>;

// A vertex at x = -3, a line from x = -2 to 2, a triangle around x = 3; y shifts it.
vtkSmartPointer<vtkPolyData> MakeData(double y)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  const double coordinates[][2] = { { -3, 0 }, { -2, 0 }, { 0, 0 }, { 2, 0 }, { 2.5, -0.4 },
    { 3.5, -0.4 }, { 3, 0.6 } };
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("scalars");
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> bytes;
  bytes->SetName("bytes");
  bytes->SetNumberOfComponents(4);
  for (int i = 0; i < 7; ++i)
  {
    points->InsertNextPoint(coordinates[i][0], coordinates[i][1] + y, 0.0);
    scalars->InsertNextValue(i == 0 ? vtkMath::Nan() : i < 4 ? i - 1.0 : 1.0);
    vectors->InsertNextTuple3(0.0, i < 4 ? i - 1.0 : 1.0, 0.0);
    const unsigned char byte = static_cast<unsigned char>(40 * i);
    const unsigned char color[] = { byte, static_cast<unsigned char>(255 - byte), 128, 255 };
    bytes->InsertNextTypedTuple(color);
  }
  data->SetPoints(points);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 1, 2, 3 });
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 4, 5, 6 });
  data->SetVerts(vertices);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->GetPointData()->AddArray(scalars);
  data->GetPointData()->AddArray(vectors);
  data->GetPointData()->AddArray(bytes);
  vtkNew<vtkDoubleArray> cells;
  cells->SetName("cells");
  cells->InsertNextValue(0.0);
  cells->InsertNextValue(1.0);
  cells->InsertNextValue(2.0);
  data->GetCellData()->AddArray(cells);
  return data;
}

class Scene
{
public:
  explicit Scene(vtkDataObject* data)
  {
    this->Table->SetNumberOfTableValues(3);
    this->Table->SetTableValue(0, 1.0, 0.0, 0.0);
    this->Table->SetTableValue(1, 0.0, 1.0, 0.0);
    this->Table->SetTableValue(2, 0.0, 0.0, 1.0);
    this->Table->SetNanColor(0.6, 0.2, 0.6, 1.0);
    this->Mapper->SetInputDataObject(data);
    this->Mapper->SetRadius(0.3);
    this->Mapper->SetLookupTable(this->Table);
    this->Mapper->SetScalarRange(0.0, 2.0);
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Actor->GetProperty()->SetColor(0.2, 0.4, 0.8);
    this->Renderer->AddActor(this->Actor);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(300, 200);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->GetActiveCamera()->SetPosition(0, 0, 14);
    this->Renderer->ResetCameraClippingRange();
  }

  void Use(int mode, const char* array, int component = -1)
  {
    this->Mapper->SetScalarMode(mode);
    this->Mapper->ColorByArrayComponent(array, component);
  }

  bool Check(const std::string& name, double x, double y, const Color& expected)
  {
    this->Window->Render();
    this->Renderer->SetWorldPoint(x, y, 0.0, 1.0);
    this->Renderer->WorldToDisplay();
    const double* display = this->Renderer->GetDisplayPoint();
    const int pixel[] = { static_cast<int>(display[0]), static_cast<int>(display[1]) };
    vtkNew<vtkUnsignedCharArray> found;
    this->Window->GetPixelData(pixel[0], pixel[1], pixel[0], pixel[1], 0, found);
    bool right = true;
    for (int i = 0; i < 3; ++i)
    {
      right = right && std::abs(found->GetValue(i) - 255.0 * expected[i]) < 6.0;
    }
    if (!right)
    {
      std::cout << name << " at " << x << ": " << int(found->GetValue(0)) << " "
                << int(found->GetValue(1)) << " " << int(found->GetValue(2)) << ", expected "
                << 255 * expected[0] << " " << 255 * expected[1] << " " << 255 * expected[2]
                << "\n";
    }
    return right;
  }

  vtkNew<vtkLookupTable> Table;
  vtkNew<vtkTrajectoryMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};
}

int TestTrajectoryMapperColors(int, char*[])
{
  const Color plain{ { 0.2, 0.4, 0.8 } };
  const Color nan{ { 0.6, 0.2, 0.6 } };
  const Color red{ { 1, 0, 0 } };
  const Color green{ { 0, 1, 0 } };
  const Color blue{ { 0, 0, 1 } };
  bool right = true;
  const auto check = [&right](bool result) { right = result && right; };

  Scene scene(MakeData(0.0));
  scene.Mapper->ScalarVisibilityOff();
  check(scene.Check("property", -3.0, 0.0, plain));
  check(scene.Check("property", 3.0, 0.0, plain));
  scene.Actor->GetProperty()->SetColor(0.8, 0.4, 0.2);
  check(scene.Check("changed property", 1.0, 0.0, { { 0.8, 0.4, 0.2 } }));

  scene.Mapper->ScalarVisibilityOn();
  scene.Use(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "scalars");
  check(scene.Check("point scalars", -3.0, 0.0, nan));
  check(scene.Check("point scalars", -2.0, 0.0, red));
  check(scene.Check("point scalars", -1.0, 0.0, { { 0.5, 0.5, 0.0 } }));
  check(scene.Check("point scalars", 0.5, 0.0, { { 0.0, 0.75, 0.25 } }));
  check(scene.Check("point scalars", 2.1, 0.0, blue));
  check(scene.Check("point scalars", 3.0, 0.0, green));

  scene.Mapper->InterpolateScalarsBeforeMappingOn();
  check(scene.Check("interpolated scalars", -3.0, 0.0, nan));
  check(scene.Check("interpolated scalars", -1.6, 0.0, red));
  check(scene.Check("interpolated scalars", 0.3, 0.0, green));
  check(scene.Check("interpolated scalars", 1.9, 0.0, blue));
  check(scene.Check("interpolated scalars", 3.0, 0.0, green));
  scene.Mapper->InterpolateScalarsBeforeMappingOff();

  scene.Use(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "vectors", 1);
  check(scene.Check("component", -2.0, 0.0, red));
  check(scene.Check("component", 2.0, 0.0, blue));
  scene.Use(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "vectors", 0);
  check(scene.Check("other component", 2.0, 0.0, red));

  scene.Use(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "bytes");
  scene.Mapper->SetColorModeToDirectScalars();
  check(scene.Check("direct colors", -2.0, 0.0, { { 40 / 255.0, 215 / 255.0, 128 / 255.0 } }));
  check(scene.Check("direct colors", 1.0, 0.0, { { 100 / 255.0, 155 / 255.0, 128 / 255.0 } }));
  scene.Mapper->SetColorModeToDefault();

  scene.Use(VTK_SCALAR_MODE_USE_CELL_FIELD_DATA, "cells");
  check(scene.Check("cell scalars", -3.0, 0.0, red));
  check(scene.Check("cell scalars", -1.0, 0.0, green));
  check(scene.Check("cell scalars", 2.0, 0.0, green));
  check(scene.Check("cell scalars", 3.0, 0.0, blue));
  check(!scene.Actor->HasTranslucentPolygonalGeometry());
  scene.Table->SetTableValue(1, 0.0, 1.0, 0.0, 0.5);
  check(scene.Actor->HasTranslucentPolygonalGeometry());
  check(scene.Check("translucent cells", -1.0, 0.0, { { 0.0, 0.5, 0.0 } }));
  scene.Table->SetTableValue(1, 0.0, 1.0, 0.0, 0.0);
  check(scene.Check("invisible cells", -1.0, 0.0, { { 0.0, 0.0, 0.0 } }));
  scene.Table->SetTableValue(1, 0.0, 1.0, 0.0, 1.0);
  scene.Actor->GetProperty()->SetOpacity(0.5);
  check(scene.Check("translucent actor", 0.5, 0.0, { { 0.0, 0.5, 0.0 } }));
  check(scene.Check("translucent actor", 3.0, 0.0, { { 0.0, 0.0, 0.5 } }));
  check(!scene.Actor->HasOpaqueGeometry());

  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto bare = MakeData(2.0);
  bare->GetPointData()->RemoveArray("scalars");
  blocks->SetBlock(0, MakeData(0.0));
  blocks->SetBlock(1, bare);
  blocks->SetBlock(2, vtkNew<vtkPolyData>());
  Scene composite(blocks);
  composite.Use(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA, "scalars");
  check(composite.Check("block with array", -2.0, 0.0, red));
  check(composite.Check("block with array", 3.0, 0.0, green));
  check(composite.Check("block without array", -2.0, 2.0, plain));
  check(composite.Check("block without array", 3.0, 2.0, plain));
  composite.Actor->GetProperty()->SetColor(0.8, 0.4, 0.2);
  check(composite.Check("changed property", -2.0, 2.0, { { 0.8, 0.4, 0.2 } }));

  Scene empty(vtkNew<vtkPolyData>{});
  check(empty.Check("empty", 0.0, 0.0, { { 0, 0, 0 } }));
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
