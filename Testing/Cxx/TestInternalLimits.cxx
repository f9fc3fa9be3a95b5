// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures are right on both sides of every number that the implementation divides its work by: for
// lists of every length from 0 to 513, in every order and with ties; draws of 65536 nodes; rows of
// 8192 segments; blocks of 16 pixels.
#include "SegmentedScene.h"

#include "vtkCellData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <limits>
#include <utility>

namespace
{
constexpr int LongestList = 513;

/** Which depth, of 0 to 1, layer i has. */
using DepthFunction = std::function<double(int)>;

using Color = std::array<double, 3>;

/** Unlit layers; pixel x of a row of pixels sees the first x of them. */
class Stairs
{
public:
  explicit Stairs(DepthFunction depth)
    : Depth(std::move(depth))
    , Colors(LongestList)
  {
    std::mt19937 random(1);
    for (Color& color : this->Colors)
    {
      color = { double(random() % 256), double(random() % 256), double(random() % 256) };
    }
  }

  /// With or without a layer more, whose depth is no number.
  Picture Draw(bool hasDamage) const
  {
    SphereScene scene(LongestList + 1, 1, 0, 0, 0);
    scene.Renderer->AddActor(this->MakeActor(hasDamage));
    scene.Renderer->SetBackground(0.0, 0.0, 0.0);
    vtkCamera* camera = scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.5);
    camera->SetPosition(0.5 * (LongestList + 1), 0.0, 1.0);
    camera->SetFocalPoint(0.5 * (LongestList + 1), 0.0, 0.0);
    camera->SetClippingRange(0.5, 2.5);
    const OpenGLDebugOutput debugOutput(scene.Window);
    vtkTransparencyInstaller::Install(scene.Renderer);
    return Picture::Render(scene.Window);
  }

  /// Front to back, and the one with less red, green and blue first where depths are equal.
  Color GetColor(int layers) const
  {
    std::vector<std::pair<double, Color>> list;
    for (int layer = 0; layer < layers; ++layer)
    {
      list.emplace_back(this->Depth(layer), this->Colors[layer]);
    }
    std::sort(list.begin(), list.end());
    Color sum{};
    double transmittance = 1.0;
    for (const auto& layer : list)
    {
      for (int i = 0; i < 3; ++i)
      {
        sum[i] += transmittance * Opacity * layer.second[i];
      }
      transmittance *= 1.0 - Opacity;
    }
    return sum;
  }

private:
  static constexpr double Opacity = 0.03;

  vtkSmartPointer<vtkActor> MakeActor(bool hasDamage) const
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    const auto add = [&](double left, double z, const Color& color)
    {
      const vtkIdType first = points->InsertNextPoint(left, -1.0, z);
      points->InsertNextPoint(LongestList + 2.0, -1.0, z);
      points->InsertNextPoint(LongestList + 2.0, 1.0, z);
      points->InsertNextPoint(left, 1.0, z);
      quads->InsertNextCell({ first, first + 1, first + 2, first + 3 });
      colors->InsertNextTuple(color.data());
    };
    for (int layer = 0; layer < LongestList; ++layer)
    {
      add(layer + 1.0, -this->Depth(layer), this->Colors[layer]);
    }
    if (hasDamage)
    {
      add(1.0, std::numeric_limits<double>::quiet_NaN(), Color{});
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(quads);
    data->GetCellData()->SetScalars(colors);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetOpacity(Opacity);
    return actor;
  }

  DepthFunction Depth;
  std::vector<Color> Colors;
};

//------------------------------------------------------------------------------
bool TestSortedLists()
{
  std::vector<int> shuffled(LongestList);
  std::iota(shuffled.begin(), shuffled.end(), 0);
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(2));
  const double length = LongestList;
  const std::vector<std::pair<std::string, DepthFunction>> orders = {
    { "sorted lists", [=](int i) { return i / length; } },
    { "reversed lists", [=](int i) { return 1.0 - i / length; } },
    { "shuffled lists", [=](int i) { return shuffled[i] / length; } },
    { "lists with ties", [=](int i) { return shuffled[i] / 7 * 7 / length; } },
    { "lists of two depths", [](int i) { return i % 2; } },
    { "lists of one depth", [](int) { return 0.5; } },
  };
  bool passed = true;
  for (const auto& [name, depth] : orders)
  {
    const Stairs stairs(depth);
    const Picture picture = stairs.Draw(false);
    double largest = 0.0;
    for (int layers = 0; layers <= LongestList; ++layers)
    {
      const Color expected = stairs.GetColor(layers);
      for (int i = 0; i < 3; ++i)
      {
        largest = std::max(largest, std::abs(picture.GetPixel(layers, 0)[i] - expected[i]));
      }
    }
    std::cout << name << ": maximum " << largest << " of 255" << std::endl;
    passed &= Check(largest <= 0.6, name + " differ by " + std::to_string(largest));
    passed &= Check(stairs.Draw(true) == picture, name + " beside a layer without depth");
  }
  return passed;
}

//------------------------------------------------------------------------------
// Balls side by side, so many nodes.
bool TestDrawsOfBalls()
{
  constexpr int nodesOfADraw = 65536;
  bool passed = true;
  for (const int balls : { nodesOfADraw - 1, nodesOfADraw, nodesOfADraw + 1, 2 * nodesOfADraw + 1 })
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> vertices;
    for (int i = 0; i < balls; ++i)
    {
      // The last ones fill the view.
      const int place = balls - 1 - i;
      const vtkIdType point =
        points->InsertNextPoint(0.1 * (place % 30) - 1.5, 0.1 * (place / 30) - 1.5, 0.001 * place);
      vertices->InsertNextCell({ point });
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    SphereScene scene(64, 48, 0, 0, 0);
    ::AddLines(scene, data, 0.08, 0.4);
    passed &= Compare(scene, std::to_string(balls) + " balls");
  }
  return passed;
}

//------------------------------------------------------------------------------
// A tube whose bends are in two draws.
bool TestDrawsOfALine()
{
  constexpr int points = 65536 + 8;
  vtkSmartPointer<vtkPolyData> data = MakeLines(1, points, 0);
  for (int i = 0; i < points; ++i)
  {
    const int visible = std::max(i - (points - 16), 0);
    data->GetPoints()->SetPoint(
      i, 0.2 * visible - 1.5 - 1e-6 * (points - i), 0.2 * (visible % 3), 0.1 * (visible % 2));
  }
  data->SetVerts(nullptr);
  SphereScene scene(300, 200, 0, 0, 0);
  AddLines(scene, data, 0.15, 0.9);
  vtkTransparencyInstaller::Install(scene.Renderer);
  scene.Window->Render();
  const ReferenceComparison comparison(scene.Window, scene.Renderer);
  return Check(comparison.GetNumberOfFragments() > 1000 && comparison.GetUnexplainedPixels() == 0,
    "a line of two draws");
}

//------------------------------------------------------------------------------
bool TestRowsOfSegments()
{
  constexpr int row = 8192;
  bool passed = true;
  for (const int segments : { row - 1, row, row + 1 })
  {
    SphereScene scene(300, 300, 0, 0, 0);
    const auto data = MakeSegmentedLines(40, segments);
    Optimize(AddLines(scene, data, 0.04, 1.0), 50.0, 100.0, 3.0, 5, false);
    passed &= Compare(scene, std::to_string(segments) + " segments wanted");
  }
  return passed;
}

//------------------------------------------------------------------------------
bool TestBlocksOfPixels()
{
  bool passed = true;
  for (const int width : { 15, 16, 17, 33 })
  {
    SphereScene scene(width, 48 - width, 0, 8, 1);
    passed &= Compare(scene, std::to_string(width) + " pixels wide");
  }
  return passed;
}
}

//------------------------------------------------------------------------------
int TestInternalLimits(int, char*[])
{
  bool passed = TestSortedLists();
  passed &= TestDrawsOfBalls();
  passed &= TestDrawsOfALine();
  passed &= TestRowsOfSegments();
  passed &= TestBlocksOfPixels();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
