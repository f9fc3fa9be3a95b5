// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    Importance.h
 * @brief   What any number means as the importance of a fragment.
 */

#ifndef Importance_h
#define Importance_h

namespace pellucid
{
/** Importance in [0,1]: what lies outside is moved to the nearer end, and NaN, a missing value, is
 * of no importance. */
template <typename Real>
Real ClampImportance(Real importance)
{
  if (importance > 0)
  {
    return importance < 1 ? importance : Real(1);
  }
  return 0;
}
}

#endif
