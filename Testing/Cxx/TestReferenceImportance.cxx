// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkReferenceRenderer where opacities follow from importance, on stacks of squares, lines and
 * balls with results by hand: both modes of vtkOcclusionAvoidance, also beside
 * vtkOpacityOptimization; smoothed attributes; the colours of all views; optimised opacities found
 * in smaller pictures. What any number means in any range of importance.
 */

#include "Importance.h"
#include "ReferenceTesting.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkExactTransparencyPass.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkReferenceRenderer.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTrajectoryMapper.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using Pass = vtkExactTransparencyPass;
using Color = std::array<double, 4>;

constexpr double Tolerance = 1e-12;
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** From the left to the right and from the lower to the upper end. */
struct Extent
{
  double x0 = -99;
  double x1 = 99;
  double y0 = -99;
  double y1 = 99;
};

/** What a camera at z = 10 sees without perspective of 2 units of height, on blue. */
class Scene
{
public:
  Scene(int width, int height)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetPosition(0, 0, 10);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(1, 19);
    this->Renderer->SetBackground(0, 0, 1);
    this->Reference->SetRenderer(this->Renderer);
    this->Reference->SetSize(width, height);
    this->Reference->TransparentBackgroundOn();
  }

  vtkActor* AddSquare(double z, double importance, vtkImportanceDrivenOpacity* settings,
    const Extent& extent = Extent(), double opacity = 0.5)
  {
    auto data = MakeData({ { extent.x0, extent.y0, z }, { extent.x1, extent.y0, z },
                           { extent.x1, extent.y1, z }, { extent.x0, extent.y1, z } },
      importance);
    vtkNew<vtkCellArray> square;
    square->InsertNextCell({ 0, 1, 2, 3 });
    data->SetPolys(square);
    vtkNew<vtkPolyDataMapper> mapper;
    return this->Add(mapper, data, settings, opacity);
  }

  /** A tube between two points, or a ball at one. */
  void AddTube(const std::vector<std::array<double, 3>>& points, double importance,
    vtkImportanceDrivenOpacity* settings)
  {
    auto data = MakeData(points, importance);
    vtkNew<vtkCellArray> cell;
    if (points.size() == 1)
    {
      cell->InsertNextCell({ 0 });
      data->SetVerts(cell);
    }
    else
    {
      cell->InsertNextCell({ 0, 1 });
      data->SetLines(cell);
    }
    vtkNew<vtkTrajectoryMapper> mapper;
    mapper->SetRadius(0.5);
    this->Add(mapper, data, settings, 0.5);
  }

  Color GetPixel(int x, int y, int view = Pass::VIEW_PICTURE, int layer = 1)
  {
    this->Reference->SetView(view);
    this->Reference->SetLayer(layer);
    this->Reference->Update();
    const auto* pixel =
      static_cast<double*>(this->Reference->GetImage()->GetScalarPointer(x, y, 0));
    return { pixel[0], pixel[1], pixel[2], pixel[3] };
  }

  /** The factor on the opacity of something white, which is 0.5 without, over no red. */
  double GetFactor(int x, int y, int layer)
  {
    return this->GetPixel(x, y, Pass::VIEW_LAYER, layer)[0] / 0.5;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkReferenceRenderer> Reference;

private:
  static vtkSmartPointer<vtkPolyData> MakeData(
    const std::vector<std::array<double, 3>>& positions, double importance)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> importances;
    importances->SetName("Importance");
    for (const auto& position : positions)
    {
      points->InsertNextPoint(position.data());
      importances->InsertNextValue(importance);
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->GetPointData()->AddArray(importances);
    return data;
  }

  vtkActor* Add(vtkPolyDataMapper* mapper, vtkPolyData* data, vtkImportanceDrivenOpacity* settings,
    double opacity)
  {
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetOpacity(opacity);
    vtkImportanceDrivenOpacity::Attach(actor, settings);
    this->Renderer->AddActor(actor);
    return actor;
  }
};

void CheckFactors(Checks& checks, const std::string& name, Scene& scene, int x, int y,
  const std::vector<double>& expected)
{
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const int layer = static_cast<int>(i) + 1;
    checks.Near(name + ", layer " + std::to_string(layer), scene.GetFactor(x, y, layer),
      expected[i], Tolerance);
  }
}

void CheckColor(Checks& checks, const std::string& name, const Color& found, const Color& expected)
{
  for (int i = 0; i < 4; ++i)
  {
    checks.Near(name + ", component " + std::to_string(i), found[i], expected[i], Tolerance);
  }
}

void TestPenalty(Checks& checks)
{
  vtkNew<vtkOcclusionAvoidance> avoidance;
  avoidance->SetGlobalOpacity(0.5);
  Scene scene(1, 1);
  scene.AddSquare(4, 0.25, avoidance);
  scene.AddSquare(2, 0.5, nullptr);
  scene.AddSquare(0, 0.75, avoidance);
  scene.AddSquare(-2, 0.75, avoidance);
  CheckFactors(checks, "penalty", scene, 0, 0, { 0.125, 1, 0.5, 0.5 });
  const double alpha = 1 - 0.9375 * 0.5 * 0.75 * 0.75;
  CheckColor(checks, "composited", scene.GetPixel(0, 0), { alpha, alpha, 1, alpha });
}

/** The values that mean importance 0 and 1 are free. */
void TestRanges(Checks& checks)
{
  const double ends[][2] = { { 3, 10 }, { 10, 3 }, { 1e5, 1e5 + 7 }, { -1e-6, 1e-6 } };
  for (const auto& range : ends)
  {
    const auto value = [&](double importance)
    { return range[0] + (range[1] - range[0]) * importance; };
    const std::string name = "from " + std::to_string(range[0]) + " to " + std::to_string(range[1]);
    vtkNew<vtkOpacityOptimization> optimization;
    vtkNew<vtkOcclusionAvoidance> avoidance;
    optimization->SetImportanceRange(range[0], range[1]);
    optimization->SetOcclusionWeight(50);
    optimization->SetClutterWeight(0);
    optimization->SetEmphasis(1);
    avoidance->SetImportanceRange(range[0], range[1]);
    Scene scene(1, 1);
    scene.AddSquare(4, value(0.25), avoidance);
    scene.AddTube({ { 0, 0, 2 } }, value(0.5), optimization);
    scene.AddSquare(0, value(0.75), avoidance);
    scene.AddSquare(-2, value(1), optimization);
    scene.AddSquare(-3, value(0.75), optimization);
    CheckFactors(checks, name, scene, 0, 0, { 0.25, 1 / (1 + 0.25 * 50 * 1.5625), 0.25, 1, 1 });
  }

  const double unimportant[][3] = { { NotANumber, 0, 1 }, { 1, NotANumber, 1 },
    { 0, Infinity, Infinity }, { -Infinity, 0, 1 }, { 0, 0, NotANumber }, { 1, 0, NotANumber } };
  for (const auto& [first, second, value] : unimportant)
  {
    vtkNew<vtkOcclusionAvoidance> avoidance;
    avoidance->SetImportanceRange(first, second);
    Scene scene(1, 1);
    scene.AddSquare(4, 0, avoidance);
    scene.AddSquare(0, value, avoidance);
    CheckFactors(checks, "unimportant", scene, 0, 0, { 1, 1 });
  }
}

template <typename Real>
void TestMapping(Checks& checks)
{
  using Range = pellucid::ImportanceRange<Real>;
  using Limits = std::numeric_limits<Real>;
  const Real special[] = { Limits::quiet_NaN(), Limits::infinity(), Limits::max(), Limits::min(),
    Limits::denorm_min(), 1, Real(0.1), 0 };
  std::vector<Real> values;
  for (const Real value : special)
  {
    values.insert(values.end(), { value, -value });
  }
  for (const Real value : values)
  {
    checks.True("the default changes no bit",
      Range().Map(value) == pellucid::ClampImportance(value) &&
        Range(std::array<double, 2>{ 0, 1 }.data()) == Range());
  }
  const std::vector<double> ends{ 0, 1, 0.1, -7, 1e-310, 1e-30, -1e30, 1e300, VTK_DOUBLE_MAX,
    VTK_DOUBLE_MIN, NotANumber, Infinity, -Infinity };
  for (const double first : ends)
  {
    for (const double second : ends)
    {
      const double both[2] = { first, second };
      const Range range(both);
      const std::string name =
        "from " + std::to_string(first) + " to " + std::to_string(second) + ": ";
      const bool finite = std::isfinite(first) && std::isfinite(second);
      for (const Real value : values)
      {
        const Real importance = range.Map(value);
        checks.True(name + "a number", importance >= 0 && importance <= (finite ? 1 : 0));
      }
      checks.True(name + "NaN", range.Map(Limits::quiet_NaN()) == 0);
      if (finite && std::abs(first) < 1e35 && std::abs(second) < 1e35)
      {
        checks.True(name + "the second end", range.Map(Real(second)) == 1);
        checks.True(
          name + "the first end", Real(first) == Real(second) || range.Map(Real(first)) == 0);
        const Real below = first <= second ? -Limits::infinity() : Limits::infinity();
        checks.True(name + "beyond the ends", range.Map(below) == 0 && range.Map(-below) == 1);
      }
    }
  }
  const double rising[2] = { 3, 7 };
  const double falling[2] = { 7, 3 };
  checks.True(
    "between the ends", Range(rising).Map(4) == Real(0.25) && Range(falling).Map(4) == Real(0.75));
  const double equal[2] = { 3, 3 };
  checks.True("equal ends", Range(equal).Map(Real(2.999)) == 0 && Range(equal).Map(3) == 1);
}

/** What is as important as all else is in front of nothing: interpolation keeps equal values. */
void TestEqualImportance(Checks& checks)
{
  vtkNew<vtkOcclusionAvoidance> avoidance;
  Scene scene(31, 31);
  for (int i = 0; i < 3; ++i)
  {
    vtkActor* square = scene.AddSquare(0, 0.7, avoidance, { -0.9, 0.7, -0.7, 0.9 });
    square->RotateX(10 + 3 * i);
    square->RotateZ(20 * i);
  }
  scene.Reference->SetView(Pass::VIEW_OPACITY);
  scene.Reference->Update();
  const auto* image = static_cast<double*>(scene.Reference->GetImage()->GetScalarPointer());
  int faded = 0;
  for (int pixel = 0; pixel < 31 * 31; ++pixel)
  {
    // White, or the blue background.
    faded += image[4 * pixel + 2] != 1;
  }
  checks.Near("pixels that fade for what is equal", faded, 0, 0);
  checks.Near("equal squares in a pixel", scene.Reference->GetLongestList(), 3, 0);
}

/** Coverage is 4, since one square is behind the opaque one; the tangents of the two lines add up
 * to the square root of 2. */
void TestWeighting(Checks& checks)
{
  vtkNew<vtkOcclusionAvoidance> avoidance;
  avoidance->SetModeToWeighting();
  avoidance->SetImportanceExponent(2);
  Scene scene(3, 3);
  scene.AddTube({ { -4, 0, 4 }, { 4, 0, 4 } }, 0.5, avoidance);
  scene.AddTube({ { 0, -4, 2 }, { 0, 4, 2 } }, 0.25, avoidance);
  scene.AddTube({ { 0, 0, 0 } }, 0.75, avoidance);
  scene.AddSquare(-2, 1, nullptr);
  scene.AddSquare(-4, 0, nullptr, Extent(), 1.0)->GetProperty()->SetColor(0, 0, 0);
  scene.AddSquare(-5, 1, avoidance);
  const double occlusion = 0.75 + 0.02 * 4 + 0.5 * (1 - std::sqrt(2.0) / 2);
  const double line = 1 / (1 + 0.75 * (occlusion + 10));
  const double crossing = 1 / (1 + (1 - 0.25 * 0.25) * (occlusion + 10));
  const double ball = 1 / (1 + (1 - 0.75 * 0.75) * occlusion);
  CheckFactors(checks, "weighting", scene, 1, 1, { line, crossing, ball, 1 });

  // The optimised squares weigh in their own sums only, but make another depth the most important.
  vtkNew<vtkOpacityOptimization> optimization;
  optimization->SetOcclusionWeight(50);
  optimization->SetClutterWeight(0);
  optimization->SetEmphasis(1);
  scene.AddSquare(6, 0.5, optimization);
  scene.AddSquare(-1, 1, optimization);
  const double denser = occlusion + 0.25 + 0.02 * 2 + 10;
  CheckFactors(checks, "mixed", scene, 1, 1,
    { 1 / (1 + 0.25 * 50), 1 / (1 + 0.75 * denser), 1 / (1 + (1 - 0.25 * 0.25) * denser),
      1 / (1 + (1 - 0.75 * 0.75) * denser), 1, 1 });
}

/** The important square is seen in the three left pixels of nine. */
void TestSmoothing(Checks& checks)
{
  vtkNew<vtkOcclusionAvoidance> avoidance;
  avoidance->SmoothAttributesOn();
  Scene scene(9, 1);
  scene.AddSquare(2, 0.25, avoidance);
  scene.AddSquare(-2, 1, avoidance, { -9, -3 });
  avoidance->SetModeToWeighting();
  avoidance->SetCoverageWeight(0);
  avoidance->SetDepthWeight(0);
  const std::array<double, 9> important{ 3, 3, 3, 2, 1, 0, 0, 0, 0 };
  const std::array<double, 9> window{ 3, 4, 5, 5, 5, 5, 5, 4, 3 };
  for (int x = 0; x < 9; ++x)
  {
    const double mean = (important[x] + 0.25 * (window[x] - important[x])) / window[x];
    checks.Near("smooth importance in pixel " + std::to_string(x), scene.GetFactor(x, 0, 1),
      1 / (1 + 0.75 * mean), Tolerance);
  }

  avoidance->SetModeToPenalty();
  for (int x = 0; x < 5; ++x)
  {
    checks.Near("in front of the mean depth", scene.GetFactor(x, 0, 1), 0.25, Tolerance);
  }
  avoidance->SmoothAttributesOff();
  for (int x = 0; x < 9; ++x)
  {
    checks.Near("in front of the depth", scene.GetFactor(x, 0, 1), x < 3 ? 0.25 : 1, Tolerance);
  }
}

/** Importance and segments show although q = r = 0. */
void TestViews(Checks& checks)
{
  vtkNew<vtkOpacityOptimization> optimization;
  optimization->SetOcclusionWeight(0);
  optimization->SetClutterWeight(0);
  vtkNew<vtkOcclusionAvoidance> avoidance;
  Scene scene(4, 2); // one unit to a pixel
  const Extent second{ -1, 0 };
  const Extent third{ 0, 1 };
  scene.AddSquare(4, 0.5, optimization, { -1, 1 })->GetProperty()->SetColor(1, 0, 0);
  scene.AddSquare(2, 0.75, optimization, second)->GetProperty()->SetColor(0, 1, 0);
  scene.AddSquare(6, 0.25, avoidance, third)->GetProperty()->SetColor(0, 1, 0);
  scene.AddSquare(0, 1, nullptr, { 0, 2 })->GetProperty()->SetColor(1, 1, 1);
  scene.AddSquare(-4, 0, nullptr, { -1, 1 }, 1.0)->GetProperty()->SetColor(0, 0, 1);

  const Color background{ 0, 0, 1, 0 };
  const Color black{ 0, 0, 0, 1 };
  const Color white{ 1, 1, 1, 1 };
  const Color orange{ 1, 0.5, 0, 1 };
  const Color firstSegment{ 0.2 + 0.8 * 103 / 255, 0.2 + 0.8 * 95 / 255, 0.2 + 0.8 * 11 / 255, 1 };
  const struct
  {
    const char* name;
    int view;
    int layer;
    std::array<Color, 4> pixels;
  } views[] = {
    { "opacity", Pass::VIEW_OPACITY, 1, { { background, white, { 0.75, 0, 0, 1 }, white } } },
    { "importance", Pass::VIEW_IMPORTANCE, 1,
      { { background, orange, { 0.75, 0, 0, 1 }, black } } },
    { "segments", Pass::VIEW_SEGMENTS, 1, { { background, firstSegment, black, black } } },
    { "length", Pass::VIEW_LENGTH, 1, { { background, { 1, 1, 0, 1 }, white, { 1, 0, 0, 1 } } } },
    { "first layer", Pass::VIEW_FIRST_LAYERS, 1,
      { { background, { 0.5, 0, 0.5, 1 }, { 0, 0.125, 0.875, 1 }, { 0.5, 0.5, 1, 0.5 } } } },
    { "two layers", Pass::VIEW_FIRST_LAYERS, 2,
      { { background, { 0.5, 0.25, 0.25, 1 }, { 0.4375, 0.125, 0.4375, 1 },
        { 0.5, 0.5, 1, 0.5 } } } },
    { "second layer", Pass::VIEW_LAYER, 2,
      { { background, { 0, 0.5, 0.5, 1 }, { 0.5, 0, 0.5, 1 }, background } } },
  };
  for (const auto& view : views)
  {
    for (int x = 0; x < 4; ++x)
    {
      CheckColor(checks, std::string(view.name) + " of pixel " + std::to_string(x),
        scene.GetPixel(x, 1, view.view, view.layer), view.pixels[x]);
    }
  }
  checks.Near("all fragments count in any view", scene.Reference->GetNumberOfFragments(), 12, 0);
}

/** A square in front is faded to 1/2 where one behind it is seen in the small picture. */
void TestGatherScale(Checks& checks)
{
  struct Case
  {
    const char* name;
    int size;
    Extent important;
    Extent opaque;
    double full;
    double half;
  };
  const Extent nowhere{ -9, -8 };
  const Extent corner{ -1, 0, -1, 0 };
  for (const Case& test : {
         Case{ "a quarter", 4, corner, nowhere, 0.5, 0.5 },
         // Full pixels have their centres at 0.25 and 0.75, small ones at 0.5.
         Case{ "one full pixel", 4, { -0.85, -0.65, -0.85, -0.65 }, nowhere, 0.5, 1 },
         // The small pixel takes the opaque depth of the full one at -0.25.
         Case{ "opaque at the small pixel", 4, corner, { -0.6, -0.4, -0.6, -0.4 }, 0.5, 0.5 },
         Case{ "opaque at the full pixel", 4, corner, { -0.4, -0.1, -0.4, -0.1 }, 0.5, 1 },
         // The last of three small pixels has its centre at 2/3; the last full one is at 0.8.
         Case{ "odd size", 5, { 0.5, 1 }, nowhere, 0.5, 0.5 },
         Case{ "opaque at the last pixel", 5, { 0.5, 1 }, { 0.75, 0.85 }, 1, 1 },
       })
  {
    vtkNew<vtkOpacityOptimization> optimization;
    optimization->SetOcclusionWeight(1);
    optimization->SetEmphasis(3);
    Scene scene(test.size, test.size);
    scene.AddSquare(4, 0, optimization);
    scene.AddSquare(0, 1, optimization, test.important);
    scene.AddSquare(2, 0, nullptr, test.opaque, 1.0);
    checks.Near(
      std::string(test.name) + ", full size", scene.GetFactor(0, 0, 1), test.full, Tolerance);
    scene.Reference->SetGatherScale(2);
    checks.Near(
      std::string(test.name) + ", half size", scene.GetFactor(0, 0, 1), test.half, Tolerance);
  }
}
}

int TestReferenceImportance(int, char*[])
{
  Checks checks;
  TestMapping<double>(checks);
  TestMapping<float>(checks);
  TestRanges(checks);
  TestPenalty(checks);
  TestEqualImportance(checks);
  TestWeighting(checks);
  TestSmoothing(checks);
  TestViews(checks);
  TestGatherScale(checks);
  return checks.Result();
}
