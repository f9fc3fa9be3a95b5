// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "ErrorTimePlot.h"

#include "Methods.h"
#include "ParetoFront.h"
#include "PictureWindow.h"
#include "PlainText.h"
#include "PointLabels.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartMatrix.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr int PanelWidth = 1000;
constexpr int PanelHeight = 640;
constexpr int LargestNumberOfColumns = 2;

// Of 255; less is drawn as this.
constexpr double LeastError = 0.01;

// Parts of a power of ten that are free round the points.
constexpr double Margin = 0.12;

constexpr float MarkerSize = 10.0f;
constexpr float ProductSize = 13.0f;
constexpr float FrontSize = 20.0f;
constexpr float FrontWidth = 5.0f;

using Points = std::vector<vtkVector2d>;

//------------------------------------------------------------------------------
struct Style
{
  vtkColor3ub Color;
  int Marker;
};

const Style ProductStyle = { vtkColor3ub(214, 39, 40), vtkPlotPoints::CIRCLE };

// As many as there are other families, all different, dark on white.
const std::vector<Style> Styles = {
  { vtkColor3ub(0, 0, 0), vtkPlotPoints::DIAMOND },
  { vtkColor3ub(127, 127, 127), vtkPlotPoints::SQUARE },
  { vtkColor3ub(31, 119, 180), vtkPlotPoints::SQUARE },
  { vtkColor3ub(44, 160, 44), vtkPlotPoints::PLUS },
  { vtkColor3ub(148, 103, 189), vtkPlotPoints::CROSS },
  { vtkColor3ub(140, 86, 75), vtkPlotPoints::SQUARE },
  { vtkColor3ub(0, 128, 128), vtkPlotPoints::DIAMOND },
  { vtkColor3ub(128, 128, 0), vtkPlotPoints::CROSS },
  { vtkColor3ub(0, 0, 160), vtkPlotPoints::PLUS },
  { vtkColor3ub(230, 97, 1), vtkPlotPoints::DIAMOND },
  { vtkColor3ub(227, 119, 194), vtkPlotPoints::CIRCLE },
  { vtkColor3ub(23, 160, 207), vtkPlotPoints::CROSS },
};

struct Front
{
  const char* Shape;
  const char* Name;
  vtkColor3ub Color;
};
const std::vector<Front> Fronts = {
  { "cones", "front: cones", vtkColor3ub(255, 205, 90) },
  { "triangles", "front: triangles", vtkColor3ub(175, 210, 245) },
};

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
vtkPlotPoints* AddPoints(
  vtkChartXY* chart, const std::string& name, const Points& points, const Style& style, bool isLine)
{
  const int kind = isLine && points.size() > 1 ? vtkChart::LINE : vtkChart::POINTS;
  auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(kind));
  plot->SetInputData(MakeTable(points), "time", "error");
  plot->SetLabel(name);
  plot->SetMarkerStyle(style.Marker);
  plot->SetColor(style.Color.GetRed(), style.Color.GetGreen(), style.Color.GetBlue(), 255);
  plot->SetWidth(1.5f);
  return plot;
}

//------------------------------------------------------------------------------
// At 1, 2 and 5 times the powers of ten: VTK's own are too few within one of them.
void PrepareAxis(vtkAxis* axis, const std::string& title, double minimum, double maximum)
{
  const double low = std::log10(minimum) - Margin;
  const double high = std::log10(maximum) + Margin;
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  for (int exponent = static_cast<int>(std::floor(low)); exponent <= high; ++exponent)
  {
    for (const double factor : { 1.0, 2.0, 5.0 })
    {
      const double place = std::log10(factor) + exponent;
      if (place >= low && place <= high)
      {
        places->InsertNextValue(place);
        labels->InsertNextValue(ToText(factor * std::pow(10.0, exponent)));
      }
    }
  }
  axis->SetTitle(title);
  axis->SetLogScale(true);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetUnscaledRange(std::pow(10.0, low), std::pow(10.0, high));
  axis->SetCustomTickPositions(places, labels);
  axis->GetTitleProperties()->SetFontSize(15);
  axis->GetLabelProperties()->SetFontSize(13);
  axis->GetGridPen()->SetColor(225, 225, 225);
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
void PrepareLegend(vtkChartXY* chart)
{
  chart->SetShowLegend(true);
  vtkChartLegend* legend = chart->GetLegend();
  legend->SetInline(false);
  legend->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->SetLabelSize(13);
  legend->GetPen()->SetLineType(vtkPen::NO_PEN);
}

//------------------------------------------------------------------------------
void AddFronts(vtkChartXY* chart, const std::vector<const Row*>& rows)
{
  for (const Front& front : Fronts)
  {
    Points points;
    for (const Row* row : rows)
    {
      if (row->IsOnFront && row->Shape == front.Shape)
      {
        points.push_back(GetPoint(*row));
      }
    }
    if (!points.empty())
    {
      std::sort(points.begin(), points.end(),
        [](const vtkVector2d& a, const vtkVector2d& b) { return a[0] < b[0]; });
      vtkPlotPoints* plot =
        AddPoints(chart, front.Name, points, { front.Color, vtkPlotPoints::CIRCLE }, true);
      plot->SetMarkerSize(FrontSize);
      plot->SetWidth(FrontWidth);
    }
  }
}

//------------------------------------------------------------------------------
// Each family in the order of its parameter; a line joins only what has one.
void AddFamilies(
  vtkChartXY* chart, const std::vector<const Row*>& rows, const std::vector<std::string>& families)
{
  for (std::size_t i = 0; i < families.size(); ++i)
  {
    std::vector<const Row*> members;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(members),
      [&](const Row* row) { return row->Family == families[i]; });
    std::stable_sort(members.begin(), members.end(),
      [](const Row* a, const Row* b) { return a->Parameter < b->Parameter; });
    Points points;
    std::transform(members.begin(), members.end(), std::back_inserter(points),
      [](const Row* row) { return GetPoint(*row); });
    if (!points.empty())
    {
      const bool isProduct = families[i] == ProductName;
      const Style& style = isProduct ? ProductStyle : Styles[i % Styles.size()];
      const bool isLine = members.front()->Parameter.has_value();
      AddPoints(chart, families[i], points, style, isLine)
        ->SetMarkerSize(isProduct ? ProductSize : MarkerSize);
    }
  }
}

//------------------------------------------------------------------------------
// Of those on a front that are as good, the fastest; and the product.
bool IsNamed(const Row& row, const std::vector<const Row*>& rows)
{
  const auto replaces = [&row](const Row* other)
  {
    return other->IsOnFront && other->Shape == row.Shape && other->GetMedian() < row.GetMedian() &&
      std::abs(other->Error->RootMeanSquare - row.Error->RootMeanSquare) <= ErrorTolerance;
  };
  return row.Family == ProductName ||
    (row.IsOnFront && std::none_of(rows.begin(), rows.end(), replaces));
}

//------------------------------------------------------------------------------
void FillPanel(
  vtkChartXY* chart, const std::vector<const Row*>& rows, const std::vector<std::string>& families)
{
  Points all;
  vtkNew<PointLabels> labels;
  labels->SetChart(chart);
  for (const Row* row : rows)
  {
    all.push_back(GetPoint(*row));
    labels->AddPoint(all.back(), IsNamed(*row, rows) ? row->Method : "");
  }
  AddFronts(chart, rows);
  AddFamilies(chart, rows, families);
  PrepareAxes(chart, all);
  PrepareLegend(chart);
  chart->SetLayoutStrategy(vtkChart::FILL_RECT); // which leaves room for the legend
  chart->SetTitle(MakeTitle(*rows.front()));
  chart->GetTitleProperties()->SetFontSize(17);
  chart->AddItem(labels);
}

//------------------------------------------------------------------------------
// Each looks the same in all panels.
std::vector<std::string> FindFamilies(const std::vector<Row>& rows)
{
  std::vector<std::string> families;
  for (const Row& row : rows)
  {
    if (std::find(families.begin(), families.end(), row.Family) == families.end())
    {
      families.push_back(row.Family);
    }
  }
  // On top of all others.
  std::stable_partition(families.begin(), families.end(),
    [](const std::string& family) { return family != ProductName; });
  return families;
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
  const auto families = FindFamilies(rows);
  const int count = std::max<int>(1, static_cast<int>(panels.size()));
  const int columns = std::min(count, LargestNumberOfColumns);
  const int lines = (count + columns - 1) / columns;
  vtkNew<vtkChartMatrix> matrix;
  matrix->SetSize(vtkVector2i(columns, lines));
  matrix->SetGutter(vtkVector2f(30.0f, 30.0f));
  matrix->SetBorders(10, 10, 10, 10);
  for (int i = 0; i < static_cast<int>(panels.size()); ++i)
  {
    // The matrix counts from the bottom.
    const vtkVector2i place(i % columns, lines - 1 - i / columns);
    FillPanel(vtkChartXY::SafeDownCast(matrix->GetChart(place)), panels[i], families);
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
