// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OptionText.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
// What follows the last colon, which is taken off the text with it; nothing without a colon.
std::optional<std::string_view> TakeLast(std::string_view& text)
{
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos)
  {
    return std::nullopt;
  }
  const std::string_view last = text.substr(colon + 1);
  text = text.substr(0, colon);
  return last;
}

//------------------------------------------------------------------------------
// "NAME:MINIMUM:MAXIMUM" with both limits.
std::optional<ImportanceTerm> ToTermWithoutWeight(std::string_view text)
{
  const auto maximum = ToLimit(TakeLast(text).value_or(""));
  const auto minimum = ToLimit(TakeLast(text).value_or(""));
  if (!minimum || !maximum || text.empty())
  {
    return std::nullopt;
  }
  return ImportanceTerm{ std::string(text), *minimum, *maximum, 1.0 };
}
}

//------------------------------------------------------------------------------
std::optional<double> ToNumber(std::string_view text)
{
  // Not all standard libraries have std::from_chars() for double. The program keeps the locale C.
  const std::string number(text);
  const bool isDecimal = number.find_first_not_of("+-.0123456789Ee") == std::string::npos;
  char* end = nullptr;
  const double value = std::strtod(number.c_str(), &end);
  const bool isWhole = !number.empty() && *end == '\0';
  return isDecimal && isWhole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<Vector3> ToVector(std::string_view text)
{
  Vector3 vector;
  std::size_t begin = 0;
  for (int i = 0; i < 3; ++i)
  {
    const std::size_t end = i < 2 ? text.find(',', begin) : text.size();
    const auto number =
      end == std::string_view::npos ? std::nullopt : ToNumber(text.substr(begin, end - begin));
    if (!number)
    {
      return std::nullopt;
    }
    vector[i] = *number;
    begin = end + 1;
  }
  return vector;
}

//------------------------------------------------------------------------------
std::optional<std::array<int, 2>> ToSize(std::string_view text)
{
  const std::size_t cross = text.find('x');
  if (cross == std::string_view::npos)
  {
    return std::nullopt;
  }
  const std::string_view sides[2] = { text.substr(0, cross), text.substr(cross + 1) };
  std::array<int, 2> size;
  for (int i = 0; i < 2; ++i)
  {
    const auto side = ToNumber(sides[i]);
    if (!side || *side < 1.0 || *side > LargestSide || *side != std::floor(*side))
    {
      return std::nullopt;
    }
    size[i] = static_cast<int>(*side);
  }
  return size;
}

//------------------------------------------------------------------------------
std::optional<NumberRange> ToRange(std::string_view text)
{
  const auto maximum = ToNumber(TakeLast(text).value_or(""));
  const auto minimum = ToNumber(text);
  return minimum && maximum && *minimum < *maximum
    ? std::optional<NumberRange>({ *minimum, *maximum })
    : std::nullopt;
}

//------------------------------------------------------------------------------
std::optional<RangeLimit> ToLimit(std::string_view text)
{
  const bool isPercentile = !text.empty() && text.back() == '%';
  const auto value = ToNumber(isPercentile ? text.substr(0, text.size() - 1) : text);
  if (!value || (isPercentile && (*value < 0.0 || *value > 100.0)))
  {
    return std::nullopt;
  }
  return RangeLimit{ *value, isPercentile };
}

//------------------------------------------------------------------------------
std::optional<ImportanceTerm> ToImportanceTerm(std::string_view text)
{
  std::string_view front = text;
  const auto weight = ToNumber(TakeLast(front).value_or(""));
  if (auto term = weight ? ToTermWithoutWeight(front) : std::nullopt)
  {
    term->Weight = *weight;
    return *weight >= -1.0 && *weight <= 1.0 ? term : std::nullopt;
  }
  return ToTermWithoutWeight(text);
}

//------------------------------------------------------------------------------
std::optional<SelectionRange> ToSelectionRange(std::string_view text)
{
  const auto last = TakeLast(text);
  const auto first = TakeLast(text);
  if (!first || text.empty() || (first->empty() && last->empty()))
  {
    return std::nullopt;
  }
  const auto minimum = ToLimit(*first);
  const auto maximum = ToLimit(*last);
  if ((!minimum && !first->empty()) || (!maximum && !last->empty()))
  {
    return std::nullopt;
  }
  return SelectionRange{ std::string(text), minimum, maximum };
}

//------------------------------------------------------------------------------
std::optional<ViewChoice> ToView(std::string_view text)
{
  static const std::map<std::string_view, ViewKind> views = { { "picture", ViewKind::Picture },
    { "opacity", ViewKind::Opacity }, { "importance", ViewKind::Importance },
    { "segments", ViewKind::Segments }, { "length", ViewKind::Length } };
  static const std::map<std::string_view, ViewKind> layers = { { "first", ViewKind::FirstLayers },
    { "layer", ViewKind::Layer } };
  if (const auto view = views.find(text); view != views.end())
  {
    return ViewChoice{ view->second };
  }
  const auto number = ToNumber(TakeLast(text).value_or(""));
  const auto view = layers.find(text);
  if (view == layers.end() || !number || *number != std::floor(*number) || *number < 1.0 ||
    *number > std::numeric_limits<int>::max())
  {
    return std::nullopt;
  }
  return ViewChoice{ view->second, static_cast<int>(*number) };
}
}
