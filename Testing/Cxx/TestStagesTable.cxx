// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a scene does not need costs nothing: the stages that the last frame of a scene has run and
// the graphics memory that the pass holds are those of the table in README.md. The data folder of
// -D says where that is; --table FILE writes the table anew.
#include "FrameStages.h"
#include "SegmentedScene.h"

#include "vtkHardwareSelector.h"
#include "vtkSelection.h"
#include "vtkTesting.h"

#include <fstream>
#include <iomanip>
#include <sstream>

namespace
{
/** An opaque ball among what the rows of the table add, with the pass installed. */
class Scene : public SphereScene
{
public:
  Scene()
    : SphereScene(300, 300, 0, 0, 1)
    , Pass(vtkTransparencyInstaller::Install(this->Renderer))
  {
  }

  void AddLines(double opacity = 0.5)
  {
    this->Actor = ::AddLines(*this, MakeSegmentedLines(10, 100), 0.04, opacity);
  }

  void AddSphere()
  {
    this->Actor = AddSurface<vtkPolyDataMapper>(*this, MakeSegmentedSphere(1.0, Wave), 0.5);
  }

  void AddOptimizedLines(double q = 400.0, double r = 50.0, int steps = 5)
  {
    this->AddLines();
    Optimize(this->Actor, q, r, 2.0, steps, false);
  }

  vtkOpacityOptimization* GetOptimization()
  {
    return vtkOpacityOptimization::SafeDownCast(vtkOpacityOptimization::Get(this->Actor));
  }

  void Turn() { this->Renderer->GetActiveCamera()->Azimuth(10.0); }

  vtkExactTransparencyPass* Pass;
  vtkActor* Actor = nullptr;
};

using Change = std::function<void(Scene&)>;

struct Row
{
  std::string Name;
  Change Prepare;
  Change ChangeAfterFirstFrame = nullptr; ///< null: one frame is drawn, not two
};

void Unchanged(Scene&) {}

const std::vector<Row>& GetRows()
{
  static const std::vector<Row> rows = {
    { "nothing translucent", Unchanged },
    { "translucent lines that are hidden",
      [](Scene& s)
      {
        s.AddLines();
        s.Actor->VisibilityOff();
      } },
    { "lines of opacity 1", [](Scene& s) { s.AddLines(1.0); } },
    { "translucent lines outside the view",
      [](Scene& s)
      {
        s.AddLines();
        s.Actor->SetPosition(0.0, 100.0, 0.0);
      } },
    { "translucent lines", [](Scene& s) { s.AddLines(); } },
    { "... a second frame", [](Scene& s) { s.AddLines(); }, Unchanged },
    { "... another view", [](Scene& s) { s.AddLines(); }, [](Scene& s) { s.Turn(); } },
    { "... after a hardware selection", [](Scene& s) { s.AddLines(); },
      [](Scene& s)
      {
        vtkNew<vtkHardwareSelector> selector;
        selector->SetRenderer(s.Renderer);
        selector->SetArea(0, 0, 299, 299);
        vtkSmartPointer<vtkSelection>::Take(selector->Select());
      } },
    { "... 4 samples",
      [](Scene& s)
      {
        s.Window->SetMultiSamples(4);
        s.AddLines();
      } },
    { "... hidden after the first frame", [](Scene& s) { s.AddLines(); },
      [](Scene& s) { s.Actor->VisibilityOff(); } },
    { "a translucent surface", [](Scene& s) { s.AddSphere(); } },
    { "optimised lines", [](Scene& s) { s.AddOptimizedLines(); } },
    { "... a second frame", [](Scene& s) { s.AddOptimizedLines(); }, Unchanged },
    { "... another view", [](Scene& s) { s.AddOptimizedLines(); }, [](Scene& s) { s.Turn(); } },
    { "... another q", [](Scene& s) { s.AddOptimizedLines(); },
      [](Scene& s) { s.GetOptimization()->SetOcclusionWeight(50.0); } },
    { "... another colour of the background", [](Scene& s) { s.AddOptimizedLines(); },
      [](Scene& s) { s.Renderer->SetBackground(1.0, 1.0, 1.0); } },
    { "... s = 0", [](Scene& s) { s.AddOptimizedLines(400.0, 50.0, 0); } },
    { "... q = r = 0", [](Scene& s) { s.AddOptimizedLines(0.0, 0.0); } },
    { "... the same importance everywhere",
      [](Scene& s)
      {
        s.AddOptimizedLines();
        s.GetOptimization()->SetImportanceRange(-2.0, -1.0);
      } },
    { "... on the way to another view",
      [](Scene& s)
      {
        s.AddOptimizedLines();
        s.Pass->SetFadeTime(1.0);
        s.Pass->SetFrameTime(0.0);
      },
      [](Scene& s)
      {
        s.Turn();
        s.Window->Render();
        s.Pass->SetFrameTime(0.1);
      } },
    { "... found in a smaller picture",
      [](Scene& s)
      {
        s.AddOptimizedLines();
        s.Pass->SetGatherScale(2);
      } },
    { "... a memory limit of 1 MiB",
      [](Scene& s)
      {
        s.AddOptimizedLines();
        s.Pass->SetMemoryLimit(1);
      } },
    { "lines that avoid occlusion",
      [](Scene& s)
      {
        s.AddLines();
        Avoid(s.Actor, vtkOcclusionAvoidance::PENALTY, false);
      } },
    { "... by smoothed attributes",
      [](Scene& s)
      {
        s.AddLines();
        Avoid(s.Actor, vtkOcclusionAvoidance::PENALTY, true);
      } },
    { "... with a penalty of 1",
      [](Scene& s)
      {
        s.AddLines();
        Avoid(s.Actor, vtkOcclusionAvoidance::PENALTY, false)->SetPenalty(1.0);
      } },
  };
  return rows;
}

std::string Draw(const Row& row)
{
  Scene scene;
  const OpenGLDebugOutput debugOutput(scene.Window);
  row.Prepare(scene);
  scene.Window->Render();
  if (row.ChangeAfterFirstFrame)
  {
    row.ChangeAfterFirstFrame(scene);
    scene.Window->Render();
  }
  std::string stages = GetStages(scene.Pass);
  stages = stages.empty() ? "none" : stages.substr(0, stages.size() - 1);
  vtkTransparencyStatistics* statistics = scene.Pass->GetStatistics();
  std::ostringstream line;
  line << "| " << row.Name << " | " << stages << " | " << statistics->GetGatherPasses() << " | "
       << std::fixed << std::setprecision(2) << statistics->GetBufferBytes() / 1048576.0 << " |\n";
  return line.str();
}

std::string MakeTable()
{
  std::string table =
    "| scene | stages of the frame | gathers | MiB |\n| --- | --- | ---: | ---: |\n";
  for (const Row& row : GetRows())
  {
    table += Draw(row);
  }
  return table;
}

/** What stands between two comments of a file. */
std::string ReadTable(const std::string& path)
{
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  const std::string begin = "<!-- stages begin -->\n";
  const std::size_t first = text.str().find(begin);
  const std::size_t last = text.str().find("<!-- stages end -->");
  return first < last && last != std::string::npos
    ? text.str().substr(first + begin.size(), last - first - begin.size())
    : std::string();
}
}

//------------------------------------------------------------------------------
int TestStagesTable(int argc, char* argv[])
{
  vtkNew<vtkTesting> testing;
  testing->AddArguments(argc, argv);
  const std::string table = MakeTable();
  std::cout << table;
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::string(argv[i]) == "--table")
    {
      std::ofstream(argv[i + 1]) << table;
    }
  }
  const std::string readme = std::string(testing->GetDataRoot()) + "/../README.md";
  return Check(ReadTable(readme) == table,
           "the table in " + readme + " differs; this test with --table FILE writes the one above")
    ? EXIT_SUCCESS
    : EXIT_FAILURE;
}
