// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointLabels.h"

#include "vtkAxis.h"
#include "vtkContext2D.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr int FontSize = 12;
constexpr float Gap = 9.0f; // pixels between a point and its name

//------------------------------------------------------------------------------
bool Overlap(const vtkRectf& a, const vtkRectf& b)
{
  return a.GetLeft() < b.GetRight() && b.GetLeft() < a.GetRight() && a.GetBottom() < b.GetTop() &&
    b.GetBottom() < a.GetTop();
}

//------------------------------------------------------------------------------
// Where a name of that size may stand, the best place first: beside the point, above and below it,
// and then farther and farther away.
std::vector<vtkRectf> ListPlaces(const vtkVector2f& point, float width, float height)
{
  std::vector<vtkRectf> places;
  for (int row = 0; row <= 8; ++row)
  {
    for (const float sign : { 1.0f, -1.0f })
    {
      const float y = point.GetY() + sign * row * (height + 1.0f) - 0.5f * height;
      for (const float x :
        { point.GetX() + Gap, point.GetX() - Gap - width, point.GetX() - 0.5f * width })
      {
        places.emplace_back(x, y, width, height);
      }
    }
  }
  return places;
}
}

vtkStandardNewMacro(PointLabels);

//------------------------------------------------------------------------------
void PointLabels::AddLabel(const vtkVector2d& values, const std::string& text, bool isBold)
{
  this->Labels.push_back({ values, text, isBold });
}

//------------------------------------------------------------------------------
vtkVector2f PointLabels::ToPixels(const vtkVector2d& values)
{
  vtkVector2f pixels;
  const int axes[2] = { vtkAxis::BOTTOM, vtkAxis::LEFT };
  for (int i = 0; i < 2; ++i)
  {
    vtkAxis* axis = this->Chart->GetAxis(axes[i]);
    const float first = axis->GetPosition1()[i];
    const float last = axis->GetPosition2()[i];
    const double part =
      (std::log10(values[i]) - axis->GetMinimum()) / (axis->GetMaximum() - axis->GetMinimum());
    pixels[i] = static_cast<float>(first + part * (last - first));
  }
  return pixels;
}

//------------------------------------------------------------------------------
bool PointLabels::Paint(vtkContext2D* painter)
{
  vtkNew<vtkTextProperty> font;
  font->SetFontSize(FontSize);
  font->SetColor(0.0, 0.0, 0.0);
  font->SetJustificationToLeft();
  font->SetVerticalJustificationToBottom();

  std::vector<vtkRectf> taken;
  for (const Label& label : this->Labels)
  {
    const vtkVector2f point = this->ToPixels(label.Values);
    taken.emplace_back(point.GetX() - 4.0f, point.GetY() - 4.0f, 8.0f, 8.0f);
  }
  vtkRectf inside = this->Chart->GetSize();
  for (const Label& label : this->Labels)
  {
    font->SetBold(label.IsBold);
    painter->ApplyTextProp(font);
    float bounds[4];
    painter->ComputeStringBounds(label.Text.c_str(), bounds);
    const vtkVector2f point = this->ToPixels(label.Values);
    const auto places = ListPlaces(point, bounds[2], bounds[3]);
    const auto isFree = [&](const vtkRectf& place)
    {
      return place.GetLeft() > inside.GetLeft() && place.GetRight() < inside.GetRight() &&
        std::none_of(taken.begin(), taken.end(),
          [&place](const vtkRectf& other) { return Overlap(place, other); });
    };
    const auto found = std::find_if(places.begin(), places.end(), isFree);
    const vtkRectf place = found == places.end() ? places.front() : *found;
    taken.push_back(place);
    painter->DrawString(place.GetLeft(), place.GetBottom(), label.Text.c_str());
  }
  return true;
}
}
}
