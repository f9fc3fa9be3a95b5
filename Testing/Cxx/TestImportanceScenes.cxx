// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Importance keeps to the actors that have it: whatever shares their mappers, is drawn beside them
// with edges, wide lines or impostors, or cannot bring importances, looks as without. What is wrong
// is said once. The locale of the process makes no difference.
#include "SegmentedScene.h"

#include "vtkCallbackCommand.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkMultiBlockDataSet.h"

#include "FrameStages.h"
#include <clocale>
#include <locale>
#include <set>

namespace
{
/** An important sphere within the others, and what the pass warns of. */
class Scene : public SphereScene
{
public:
  Scene()
    : SphereScene(90, 70, 0, 0, 0)
  {
    this->Core = AddSurface<vtkPolyDataMapper>(*this, MakeSegmentedSphere(0.7, Wave), 0.9);
    vtkOpacityOptimization::Attach(this->Core, this->Optimization);
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(&this->Warnings);
    observer->SetCallback([](vtkObject*, unsigned long, void* warnings, void* text)
      { static_cast<std::vector<std::string>*>(warnings)->push_back(static_cast<char*>(text)); });
    this->Pass->AddObserver(vtkCommand::WarningEvent, observer);
  }

  vtkActor* Add(vtkMapper* mapper, bool optimizes)
  {
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetOpacity(0.5);
    this->Renderer->AddActor(actor);
    if (optimizes)
    {
      vtkOpacityOptimization::Attach(actor, this->Optimization);
    }
    return actor;
  }

  vtkNew<vtkOpacityOptimization> Optimization;
  vtkActor* Core;
  vtkExactTransparencyPass* Pass;
  std::vector<std::string> Warnings;
};

template <typename Mapper>
vtkSmartPointer<vtkMapper> MakeMapper(vtkDataObject* data)
{
  auto mapper = vtkSmartPointer<Mapper>::New();
  mapper->SetInputDataObject(data);
  return mapper;
}

//------------------------------------------------------------------------------
// One mapper of two actors, one with importance, is as good as two mappers.
bool TestSharedMappers()
{
  const auto lines = MakeSegmentedLines(12, 100);
  const auto sphere = MakeSegmentedSphere(1.3, Wave);
  const std::vector<std::pair<std::string, std::function<vtkSmartPointer<vtkMapper>()>>> mappers = {
    { "a vtkPolyDataMapper", [&] { return MakeMapper<vtkPolyDataMapper>(sphere); } },
    { "a vtkTrajectoryMapper of lines", [&] { return MakeMapper<vtkTrajectoryMapper>(lines); } },
    { "a vtkTrajectoryMapper of surfaces",
      [&] { return MakeMapper<vtkTrajectoryMapper>(sphere); } },
  };
  bool passed = true;
  for (const auto& [name, make] : mappers)
  {
    for (const bool first : { false, true })
    {
      Picture pictures[2];
      for (const bool shares : { false, true })
      {
        Scene scene;
        OpenGLDebugOutput debugOutput(scene.Window);
        const auto mapper = make();
        scene.Add(mapper, first);
        scene.Add(shares ? mapper : make(), !first)->SetPosition(0.5, 0.3, 0.4);
        scene.Window->Render();
        // VTK makes the shaders for each actor in the first frame, and then for the mapper.
        scene.Renderer->GetActiveCamera()->Azimuth(20.0);
        pictures[shares] = Picture::Render(scene.Window);
      }
      passed &= Check(pictures[0] == pictures[1], name + " that two share");
    }
  }
  return passed;
}

//------------------------------------------------------------------------------
// Shaders of VTK that importance has to find its way through, with importance and without.
bool TestNeighbors()
{
  using Mapper = vtkSmartPointer<vtkMapper>;
  const auto lines = MakeSegmentedLines(12, 100);
  const std::vector<std::pair<std::string, Mapper>> neighbors = {
    { "edges", MakeMapper<vtkPolyDataMapper>(MakeSegmentedSphere(1.3, Wave)) },
    { "wide lines", MakeMapper<vtkPolyDataMapper>(lines) },
  };
  bool passed = true;
  for (const auto& [name, mapper] : neighbors)
  {
    Scene scene;
    OpenGLDebugOutput debugOutput(scene.Window);
    vtkActor* actor = scene.Add(mapper, false);
    actor->GetProperty()->SetEdgeVisibility(name == "edges");
    actor->GetProperty()->SetLineWidth(4.0f);
    scene.Core->SetPosition(100.0, 0.0, 0.0);
    const Picture beside = Picture::Render(scene.Window);
    vtkOpacityOptimization::Attach(scene.Core, nullptr);
    passed &= Check(Picture::Render(scene.Window) == beside, name + " beside importance");
    passed &= Check(scene.Warnings.empty(), name + " beside importance: warnings");
    vtkOpacityOptimization::Attach(actor, scene.Optimization);
    scene.Pass->SetView(vtkExactTransparencyPass::VIEW_IMPORTANCE);
    const Picture picture = Picture::Render(scene.Window);
    const std::set<unsigned char> values(picture.Rgba.begin(), picture.Rgba.end());
    passed &= Check(
      values.size() > 20, name + " with importance: " + std::to_string(values.size()) + " values");
  }
  return passed;
}

//------------------------------------------------------------------------------
// They keep their own opacity, with one warning for all frames.
bool TestUnsupportedMappers()
{
  using MakeFunction = std::function<vtkSmartPointer<vtkMapper>()>;
  const auto lines = MakeSegmentedLines(3, 10);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeSegmentedSphere(1.3, Wave));
  const auto makeGlyphs = [&]
  {
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(lines);
    vtkNew<vtkConeSource> cone;
    mapper->SetSourceConnection(cone->GetOutputPort());
    mapper->SetScaleFactor(0.2);
    return mapper;
  };
  bool passed = true;
  for (const MakeFunction& make :
    { MakeFunction([&] { return MakeMapper<vtkCompositePolyDataMapper>(blocks); }),
      MakeFunction(makeGlyphs) })
  {
    Scene plain;
    plain.Add(make(), false);
    Scene scene;
    OpenGLDebugOutput debugOutput(scene.Window);
    const std::string name = scene.Add(make(), true)->GetMapper()->GetClassName();
    for (const double weight : { 400.0, 400.0, 300.0, 200.0 })
    {
      plain.Optimization->SetOcclusionWeight(weight);
      scene.Optimization->SetOcclusionWeight(weight);
      passed &= Check(
        Picture::Render(scene.Window) == Picture::Render(plain.Window), name + " is not plain");
    }
    const std::string warning = name + ", which cannot bring importances to the pass";
    const auto count = std::count_if(scene.Warnings.begin(), scene.Warnings.end(),
      [&](const std::string& text) { return text.find(warning) != std::string::npos; });
    passed &= Check(count == 1, name + ": " + std::to_string(count) + " warnings");
  }
  return passed;
}

//------------------------------------------------------------------------------
// Also of one actor alone, and of data that change in every frame.
bool TestMissingArray()
{
  Scene scene;
  scene.Optimization->SetImportanceArray("Typo");
  for (int frame = 0; frame < 4; ++frame)
  {
    scene.Core->GetMapper()->GetInputDataObject(0, 0)->Modified();
    scene.Window->Render();
  }
  return Check(scene.Warnings.size() == 1 &&
      scene.Warnings[0].find("no point array \"Typo\"") != std::string::npos,
    "a missing array: " + std::to_string(scene.Warnings.size()) + " warnings");
}

//------------------------------------------------------------------------------
/** Numbers as 1.234,5. */
class Grouped : public std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

bool TestLocales()
{
  const auto render = [](bool avoids)
  {
    Scene scene;
    vtkActor* lines = AddLines(scene, MakeSegmentedLines(12, 2000), 0.06, 0.9);
    if (avoids)
    {
      Avoid(lines, 1, true);
      Avoid(scene.Core, 0, false);
    }
    else
    {
      Optimize(lines, 400.0, 50.0, 2.0, 5, false);
    }
    return Picture::Render(scene.Window);
  };
  bool passed = true;
  for (const bool avoids : { false, true })
  {
    const Picture expected = render(avoids);
    const std::locale before = std::locale::global(std::locale(std::locale(), new Grouped));
    // Where it is installed.
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");
    const Picture picture = render(avoids);
    std::locale::global(before);
    std::setlocale(LC_NUMERIC, "C");
    passed &= Check(picture == expected, avoids ? "avoidance with commas" : "commas");
  }
  return passed;
}
}

//------------------------------------------------------------------------------
int TestImportanceScenes(int, char*[])
{
  bool passed = TestSharedMappers();
  passed &= TestNeighbors();
  passed &= TestUnsupportedMappers();
  passed &= TestMissingArray();
  passed &= TestLocales();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
