// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    ReferenceTesting.h
 * @brief   Checks that report what was found and expected, and go on.
 */

#ifndef ReferenceTesting_h
#define ReferenceTesting_h

#include <cmath>
#include <iostream>
#include <string>

/** Counts the checks that failed; Result() is the exit status of a test. */
class Checks
{
public:
  void Near(const std::string& what, double found, double expected, double tolerance)
  {
    this->True(what + ": found " + std::to_string(found) + ", expected " +
        std::to_string(expected) + ", difference " + std::to_string(found - expected),
      std::abs(found - expected) <= tolerance);
  }

  void True(const std::string& what, bool condition)
  {
    if (!condition)
    {
      std::cerr << "FAILED " << what << "\n";
      ++this->Failures;
    }
  }

  int Result() const { return this->Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  int Failures = 0;
};

#endif
