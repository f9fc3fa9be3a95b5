// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Choices.h"

#include "OptionText.h"

#include "vtksys/Glob.hxx"
#include "vtksys/RegularExpression.hxx"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <optional>
#include <ostream>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr int WidthOfNames = 30;

//------------------------------------------------------------------------------
// * stands for any text, ? for one character.
bool Matches(const std::string& name, const std::string& pattern)
{
  vtksys::RegularExpression expression(vtksys::Glob::PatternToRegex(pattern));
  return expression.find(name);
}

//------------------------------------------------------------------------------
SceneChoice MakeChoice(const SceneFamily& family, int size)
{
  const std::string name =
    family.LargestSize > 0 ? family.Name + "-" + std::to_string(size) : family.Name;
  return { name, family.Description,
    [make = family.Make, name, size] { return make(name, size); } };
}

//------------------------------------------------------------------------------
std::vector<SceneChoice> ListScenes(const std::vector<SceneFamily>& families)
{
  std::vector<SceneChoice> scenes;
  for (const SceneFamily& family : families)
  {
    if (family.LargestSize == 0)
    {
      scenes.push_back(MakeChoice(family, 0));
    }
    for (const int size : family.Sizes)
    {
      scenes.push_back(MakeChoice(family, size));
    }
  }
  return scenes;
}

//------------------------------------------------------------------------------
// "abc-250"
std::optional<SceneChoice> FindOtherSize(
  const std::vector<SceneFamily>& families, const std::string& name)
{
  for (const SceneFamily& family : families)
  {
    const std::string prefix = family.Name + "-";
    if (family.LargestSize > 0 && name.compare(0, prefix.size(), prefix) == 0)
    {
      const auto size = ToNumber(name.substr(prefix.size()));
      if (size && *size == std::floor(*size) && *size >= 1.0 && *size <= family.LargestSize)
      {
        return MakeChoice(family, static_cast<int>(*size));
      }
    }
  }
  return std::nullopt;
}

//------------------------------------------------------------------------------
template <typename Choice>
std::string ListNames(const std::vector<Choice>& choices)
{
  std::string names;
  for (const Choice& choice : choices)
  {
    names += (names.empty() ? "" : ", ") + choice.Name;
  }
  return names;
}

//------------------------------------------------------------------------------
template <typename Choice>
void Write(std::ostream& stream, const std::string& title, const std::vector<Choice>& choices)
{
  stream << title << "\n";
  for (const Choice& choice : choices)
  {
    stream << "  " << std::left << std::setw(WidthOfNames) << choice.Name << choice.Description
           << "\n";
  }
}
}

//------------------------------------------------------------------------------
std::vector<SceneChoice> ChooseScenes(
  const std::vector<std::string>& patterns, const std::string& dataFolder)
{
  const auto families = MakeSceneFamilies(dataFolder);
  const auto listed = ListScenes(families);
  std::vector<SceneChoice> chosen;
  for (const std::string& pattern : patterns)
  {
    std::vector<SceneChoice> found;
    std::copy_if(listed.begin(), listed.end(), std::back_inserter(found),
      [&pattern](const SceneChoice& scene) { return Matches(scene.Name, pattern); });
    if (const auto other = FindOtherSize(families, pattern); other && found.empty())
    {
      found.push_back(*other);
    }
    if (found.empty())
    {
      throw UnknownName("--scene: no scene is called '" + pattern + "'; there are " +
        ListNames(listed) + ", and those with hyphen in other sizes");
    }
    std::copy_if(found.begin(), found.end(), std::back_inserter(chosen),
      [&chosen](const SceneChoice& scene)
      {
        return std::none_of(chosen.begin(), chosen.end(),
          [&scene](const SceneChoice& other) { return other.Name == scene.Name; });
      });
  }
  return chosen;
}

//------------------------------------------------------------------------------
std::vector<Method> ChooseMethods(const std::vector<std::string>& patterns)
{
  const std::vector<Method>& all = GetMethods();
  for (const std::string& pattern : patterns)
  {
    if (std::none_of(all.begin(), all.end(),
          [&pattern](const Method& method) { return Matches(method.Name, pattern); }))
    {
      throw UnknownName(
        "--method: no method is called '" + pattern + "'; there are " + ListNames(all));
    }
  }
  std::vector<Method> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
    [&patterns](const Method& method)
    {
      return std::any_of(patterns.begin(), patterns.end(),
        [&method](const std::string& pattern) { return Matches(method.Name, pattern); });
    });
  return chosen;
}

//------------------------------------------------------------------------------
std::vector<Method> ChooseSuitable(const std::vector<Method>& methods, const Scene& scene)
{
  std::vector<Method> suitable;
  std::copy_if(methods.begin(), methods.end(), std::back_inserter(suitable),
    [&scene](const Method& method) { return method.Suits(scene); });
  return suitable;
}

//------------------------------------------------------------------------------
void WriteList(std::ostream& stream, const std::string& dataFolder)
{
  Write(stream,
    "Scenes, those with hyphen in other sizes too:", ListScenes(MakeSceneFamilies(dataFolder)));
  Write(stream, "Methods:", GetMethods());
}
}
}
