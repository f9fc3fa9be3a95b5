// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Random scenes look as the double-precision reference draws them, with the same bits in any order.
// A scene that does not is shrunk, and printed so that --replay can repeat it.
//
//   pellucidStressTests TestRandomScenes --seconds 3600 --seed 5
//   pellucidStressTests TestRandomScenes --replay scene.json
#include "SceneCheck.h"
#include "SceneGenerator.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace
{
using pellucid::SceneDescription;

std::string Join(const std::vector<std::string>& lines)
{
  std::string text;
  for (const std::string& line : lines)
  {
    text += line + "\n";
  }
  return text;
}

bool Replay(pellucid::SceneChecker& checker, const std::string& file)
{
  const auto scene = nlohmann::json::parse(std::ifstream(file)).get<SceneDescription>();
  const std::string problems = Join(checker.Check(scene));
  std::cout << problems;
  return problems.empty();
}

/** RapidCheck knows no time: once it is over, the rest of the scenes pass unseen. */
bool CheckFor(pellucid::SceneChecker& checker, double seconds, unsigned int seed)
{
  const std::string parameters = "seed=" + std::to_string(seed) + " max_success=1000000";
  setenv("RC_PARAMS", parameters.c_str(), 0);
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  const auto generator = pellucid::MakeSceneGenerator();
  bool hasFailed = false;
  return rc::check("Random scenes look as the reference",
    [&]
    {
      if (!hasFailed && Clock::now() > end)
      {
        return;
      }
      const SceneDescription scene = *generator;
      const std::string problems = Join(checker.Check(scene));
      hasFailed = hasFailed || !problems.empty();
      if (!problems.empty())
      {
        RC_FAIL(problems);
      }
    });
}
}

//------------------------------------------------------------------------------
int TestRandomScenes(int argc, char* argv[])
{
  CLI::App application("Random scenes against the reference");
  application.allow_extras();
  double seconds = 20.0;
  unsigned int seed = 1;
  std::string file;
  application.add_option("--seconds", seconds, "Time to spend")->capture_default_str();
  application.add_option("--seed", seed, "Another seed, other scenes")->capture_default_str();
  application.add_option("--replay", file, "Check the scene of this JSON file alone");
  CLI11_PARSE(application, argc, argv);

  pellucid::SceneChecker checker;
  const bool passed = file.empty() ? CheckFor(checker, seconds, seed) : Replay(checker, file);
  checker.GetFigures().Print(std::cout);
  if (!passed)
  {
    std::cerr << "ERROR: a scene has failed" << std::endl;
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
