// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkImportance.h"

#include "Private/vtkBatches.h"
#include "Private/vtkFillOutput.h"
#include "Private/vtkForEachCell.h"
#include "Private/vtkLeafCopies.h"
#include "Private/vtkRequirePointIds.h"
#include "Private/vtkScalarAttribute.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPThreadLocal.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkImportance);

//------------------------------------------------------------------------------
struct vtkImportance::Criterion
{
  std::string ArrayName;
  vtkScalarAttribute::Bound Minimum;
  vtkScalarAttribute::Bound Maximum;
  double Weight;

  bool operator==(const Criterion& other) const
  {
    return this->ArrayName == other.ArrayName && this->Minimum == other.Minimum &&
      this->Maximum == other.Maximum && this->Weight == other.Weight;
  }

  std::array<double, 2> EffectiveRange = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::quiet_NaN() };
};

namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

// Points whose sums are kept at once: few enough for the first cache.
constexpr vtkIdType BlockSize = 1024;

//------------------------------------------------------------------------------
// The mean, at each point, over the cells that use it; NaN where there is none. Incomplete when
// aborted, which the next loop of the filter finds, too.
vtkSmartPointer<vtkDataArray> AverageAtPoints(
  vtkDataSet* data, vtkDataArray* cellArray, const vtkBatches& batches)
{
  vtkRequirePointIds(data);
  const vtkIdType cellCount = data->GetNumberOfCells();
  std::vector<double> cellValues(cellCount);
  vtkScalarAttribute::ForEach(cellArray, 0, cellCount,
    [&cellValues](vtkIdType cell, double value) { cellValues[cell] = value; });

  struct Sum
  {
    double Total = 0.0;
    vtkIdType Count = 0;
    vtkIdType LastCell = -1; // A closed line names its first point twice.
  };
  std::vector<Sum> sums(data->GetNumberOfPoints());
  const auto add = [&](vtkIdType cell, vtkIdType count, const vtkIdType* points)
  {
    if (std::isnan(cellValues[cell]))
    {
      return;
    }
    for (vtkIdType i = 0; i < count; ++i)
    {
      Sum& sum = sums[points[i]];
      if (sum.LastCell != cell)
      {
        sum.Total += cellValues[cell];
        ++sum.Count;
        sum.LastCell = cell;
      }
    }
  };
  batches.For(
    cellCount, [&](vtkIdType begin, vtkIdType end) { vtkForEachCell(data, begin, end, add); });

  auto means = vtkSmartPointer<vtkDoubleArray>::New();
  means->SetNumberOfValues(data->GetNumberOfPoints());
  std::transform(sums.begin(), sums.end(), means->GetPointer(0),
    [](const Sum& sum)
    { return sum.Count > 0 ? sum.Total / static_cast<double>(sum.Count) : NotANumber; });
  return means;
}

//------------------------------------------------------------------------------
// A criterion at the points of one leaf.
class PointCriterion
{
public:
  PointCriterion(
    vtkSmartPointer<vtkDataArray> values, const std::array<double, 2>& range, double weight)
    : Values(std::move(values))
    , Minimum(range[0])
    , Maximum(range[1])
    , Weight(weight)
  {
  }

  // Add the weighted map of each point to `sums`; `known` becomes 1 where there is a value.
  void Accumulate(vtkIdType begin, vtkIdType end, double* sums, double* known) const
  {
    if (this->Minimum == this->Maximum)
    {
      this->AccumulateMap(begin, end, sums, known,
        [threshold = this->Minimum](double value) { return value >= threshold ? 1.0 : 0.0; });
      return;
    }
    // Half of everything, where the width of the range would overflow.
    const double scale = std::isinf(this->Maximum - this->Minimum) ? 0.5 : 1.0;
    const double low = std::min(this->Minimum, this->Maximum);
    const double high = std::max(this->Minimum, this->Maximum);
    const double zero = scale * this->Minimum;
    const double width = scale * this->Maximum - zero;
    this->AccumulateMap(begin, end, sums, known,
      [=](double value) { return (scale * std::min(std::max(value, low), high) - zero) / width; });
  }

private:
  template <typename Map>
  void AccumulateMap(
    vtkIdType begin, vtkIdType end, double* sums, double* known, const Map& map) const
  {
    vtkScalarAttribute::ForEach(this->Values, begin, end,
      [=, weight = this->Weight](vtkIdType point, double value)
      {
        const bool isMissing = std::isnan(value);
        sums[point - begin] += isMissing ? 0.0 : weight * map(value);
        known[point - begin] = isMissing ? known[point - begin] : 1.0;
      });
  }

  vtkSmartPointer<vtkDataArray> Values;
  double Minimum;
  double Maximum;
  double Weight;
};

//------------------------------------------------------------------------------
// From the weighted sum of a point to its importance.
class ImportanceFunction
{
public:
  ImportanceFunction(double weightSum, double exponent)
    : WeightSum(weightSum)
    , Exponent(exponent)
  {
  }

  float operator()(double sum, double known) const
  {
    if (known == 0.0 || this->WeightSum == 0.0)
    {
      return 0.0F;
    }
    const double mean = std::min(std::max(sum / this->WeightSum, 0.0), 1.0);
    const double importance = this->WeightSum < 0.0 ? 1.0 - mean : mean;
    return static_cast<float>(
      this->Exponent == 1.0 ? importance : std::pow(importance, this->Exponent));
  }

private:
  double WeightSum;
  double Exponent;
};

//------------------------------------------------------------------------------
// The sum of the weights, or 0 where only rounding keeps it from that.
template <typename Criteria>
double SumWeights(const Criteria& criteria)
{
  double sum = 0.0;
  double magnitude = 0.0;
  for (const auto& criterion : criteria)
  {
    sum += criterion.Weight;
    magnitude += std::abs(criterion.Weight);
  }
  return std::abs(sum) > 1e-12 * magnitude ? sum : 0.0;
}

//------------------------------------------------------------------------------
// The importance at the points of one leaf, and how many of them lie in each bin of a histogram.
class LeafImportance
{
public:
  LeafImportance(vtkIdType pointCount, int binCount)
    : BinCount(binCount)
    , LocalCounts(std::vector<vtkIdType>(binCount, 0))
  {
    this->Values->SetName(vtkImportance::IMPORTANCE());
    this->Values->SetNumberOfValues(pointCount);
  }

  // Returns false when aborted.
  bool Compute(const vtkBatches& batches, const std::vector<PointCriterion>& criteria,
    const ImportanceFunction& function)
  {
    return batches.ParallelFor(this->Values->GetNumberOfValues(),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (; begin < end; begin += BlockSize)
        {
          this->ComputeBlock(begin, std::min(begin + BlockSize, end), criteria, function);
        }
      });
  }

  vtkFloatArray* GetValues() const { return this->Values; }

  std::vector<vtkIdType> GetCounts()
  {
    std::vector<vtkIdType> counts(this->BinCount, 0);
    for (const std::vector<vtkIdType>& local : this->LocalCounts)
    {
      std::transform(
        local.begin(), local.end(), counts.begin(), counts.begin(), std::plus<vtkIdType>());
    }
    return counts;
  }

private:
  void ComputeBlock(vtkIdType begin, vtkIdType end, const std::vector<PointCriterion>& criteria,
    const ImportanceFunction& function)
  {
    std::array<double, BlockSize> sums{};
    std::array<double, BlockSize> known{};
    for (const PointCriterion& criterion : criteria)
    {
      criterion.Accumulate(begin, end, sums.data(), known.data());
    }
    float* values = this->Values->GetPointer(begin);
    std::vector<vtkIdType>& counts = this->LocalCounts.Local();
    for (vtkIdType i = 0; i < end - begin; ++i)
    {
      values[i] = function(sums[i], known[i]);
      // The product is exact, so that a bin holds exactly what lies between its edges.
      const int bin = static_cast<int>(static_cast<double>(values[i]) * this->BinCount);
      ++counts[std::min(bin, this->BinCount - 1)];
    }
  }

  int BinCount;
  vtkNew<vtkFloatArray> Values;
  vtkSMPThreadLocal<std::vector<vtkIdType>> LocalCounts;
};

//------------------------------------------------------------------------------
void FillHistogram(vtkIdTypeArray* histogram, const std::vector<vtkIdType>& counts)
{
  histogram->SetName(vtkImportance::HISTOGRAM());
  histogram->SetNumberOfValues(static_cast<vtkIdType>(counts.size()));
  std::copy(counts.begin(), counts.end(), histogram->GetPointer(0));
}
}

//------------------------------------------------------------------------------
vtkImportance::vtkImportance() = default;

//------------------------------------------------------------------------------
vtkImportance::~vtkImportance() = default;

//------------------------------------------------------------------------------
int vtkImportance::AddCriterion(const char* arrayName, double minimum, double maximum,
  double weight, bool minimumIsPercentile, bool maximumIsPercentile)
{
  const int index = this->GetNumberOfCriteria();
  this->Criteria.emplace_back();
  this->Modified();
  this->SetCriterion(
    index, arrayName, minimum, maximum, weight, minimumIsPercentile, maximumIsPercentile);
  return index;
}

//------------------------------------------------------------------------------
void vtkImportance::SetCriterion(int index, const char* arrayName, double minimum, double maximum,
  double weight, bool minimumIsPercentile, bool maximumIsPercentile)
{
  if (!this->FindCriterion(index))
  {
    vtkErrorMacro("There is no criterion " << index << " to replace, only " << this->Criteria.size()
                                           << "; call AddCriterion().");
    return;
  }
  const Criterion criterion{ arrayName ? arrayName : "", { minimum, minimumIsPercentile },
    { maximum, maximumIsPercentile }, weight };
  if (!(criterion == this->Criteria[index]))
  {
    this->Criteria[index] = criterion;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkImportance::RemoveAllCriteria()
{
  if (!this->Criteria.empty())
  {
    this->Criteria.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkImportance::GetNumberOfCriteria()
{
  return static_cast<int>(this->Criteria.size());
}

//------------------------------------------------------------------------------
const vtkImportance::Criterion* vtkImportance::FindCriterion(int index) const
{
  return index >= 0 && index < static_cast<int>(this->Criteria.size()) ? &this->Criteria[index]
                                                                       : nullptr;
}

//------------------------------------------------------------------------------
const char* vtkImportance::GetCriterionArrayName(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion ? criterion->ArrayName.c_str() : nullptr;
}

//------------------------------------------------------------------------------
double vtkImportance::GetCriterionMinimum(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion ? criterion->Minimum.Number : 0.0;
}

//------------------------------------------------------------------------------
double vtkImportance::GetCriterionMaximum(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion ? criterion->Maximum.Number : 0.0;
}

//------------------------------------------------------------------------------
double vtkImportance::GetCriterionWeight(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion ? criterion->Weight : 0.0;
}

//------------------------------------------------------------------------------
bool vtkImportance::GetCriterionMinimumIsPercentile(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion && criterion->Minimum.IsPercentile;
}

//------------------------------------------------------------------------------
bool vtkImportance::GetCriterionMaximumIsPercentile(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion && criterion->Maximum.IsPercentile;
}

//------------------------------------------------------------------------------
double vtkImportance::GetEffectiveMinimum(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion ? criterion->EffectiveRange[0] : NotANumber;
}

//------------------------------------------------------------------------------
double vtkImportance::GetEffectiveMaximum(int index)
{
  const Criterion* criterion = this->FindCriterion(index);
  return criterion ? criterion->EffectiveRange[1] : NotANumber;
}

//------------------------------------------------------------------------------
int vtkImportance::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkImportance::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  this->Histogram->Initialize();
  for (Criterion& criterion : this->Criteria)
  {
    criterion.EffectiveRange.fill(NotANumber);
  }
  return vtkFillOutput(
    this, output, [&] { return this->Compute(vtkDataObject::GetData(inputVector[0]), output); });
}

//------------------------------------------------------------------------------
std::vector<vtkScalarAttribute> vtkImportance::FindAttributes(vtkDataObject* input)
{
  if (this->Criteria.empty())
  {
    throw std::invalid_argument("There is no criterion to be important by; call AddCriterion().");
  }
  if (!std::isfinite(this->Exponent))
  {
    throw std::invalid_argument("The exponent is not a finite number; set one from 0 on.");
  }
  std::vector<vtkScalarAttribute> attributes;
  for (Criterion& criterion : this->Criteria)
  {
    const std::string name = "the array '" + criterion.ArrayName + "'";
    if (!(std::abs(criterion.Weight) <= 1.0))
    {
      throw std::invalid_argument("The weight of " + name + " is " +
        std::to_string(criterion.Weight) + "; set one in [-1, 1].");
    }
    attributes.emplace_back(input, criterion.ArrayName);
    const auto range = attributes.back().ComputeRange(criterion.Minimum, criterion.Maximum);
    if (std::isinf(range[0]) || std::isinf(range[1]))
    {
      throw std::invalid_argument("A bound for " + name + " is infinite; set a finite one.");
    }
    if (std::isnan(range[0]) || std::isnan(range[1]))
    {
      vtkWarningMacro("There is no finite value to take percentiles of in "
        << name << ", which counts as missing everywhere.");
    }
    criterion.EffectiveRange = range;
  }
  return attributes;
}

//------------------------------------------------------------------------------
bool vtkImportance::Compute(vtkDataObject* input, vtkDataObject* output)
{
  const auto attributes = this->FindAttributes(input);
  const double weightSum = SumWeights(this->Criteria);
  if (weightSum == 0.0)
  {
    vtkWarningMacro("The weights add up to 0: the importance is 0 everywhere.");
  }
  const ImportanceFunction function(weightSum, this->Exponent);

  const auto leaves = vtkCopyLeaves(input, output);
  std::vector<vtkIdType> totals(this->NumberOfHistogramBins, 0);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    vtkDataSet* data = leaves[leaf].first;
    const double fraction = 1.0 / static_cast<double>(leaves.size());
    const vtkBatches batches(this, leaf * fraction, (leaf + 1) * fraction);
    // A part of the progress for each array that has to come from the cells to the points.
    const double part = 1.0 / static_cast<double>(attributes.size() + 1);
    double done = 0.0;
    std::vector<PointCriterion> criteria;
    for (std::size_t i = 0; i < attributes.size(); ++i)
    {
      const auto location = attributes[i].Locate(data);
      const auto& range = this->Criteria[i].EffectiveRange;
      if (location.Array && !std::isnan(range[0]) && !std::isnan(range[1]))
      {
        vtkSmartPointer<vtkDataArray> values = location.Array;
        if (location.OnCells)
        {
          values = AverageAtPoints(data, location.Array, batches.GetPart(done, done + part));
          done += part;
        }
        criteria.emplace_back(values, range, this->Criteria[i].Weight);
      }
    }
    LeafImportance importance(data->GetNumberOfPoints(), this->NumberOfHistogramBins);
    if (!importance.Compute(batches.GetPart(done, 1.0), criteria, function))
    {
      return false;
    }
    const auto counts = importance.GetCounts();
    std::transform(
      counts.begin(), counts.end(), totals.begin(), totals.begin(), std::plus<vtkIdType>());
    leaves[leaf].second->GetPointData()->AddArray(importance.GetValues());
    vtkNew<vtkIdTypeArray> histogram;
    FillHistogram(histogram, counts);
    leaves[leaf].second->GetFieldData()->AddArray(histogram);
  }
  FillHistogram(this->Histogram, totals);
  return true;
}

//------------------------------------------------------------------------------
void vtkImportance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Exponent: " << this->Exponent << "\n";
  os << indent << "NumberOfHistogramBins: " << this->NumberOfHistogramBins << "\n";
  os << indent << "Criteria: " << this->Criteria.size() << "\n";
  for (const Criterion& criterion : this->Criteria)
  {
    os << indent.GetNextIndent() << criterion.ArrayName << ": " << criterion.Minimum.Number
       << (criterion.Minimum.IsPercentile ? "%" : "") << " to " << criterion.Maximum.Number
       << (criterion.Maximum.IsPercentile ? "%" : "") << ", weight " << criterion.Weight
       << ", effective range " << criterion.EffectiveRange[0] << " to "
       << criterion.EffectiveRange[1] << "\n";
  }
}

VTK_ABI_NAMESPACE_END
