// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Optimised opacities are those of the double-precision solution, for lists of every critical
// length and weights of any size; stages run only where they have something to do.
#include "FrameStages.h"
#include "OpacitySolution.h"
#include "OpenGLDebugOutput.h"
#include "SegmentOpacity.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkExactTransparencyPass.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkOpacityOptimization.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTrajectorySegments.h"
#include "vtkTransparencyInstaller.h"

#include <cmath>
#include <functional>
#include <iostream>
#include <numeric>
#include <random>

namespace
{
constexpr double Tolerance = 1e-5;

/// Balls one behind the other, all in every pixel; each is one segment.
class Scene
{
public:
  explicit Scene(int balls)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(3, 3);
    this->Window->OffScreenRenderingOn();
    this->Window->AddRenderer(this->Renderer);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> vertices;
    this->Importances->SetName("Importance");
    for (int ball = 0; ball < balls; ++ball)
    {
      const vtkIdType point = points->InsertNextPoint(0.0, 0.0, -static_cast<double>(ball) / balls);
      vertices->InsertNextCell(1, &point);
      this->Importances->InsertNextValue(0.0f);
    }
    this->Data->SetPoints(points);
    this->Data->SetVerts(vertices);
    this->Data->GetPointData()->AddArray(this->Importances);
    this->Segments->SetInputData(this->Data);
    this->Mapper->SetInputConnection(this->Segments->GetOutputPort());
    this->Mapper->SetRadius(10.0);
    this->Mapper->ScalarVisibilityOff();
    this->Actor->SetMapper(this->Mapper);
    this->Actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(this->Actor);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.1);
    camera->SetPosition(0.0, 0.0, 20.0);
    camera->SetClippingRange(5.0, 15.0);
    vtkOpacityOptimization::Attach(this->Actor, this->Optimization);
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
  }

  void SetImportances(const std::function<double(int)>& importance)
  {
    for (vtkIdType i = 0; i < this->Importances->GetNumberOfValues(); ++i)
    {
      this->Importances->SetValue(i, static_cast<float>(importance(static_cast<int>(i))));
    }
    this->Importances->Modified();
    this->Data->Modified();
  }

  void SetWeights(double q, double r, double lambda)
  {
    this->Optimization->SetOcclusionWeight(q);
    this->Optimization->SetClutterWeight(r);
    this->Optimization->SetEmphasis(lambda);
  }

  std::vector<double> Solve() const
  {
    const pellucid::OpacityParameters<double> parameters{ this->Optimization->GetOcclusionWeight(),
      this->Optimization->GetClutterWeight(), this->Optimization->GetEmphasis(), true };
    std::vector<pellucid::OpacityFragment<double>> list;
    for (vtkIdType i = 0; i < this->Importances->GetNumberOfValues(); ++i)
    {
      list.push_back({ this->Importances->GetValue(i), i, &parameters });
    }
    std::vector<double> opacities;
    pellucid::SolveOpacities(list, opacities);
    return opacities;
  }

  /// Renders, and compares with the solution; the largest difference.
  double Compare()
  {
    this->Window->Render();
    const auto found = this->Pass->GetOptimizedOpacities(this->Actor);
    const std::vector<double> expected = this->Solve();
    if (!found || found->GetNumberOfValues() != static_cast<vtkIdType>(expected.size()))
    {
      return VTK_DOUBLE_MAX;
    }
    double largest = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i)
    {
      largest =
        std::max(largest, std::abs(found->GetValue(static_cast<vtkIdType>(i)) - expected[i]));
    }
    return largest;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkFloatArray> Importances;
  vtkNew<vtkTrajectorySegments> Segments;
  vtkNew<vtkTrajectoryMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkOpacityOptimization> Optimization;
  vtkExactTransparencyPass* Pass = nullptr;
};

//------------------------------------------------------------------------------
bool Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << "\n";
  }
  return condition;
}

//------------------------------------------------------------------------------
bool TestLists()
{
  struct Weights
  {
    double Q;
    double R;
    double Lambda;
  };
  bool success = true;
  for (const int length : { 2, 15, 16, 17, 33, 300, 2047, 2048, 2049, 2064, 2065, 100000 })
  {
    Scene scene(length);
    OpenGLDebugOutput debugOutput(scene.Window);
    std::mt19937 random(length);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const std::vector<std::pair<std::string, std::function<double(int)>>> importances = {
      { "random", [&](int) { return uniform(random); } },
      { "nearly constant", [](int i) { return i == 0 ? 0.0 : 0.835; } },
      { "one important", [length](int i) { return i == length / 2 ? 1.0 : 0.01; } },
      { "all but one important", [](int i) { return i == 1 ? 0.0 : 1.0; } },
    };
    for (const auto& [name, importance] : importances)
    {
      scene.SetImportances(importance);
      for (const Weights& weights : { Weights{ 50, 100, 3 }, Weights{ 1e5, 0, 0.1 },
             Weights{ 0, 1e5, 20 }, Weights{ 1e5, 1e5, 1.3 }, Weights{ 0.001, 0.002, 0.5 } })
      {
        scene.SetWeights(weights.Q, weights.R, weights.Lambda);
        const double difference = scene.Compare();
        success &= Check(difference <= Tolerance,
          std::to_string(length) + " balls, " + name + ", q " + std::to_string(weights.Q) + ", r " +
            std::to_string(weights.R) + ", lambda " + std::to_string(weights.Lambda) + ": off by " +
            std::to_string(difference));
      }
    }
    success &= Check(scene.Pass->GetStatistics()->GetSolvedFragments() == 9 * length &&
        scene.Pass->GetStatistics()->GetLongestList() == length,
      std::to_string(length) + " balls: fragments were not solved, or counted");
  }
  return success;
}

//------------------------------------------------------------------------------
// Sums of weights may be infinite in single precision; opacities are not, nor NaN.
bool TestHugeWeights()
{
  bool success = true;
  for (const int length : { 4, 40, 3000 })
  {
    Scene scene(length);
    OpenGLDebugOutput debugOutput(scene.Window);
    scene.SetImportances([](int i) { return 0.5 * (i % 3); });
    for (const double weight : { 1e20, 1e38, static_cast<double>(VTK_FLOAT_MAX), VTK_DOUBLE_MAX })
    {
      scene.SetWeights(weight, weight, 2.0);
      const std::string name = std::to_string(length) + " balls of huge weights";
      success &= Check(scene.Compare() <= Tolerance, name + " are off");
      const auto found = scene.Pass->GetOptimizedOpacities(scene.Actor);
      for (vtkIdType i = 0; i < length; ++i)
      {
        const double opacity = found->GetValue(i);
        success &= Check(i % 3 == 2 ? opacity == 1.0 : (opacity >= 0.0 && opacity <= 1.0),
          name + ": opacity " + std::to_string(opacity));
      }
    }
  }
  return success;
}

//------------------------------------------------------------------------------
bool TestSkippedStages()
{
  Scene scene(20);
  const auto runs = [&scene](const char* stage) { return RanStage(scene.Pass, stage); };
  scene.SetImportances([](int i) { return i / 20.0; });
  scene.Window->Render();
  bool success = Check(runs("solve") && runs("smooth"), "opacities are not optimised");
  scene.SetWeights(0.0, 0.0, 2.0);
  scene.Window->Render();
  success &= Check(!runs("solve") && !runs("smooth") && runs("resolve"), "q = r = 0 is solved");
  scene.SetWeights(1.0, 1.0, 2.0);
  scene.SetImportances([](int) { return 0.4; });
  scene.Window->Render();
  success &= Check(!runs("solve") && !runs("smooth"), "a constant importance is solved");
  success &= Check(!scene.Pass->GetOptimizedOpacities(scene.Actor), "opacities of nothing");
  scene.SetImportances([](int i) { return i % 2 ? 0.4 : std::nan(""); });
  success &= Check(scene.Compare() <= Tolerance && runs("solve"), "missing is not the least");
  scene.SetImportances([](int i) { return i / 20.0; });
  vtkOpacityOptimization::Attach(scene.Actor, nullptr);
  scene.Actor->GetProperty()->SetOpacity(0.5);
  scene.Window->Render();
  success &= Check(!runs("solve") && runs("resolve"), "an actor that takes no part is solved");
  return success;
}
}

//------------------------------------------------------------------------------
int TestOpacityOptimization(int, char*[])
{
  const bool success = TestLists() & TestHugeWeights() & TestSkippedStages();
  return success ? EXIT_SUCCESS : EXIT_FAILURE;
}
