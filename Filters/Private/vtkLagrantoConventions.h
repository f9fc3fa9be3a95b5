// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLagrantoConventions
 * @brief   What LAGRANTO's files leave unsaid (M. Sprenger, H. Wernli, Geosci. Model Dev. 8, 2015).
 *
 * Private to the module.
 *
 * @sa vtkLagrantoReader vtkLagrantoNetCDFReader
 */

#ifndef vtkLagrantoConventions_h
#define vtkLagrantoConventions_h

#include "vtkABINamespace.h"

#include <string> // for units

VTK_ABI_NAMESPACE_BEGIN
class vtkDoubleArray;

struct vtkLagrantoConventions
{
  static constexpr double MissingValue = -999.99;

  /** The unit of a variable that is always the same; empty: not known. */
  static std::string GetUnits(const std::string& variable);

  /** "hours since 2006-01-31 18:00:00" or, if that is no date, "hours". */
  static std::string GetTimeUnits(
    double year, double month, double day, double hour, double minute);

  /**
   * Turn times in hh.mm, whose fraction is minutes, into hours. Nothing is changed where the times
   * are in decimals, as fractions of 60 minutes or more show, and steps that are more even so:
   * returns a warning, else an empty text.
   */
  static std::string ConvertToHours(vtkDoubleArray* times);
};

VTK_ABI_NAMESPACE_END
#endif
