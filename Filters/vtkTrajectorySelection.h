// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectorySelection
 * @brief   Keep the lines whose values of one array lie in a range; whole lines, or none of them.
 *
 * Input: vtkPolyData, or composite data, whose leaves of other classes pass. The array is searched
 * in the point data before the cell data. A cell array has one value for each line; of a point
 * array one value in the range is enough to keep a line, or, with AllPoints, all have to lie
 * there. Several criteria: several filters in a row.
 *
 * The line selection of Bandle 2016 ("Opacity-Based Rendering of Lagrangian Particle Trajectories
 * in Met.3D", section 3.3): discarded lines cost nothing downstream.
 *
 * - Minimum and Maximum belong to the range. With the minimum above the maximum it is empty.
 * - NaN, a missing value, never lies in the range. A line without points has no value, and in
 *   composite data a leaf without the array has none: their lines are discarded.
 * - Arrays of several components count by their magnitude.
 *
 * Output: the input without the discarded lines. The points that only they use leave with them;
 * everything else stays: vertices, polygons and strips, their points, points that nothing uses,
 * point and cell data, all in the order of the input. Where no line is discarded, points and
 * arrays are those of the input, by reference.
 *
 * Errors, which leave an empty output: an array that no leaf has (the message names those that
 * exist; data without points need none), of text, or too short; a bound that is NaN; a percentile
 * outside of [0, 100]. A warning: percentiles of an array without a finite value, which select
 * nothing.
 *
 * Cost: parallel passes over the values and the lines' points, and a copy of what stays. The result
 * does not depend on the number of threads. Progress is reported, and an abort, which leaves an
 * empty output, obeyed at about every hundredth of each pass.
 *
 * @sa vtkImportance
 */

#ifndef vtkTrajectorySelection_h
#define vtkTrajectorySelection_h

#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPellucidFiltersModule.h" // for the export macro

#include <limits> // for the default range
#include <string> // for the array's name

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
class vtkScalarAttribute;

class VTKPELLUCIDFILTERS_EXPORT vtkTrajectorySelection : public vtkPassInputTypeAlgorithm
{
public:
  static vtkTrajectorySelection* New();
  vtkTypeMacro(vtkTrajectorySelection, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the point or cell array to select by. There is no default.
   */
  vtkSetStdStringFromCharMacro(ArrayName);
  vtkGetCharFromStdStringMacro(ArrayName);
  ///@}

  ///@{
  /**
   * The range, both ends included; open by default (minus infinity to infinity), when it holds
   * every value that is not missing.
   */
  vtkSetMacro(Minimum, double);
  vtkGetMacro(Minimum, double);
  vtkSetMacro(Maximum, double);
  vtkGetMacro(Maximum, double);
  ///@}

  ///@{
  /**
   * Whether Minimum or Maximum is a percentile, from 0 to 100, of the array's finite values in all
   * leaves together, as in vtkImportance::AddCriterion(). Default is off.
   */
  vtkSetMacro(MinimumIsPercentile, bool);
  vtkGetMacro(MinimumIsPercentile, bool);
  vtkBooleanMacro(MinimumIsPercentile, bool);
  vtkSetMacro(MaximumIsPercentile, bool);
  vtkGetMacro(MaximumIsPercentile, bool);
  vtkBooleanMacro(MaximumIsPercentile, bool);
  ///@}

  ///@{
  /**
   * Whether all values of a line have to lie in the range, or one is enough; point arrays only.
   * Default is off: one is enough.
   */
  vtkSetMacro(AllPoints, bool);
  vtkGetMacro(AllPoints, bool);
  vtkBooleanMacro(AllPoints, bool);
  ///@}

  ///@{
  /**
   * The range of the last update in values of the array: what was set, or what the percentiles came
   * to. NaN before an update, and where there was no finite value.
   */
  vtkGetMacro(EffectiveMinimum, double);
  vtkGetMacro(EffectiveMaximum, double);
  ///@}

  ///@{
  /**
   * Lines of all leaves in the last update: of the input, and those that were kept.
   */
  vtkGetMacro(NumberOfLines, vtkIdType);
  vtkGetMacro(NumberOfSelectedLines, vtkIdType);
  ///@}

protected:
  vtkTrajectorySelection() = default;
  ~vtkTrajectorySelection() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkTrajectorySelection(const vtkTrajectorySelection&) = delete;
  void operator=(const vtkTrajectorySelection&) = delete;

  // Throws std::invalid_argument; returns false when aborted.
  bool Select(vtkDataObject* input, vtkDataObject* output);

  std::string ArrayName;
  double Minimum = -std::numeric_limits<double>::infinity();
  double Maximum = std::numeric_limits<double>::infinity();
  bool MinimumIsPercentile = false;
  bool MaximumIsPercentile = false;
  bool AllPoints = false;
  double EffectiveMinimum = std::numeric_limits<double>::quiet_NaN();
  double EffectiveMaximum = std::numeric_limits<double>::quiet_NaN();
  vtkIdType NumberOfLines = 0;
  vtkIdType NumberOfSelectedLines = 0;
};

VTK_ABI_NAMESPACE_END
#endif
