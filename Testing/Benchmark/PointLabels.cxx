// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PointLabels.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr int FontSize = 13;
constexpr float PointRadius = 7.0f; // pixels that are kept free round a point
constexpr float Gap = 9.0f;         // pixels between a point and its name
constexpr float Padding = 5.0f;     // pixels between names
constexpr float Step = 6.0f;        // pixels by which names move away
constexpr int Steps = 40;
constexpr int Directions = 16;

//------------------------------------------------------------------------------
float FindOverlap(const vtkRectf& a, const vtkRectf& b)
{
  const float width = std::min(a.GetRight(), b.GetRight()) - std::max(a.GetLeft(), b.GetLeft());
  const float height = std::min(a.GetTop(), b.GetTop()) - std::max(a.GetBottom(), b.GetBottom());
  return width > 0.0f && height > 0.0f ? width * height : 0.0f;
}

//------------------------------------------------------------------------------
bool Holds(const vtkRectf& outer, const vtkRectf& inner)
{
  return inner.GetLeft() >= outer.GetLeft() && inner.GetRight() <= outer.GetRight() &&
    inner.GetBottom() >= outer.GetBottom() && inner.GetTop() <= outer.GetTop();
}

//------------------------------------------------------------------------------
// Where a name of that size may stand, the best place first: right of the point and round it, and
// then farther and farther away.
std::vector<vtkRectf> ListPlaces(const vtkVector2f& point, const vtkVector2f& size)
{
  std::vector<vtkRectf> places;
  for (int step = 0; step < Steps; ++step)
  {
    for (int direction = 0; direction < Directions; ++direction)
    {
      const double angle = 2.0 * vtkMath::Pi() * direction / Directions;
      const double x = std::cos(angle);
      const double y = std::sin(angle);
      const double distance = Gap + Step * step;
      // Beside, above and below the point the rectangle begins at that distance.
      places.emplace_back(
        static_cast<float>(point.GetX() + distance * x + 0.5 * (x - 1.0) * size.GetX()),
        static_cast<float>(point.GetY() + distance * y + 0.5 * (y - 1.0) * size.GetY()),
        size.GetX(), size.GetY());
    }
  }
  return places;
}
}

vtkStandardNewMacro(PointLabels);

//------------------------------------------------------------------------------
void PointLabels::AddPoint(const vtkVector2d& values, const std::string& text)
{
  this->Points.push_back({ values, text });
}

//------------------------------------------------------------------------------
vtkRectf PointLabels::GetInside()
{
  vtkAxis* bottom = this->Chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* left = this->Chart->GetAxis(vtkAxis::LEFT);
  const float x = bottom->GetPosition1()[0];
  const float y = left->GetPosition1()[1];
  return vtkRectf(x, y, bottom->GetPosition2()[0] - x, left->GetPosition2()[1] - y);
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
// The first place that is free, or else the one that covers least.
vtkRectf PointLabels::FindPlace(const vtkVector2f& point, const vtkVector2f& size)
{
  const vtkRectf inside = this->GetInside();
  vtkRectf best(inside.GetLeft(), inside.GetBottom(), size.GetX(), size.GetY());
  float least = std::numeric_limits<float>::infinity();
  for (const vtkRectf& place : ListPlaces(point, size))
  {
    const float covered = std::accumulate(this->Taken.begin(), this->Taken.end(), 0.0f,
      [&place](float sum, const vtkRectf& other) { return sum + FindOverlap(place, other); });
    if (Holds(inside, place) && covered < least)
    {
      least = covered;
      best = place;
    }
  }
  return best;
}

//------------------------------------------------------------------------------
bool PointLabels::Paint(vtkContext2D* painter)
{
  vtkNew<vtkTextProperty> font;
  font->SetFontSize(FontSize);
  font->SetColor(0.0, 0.0, 0.0);
  font->SetJustificationToLeft();
  font->SetVerticalJustificationToBottom();
  painter->ApplyTextProp(font);
  vtkNew<vtkPen> pen;
  pen->SetColor(90, 90, 90);
  pen->SetWidth(1.0f);
  painter->ApplyPen(pen);
  vtkNew<vtkBrush> ground;
  ground->SetColor(255, 255, 255, 190);
  painter->ApplyBrush(ground);

  this->Taken.clear();
  for (const Point& point : this->Points)
  {
    const vtkVector2f pixel = this->ToPixels(point.Values);
    this->Taken.emplace_back(pixel.GetX() - PointRadius, pixel.GetY() - PointRadius,
      2.0f * PointRadius, 2.0f * PointRadius);
  }
  for (const Point& point : this->Points)
  {
    if (point.Text.empty())
    {
      continue;
    }
    float bounds[4];
    painter->ComputeStringBounds(point.Text.c_str(), bounds);
    const vtkVector2f pixel = this->ToPixels(point.Values);
    const vtkRectf place = this->FindPlace(pixel, vtkVector2f(bounds[2], bounds[3]));
    this->Taken.emplace_back(place.GetLeft() - Padding, place.GetBottom(),
      place.GetWidth() + 2.0f * Padding, place.GetHeight());
    const float x = std::clamp(pixel.GetX(), place.GetLeft(), place.GetRight());
    const float y = std::clamp(pixel.GetY(), place.GetBottom(), place.GetTop());
    if (std::hypot(x - pixel.GetX(), y - pixel.GetY()) > Gap + 0.5f * Step)
    {
      painter->DrawLine(pixel.GetX(), pixel.GetY(), x, y);
    }
    painter->GetPen()->SetLineType(vtkPen::NO_PEN);
    painter->DrawRect(place.GetLeft(), place.GetBottom(), place.GetWidth(), place.GetHeight());
    painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
    painter->DrawString(place.GetLeft(), place.GetBottom(), point.Text.c_str());
  }
  return true;
}
}
}
