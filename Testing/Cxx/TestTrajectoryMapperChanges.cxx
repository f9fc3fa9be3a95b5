// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// A mapper that several actors share, that is deleted while another window is current, that is
// given a radius array of vectors, or blocks that move within their tree, or whose actor or block
// gets another look.
#include "LastShaders.h"
#include "Picture.h"
#include "SphereScene.h"

#include "vtkCompositeDataDisplayAttributes.h"
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

// Shaders leave out what has no effect; a later change brings it back.
bool TestEffectsThatComeLater()
{
  const auto render = [](bool shinyFirst, bool shiny, bool blockFirst, bool block)
  {
    SphereScene scene(100, 80, 0, 0, 0);
    vtkNew<vtkMultiBlockDataSet> blocks;
    blocks->SetBlock(0, MakeLine());
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    vtkNew<vtkTrajectoryMapper> mapper;
    mapper->SetInputDataObject(blocks);
    mapper->SetRadius(0.2);
    mapper->SetCompositeDataDisplayAttributes(attributes);
    vtkActor* actor = AddActor(scene, mapper, 0.0, 1.0);
    actor->GetProperty()->LightingOn();
    actor->GetProperty()->SetOpacity(0.5);
    const auto display = [&](bool isShiny, bool isBlue)
    {
      actor->GetProperty()->SetSpecular(isShiny ? 0.8 : 0.0);
      attributes->RemoveBlockColors();
      if (isBlue)
      {
        const double blue[] = { 0.0, 0.0, 1.0 };
        attributes->SetBlockColor(blocks->GetBlock(0), blue);
      }
      mapper->Modified();
      return Picture::Render(scene.Window);
    };
    display(shinyFirst, blockFirst);
    return display(shiny, block);
  };
  const Picture plain = render(false, false, false, false);
  const Picture shiny = render(true, true, false, false);
  const Picture blue = render(false, false, true, true);
  bool passed = Check(!(shiny == plain) && !(blue == plain), "an effect cannot be seen");
  passed &= Check(render(false, true, false, false) == shiny, "specular light did not come");
  passed &= Check(render(true, false, false, false) == plain, "specular light did not go");
  passed &= Check(render(false, false, false, true) == blue, "a block's colour did not come");
  passed &= Check(render(false, false, true, false) == plain, "a block's colour did not go");
  return passed;
}

// Mesa's software renderer would compute the highlights of a specular coefficient of 0.
bool TestNoCostWithoutHighlights()
{
  SphereScene scene(100, 80, 0, 0, 0);
  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputDataObject(MakeLine());
  vtkProperty* property = AddActor(scene, mapper, 0.0, 1.0)->GetProperty();
  property->LightingOn();
  const auto declares = [&](const char* qualifier)
  {
    return GetLastShaders(scene.Renderer)
             .find(qualifier + std::string(" float specularIntensity")) != std::string::npos;
  };
  bool passed = Check(declares("const"), "shaders compute highlights that nothing has");
  property->SetSpecular(0.3);
  passed &= Check(declares("uniform"), "shaders have no highlights");
  return passed;
}

// Two actors of one mapper, one of them shiny, look as with mappers of their own.
bool TestShinyActorOfSharedMapper()
{
  const auto render = [](bool shared)
  {
    SphereScene scene(100, 80, 0, 0, 0);
    vtkNew<vtkTrajectoryMapper> mappers[2];
    for (int i = 0; i < 2; ++i)
    {
      mappers[i]->SetInputDataObject(MakeLine());
      mappers[i]->SetRadius(0.2);
      vtkProperty* property = AddActor(scene, mappers[shared ? 0 : i], i - 0.5, 1.0)->GetProperty();
      property->LightingOn();
      property->SetSpecular(i == 0 ? 0.8 : 0.0);
    }
    Picture::Render(scene.Window);
    return Picture::Render(scene.Window);
  };
  return Check(render(true) == render(false), "a shared mapper mixes up specular light");
}
}

int TestTrajectoryMapperChanges(int, char*[])
{
  bool passed = TestSharedMapper();
  passed &= TestDeletedInAnotherWindow();
  passed &= TestVectorsAsRadii();
  passed &= TestMovedBlock();
  passed &= TestEffectsThatComeLater();
  passed &= TestNoCostWithoutHighlights();
  passed &= TestShinyActorOfSharedMapper();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
