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
/** An item of a chart whose axes both are logarithmic. */
class PointLabels : public vtkContextItem
{
public:
  static PointLabels* New();
  vtkTypeMacro(PointLabels, vtkContextItem);

  /** Label the point at these values of the chart's bottom and left axis. */
  void AddLabel(const vtkVector2d& values, const std::string& text, bool isBold);

  void SetChart(vtkChartXY* chart) { this->Chart = chart; }

  bool Paint(vtkContext2D* painter) override;

private:
  struct Label
  {
    vtkVector2d Values;
    std::string Text;
    bool IsBold;
  };

  vtkVector2f ToPixels(const vtkVector2d& values);

  std::vector<Label> Labels;
  vtkChartXY* Chart = nullptr; // which owns this item
};
}
}

#endif
