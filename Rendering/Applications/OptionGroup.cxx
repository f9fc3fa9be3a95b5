// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OptionGroup.h"

#include "OptionText.h"
#include "PlainText.h"

#include <cmath>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
std::string DescribeRange(const std::string& kind, double minimum, double maximum)
{
  std::string text = kind;
  if (minimum > -OptionGroup::Unbounded)
  {
    text += " of at least " + ToText(minimum);
  }
  if (maximum < OptionGroup::LargestInteger)
  {
    text += " and at most " + ToText(maximum);
  }
  return text;
}
}

//------------------------------------------------------------------------------
void Refuse(const std::string& option, const std::string& expected, const std::string& found)
{
  throw CLI::ValidationError(option, "expected " + expected + ", found '" + found + "'");
}

//------------------------------------------------------------------------------
OptionGroup::OptionGroup(CLI::App& app, std::string title)
  : App(app)
  , Title(std::move(title))
{
}

//------------------------------------------------------------------------------
CLI::Option* OptionGroup::Add(
  const std::string& name, const Parser& parse, const std::string& metavar, const std::string& help)
{
  return this->App.add_option_function<std::string>(name, parse, help)
    ->type_name(metavar)
    ->group(this->Title);
}

//------------------------------------------------------------------------------
void OptionGroup::AddRepeatable(
  const std::string& name, const Parser& parse, const std::string& metavar, const std::string& help)
{
  this->App
    .add_option_function<std::vector<std::string>>(
      name,
      [parse](const std::vector<std::string>& texts)
      { std::for_each(texts.begin(), texts.end(), parse); },
      help)
    ->allow_extra_args(false)
    ->type_name(metavar)
    ->group(this->Title);
}

//------------------------------------------------------------------------------
double OptionGroup::CheckNumber(
  const std::string& name, const std::string& text, double minimum, double maximum)
{
  const auto number = ToNumber(text);
  if (!number || *number < minimum || *number > maximum)
  {
    Refuse(name, DescribeRange("a number", minimum, maximum), text);
  }
  return *number;
}

//------------------------------------------------------------------------------
int OptionGroup::CheckInteger(
  const std::string& name, const std::string& text, int minimum, int maximum)
{
  const auto number = ToNumber(text);
  if (!number || *number != std::floor(*number) || *number < minimum || *number > maximum)
  {
    Refuse(name, DescribeRange("a whole number", minimum, maximum), text);
  }
  return static_cast<int>(*number);
}

//------------------------------------------------------------------------------
void OptionGroup::AddVector(
  const std::string& name, std::optional<Vector3>& value, const std::string& help)
{
  this->Add(
    name,
    [&value, name](const std::string& text)
    {
      value = ToVector(text);
      if (!value)
      {
        Refuse(name, "three numbers X,Y,Z", text);
      }
    },
    "X,Y,Z", help);
}

//------------------------------------------------------------------------------
void OptionGroup::AddText(
  const std::string& name, std::string& value, const std::string& metavar, const std::string& help)
{
  this->App.add_option(name, value, help)->type_name(metavar)->group(this->Title);
}

//------------------------------------------------------------------------------
CLI::Option* OptionGroup::AddFlag(const std::string& name, bool& value, const std::string& help)
{
  return this->App.add_flag(name, value, help)->group(this->Title);
}
}
