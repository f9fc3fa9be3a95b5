// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Record.h"

#include "Methods.h"
#include "PlainText.h"
#include "RenderError.h"
#include "Statistics.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <tuple>
#include <vector>

namespace pellucid
{
namespace benchmark
{
namespace
{
//------------------------------------------------------------------------------
// A scene in a window.
struct Setting
{
  std::string Scene;
  int Width;
  int Height;
  double Opacity;

  std::string GetSize() const
  {
    return std::to_string(this->Width) + "x" + std::to_string(this->Height);
  }

  bool operator<(const Setting& other) const
  {
    return std::tie(this->Scene, this->Width, this->Height, this->Opacity) <
      std::tie(other.Scene, other.Width, other.Height, other.Opacity);
  }
};

//------------------------------------------------------------------------------
struct Figure
{
  double Milliseconds;
  std::optional<double> Error;
  bool IsOnFront;
};

//------------------------------------------------------------------------------
// What a file says, in its order.
struct Results
{
  std::string Machine;
  std::vector<Setting> Settings;
  std::map<std::string, std::map<Setting, Figure>> Methods;
};

//------------------------------------------------------------------------------
Results ParseResults(const nlohmann::json& document)
{
  Results results;
  const auto& machine = document.at("machine");
  results.Machine = machine.at("renderer").get<std::string>() + ", VTK " +
    machine.at("vtk").get<std::string>() + ", " + machine.at("processor").get<std::string>();
  std::set<Setting> known;
  for (const auto& row : document.at("rows"))
  {
    const Setting setting = { row.at("scene"), row.at("width"), row.at("height"), row.at("alpha") };
    if (known.insert(setting).second)
    {
      results.Settings.push_back(setting);
    }
    if (row.at("median_ms").is_null() || row.value("cold", false))
    {
      continue; // There is no time to compare.
    }
    const auto& error = row.at("rmse");
    results.Methods[row.at("method")].insert({ setting,
      { row.at("median_ms"), error.is_null() ? std::nullopt : std::optional<double>(error),
        row.at("on_front") } });
  }
  return results;
}

//------------------------------------------------------------------------------
void CheckMethods(const Results& results, const std::string& fileName)
{
  const auto& methods = GetMethods();
  for (const auto& measured : results.Methods)
  {
    if (std::none_of(methods.begin(), methods.end(),
          [&measured](const Method& method) { return method.Name == measured.first; }))
    {
      throw RenderError(fileName + ": expected methods that --list names, found '" +
        measured.first + "'; measure again with this version");
    }
  }
  if (results.Methods.count(ProductName) == 0)
  {
    throw RenderError(fileName + ": expected a row of '" + ProductName +
      "' to compare with, found none; measure it beside the candidates");
  }
}

//------------------------------------------------------------------------------
Results ReadResults(const std::string& fileName)
{
  std::ifstream file(fileName);
  if (!file)
  {
    throw RenderError(fileName + ": cannot be read");
  }
  Results results;
  try
  {
    results = ParseResults(nlohmann::json::parse(file));
  }
  catch (const nlohmann::json::exception& error)
  {
    throw RenderError(
      fileName + ": expected a file that --json has written, found: " + error.what());
  }
  CheckMethods(results, fileName);
  return results;
}

//------------------------------------------------------------------------------
// Names with as much as tells them apart.
class SettingNames
{
public:
  explicit SettingNames(const std::vector<Setting>& settings)
  {
    for (const Setting& setting : settings)
    {
      this->Sizes.insert(setting.GetSize());
      this->Opacities.insert(setting.Opacity);
    }
  }

  std::string Get(const Setting& setting) const
  {
    return setting.Scene + (this->Sizes.size() > 1 ? " " + setting.GetSize() : "") +
      (this->Opacities.size() > 1 ? " at " + ToText(setting.Opacity) : "");
  }

  /** What all have in common. */
  std::string GetCommon() const
  {
    return (this->Sizes.size() == 1 ? ", " + *this->Sizes.begin() : "") +
      (this->Opacities.size() == 1 ? ", opacity " + ToText(*this->Opacities.begin()) : "");
  }

private:
  std::set<std::string> Sizes;
  std::set<double> Opacities;
};

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& words)
{
  std::string text;
  for (const std::string& word : words)
  {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

//------------------------------------------------------------------------------
std::string ToFixed(double value)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << (std::abs(value) < 0.005 ? 0.0 : value);
  return text.str();
}

//------------------------------------------------------------------------------
void WriteCandidate(
  std::ostream& stream, const Method& method, const Results& results, const SettingNames& names)
{
  const auto& product = results.Methods.at(ProductName);
  const auto& figures = results.Methods.at(method.Name);
  std::vector<std::string> fronts;
  std::vector<double> ratios;
  std::vector<double> errors;
  for (const Setting& setting : results.Settings)
  {
    const auto candidate = figures.find(setting);
    const auto own = product.find(setting);
    if (candidate == figures.end() || own == product.end())
    {
      continue;
    }
    if (candidate->second.IsOnFront)
    {
      fronts.push_back(names.Get(setting));
    }
    ratios.push_back(candidate->second.Milliseconds / own->second.Milliseconds);
    if (candidate->second.Error && own->second.Error)
    {
      errors.push_back(*candidate->second.Error - *own->second.Error);
    }
  }
  const auto quantile = [](const std::vector<double>& values, double p)
  { return values.empty() ? "" : ToFixed(FindQuantile(values, p)); };
  stream << "| `" << method.Name << "` | " << (fronts.empty() ? "-" : Join(fronts)) << " | "
         << quantile(ratios, 0.0) << " | " << quantile(ratios, 0.5) << " | "
         << quantile(ratios, 1.0) << " | " << quantile(errors, 1.0) << " | " << method.Reason
         << " |\n";
}
}

//------------------------------------------------------------------------------
void PrintRecord(const std::string& fileName, std::ostream& stream)
{
  const Results results = ReadResults(fileName);
  const SettingNames names(results.Settings);
  std::vector<std::string> settings;
  std::transform(results.Settings.begin(), results.Settings.end(), std::back_inserter(settings),
    [&names](const Setting& setting) { return names.Get(setting); });
  stream << results.Machine << names.GetCommon() << ": " << Join(settings) << ".\n\n"
         << "| candidate | on the front of | least time / product | median | largest "
            "| RMSE above product, at most | why it is not in the product |\n"
         << "| --- | --- | --- | --- | --- | --- | --- |\n";
  for (const Method& method : GetMethods())
  {
    if (!method.Reason.empty() && results.Methods.count(method.Name) > 0)
    {
      WriteCandidate(stream, method, results, names);
    }
  }
}
}
}
