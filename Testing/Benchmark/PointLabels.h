// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Names beside the points of a chart, none over another where there is room.
 */

#ifndef PointLabels_h
#define PointLabels_h

#include "vtkChartXY.h"
#include "vtkContextItem.h"
#include "vtkRect.h"
#include "vtkVector.h"

#include <string> // for names
#include <vector> // for labels

namespace pellucid
{
namespace benchmark
{
/**
 * An item of a chart whose axes both are logarithmic. Names stay within the axes. Those that have
 * no room beside their point are farther away, with a line to it.
 */
class PointLabels : public vtkContextItem
{
public:
  static PointLabels* New();
  vtkTypeMacro(PointLabels, vtkContextItem);

  /** Keep the point at these values of the chart's bottom and left axis free, and put its text,
   * unless that is empty, beside it. */
  void AddPoint(const vtkVector2d& values, const std::string& text);

  void SetChart(vtkChartXY* chart) { this->Chart = chart; }

  bool Paint(vtkContext2D* painter) override;

private:
  struct Point
  {
    vtkVector2d Values;
    std::string Text;
  };

  vtkRectf GetInside();
  vtkVector2f ToPixels(const vtkVector2d& values);
  vtkRectf FindPlace(const vtkVector2f& point, const vtkVector2f& size);

  std::vector<Point> Points;
  std::vector<vtkRectf> Taken; // while it paints: points and names
  vtkChartXY* Chart = nullptr; // which owns this item
};
}
}

#endif
