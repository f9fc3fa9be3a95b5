// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTrajectorySelection
 * @brief   Keep the trajectories whose values of one array lie in a range, whole or not at all.
 *
 * Input: vtkPolyData, or composite data, whose leaves of other classes pass. The array is searched
 * in the point data before the cell data. One value in the range is enough to keep a trajectory,
 * or, with AllPoints, all have to lie there. Several criteria: several filters in a row.
 *
 * A trajectory is a line or, where the cell data has a "TrajectoryId" (one component), a run of
 * successive lines with the same: readers split trajectories at gaps and at the edges of a map. All
 * its lines are kept or discarded together, by the values of a point array at all their points, or
 * of a cell array on each of them. Runs end with their leaf. Appending data may bring equal ids of
 * two files next to each other; composite data keeps them apart.
 *
 * The line selection of Bandle 2016 ("Opacity-Based Rendering of Lagrangian Particle Trajectories
 * in Met.3D", section 3.3): discarded lines cost nothing downstream.
 *
 * - Minimum and Maximum belong to the range. With the minimum above the maximum it is empty.
 * - NaN, a missing value, never lies in the range. A trajectory without points has no value in a
 *   point array, and in composite data a leaf without the array has none: they are discarded.
 * - Arrays of several components count by their magnitude.
 *
 * Output: the input without the discarded lines. The points that only they use leave with them;
 * everything else stays: vertices, polygons and strips, their points, points that nothing uses,
 * point and cell data, all in the order of the input. Where no line is discarded, points and
 * arrays are those of the input, by reference. Where some are, arrays with too few tuples for the
 * points or cells are left out, with a warning that names them.
 *
 * Errors, which leave an empty output: an array that no leaf has (the message names those that
 * exist; data without points need none), of text, or too short; a bound that is NaN; a percentile
 * outside of [0, 100]; a cell that uses a point that does not exist. A warning: percentiles of an
 * array without a finite value, which select nothing.
 *
 * Cost: parallel passes over the values and the lines' points, and a copy of what stays. The result
 * does not depend on the number of threads. Progress is reported, and an abort, which leaves an
 * empty output, obeyed at about every hundredth of each pass; percentiles are found before.
 *
 * @par Reference
 * M. Bandle: Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D, 2016,
 * section 3.3.
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
   * leaves together, as in vtkImportance::AddCriterion(): in a distributed run, those of each
   * process for itself. Default is off.
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
   * Whether all values of a trajectory have to lie in the range, or one is enough. Default is off:
   * one is enough.
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
