// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/** The candidate methods that the benchmark measures beside the product. */

#ifndef Candidates_h
#define Candidates_h

#include "vtkCandidatePass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pellucid
{
struct Candidate
{
  std::string Name;
  std::string Family;              ///< those with the same store and the same way to composite
  std::optional<double> Parameter; ///< what orders its family; none: the family has no order
  std::string Description;         ///< in one line
  std::string Reason;              ///< why it is not in the product, in one line
  bool IsExact;                    ///< by design; GetLossyPixels() tells of a frame
  std::function<vtkSmartPointer<vtkCandidatePass>()> MakePass;
};

/** All candidates; those of one family follow each other. */
std::vector<Candidate> GetCandidates();
}

#endif
