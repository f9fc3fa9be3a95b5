// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Every view of every way to find opacities shows what the double-precision reference shows, also
// in multisampled windows, with lists that the CPU works on, and from smaller pictures; tiles do
// not change a byte.
#include "SegmentedScene.h"

namespace
{
using Pass = vtkExactTransparencyPass;

constexpr const char* ViewNames[] = { "picture", "opacity", "importance", "segments", "length",
  "first layers", "layer" };

/** What the actors have, in the order lines, surface. */
struct Kind
{
  std::string Name;
  std::function<void(vtkActor*)> Lines;
  std::function<void(vtkActor*)> Surface;
};

const auto Optimized = [](vtkActor* actor) { Optimize(actor, 50.0, 20.0, 2.0, 5, false); };
const auto Penalized = [](vtkActor* actor) { Avoid(actor, 0, false)->SetGlobalOpacity(0.9); };
const auto Weighted = [](vtkActor* actor) { Avoid(actor, 1, false); };
const auto Smoothed = [](vtkActor* actor) { Avoid(actor, 0, true); };
const auto SmoothlyWeighted = [](vtkActor* actor) { Avoid(actor, 1, true); };

const std::vector<Kind> Kinds = {
  { "optimised", Optimized, Optimized },
  { "avoiding", Weighted, Penalized },
  { "avoiding smoothly", Smoothed, SmoothlyWeighted },
  { "mixed", Optimized, Smoothed },
  { "mixed the other way", SmoothlyWeighted, Optimized },
};

/** Lines, balls and a surface, translucent alone. */
class Scene : public SphereScene
{
public:
  Scene(int width, int height, const Kind& kind, int samples = 0,
    const ImportanceFunction& importance = Wave)
    : SphereScene(width, height, samples, 0, 0)
  {
    // Not the balls at the ends of the lines: which of two surfaces in one place is seen is chance.
    auto lines = MakeLines(25, 60, 1);
    auto balls = MakeLines(15, 60, 1);
    lines->SetVerts(nullptr);
    balls->SetLines(nullptr);
    for (vtkPolyData* data : { lines.Get(), balls.Get() })
    {
      AddImportance(data, importance);
      vtkActor* actor = AddLines(*this, DivideLines(data, 200), data == lines ? 0.05 : 0.1, 0.9);
      actor->SetPosition(0.0, data == lines ? 0.0 : 0.3, 0.0);
      kind.Lines(actor);
    }
    kind.Surface(AddSurface<vtkPolyDataMapper>(*this, MakeSegmentedSphere(1.4, importance), 0.8));
    this->AddSphere(2, 0.3); // takes no part
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
    this->Pass->SetLayer(3);
  }

  vtkExactTransparencyPass* Pass;
};

//------------------------------------------------------------------------------
bool CompareView(SphereScene& scene, const std::string& name, int view)
{
  vtkTransparencyInstaller::GetPass(scene.Renderer)->SetView(view);
  return ReferenceComparison(scene.Window, scene.Renderer).Passes(name + ", " + ViewNames[view]);
}

//------------------------------------------------------------------------------
bool CompareViews(SphereScene& scene, const std::string& name)
{
  bool passed = true;
  for (int view = Pass::VIEW_PICTURE; view <= Pass::VIEW_LAYER; ++view)
  {
    passed &= CompareView(scene, name, view);
  }
  return passed;
}

//------------------------------------------------------------------------------
bool TestViews()
{
  bool passed = true;
  for (const Kind& kind : Kinds)
  {
    Scene scene(91, 71, kind);
    OpenGLDebugOutput debugOutput(scene.Window);
    scene.AddSphere(3, 1.0);
    passed &= CompareViews(scene, kind.Name);
    for (const int scale : { 2, 4 })
    {
      scene.Pass->SetGatherScale(scale);
      const std::string name = kind.Name + " in 1/" + std::to_string(scale);
      passed &= CompareView(scene, name, Pass::VIEW_PICTURE);
      passed &= CompareView(scene, name, Pass::VIEW_OPACITY);
    }
  }
  return passed;
}

//------------------------------------------------------------------------------
// Importances of some points are missing; many are the same but for rounding.
bool TestUnevenImportances()
{
  const std::vector<std::pair<std::string, ImportanceFunction>> importances = {
    { "missing",
      [](const double* p) { return std::sin(40.0 * p[2]) > 0.5 ? std::nan("") : Wave(p); } },
    { "equal", [](const double* p) { return std::hypot(p[0], p[1], p[2]) > 1.39 ? 0.7 : 0.2; } },
  };
  bool passed = true;
  for (const auto& [name, importance] : importances)
  {
    for (const Kind& kind : Kinds)
    {
      Scene scene(91, 71, kind, 0, importance);
      passed &= CompareView(scene, kind.Name + ", " + name + " importances", Pass::VIEW_PICTURE);
      passed &= CompareView(scene, kind.Name + ", " + name + " importances", Pass::VIEW_OPACITY);
    }
  }
  return passed;
}

//------------------------------------------------------------------------------
// Samples make no difference where no edge of something opaque is.
bool TestSamples()
{
  bool passed = true;
  for (const Kind& kind : Kinds)
  {
    Scene plain(120, 90, kind);
    Scene sampled(120, 90, kind, 4);
    OpenGLDebugOutput debugOutput(sampled.Window);
    for (int view = Pass::VIEW_PICTURE; view <= Pass::VIEW_LAYER; ++view)
    {
      plain.Pass->SetView(view);
      sampled.Pass->SetView(view);
      passed &= Check(Picture::Render(sampled.Window) == Picture::Render(plain.Window),
        kind.Name + " with 4 samples, " + ViewNames[view]);
    }
  }
  return passed;
}

//------------------------------------------------------------------------------
bool TestTiles()
{
  bool passed = true;
  for (const Kind& kind : Kinds)
  {
    Scene whole(300, 240, kind);
    Scene tiled(300, 240, kind);
    OpenGLDebugOutput debugOutput(tiled.Window);
    tiled.Pass->SetMemoryLimit(1);
    // The longest lists are in the last tiles.
    for (Scene* scene : { &whole, &tiled })
    {
      scene->Renderer->GetActiveCamera()->SetWindowCenter(-0.4, -0.8);
    }
    for (int view = Pass::VIEW_PICTURE; view <= Pass::VIEW_LAYER; ++view)
    {
      for (Scene* scene : { &whole, &tiled })
      {
        scene->Pass->SetView(view);
        scene->Pass->SetGatherScale(view == Pass::VIEW_OPACITY ? 2 : 1);
      }
      const std::string name = kind.Name + " in tiles, " + ViewNames[view];
      const Picture expected = Picture::Render(whole.Window);
      passed &= Check(Picture::Render(tiled.Window) == expected, name);
      passed &= Check(tiled.Pass->GetStatistics()->GetTiles() > 1, name + ": one tile");
      passed &= Check(Picture::Render(tiled.Window) == expected, name + ", the second frame");
    }
  }
  return passed;
}

//------------------------------------------------------------------------------
// Thick lines through one middle, more than a shader sorts, around which lists are shorter.
vtkSmartPointer<vtkPolyData> MakeBundle(int lines)
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetName("Value");
  for (int line = 0; line < lines; ++line)
  {
    const double direction[3] = { normal(random), normal(random), normal(random) };
    cells->InsertNextCell(2);
    for (const double side : { -0.6, 0.6 })
    {
      cells->InsertCellPoint(
        points->InsertNextPoint(side * direction[0], side * direction[1], side * direction[2]));
      scalars->InsertNextValue(std::sin(line));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetPointData()->SetScalars(scalars);
  AddImportance(data, Wave);
  return DivideLines(data, 2 * lines);
}

//------------------------------------------------------------------------------
bool TestLongLists()
{
  bool passed = true;
  for (const Kind& kind : Kinds)
  {
    SphereScene scene(20, 15, 0, 0, 0);
    OpenGLDebugOutput debugOutput(scene.Window);
    kind.Lines(AddLines(scene, MakeBundle(2300), 1.2, 0.01));
    kind.Surface(AddSurface<vtkPolyDataMapper>(scene, MakeSegmentedSphere(1.4, Wave), 0.3));
    vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
    pass->SetLayer(2);
    passed &= CompareViews(scene, kind.Name + ", long lists");
    vtkTransparencyStatistics* statistics = pass->GetStatistics();
    passed &=
      Check(statistics->GetLongestList() > 2064 && statistics->GetFragments() < 2064 * 20 * 15,
        kind.Name + ": lists are not both long and short");

    pass->SetView(Pass::VIEW_PICTURE);
    const Picture whole = Picture::Render(scene.Window);
    pass->SetMemoryLimit(1);
    passed &= Check(Picture::Render(scene.Window) == whole && statistics->GetTiles() > 1,
      kind.Name + ": long lists in tiles");
    scene.Window->SetMultiSamples(4);
    passed &= Check(Picture::Render(scene.Window) == whole, kind.Name + ": long lists of samples");
  }
  return passed;
}
}

//------------------------------------------------------------------------------
int TestPictureViews(int, char*[])
{
  bool passed = TestViews();
  passed &= TestUnevenImportances();
  passed &= TestSamples();
  passed &= TestTiles();
  passed &= TestLongLists();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
