// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorTimePlot.h"

#include "PictureWindow.h"
#include "PlainText.h"
#include "PointLabels.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartMatrix.h"
#include "vtkChartXY.h"
#include "vtkColorSeries.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkRenderer.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr int PanelWidth = 760;
constexpr int PanelHeight = 560;
constexpr int LargestNumberOfColumns = 3;

// Of 255; less is drawn as this.
constexpr double LeastError = 0.01;

// Parts of a power of ten that are free round the points, for the names.
constexpr double Margin = 0.35;

using Points = std::vector<vtkVector2d>;

//------------------------------------------------------------------------------
vtkVector2d GetPoint(const Row& row)
{
  return vtkVector2d(row.GetMedian(), std::max(LeastError, row.Error->RootMeanSquare));
}

//------------------------------------------------------------------------------
std::string MakeTitle(const Row& row)
{
  return row.Scene + ", " + std::to_string(row.Width) + "x" + std::to_string(row.Height) +
    ", opacity " + ToText(row.Opacity);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeTable(const Points& points)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const char* names[2] = { "time", "error" };
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(names[i]);
    for (const vtkVector2d& point : points)
    {
      column->InsertNextValue(point[i]);
    }
    table->AddColumn(column);
  }
  return table;
}

//------------------------------------------------------------------------------
void AddPoints(vtkChartXY* chart, const Points& points, const vtkColor3ub& color, float markerSize,
  float lineWidth)
{
  const int kind = points.size() > 1 ? vtkChart::LINE : vtkChart::POINTS;
  auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(kind));
  plot->SetInputData(MakeTable(points), "time", "error");
  plot->SetMarkerStyle(vtkPlotPoints::CIRCLE);
  plot->SetMarkerSize(markerSize);
  plot->SetColor(color.GetRed(), color.GetGreen(), color.GetBlue(), 255);
  plot->SetWidth(lineWidth);
}

//------------------------------------------------------------------------------
void PrepareAxis(vtkAxis* axis, const std::string& title, double minimum, double maximum)
{
  axis->SetTitle(title);
  axis->SetLogScale(true);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetUnscaledRange(minimum / std::pow(10.0, Margin), maximum * std::pow(10.0, Margin));
  axis->GetTitleProperties()->SetFontSize(14);
  axis->GetLabelProperties()->SetFontSize(12);
}

//------------------------------------------------------------------------------
void PrepareAxes(vtkChartXY* chart, const Points& points)
{
  const auto range = [&points](int i)
  {
    return std::minmax_element(points.begin(), points.end(),
      [i](const vtkVector2d& a, const vtkVector2d& b) { return a[i] < b[i]; });
  };
  const auto [fastest, slowest] = range(0);
  const auto [best, worst] = range(1);
  PrepareAxis(
    chart->GetAxis(vtkAxis::BOTTOM), "time of a frame, ms", fastest->GetX(), slowest->GetX());
  PrepareAxis(chart->GetAxis(vtkAxis::LEFT), "error of the picture, RMSE of 255", best->GetY(),
    worst->GetY());
}

//------------------------------------------------------------------------------
void FillPanel(vtkChartXY* chart, const std::vector<const Row*>& rows)
{
  Points all;
  Points front;
  std::vector<std::string> names;
  std::map<std::string, Points> families;
  vtkNew<PointLabels> labels;
  labels->SetChart(chart);
  for (const Row* row : rows)
  {
    const vtkVector2d point = GetPoint(*row);
    all.push_back(point);
    if (row->IsOnFront)
    {
      front.push_back(point);
    }
    // Only methods in the order of their costs make a line that means something.
    const std::string& family = row->HasOptimizedOpacities ? row->Method : row->Family;
    if (families.count(family) == 0)
    {
      names.push_back(family);
    }
    families[family].push_back(point);
    labels->AddLabel(point, row->Method, row->IsOnFront);
  }
  std::sort(front.begin(), front.end(),
    [](const vtkVector2d& a, const vtkVector2d& b) { return a[0] < b[0]; });
  AddPoints(chart, front, vtkColor3ub(255, 200, 40), 18.0f, 4.0f);
  vtkNew<vtkColorSeries> colors;
  colors->SetColorScheme(vtkColorSeries::BREWER_QUALITATIVE_DARK2);
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    AddPoints(
      chart, families[names[i]], colors->GetColorRepeating(static_cast<int>(i)), 8.0f, 1.5f);
  }
  PrepareAxes(chart, all);
  chart->SetTitle(MakeTitle(*rows.front()));
  chart->GetTitleProperties()->SetFontSize(16);
  chart->AddItem(labels);
}

//------------------------------------------------------------------------------
std::vector<std::vector<const Row*>> FindPanels(const std::vector<Row>& rows)
{
  std::vector<std::vector<const Row*>> panels;
  for (const Row& row : rows)
  {
    if (!row.Error)
    {
      continue;
    }
    if (panels.empty() || MakeTitle(*panels.back().front()) != MakeTitle(row))
    {
      panels.emplace_back();
    }
    panels.back().push_back(&row);
  }
  return panels;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> DrawErrorTimePlot(const std::vector<Row>& rows)
{
  const auto panels = FindPanels(rows);
  const int count = std::max<int>(1, static_cast<int>(panels.size()));
  const int columns = std::min(count, LargestNumberOfColumns);
  const int lines = (count + columns - 1) / columns;
  vtkNew<vtkChartMatrix> matrix;
  matrix->SetSize(vtkVector2i(columns, lines));
  matrix->SetGutter(vtkVector2f(70.0f, 80.0f));
  matrix->SetBorders(70, 60, 20, 40);
  for (int i = 0; i < static_cast<int>(panels.size()); ++i)
  {
    // The matrix counts from the bottom.
    const vtkVector2i place(i % columns, lines - 1 - i / columns);
    FillPanel(vtkChartXY::SafeDownCast(matrix->GetChart(place)), panels[i]);
  }
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(matrix);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  PictureWindow window({ columns * PanelWidth, lines * PanelHeight });
  window.AddRenderer(renderer);
  window.Render();
  return window.Grab(false);
}
}
}
