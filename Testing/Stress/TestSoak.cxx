// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Three windows, two of which share their context, go through the same changes again and again:
// sizes, samples, data, parameters, actors that come and go, lost contexts, new windows. Whenever a
// round ends, the pictures and the graphics memory are those of the first, and the process has not
// grown. The second window stays open, or OpenGL would free with a context what was lost in it.
//
//   pellucidStressTests TestSoak --frames 10000
#include "OpenGLDebugOutput.h"
#include "Picture.h"
#include "SceneBuilder.h"

#include "vtkCamera.h"
#include "vtkExactTransparencyPass.h"
#include "vtkMapper.h"
#include "vtkOpacityOptimization.h"
#include "vtkProperty.h"
#include "vtkTransparencyInstaller.h"

#include <CLI/CLI.hpp>
#include <vtksys/SystemInformation.hxx>

#ifdef PELLUCID_HAS_MALLINFO2
#include <malloc.h>
#endif

#include <array>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

namespace
{
using pellucid::PropDescription;
using pellucid::SceneDescription;

constexpr int FramesPerRound = 60;
constexpr int WarmUpRounds = 3;

/** Bytes per frame by which the process may grow: OpenGL itself keeps some of each lost context. */
constexpr double LargestGrowth = 4096.0;

/** The lines, or else balls, of a seed, whose opacities are optimised. */
PropDescription DescribeLines(int seed)
{
  PropDescription prop;
  prop.Kind = seed % 2 == 0 ? "lines" : "balls";
  prop.Seed = seed;
  prop.Cells = 20;
  prop.PointsPerCell = 10;
  prop.Radius = 0.05;
  prop.Importance = "wave";
  prop.Method = "optimization";
  prop.Segments = 50;
  prop.OcclusionWeight = 50.0;
  prop.SmoothingIterations = 5;
  return prop;
}

PropDescription DescribeSurface(bool isOpaque)
{
  PropDescription prop;
  prop.Kind = "sphere";
  prop.PointsPerCell = 20;
  prop.Opacity = isOpaque ? 1.0 : 0.3;
  return prop;
}

/** A window with a scene of its own. */
class View
{
public:
  explicit View(vtkRenderWindow* shared)
  {
    SceneDescription scene;
    scene.ParallelProjection = false;
    scene.Props = { DescribeSurface(false), DescribeSurface(true) };
    scene.Props.back().Seed = 3;
    this->Renderer = pellucid::MakeRenderer(scene, pellucid::BuildOrder::Forward);
    this->Lines = pellucid::MakeActor(scene, DescribeLines(0), pellucid::BuildOrder::Forward);
    this->Renderer->AddActor(this->Lines);
    this->Camera->DeepCopy(this->Renderer->GetActiveCamera());
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
    this->Open(shared);
  }

  ~View() { this->Close(); }
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// Another window in place of the one that there is, if any.
  void Open(vtkRenderWindow* shared)
  {
    this->Close();
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->OffScreenRenderingOn();
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(90, 70);
    this->Window->SetSharedRenderWindow(shared);
    this->Window->AddRenderer(this->Renderer);
  }

  void LoseContext()
  {
    this->DebugOutput.reset();
    this->Window->Finalize();
  }

  void ReleaseResources() { this->Renderer->ReleaseGraphicsResources(this->Window); }

  void SetFrame(int frame)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->DeepCopy(this->Camera);
    camera->Azimuth(6.0 * frame);
    constexpr std::array<std::array<int, 2>, 4> sizes{ { { { 90, 70 } }, { { 61, 1 } },
      { { 128, 96 } }, { { 33, 77 } } } };
    const auto& size = sizes[frame / 3 % sizes.size()];
    this->Window->SetSize(size[0], size[1]);
    this->Window->SetMultiSamples(frame / 20 % 3 == 1 ? 4 : 0);
    this->Pass->SetMemoryLimit(frame / 13 % 2 == 0 ? 1024 : 1);
    this->Pass->SetGatherScale(frame / 17 % 2 + 1);
    if (frame % 5 == 0)
    {
      this->ReplaceLines(DescribeLines(frame / 5));
    }
    if (frame % 11 == 0)
    {
      this->ToggleVisitor();
    }
    this->SetParameters(frame / 7);
  }

  Picture Draw()
  {
    if (!this->DebugOutput)
    {
      this->DebugOutput = std::make_unique<OpenGLDebugOutput>(this->Window);
    }
    this->Window->MakeCurrent();
    return Picture::Render(this->Window);
  }

  vtkRenderWindow* GetWindow() { return this->Window; }
  vtkIdType GetBytes() { return this->Pass->GetStatistics()->GetBufferBytes(); }

private:
  void Close()
  {
    this->DebugOutput.reset();
    if (this->Window)
    {
      this->Window->RemoveRenderer(this->Renderer);
    }
  }

  void ReplaceLines(const PropDescription& prop)
  {
    const auto data = pellucid::MakeData(SceneDescription(), prop, pellucid::BuildOrder::Forward);
    this->Lines->GetMapper()->SetInputDataObject(0, data);
  }

  void ToggleVisitor()
  {
    if (this->Visitor)
    {
      this->Renderer->RemoveActor(this->Visitor);
      this->Visitor = nullptr;
      return;
    }
    this->Visitor =
      pellucid::MakeActor(SceneDescription(), DescribeLines(7), pellucid::BuildOrder::Forward);
    this->Renderer->AddActor(this->Visitor);
  }

  void SetParameters(int step)
  {
    auto* optimization =
      vtkOpacityOptimization::SafeDownCast(vtkImportanceDrivenOpacity::Get(this->Lines));
    optimization->SetOcclusionWeight(step % 3 * 50.0);
    optimization->SetSmoothingIterations(step % 2 * 5);
    this->Lines->GetProperty()->SetOpacity(0.3 + 0.1 * (step % 5));
    this->Lines->SetVisibility(step % 6 != 5);
  }

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkActor> Lines;
  vtkNew<vtkCamera> Camera;
  vtkExactTransparencyPass* Pass;
  vtkSmartPointer<vtkActor> Visitor;
  std::unique_ptr<OpenGLDebugOutput> DebugOutput;
};

/** What has to be the same at the end of every round. */
struct RoundEnd
{
  std::vector<Picture> Pictures;
  std::vector<vtkIdType> Bytes;
};

class Soak
{
public:
  explicit Soak(bool leaks)
    : Leaks(leaks)
  {
  }

  // Mesa 22 crashes where a context is destroyed with what another one of its group had lost.
  ~Soak()
  {
    this->Second.GetWindow()->MakeCurrent();
    glDeleteBuffers(static_cast<GLsizei>(this->Leaked.size()), this->Leaked.data());
  }
  Soak(const Soak&) = delete;
  Soak& operator=(const Soak&) = delete;

  RoundEnd DrawRound()
  {
    RoundEnd end;
    for (int frame = 0; frame < FramesPerRound; ++frame)
    {
      if (frame == 20)
      {
        this->First.LoseContext();
      }
      if (frame == 30)
      {
        this->First.Open(nullptr);
        this->Third.Open(this->Second.GetWindow());
      }
      if (frame == 40)
      {
        this->Second.ReleaseResources();
      }
      end = RoundEnd();
      for (View* view : { &this->First, &this->Second, &this->Third })
      {
        view->SetFrame(frame);
        end.Pictures.push_back(view->Draw());
        end.Bytes.push_back(view->GetBytes());
      }
      if (this->Leaks)
      {
        this->LeakBuffer();
      }
    }
    return end;
  }

private:
  // As large as the list heads of a small picture.
  void LeakBuffer()
  {
    const std::vector<unsigned int> heads(33 * 77, 1u);
    this->Second.GetWindow()->MakeCurrent();
    this->Leaked.push_back(0);
    glGenBuffers(1, &this->Leaked.back());
    glBindBuffer(GL_ARRAY_BUFFER, this->Leaked.back());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(heads.size() * sizeof(unsigned int)),
      heads.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
  }

  View First{ nullptr };
  View Second{ nullptr };
  View Third{ Second.GetWindow() };
  std::vector<GLuint> Leaked;
  bool Leaks;
};

double GetResidentBytes()
{
  vtksys::SystemInformation information;
  return 1024.0 * static_cast<double>(information.GetProcMemoryUsed());
}

/** What is allocated, to the byte; where the C library does not tell, what is resident. */
double GetAllocatedBytes()
{
#ifdef PELLUCID_HAS_MALLINFO2
  const auto information = mallinfo2();
  return static_cast<double>(information.uordblks) + static_cast<double>(information.hblkhd);
#else
  return GetResidentBytes();
#endif
}

/** Slope of the least-squares line through values at 0, 1, 2... */
double FitSlope(const std::vector<double>& values)
{
  const double count = static_cast<double>(values.size());
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double x = static_cast<double>(i) - 0.5 * (count - 1.0);
    products += x * values[i];
    squares += x * x;
  }
  return squares > 0.0 ? products / squares : 0.0;
}
}

//------------------------------------------------------------------------------
int TestSoak(int argc, char* argv[])
{
  CLI::App application("Changes without end");
  application.allow_extras();
  bool leaks = false;
  constexpr int fewest = 10 * FramesPerRound; // below, what rounds differ by looks like growth
  int frames = fewest;
  application
    .add_option("--frames", frames,
      "Frames to draw, in each of three windows, in whole rounds of " +
        std::to_string(FramesPerRound))
    ->check(CLI::Range(fewest, std::numeric_limits<int>::max()))
    ->capture_default_str();
  application.add_flag("--leak", leaks, "Lose a small buffer in each frame, to see it found");
  CLI11_PARSE(application, argc, argv);

  bool passed = true;
  Soak soak(leaks);
  RoundEnd first;
  std::vector<double> allocated;
  std::vector<double> resident;
  const int rounds = (frames + FramesPerRound - 1) / FramesPerRound;
  for (int round = 0; round < rounds && passed; ++round)
  {
    RoundEnd end = soak.DrawRound();
    if (round == 1)
    {
      first = end;
    }
    if (round > 1)
    {
      passed &= Check(end.Pictures == first.Pictures,
        "round " + std::to_string(round) + " ends with another picture");
      passed &= Check(end.Bytes == first.Bytes,
        "round " + std::to_string(round) + " ends with other graphics memory");
    }
    if (round >= WarmUpRounds)
    {
      allocated.push_back(GetAllocatedBytes());
      resident.push_back(GetResidentBytes());
    }
  }
  if (!passed)
  {
    return EXIT_FAILURE;
  }
  const double growth = FitSlope(allocated) / FramesPerRound;
  std::cout << rounds * FramesPerRound << " frames: allocated memory grows by " << growth
            << " bytes in a frame, resident memory by " << FitSlope(resident) / FramesPerRound
            << " (from " << resident.front() / 1048576.0 << " to " << resident.back() / 1048576.0
            << " MiB after warming up); the passes hold "
            << first.Bytes[0] + first.Bytes[1] + first.Bytes[2] << " bytes" << std::endl;
  passed &= Check(
    growth <= LargestGrowth, "memory grows by " + std::to_string(growth) + " bytes in a frame");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
