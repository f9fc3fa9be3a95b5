// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkImportance
 * @brief   Combine any number of arrays into one importance in [0, 1] at each point.
 *
 * Input: any vtkDataSet (points, lines, surfaces, grids), or composite data of them. A criterion
 * maps the values a of one array linearly so that its minimum gives 0 and its maximum gives 1,
 * clamped; the importance of a point is the weighted mean of its criteria (Bandle 2016,
 * "Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D", section 3.3.1):
 *
 *     m_k = clamp((a_k - minimum_k) / (maximum_k - minimum_k), 0, 1)
 *     g   = clamp((sum_k w_k m_k) / (sum_k w_k), 0, 1)
 *     g  <- 1 - g    if sum_k w_k < 0: the weighted mean is a penalty
 *     g  <- g^Exponent
 *
 * - A minimum above the maximum reverses the map: small values are important. Where both are equal
 * it is a step: 1 from that value on.
 * - Weights that add up to 0 (to within rounding) leave the mean undefined: the importance is 0
 *   everywhere, and a warning says so.
 * - NaN is a missing value: m_k = 0, while w_k still counts. Where the values of all criteria
 *   are missing the importance is 0, whatever the weights and the exponent. Infinite values are
 *   clamped as others. The importance itself is never NaN.
 * - Arrays of several components count by their magnitude, a NaN in one of them as missing.
 *
 * An array is searched in the point data before the cell data. From a cell array a point gets the
 * mean over the cells that use it, each counting once and those with missing values not at all: a
 * point of one line has that line's value, a point of no cell none. In composite data, a leaf
 * without the array counts as having only missing values.
 *
 * Output: the input (its arrays by reference), and in each leaf:
 *
 * - point data: "Importance", vtkFloatArray of one component in [0, 1]; it does not become the
 * active scalars. An array of that name in the input is replaced, and can be a criterion.
 * - field data: "ImportanceHistogram", vtkIdTypeArray of one component, the number of points in
 * each of NumberOfHistogramBins equal bins of [0, 1]. A bin holds its lower edge, the last one 1 as
 *   well. GetHistogram() is that of all leaves together.
 *
 * Errors, which leave an empty output: no criterion; an array that no leaf has (the message names
 * those that exist; data without points need none), of text, or too short; a bound or exponent
 * that is infinite or NaN; a weight outside of [-1, 1], a percentile outside of [0, 100]; for a
 * cell array, a cell that uses a point that does not exist. Warnings: weights that add up to 0;
 * percentiles of an array without a finite value, which counts as missing everywhere.
 *
 * Cost: one parallel pass over the values, and the same bits with any number of threads. A
 * percentile costs a copy of its array in double precision, a cell array 32 bytes a point and one
 * serial pass over the cells. Progress is reported, and an abort, which leaves an empty output,
 * obeyed at about every hundredth of the points and of the cells; percentiles are found before.
 *
 * @par Reference
 * M. Bandle: Opacity-Based Rendering of Lagrangian Particle Trajectories in Met.3D, 2016,
 * section 3.3.1.
 *
 * @sa vtkTrajectorySelection
 */

#ifndef vtkImportance_h
#define vtkImportance_h

#include "vtkNew.h" // for the histogram
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkPellucidFiltersModule.h" // for the export macro

#include <string> // for names
#include <vector> // for the criteria

VTK_ABI_NAMESPACE_BEGIN
class vtkIdTypeArray;
class vtkScalarAttribute;

class VTKPELLUCIDFILTERS_EXPORT vtkImportance : public vtkPassInputTypeAlgorithm
{
public:
  static vtkImportance* New();
  vtkTypeMacro(vtkImportance, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Name of the point array of the output. */
  static const char* IMPORTANCE() { return "Importance"; }

  /** Name of the field array of the output. */
  static const char* HISTOGRAM() { return "ImportanceHistogram"; }

  ///@{
  /**
   * Add a criterion, or replace that of an index: the name of an array, the values of importance 0
   * and 1 and the weight, in [-1, 1]. Each bound is a value of the array or, where
   * `...IsPercentile`, the percentile, 0 to 100, of its finite values in all leaves together
   * (for a cell array: of the cells), so that blocks compare. In a distributed run each process has
   * the percentiles of its own leaves; give values where processes are to compare. Percentiles
   * interpolate linearly between the values in order: percentile p of n values is at
   * p / 100 (n - 1), counted from 0. What is out of range is an error of the update. AddCriterion()
   * returns the index.
   */
  int AddCriterion(const char* arrayName, double minimum, double maximum, double weight = 1.0,
    bool minimumIsPercentile = false, bool maximumIsPercentile = false);
  void SetCriterion(int index, const char* arrayName, double minimum, double maximum,
    double weight = 1.0, bool minimumIsPercentile = false, bool maximumIsPercentile = false);
  ///@}

  ///@{
  /** End all criteria; how many there are, 0 at first. */
  void RemoveAllCriteria();
  int GetNumberOfCriteria();
  ///@}

  ///@{
  /**
   * What was set for the criterion of an index from 0 to GetNumberOfCriteria() - 1; outside of
   * that, nullptr, 0 and false.
   */
  const char* GetCriterionArrayName(int index);
  double GetCriterionMinimum(int index);
  double GetCriterionMaximum(int index);
  double GetCriterionWeight(int index);
  bool GetCriterionMinimumIsPercentile(int index);
  bool GetCriterionMaximumIsPercentile(int index);
  ///@}

  ///@{
  /**
   * The values of the array that the last update gave importance 0 and 1: the bounds that were set,
   * or what the percentiles came to. NaN before an update, and where there was no finite value.
   */
  double GetEffectiveMinimum(int index);
  double GetEffectiveMaximum(int index);
  ///@}

  ///@{
  /**
   * Exponent of the importance, at least 0. Above 1 it favours the most important points, below 1
   * it raises the others; 0 gives 1 everywhere except where all values are missing. Default is 1.
   */
  vtkSetClampMacro(Exponent, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Exponent, double);
  ///@}

  ///@{
  /**
   * Bins of the histograms, from 1 to 65536. Default is 100.
   */
  vtkSetClampMacro(NumberOfHistogramBins, int, 1, 65536);
  vtkGetMacro(NumberOfHistogramBins, int);
  ///@}

  /** Points of all leaves in each bin after an update; empty before. */
  vtkIdTypeArray* GetHistogram() { return this->Histogram; }

protected:
  vtkImportance();
  ~vtkImportance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkImportance(const vtkImportance&) = delete;
  void operator=(const vtkImportance&) = delete;

  struct Criterion;
  const Criterion* FindCriterion(int index) const;

  // Both throw std::invalid_argument; the second returns false when aborted.
  std::vector<vtkScalarAttribute> FindAttributes(vtkDataObject* input);
  bool Compute(vtkDataObject* input, vtkDataObject* output);

  std::vector<Criterion> Criteria;
  double Exponent = 1.0;
  int NumberOfHistogramBins = 100;
  vtkNew<vtkIdTypeArray> Histogram;
};

VTK_ABI_NAMESPACE_END
#endif
