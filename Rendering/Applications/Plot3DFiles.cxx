// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Plot3DFiles.h"

#include "RenderError.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace pellucid
{
namespace
{
const std::vector<std::string> Suffixes = { ".bin", ".xyz", ".x", ".g", ".p3d", ".q", ".f" };

// How the names of a grid and its solution end.
const std::vector<std::pair<std::string, std::string>> Endings = { { "xyz.bin", "q.bin" },
  { ".xyz", ".q" }, { ".x", ".q" }, { ".g", ".q" }, { ".p3d", ".q" }, { ".bin", ".q" } };

//------------------------------------------------------------------------------
bool EndsWith(const std::string& text, const std::string& ending)
{
  return text.size() >= ending.size() &&
    text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

//------------------------------------------------------------------------------
std::string ReplaceEnding(
  const std::string& text, const std::string& ending, const std::string& replacement)
{
  return text.substr(0, text.size() - ending.size()) + replacement;
}

//------------------------------------------------------------------------------
// The pairs that the name may belong to, the likeliest first.
std::vector<Plot3DFiles> ListCandidates(const std::string& fileName)
{
  std::vector<Plot3DFiles> candidates;
  for (const auto& [grid, solution] : Endings)
  {
    if (EndsWith(fileName, grid))
    {
      candidates.push_back({ fileName, ReplaceEnding(fileName, grid, solution) });
    }
    else if (EndsWith(fileName, solution))
    {
      candidates.push_back({ ReplaceEnding(fileName, solution, grid), fileName });
    }
  }
  return candidates;
}

//------------------------------------------------------------------------------
// Take the file out of the list; whether it was in it.
bool Take(std::vector<std::string>& fileNames, const std::string& fileName)
{
  const auto found = std::find(fileNames.begin(), fileNames.end(), fileName);
  if (found == fileNames.end())
  {
    return false;
  }
  fileNames.erase(found);
  return true;
}
}

//------------------------------------------------------------------------------
bool IsPlot3DFileName(const std::string& fileName)
{
  const std::string suffix =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(fileName));
  return std::find(Suffixes.begin(), Suffixes.end(), suffix) != Suffixes.end();
}

//------------------------------------------------------------------------------
std::string ListPlot3DSuffixes()
{
  std::string list;
  for (const std::string& suffix : Suffixes)
  {
    list += (list.empty() ? "" : " ") + suffix;
  }
  return list;
}

//------------------------------------------------------------------------------
Plot3DFiles TakePlot3DFiles(std::vector<std::string>& fileNames)
{
  const std::string first = fileNames.front();
  fileNames.erase(fileNames.begin());
  const auto candidates = ListCandidates(first);
  for (const Plot3DFiles& files : candidates)
  {
    const std::string& partner = files.Grid == first ? files.Solution : files.Grid;
    if (Take(fileNames, partner) || std::filesystem::exists(partner))
    {
      return files;
    }
  }
  if (!fileNames.empty() && IsPlot3DFileName(fileNames.front()))
  {
    const std::string second = fileNames.front();
    fileNames.erase(fileNames.begin());
    return { first, second };
  }
  std::string wanted;
  for (const Plot3DFiles& files : candidates)
  {
    wanted = wanted.empty() ? files.Grid == first ? files.Solution : files.Grid : wanted;
  }
  throw RenderError(first + ": PLOT3D needs a grid and a solution; name both" +
    (wanted.empty() ? "" : ", or put the other one at " + wanted));
}
}
