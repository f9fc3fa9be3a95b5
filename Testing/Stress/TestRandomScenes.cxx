// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Random scenes look as the double-precision reference draws them, with the same bits in any order.
// A scene that does not is shrunk, and printed so that --replay can repeat it.
//
//   pellucidStressTests TestRandomScenes --seconds 3600 --seed 5
//   pellucidStressTests TestRandomScenes --replay scene.json...
#include "SceneCheck.h"
#include "SceneGenerator.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

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
  SceneDescription scene;
  try
  {
    scene = nlohmann::json::parse(std::ifstream(file)).get<SceneDescription>();
  }
  catch (const nlohmann::json::exception& error)
  {
    std::cerr << "ERROR: expected a scene, as a failure prints it, in " << file << ": "
              << error.what() << std::endl;
    return false;
  }
  const std::string problems = Join(checker.Check(scene));
  std::cout << file << ": " << (problems.empty() ? "as the reference\n" : problems);
  return problems.empty();
}

/** Keeps what is written to std::cerr. */
class ErrorCapture
{
public:
  ErrorCapture()
    : Terminal(std::cerr.rdbuf(this->Text.rdbuf()))
  {
  }
  ~ErrorCapture() { std::cerr.rdbuf(this->Terminal); }
  ErrorCapture(const ErrorCapture&) = delete;
  ErrorCapture& operator=(const ErrorCapture&) = delete;

  std::string GetText() const { return this->Text.str(); }

private:
  std::ostringstream Text;
  std::streambuf* Terminal;
};

/**
 * RapidCheck knows no time: once it is over, the rest of the scenes pass unseen. So what it says of
 * their number is kept back, unless a scene fails.
 */
bool CheckFor(pellucid::SceneChecker& checker, double seconds, unsigned int seed)
{
  const std::string parameters = "seed=" + std::to_string(seed) + " max_success=1000000";
  setenv("RC_PARAMS", parameters.c_str(), 1);
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  const auto generator = pellucid::MakeSceneGenerator();
  bool hasFailed = false;
  ErrorCapture capture;
  const bool passed = rc::check("Random scenes look as the reference",
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
  if (!passed)
  {
    std::cout << capture.GetText() << std::endl;
  }
  return passed && checker.GetFigures().Scenes > 0;
}
}

//------------------------------------------------------------------------------
int TestRandomScenes(int argc, char* argv[])
{
  CLI::App application("Random scenes against the reference");
  application.allow_extras();
  double seconds = 20.0;
  unsigned int seed = 1;
  std::vector<std::string> files;
  application.add_option("--seconds", seconds, "Time to spend")
    ->check(CLI::PositiveNumber)
    ->capture_default_str();
  application.add_option("--seed", seed, "Another seed, other scenes")->capture_default_str();
  application.add_option("--replay", files, "Check the scenes of these JSON files alone")
    ->check(CLI::ExistingFile);
  CLI11_PARSE(application, argc, argv);

  pellucid::SceneChecker checker;
  bool passed = !files.empty() || CheckFor(checker, seconds, seed);
  for (const std::string& file : files)
  {
    passed &= Replay(checker, file);
  }
  checker.GetFigures().Print(std::cout);
  if (!passed)
  {
    std::cerr << "ERROR: a scene has failed, or none was checked" << std::endl;
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
