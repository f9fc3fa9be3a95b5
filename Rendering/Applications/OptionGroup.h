// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Options whose text is checked here, so that messages say what was expected and found.
 */

#ifndef OptionGroup_h
#define OptionGroup_h

#include "RenderOptions.h"

#include <CLI/CLI.hpp>

#include <functional> // for parsers
#include <limits>     // for the default bounds

namespace pellucid
{
/** Ends parsing with a message: wrong usage. */
[[noreturn]] void Refuse(
  const std::string& option, const std::string& expected, const std::string& found);

/** One titled part of the help. */
class OptionGroup
{
public:
  using Parser = std::function<void(const std::string&)>;

  static constexpr double Unbounded = std::numeric_limits<double>::max();
  static constexpr int LargestInteger = std::numeric_limits<int>::max();

  OptionGroup(CLI::App& app, std::string title);

  CLI::Option* Add(const std::string& name, const Parser& parse, const std::string& metavar,
    const std::string& help);

  /** May stand several times; each is parsed. */
  void AddRepeatable(const std::string& name, const Parser& parse, const std::string& metavar,
    const std::string& help);

  /** `value` may be optional. */
  template <typename Value>
  void AddNumber(const std::string& name, Value& value, double minimum, double maximum,
    const std::string& metavar, const std::string& help)
  {
    this->Add(
      name,
      [&value, name, minimum, maximum](const std::string& text)
      { value = CheckNumber(name, text, minimum, maximum); },
      metavar, help);
  }

  /** `value` may be optional. */
  template <typename Value>
  void AddInteger(const std::string& name, Value& value, int minimum, int maximum,
    const std::string& metavar, const std::string& help)
  {
    this->Add(
      name,
      [&value, name, minimum, maximum](const std::string& text)
      { value = CheckInteger(name, text, minimum, maximum); },
      metavar, help);
  }

  void AddVector(const std::string& name, std::optional<Vector3>& value, const std::string& help);

  void AddText(const std::string& name, std::string& value, const std::string& metavar,
    const std::string& help);

  CLI::Option* AddFlag(const std::string& name, bool& value, const std::string& help);

  template <typename Value>
  void AddChoice(const std::string& name, Value& value,
    const std::vector<std::pair<std::string, Value>>& choices, const std::string& help)
  {
    std::string names;
    for (const auto& choice : choices)
    {
      names += (names.empty() ? "" : "|") + choice.first;
    }
    this->Add(
      name,
      [&value, name, names, choices](const std::string& text)
      {
        for (const auto& choice : choices)
        {
          if (choice.first == text)
          {
            value = choice.second;
            return;
          }
        }
        Refuse(name, names, text);
      },
      names, help);
  }

private:
  static double CheckNumber(
    const std::string& name, const std::string& text, double minimum, double maximum);
  static int CheckInteger(
    const std::string& name, const std::string& text, int minimum, int maximum);

  CLI::App& App;
  std::string Title;
};
}

#endif
