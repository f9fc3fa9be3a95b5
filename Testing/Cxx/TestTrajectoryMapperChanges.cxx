// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// A mapper that several actors share, that is deleted while another window is current, that is
// given a radius array of vectors, or blocks that move within their tree.
#include "Picture.h"
#include "SphereScene.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTestErrorObserver.h"
#include "vtkTrajectoryMapper.h"

namespace
{
vtkSmartPointer<vtkPolyData> MakeLine()
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-1.5, 0.0, 0.0);
  line->SetPoint2(1.5, 0.0, 0.0);
  line->Update();
  return line->GetOutput();
}

vtkSmartPointer<vtkActor> AddActor(SphereScene& scene, vtkMapper* mapper, double y, double red)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetPosition(0.0, y, 0.0);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(red, 1.0 - red, 0.0);
  scene.Renderer->AddActor(actor);
  return actor;
}

int CountColor(const Picture& picture, int red, int green)
{
  int count = 0;
  for (std::size_t i = 0; i < picture.Rgba.size(); i += 4)
  {
    count += picture.Rgba[i] == red && picture.Rgba[i + 1] == green && picture.Rgba[i + 2] == 0;
  }
  return count;
}

// Composite data of which one leaf lacks scalars: that one takes the colour of each actor.
bool TestSharedMapper()
{
  SphereScene scene(200, 150, 0, 0, 0);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkTrajectoryMapper> mapper;
  blocks->SetBlock(0, MakeLine());
  mapper->SetInputDataObject(blocks);
  mapper->SetRadius(0.2);
  AddActor(scene, mapper, -0.5, 1.0);
  AddActor(scene, mapper, 0.5, 0.0);
  mapper->Modified();
  const Picture picture = Picture::Render(scene.Window);
  bool passed = Check(CountColor(picture, 255, 0) > 300, "the first actor lacks its colour");
  passed &= Check(CountColor(picture, 0, 255) > 300, "the second actor lacks its colour");
  return passed;
}

bool TestDeletedInAnotherWindow()
{
  SphereScene first(100, 80, 0, 0, 0);
  SphereScene second(100, 80, 0, 0, 3);
  Picture expected;
  {
    vtkNew<vtkTrajectoryMapper> mapper;
    mapper->SetInputDataObject(MakeLine());
    vtkSmartPointer<vtkActor> actor = AddActor(first, mapper, 0.0, 1.0);
    Picture::Render(first.Window);
    expected = Picture::Render(second.Window);
    actor->SetMapper(nullptr);
  }
  return Check(Picture::Render(second.Window) == expected, "another window lost its buffers");
}

bool TestVectorsAsRadii()
{
  SphereScene scene(100, 80, 0, 0, 0);
  vtkSmartPointer<vtkPolyData> line = MakeLine();
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(line->GetNumberOfPoints());
  vectors->Fill(5.0);
  line->GetPointData()->AddArray(vectors);
  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputDataObject(line);
  mapper->SetRadius(0.2);
  AddActor(scene, mapper, 0.0, 1.0);
  const Picture expected = Picture::Render(scene.Window);
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::WarningEvent, observer);
  mapper->SetRadiusArray("Vectors");
  bool passed = Check(Picture::Render(scene.Window) == expected, "vectors change the radius");
  passed &= Check(
    observer->GetWarning() && observer->GetWarningMessage().find("'Vectors'") != std::string::npos,
    "no warning names the radius array");
  return passed;
}

unsigned int SelectBlock(SphereScene& scene)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(0, 0, 99, 79);
  const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  return selection->GetNumberOfNodes() == 1
    ? selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::COMPOSITE_INDEX())
    : 0;
}

bool TestMovedBlock()
{
  SphereScene scene(100, 80, 0, 0, 0);
  const vtkSmartPointer<vtkPolyData> line = MakeLine();
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, line);
  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetRadius(0.2);
  AddActor(scene, mapper, 0.0, 1.0);
  Picture::Render(scene.Window);
  bool passed = Check(SelectBlock(scene) == 1, "the first block is not number 1");
  blocks->SetBlock(0, nullptr);
  blocks->SetBlock(4, line);
  Picture::Render(scene.Window);
  passed &= Check(SelectBlock(scene) == 5, "the fifth block is not number 5");
  return passed;
}
}

int TestTrajectoryMapperChanges(int, char*[])
{
  bool passed = TestSharedMapper();
  passed &= TestDeletedInAnotherWindow();
  passed &= TestVectorsAsRadii();
  passed &= TestMovedBlock();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
