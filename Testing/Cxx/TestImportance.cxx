// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkImportance against closed forms and against its formula in double precision on random values
 * of all kinds: weights, reversal, steps, penalty, exponents, missing and infinite values,
 * magnitudes, percentiles, cell arrays, composite data, histograms, threads, messages, progress.
 */

#include "ImportanceTesting.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImportance.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace
{
using Values = std::vector<double>;

struct Criterion
{
  std::string Name;
  double Minimum;
  double Maximum;
  double Weight;
};

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImportance> MakeFilter(
  vtkDataObject* data, const std::vector<Criterion>& criteria, double exponent = 1.0)
{
  auto filter = vtkSmartPointer<vtkImportance>::New();
  filter->SetInputData(data);
  filter->SetExponent(exponent);
  for (const Criterion& criterion : criteria)
  {
    filter->AddCriterion(
      criterion.Name.c_str(), criterion.Minimum, criterion.Maximum, criterion.Weight);
  }
  return filter;
}

//------------------------------------------------------------------------------
Values GetImportance(vtkDataObject* output)
{
  auto* data = vtkDataSet::SafeDownCast(output);
  return data ? GetValues(data->GetPointData()->GetArray("Importance")) : Values();
}

//------------------------------------------------------------------------------
// The importance by the criteria on points of the values "a" and "b".
Values Compute(Checks& checks, const Values& a, const Values& b,
  const std::vector<Criterion>& criteria, double exponent = 1.0, const std::string& message = "")
{
  const auto data = MakePoints(static_cast<vtkIdType>(a.size()));
  data->GetPointData()->AddArray(MakeArray("a", a));
  data->GetPointData()->AddArray(MakeArray("b", b));
  const auto filter = MakeFilter(data, criteria, exponent);
  CheckMessage(checks, filter, message);
  checks.True("the input stays as it is",
    !data->GetPointData()->HasArray("Importance") &&
      data->GetFieldData()->GetNumberOfArrays() == 0);
  return GetImportance(filter->GetOutput());
}

//------------------------------------------------------------------------------
void TestClosedForms(Checks& checks)
{
  const Values a = { 0, 1, 2, 3, 4, -Infinity, Infinity, NotANumber };
  const Values b = { 4, 4, 4, 4, 0, 4, 4, NotANumber };
  const auto check = [&](const std::string& what, const std::vector<Criterion>& criteria,
                       double exponent, const Values& expected)
  { CheckValues(checks, what, Compute(checks, a, b, criteria, exponent), expected); };
  check("linear", { { "a", 1, 3, 1 } }, 1, { 0, 0, 0.5, 1, 1, 0, 1, 0 });
  check("reversed", { { "a", 3, 1, 1 } }, 1, { 1, 1, 0.5, 0, 0, 1, 0, 0 });
  check("step", { { "a", 2, 2, 1 } }, 1, { 0, 0, 1, 1, 1, 0, 1, 0 });
  check("weight does not scale", { { "a", 1, 3, 0.1 } }, 1, { 0, 0, 0.5, 1, 1, 0, 1, 0 });
  check("penalty", { { "a", 1, 3, -0.5 } }, 1, { 1, 1, 0.5, 0, 0, 1, 0, 0 });
  check("exponent 2", { { "a", 0, 4, 1 } }, 2, { 0, 0.0625, 0.25, 0.5625, 1, 0, 1, 0 });
  check("exponent 1/2", { { "a", 0, 4, 1 } }, 0.5,
    { 0, 0.5, std::sqrt(0.5), std::sqrt(0.75), 1, 0, 1, 0 });
  check(
    "penalty before exponent", { { "a", 0, 4, -1 } }, 2, { 1, 0.5625, 0.25, 0.0625, 0, 1, 0, 0 });
  check("exponent 0", { { "a", 1, 3, 1 } }, 0, { 1, 1, 1, 1, 1, 1, 1, 0 });
  check("greatest exponent", { { "a", 1, 3, 1 } }, VTK_DOUBLE_MAX, { 0, 0, 0, 1, 1, 0, 1, 0 });
  check("two", { { "a", 0, 4, 1 }, { "b", 0, 8, 0.5 } }, 1,
    { 0.5 / 3, 1 / 3.0, 0.5, 2 / 3.0, 2 / 3.0, 0.5 / 3, 2.5 / 3, 0 });
  check("clamped at both ends", { { "a", 0, 4, 1 }, { "b", 0, 4, -0.5 } }, 1,
    { 0, 0, 0, 0.5, 1, 0, 1, 0 });
  check(
    "a negative sum", { { "a", 0, 4, -1 }, { "b", 0, 4, 0.5 } }, 1, { 1, 1, 1, 0.5, 0, 1, 0, 0 });
  check(
    "the widest range", { { "a", -1.7e308, 1.7e308, 1 } }, 1, { 0.5, 0.5, 0.5, 0.5, 0.5, 0, 1, 0 });
  check("the narrowest range", { { "a", 0, 4.9406564584124654e-324, 1 } }, 1,
    { 0, 1, 1, 1, 1, 0, 1, 0 });

  // A missing value counts as irrelevant while another one is there.
  CheckValues(checks, "partly missing",
    Compute(checks, { NotANumber, 4, NotANumber }, { 4, NotANumber, NotANumber },
      { { "a", 0, 4, 1 }, { "b", 0, 4, 0.5 } }),
    { 1 / 3.0, 2 / 3.0, 0 });
  CheckValues(checks, "partly missing, penalty",
    Compute(checks, { NotANumber, 4, NotANumber }, { 4, NotANumber, NotANumber },
      { { "a", 0, 4, -1 }, { "b", 0, 4, -1 } }),
    { 0.5, 0.5, 0 });
  const std::string noSum = "The weights add up to 0";
  CheckValues(checks, "weights of 0",
    Compute(checks, { 0, 4 }, { 4, 4 }, { { "a", 0, 4, 0 } }, 0, noSum), { 0, 0 });
  CheckValues(checks, "weights that add up to 0 but for rounding",
    Compute(checks, { 0, 4 }, { 4, 0 },
      { { "a", 0, 4, 0.1 }, { "b", 0, 4, 0.2 }, { "a", 0, 4, -0.3 } }, 1, noSum),
    { 0, 0 });
}

//------------------------------------------------------------------------------
// The formula, point by point.
double ComputeReference(const std::vector<Criterion>& criteria, const Values& a, double exponent)
{
  double sum = 0.0;
  double weights = 0.0;
  bool isMissing = true;
  for (std::size_t k = 0; k < criteria.size(); ++k)
  {
    weights += criteria[k].Weight;
    if (!std::isnan(a[k]))
    {
      isMissing = false;
      const double map = (a[k] - criteria[k].Minimum) / (criteria[k].Maximum - criteria[k].Minimum);
      sum += criteria[k].Weight * std::min(std::max(map, 0.0), 1.0);
    }
  }
  const double mean = std::min(std::max(sum / weights, 0.0), 1.0);
  return isMissing ? 0.0 : std::pow(weights < 0.0 ? 1.0 - mean : mean, exponent);
}

//------------------------------------------------------------------------------
// Arrays of several types, layouts and numbers of components, with missing and infinite values.
vtkSmartPointer<vtkPolyData> MakeRandomData(vtkIdType count, std::vector<Values>& attributes)
{
  vtkNew<vtkFloatArray> floats;
  vtkNew<vtkDoubleArray> vectors;
  vtkNew<vtkIntArray> integers;
  vtkNew<vtkSOADataArrayTemplate<double>> columns;
  floats->SetName("floats");
  vectors->SetName("vectors");
  integers->SetName("integers");
  columns->SetName("columns");
  vectors->SetNumberOfComponents(3);
  columns->SetNumberOfComponents(2);
  columns->SetNumberOfTuples(count);

  std::mt19937 generator(5);
  std::uniform_int_distribution<int> number(-50, 50);
  const auto draw = [&]
  {
    const int value = number(generator);
    return value > 40 ? NotANumber
      : value == 40   ? Infinity
      : value == -50  ? -Infinity
                      : value / 7.0;
  };
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto single = static_cast<float>(draw());
    const double vector[3] = { draw(), draw(), draw() };
    const double column[2] = { draw(), draw() };
    const int integer = number(generator);
    floats->InsertNextValue(single);
    vectors->InsertNextTuple(vector);
    columns->SetTuple(i, column);
    integers->InsertNextValue(integer);
    const double length = std::sqrt(std::inner_product(vector, vector + 3, vector, 0.0));
    attributes.push_back({ single, length, std::sqrt(column[0] * column[0] + column[1] * column[1]),
      static_cast<double>(integer) });
  }
  auto data = MakePoints(count);
  for (vtkDataArray* array :
    std::initializer_list<vtkDataArray*>{ floats, vectors, columns, integers })
  {
    data->GetPointData()->AddArray(array);
  }
  return data;
}

//------------------------------------------------------------------------------
void TestReference(Checks& checks)
{
  constexpr vtkIdType count = 5000;
  std::vector<Values> attributes;
  const auto data = MakeRandomData(count, attributes);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int round = 0; round < 20; ++round)
  {
    std::vector<Criterion> criteria;
    for (const char* name : { "floats", "vectors", "columns", "integers" })
    {
      criteria.push_back({ name, 10 * unit(generator), 10 * unit(generator), unit(generator) });
    }
    const double exponent = round % 2 == 0 ? 1.0 : 1.5 * (1.0 + unit(generator));
    const auto filter = MakeFilter(data, criteria, exponent);
    filter->SetNumberOfHistogramBins(1 + 7 * round);
    CheckMessage(checks, filter, "");
    const Values found = GetImportance(filter->GetOutput());
    checks.True("importance at every point", found.size() == count);

    double difference = 0.0;
    Values bins(filter->GetNumberOfHistogramBins(), 0.0);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const double expected = ComputeReference(criteria, attributes[i], exponent);
      difference = std::max(difference, std::abs(found[i] - expected));
      checks.True("importance in [0, 1]", found[i] >= 0.0 && found[i] <= 1.0);
      ++bins[std::min(static_cast<std::size_t>(found[i] * bins.size()), bins.size() - 1)];
    }
    checks.Near("difference to the reference", difference, 0.0, 1e-7);
    CheckValues(checks, "histogram", GetValues(filter->GetHistogram()), bins, 0.0);
  }

  std::vector<Values> bits;
  ForThreadCounts(
    [&](int)
    {
      std::vector<Values> ignored;
      const auto many = MakeRandomData(50000, ignored);
      const auto filter = MakeFilter(many,
        { { "floats", -3, 4, 1 }, { "vectors", 9, 1, -0.3 }, { "integers", 0, 0, 0.6 } }, 1.7);
      filter->AddCriterion("columns", 10, 90, 0.5, true, true);
      filter->Update();
      bits.push_back(GetImportance(filter->GetOutput()));
    });
  checks.True("same bits for 1, 2 and 3 threads", bits[0] == bits[1] && bits[0] == bits[2]);
}

//------------------------------------------------------------------------------
// Neither squares that overflow nor squares that underflow spoil a magnitude.
void TestMagnitudes(Checks& checks)
{
  for (const double scale : { 1e-300, 1e-160, 1.0, 1e160, 1e300 })
  {
    const auto data = MakePoints(6);
    data->GetPointData()->AddArray(MakeArray("a",
      { 3 * scale, -4 * scale, 0, 0, 0, 6 * scale, 0, 0, 0, -Infinity, scale, 0, Infinity,
        NotANumber, scale, scale, scale, scale },
      3));
    const auto filter = MakeFilter(data, { { "a", 0, 10 * scale, 1 } });
    CheckMessage(checks, filter, "");
    CheckValues(checks, "magnitudes", GetImportance(filter->GetOutput()),
      { 0.5, 0.6, 0, 1, 0, 0.1 * std::sqrt(3) });
  }
}

//------------------------------------------------------------------------------
// The values between which the percentiles p and q of `a` lie.
Values GetRange(Checks& checks, const Values& a, double p, double q, const std::string& message)
{
  const auto data = MakePoints(static_cast<vtkIdType>(a.size()));
  data->GetPointData()->AddArray(MakeArray("a", a));
  vtkNew<vtkImportance> filter;
  filter->SetInputData(data);
  checks.True("index", filter->AddCriterion("a", p, q, 1.0, true, true) == 0);
  checks.True("no range before an update", std::isnan(filter->GetEffectiveMinimum(0)));
  CheckMessage(checks, filter, message);
  for (const double value : GetImportance(filter->GetOutput()))
  {
    checks.True("importance by percentiles in [0, 1]", value >= 0.0 && value <= 1.0);
  }
  return { filter->GetEffectiveMinimum(0), filter->GetEffectiveMaximum(0) };
}

//------------------------------------------------------------------------------
void TestPercentiles(Checks& checks)
{
  const Values ties = { 10, 2, NotANumber, 3, 2, Infinity, 1, -Infinity };
  const auto check = [&checks](const Values& a, double p, double q, const Values& expected)
  { CheckValues(checks, "percentiles", GetRange(checks, a, p, q, ""), expected, 1e-13); };
  check(ties, 0, 100, { 1, 10 });
  check(ties, 25, 50, { 2, 2 });
  check(ties, 10, 90, { 1.4, 7.2 });
  check(ties, 75, 12.5, { 3, 1.5 });
  check({ 5 }, 0, 33, { 5, 5 });
  check({ 1, 2 }, 50, 99, { 1.5, 1.99 });
  check({ -1e308, 1e308 }, 50, 75, { 0, 5e307 });
  check({ 0.1, 0.1, 0.1 }, 33, 66.6, { 0.1, 0.1 });
  for (const double nothing : { NotANumber, Infinity })
  {
    const Values range =
      GetRange(checks, { nothing, nothing }, 5, 95, "There is no finite value to take percentiles");
    checks.True("no range without a value", std::isnan(range[0]) && std::isnan(range[1]));
  }

  // One bound a value, the other a percentile.
  const auto data = MakePoints(5);
  data->GetPointData()->AddArray(MakeArray("a", { 0, 10, 20, 30, 40 }));
  vtkNew<vtkImportance> filter;
  filter->SetInputData(data);
  filter->AddCriterion("a", -10, 50, 1.0, false, true);
  CheckMessage(checks, filter, "");
  CheckValues(checks, "value and percentile", GetImportance(filter->GetOutput()),
    { 1 / 3.0, 2 / 3.0, 1, 1, 1 });

  // A criterion of no finite value counts as missing, its weight still counts.
  data->GetPointData()->AddArray(MakeArray("b", { Infinity, NotANumber, Infinity, 4, 4 }));
  data->GetPointData()->GetArray("b")->SetComponent(3, 0, NotANumber);
  data->GetPointData()->GetArray("b")->SetComponent(4, 0, NotANumber);
  filter->AddCriterion("b", 0, 100, 1.0, true, true);
  CheckMessage(checks, filter, "in the array 'b', which counts as missing everywhere");
  CheckValues(checks, "with nothing finite", GetImportance(filter->GetOutput()),
    { 1 / 6.0, 1 / 3.0, 0.5, 0.5, 0.5 });
}

//------------------------------------------------------------------------------
void TestHistogram(Checks& checks)
{
  const auto data = MakePoints(6);
  data->GetPointData()->AddArray(MakeArray("a", { 0, 0.25, 0.5, 0.75, 1, NotANumber }));
  data->GetPointData()->SetActiveScalars("a");
  const auto filter = MakeFilter(data, { { "a", 0, 1, 1 } });
  filter->SetNumberOfHistogramBins(4);
  CheckMessage(checks, filter, "");
  CheckValues(checks, "bins hold their lower edges, the last one 1",
    GetValues(filter->GetHistogram()), { 2, 1, 1, 2 }, 0.0);
  auto* output = filter->GetPolyDataOutput();
  CheckValues(checks, "histogram of the leaf",
    GetValues(output->GetFieldData()->GetArray("ImportanceHistogram")), { 2, 1, 1, 2 }, 0.0);
  checks.True("the active scalars stay",
    output->GetPointData()->GetScalars() == data->GetPointData()->GetArray("a"));
  checks.True("single precision",
    vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("Importance")) != nullptr);

  // What an importance is computed from may be one.
  const auto second = MakeFilter(output, { { "Importance", 1, 0, 1 } });
  CheckMessage(checks, second, "");
  CheckValues(checks, "importance of an importance", GetImportance(second->GetOutput()),
    { 1, 0.75, 0.5, 0.25, 0, 1 });
  checks.True("replaces the first",
    second->GetPolyDataOutput()->GetPointData()->GetNumberOfArrays() == 2 &&
      second->GetHistogram()->GetNumberOfTuples() == 100);
}

//------------------------------------------------------------------------------
void TestCellArrays(Checks& checks)
{
  const auto data = MakePoints(9);
  data->SetVerts(MakeCells({ { 7 } }));
  data->SetLines(MakeCells({ { 0, 1, 2 }, { 2, 3, 4, 2 }, { 5 }, { 6, 0 } }));
  data->SetPolys(MakeCells({ { 4, 5, 6 } }));
  data->GetCellData()->AddArray(MakeArray("a", { 9, 1, 2, 3, NotANumber, 7 }));
  const auto filter = MakeFilter(data, { { "a", 0, 10, 1 } });
  CheckMessage(checks, filter, "");
  CheckValues(checks, "means of lines", GetImportance(filter->GetOutput()),
    { 0.1, 0.1, 0.15, 0.2, 0.45, 0.5, 0.7, 0.9, 0 });
  filter->SetCriterion(0, "a", 0, 50, 1.0, true, true);
  CheckMessage(checks, filter, "");
  checks.Near("percentiles are those of the cells", filter->GetEffectiveMaximum(0), 3.0, 0.0);

  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 1);
  image->GetCellData()->AddArray(MakeArray("a", { 2, 6 }));
  image->GetPointData()->AddArray(MakeArray("b", { 0, 1, 2, 3, 4, 5 }));
  CheckValues(checks, "means of pixels",
    [&]
    {
      const auto pixels = MakeFilter(image, { { "a", 0, 10, 1 } });
      CheckMessage(checks, pixels, "");
      return GetImportance(pixels->GetOutput());
    }(),
    { 0.2, 0.4, 0.6, 0.2, 0.4, 0.6 });
  image->GetCellData()->AddArray(MakeArray("b", { 9, 9 }));
  const auto points = MakeFilter(image, { { "b", 0, 5, 1 } });
  CheckMessage(checks, points, "");
  CheckValues(checks, "points before cells", GetImportance(points->GetOutput()),
    { 0, 0.2, 0.4, 0.6, 0.8, 1 });
}

//------------------------------------------------------------------------------
void TestComposite(Checks& checks)
{
  const auto low = MakePoints(2);
  low->GetPointData()->AddArray(MakeArray("a", { 0, 10 }));
  const auto high = MakePoints(3);
  high->GetPointData()->AddArray(MakeArray("a", { 20, 30, 40 }));
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, high);
  inner->SetBlock(1, MakePoints(1));
  inner->SetBlock(2, vtkSmartPointer<vtkTable>::New());
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, low);
  blocks->SetBlock(2, inner);
  blocks->GetMetaData(0u)->Set(vtkCompositeDataSet::NAME(), "low");
  blocks->GetFieldData()->AddArray(MakeArray("note", { 1 }));

  vtkNew<vtkImportance> filter;
  filter->SetInputData(blocks);
  filter->AddCriterion("a", 0, 100, 1.0, true, true);
  filter->SetNumberOfHistogramBins(2);
  CheckMessage(checks, filter, "");
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutput());
  auto* innerOutput = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(2));
  CheckValues(checks, "first leaf", GetImportance(output->GetBlock(0)), { 0, 0.25 });
  CheckValues(checks, "second leaf", GetImportance(innerOutput->GetBlock(0)), { 0.5, 0.75, 1 });
  CheckValues(checks, "leaf without the array", GetImportance(innerOutput->GetBlock(1)), { 0 });
  checks.True("no leaf stays none, a table stays one",
    !output->GetBlock(1) && vtkTable::SafeDownCast(innerOutput->GetBlock(2)));
  checks.True("names and field data stay",
    std::string(output->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME())) == "low" &&
      output->GetFieldData()->HasArray("note"));
  CheckValues(checks, "histogram of all", GetValues(filter->GetHistogram()), { 3, 3 }, 0.0);
  CheckValues(checks, "histogram of a leaf",
    GetValues(innerOutput->GetBlock(0)->GetFieldData()->GetArray("ImportanceHistogram")), { 0, 3 },
    0.0);
  checks.True("the input stays as it is",
    !low->GetPointData()->HasArray("Importance") && low->GetFieldData()->GetNumberOfArrays() == 0);
}

//------------------------------------------------------------------------------
void TestMessages(Checks& checks)
{
  const auto data = MakePoints(2);
  data->GetPointData()->AddArray(MakeArray("a", { 0, 1 }));
  data->GetPointData()->AddArray(MakeArray("short", { 0 }));
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  text->SetNumberOfValues(2);
  data->GetPointData()->AddArray(text);

  const auto check = [&](const std::vector<Criterion>& criteria, const std::string& message)
  {
    const auto filter = MakeFilter(data, criteria);
    CheckMessage(checks, filter, message);
    checks.True("nothing after an error",
      filter->GetPolyDataOutput()->GetNumberOfPoints() == 0 &&
        filter->GetHistogram()->GetNumberOfTuples() == 0);
  };
  check({}, "There is no criterion to be important by; call AddCriterion().");
  check({ { "b", 0, 1, 1 } },
    "There is no array named 'b'. The input has the arrays (association, components): "
    "a (points, 1), short (points, 1), text (points, 1).");
  check({ { "text", 0, 1, 1 } }, "The array 'text' holds strings instead of numbers");
  check({ { "short", 0, 1, 1 } }, "The array 'short' has 1 tuples for 2 points");
  check({ { "a", NotANumber, 1, 1 } }, "A bound for the array 'a' is not a number");
  check({ { "a", 0, Infinity, 1 } }, "A bound for the array 'a' is infinite");
  check({ { "a", 0, 1, NotANumber } }, "The weight of the array 'a' is nan; set one in [-1, 1].");
  check({ { "a", 0, 1, -1.5 } }, "The weight of the array 'a' is -1.5");

  const auto lines = MakePoints(3);
  lines->SetLines(MakeCells({ { 0, 1 }, { 2, 3 } }));
  lines->GetCellData()->AddArray(MakeArray("c", { 0, 1 }));
  lines->GetPointData()->AddArray(MakeArray("a", { 0, 1, 2 }));
  CheckMessage(checks, MakeFilter(lines, { { "a", 0, 1, 1 } }), "");
  const auto bad = MakeFilter(lines, { { "a", 0, 1, 1 }, { "c", 0, 1, 1 } });
  CheckMessage(checks, bad, "Line 1 uses the point 3, but the input has the points 0 to 2");
  checks.True("nothing after a bad id", bad->GetPolyDataOutput()->GetNumberOfPoints() == 0);

  const auto exponent = MakeFilter(data, { { "a", 0, 1, 1 } }, NotANumber);
  CheckMessage(checks, exponent, "The exponent is not a finite number");
  vtkNew<vtkImportance> percentile;
  percentile->SetInputData(data);
  percentile->AddCriterion("a", 0, 100.5, 1.0, true, true);
  CheckMessage(checks, percentile, "percentile 100.5");

  // Empty data need not have the array.
  const auto empty = MakeFilter(vtkSmartPointer<vtkPolyData>::New(), { { "b", 0, 1, 1 } });
  CheckMessage(checks, empty, "");
  checks.True("no importance of no points", GetImportance(empty->GetOutput()).empty());

  vtkNew<vtkImportance> filter;
  filter->AddCriterion(nullptr, 1, 2, 3);
  filter->SetCriterion(0, "a", 4, 5, -6, true, false);
  checks.True("what was set",
    filter->GetNumberOfCriteria() == 1 && filter->GetCriterionArrayName(0) == std::string("a") &&
      filter->GetCriterionMinimum(0) == 4.0 && filter->GetCriterionMaximum(0) == 5.0 &&
      filter->GetCriterionWeight(0) == -6.0 && filter->GetCriterionMinimumIsPercentile(0) &&
      !filter->GetCriterionMaximumIsPercentile(0));
  const vtkMTimeType time = filter->GetMTime();
  filter->SetCriterion(0, "a", 4, 5, -6, true, false);
  checks.True("the same again changes nothing", filter->GetMTime() == time);
  filter->SetCriterion(0, "a", 4, 5, -6, true, true);
  checks.True("another changes the filter", filter->GetMTime() > time);
  filter->SetCriterion(0, "a", 4, 5, -6, true, false);
  checks.True("nothing outside",
    !filter->GetCriterionArrayName(1) && filter->GetCriterionMinimum(-1) == 0.0 &&
      filter->GetCriterionMaximum(1) == 0.0 && filter->GetCriterionWeight(1) == 0.0 &&
      !filter->GetCriterionMinimumIsPercentile(1) && !filter->GetCriterionMaximumIsPercentile(1) &&
      std::isnan(filter->GetEffectiveMinimum(1)) && std::isnan(filter->GetEffectiveMaximum(1)));
  filter->SetInputData(data);
  checks.True("message",
    CollectMessages(filter,
      [&] {
        filter->SetCriterion(1, "b", 0, 1);
      }).find("There is no criterion 1 to replace, only 1") != std::string::npos);
  filter->RemoveAllCriteria();
  checks.True("none left", filter->GetNumberOfCriteria() == 0);
}

//------------------------------------------------------------------------------
void TestProgress(Checks& checks)
{
  std::vector<Values> ignored;
  const auto data = MakeRandomData(200000, ignored);
  const auto filter = MakeFilter(data, { { "floats", 0, 1, 1 } });
  checks.True("progress is steady", CountProgress(filter, 2.0) > 5);
  checks.True("importance after an update", !GetImportance(filter->GetOutput()).empty());
  checks.True("an abort stops early", CountProgress(filter, 0.3) < 9);
  checks.True("nothing after an abort", GetImportance(filter->GetOutput()).empty());

  // Each array on cells has a part of it.
  constexpr vtkIdType lineCount = 100000;
  std::vector<std::vector<vtkIdType>> ids(lineCount);
  for (vtkIdType line = 0; line < lineCount; ++line)
  {
    ids[line] = { 2 * line, 2 * line + 1 };
  }
  data->SetLines(MakeCells(ids));
  data->GetCellData()->AddArray(MakeArray("c", Values(lineCount, 0.5)));
  const auto onCells =
    MakeFilter(data, { { "c", 0, 1, 1 }, { "floats", 0, 1, 1 }, { "c", 1, 0, 1 } });
  checks.True("progress through cells", CountProgress(onCells, 2.0) > 20);
  checks.True("an abort stops in the cells", CountProgress(onCells, 0.2) < 9);
  checks.True("nothing after it", GetImportance(onCells->GetOutput()).empty());
}
}

//------------------------------------------------------------------------------
int TestImportance(int, char*[])
{
  Checks checks;
  TestClosedForms(checks);
  TestReference(checks);
  TestMagnitudes(checks);
  TestPercentiles(checks);
  TestHistogram(checks);
  TestCellArrays(checks);
  TestComposite(checks);
  TestMessages(checks);
  TestProgress(checks);
  return checks.Result();
}
