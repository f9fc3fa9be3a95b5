// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The global solver against closed forms of two and three segments, against a projected gradient
 * on random problems with a dense matrix of occlusion degrees, and against its optimality
 * conditions; what it refuses.
 */

#include "ReferenceTesting.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkGlobalOpacitySolver.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkTestErrorObserver.h"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace
{
using Lists = std::vector<std::vector<vtkIdType>>;

struct Problem
{
  std::vector<double> importance;
  Lists pixels;
  Lists neighbors;
  double q = 0;
  double r = 0;
  double lambda = 1;
  double s = 0;
};

vtkSmartPointer<vtkDoubleArray> MakeArray(const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

vtkSmartPointer<vtkCellArray> MakeCells(const Lists& lists)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& list : lists)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(list.size()), list.data());
  }
  return cells;
}

void SetUp(vtkGlobalOpacitySolver* solver, const Problem& problem)
{
  solver->SetImportance(MakeArray(problem.importance));
  solver->SetPixelLists(MakeCells(problem.pixels));
  solver->SetNeighbors(problem.neighbors.empty() ? nullptr : MakeCells(problem.neighbors));
  solver->SetOcclusionWeight(problem.q);
  solver->SetBackgroundWeight(problem.r);
  solver->SetEmphasis(problem.lambda);
  solver->SetSmoothness(problem.s);
}

std::vector<double> Solve(Checks& checks, const Problem& problem)
{
  vtkNew<vtkGlobalOpacitySolver> solver;
  SetUp(solver, problem);
  checks.True("solved", solver->Solve());
  checks.True("optimality conditions", solver->GetResidual() <= 1e-10);
  const auto* values = solver->GetOpacity()->GetPointer(0);
  std::vector<double> opacities(values, values + solver->GetOpacity()->GetNumberOfTuples());
  checks.True("inside the bounds",
    std::all_of(opacities.begin(), opacities.end(), [](double a) { return a > 0 && a <= 1; }));
  return opacities;
}

// The problem as it is written down: GTG17 eqs. 1 to 4.
class DenseProblem
{
public:
  explicit DenseProblem(const Problem& problem)
    : Given(problem)
    , Size(problem.importance.size())
    , Degree(this->Size, std::vector<double>(this->Size, 0.0))
    , Adjacency(this->Size, std::vector<double>(this->Size, 0.0))
  {
    for (const auto& list : problem.pixels)
    {
      auto occludes = std::vector<std::vector<bool>>(this->Size, std::vector<bool>(this->Size));
      for (std::size_t front = 0; front < list.size(); ++front)
      {
        for (std::size_t back = front + 1; back < list.size(); ++back)
        {
          occludes[list[front]][list[back]] = list[front] != list[back];
        }
      }
      for (std::size_t i = 0; i < this->Size; ++i)
      {
        for (std::size_t j = 0; j < this->Size; ++j)
        {
          this->Degree[i][j] += occludes[i][j] ? 1 : 0;
        }
      }
    }
    for (std::size_t i = 0; i < problem.neighbors.size(); ++i)
    {
      for (const vtkIdType j : problem.neighbors[i])
      {
        this->Adjacency[i][j] = 1;
      }
    }
  }

  double Energy(const std::vector<double>& opacities) const
  {
    const auto& given = this->Given;
    const auto square = [](double x) { return x * x; };
    double energy = 0;
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      const double weight = std::pow(1 - given.importance[i], given.lambda);
      energy += square(opacities[i] - 1);
      for (std::size_t j = 0; j < this->Size; ++j)
      {
        const double term = opacities[i] * weight * given.importance[j];
        energy += given.q * square(term * this->Degree[i][j]);
        energy += given.r * square(term * this->Degree[j][i]);
        energy += given.s * this->Adjacency[i][j] / 2 * square(opacities[i] - opacities[j]);
      }
    }
    return energy / 2;
  }

  // Descent by steps along the negative gradient, each moved back into the bounds.
  std::vector<double> ProjectedGradient() const
  {
    std::vector<double> base(this->Size, 0.0);
    const auto linear = this->Gradient(base);
    std::vector<std::vector<double>> hessian(this->Size);
    double bound = 0;
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      base[i] = 1;
      hessian[i] = this->Gradient(base);
      base[i] = 0;
      double sum = 0;
      for (std::size_t j = 0; j < this->Size; ++j)
      {
        hessian[i][j] -= linear[j];
        sum += std::abs(hessian[i][j]);
      }
      bound = std::max(bound, sum);
    }
    std::vector<double> opacities(this->Size, 0.5);
    for (int iteration = 0; iteration < 20000; ++iteration)
    {
      std::vector<double> gradient(linear);
      for (std::size_t i = 0; i < this->Size; ++i)
      {
        for (std::size_t j = 0; j < this->Size; ++j)
        {
          gradient[i] += hessian[i][j] * opacities[j];
        }
      }
      for (std::size_t i = 0; i < this->Size; ++i)
      {
        opacities[i] = std::clamp(opacities[i] - gradient[i] / bound, 0.0, 1.0);
      }
    }
    return opacities;
  }

private:
  // Central differences are exact for a quadratic function, but for rounding.
  std::vector<double> Gradient(std::vector<double> opacities) const
  {
    std::vector<double> gradient;
    for (double& opacity : opacities)
    {
      const double here = opacity;
      opacity = here + 0.5;
      const double above = this->Energy(opacities);
      opacity = here - 0.5;
      gradient.push_back(above - this->Energy(opacities));
      opacity = here;
    }
    return gradient;
  }

  const Problem& Given;
  std::size_t Size;
  std::vector<std::vector<double>> Degree;
  std::vector<std::vector<double>> Adjacency;
};

Problem RandomProblem(std::mt19937& generator, vtkIdType segments)
{
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto anySegment = [&generator, segments]()
  { return static_cast<vtkIdType>(generator() % segments); };
  Problem problem;
  for (vtkIdType i = 0; i < segments; ++i)
  {
    problem.importance.push_back(uniform(generator));
    // Neighbours that repeat, that are the segment itself, and that do not return the favour.
    problem.neighbors.push_back({ anySegment(), anySegment(), anySegment() });
  }
  for (int pixel = 0; pixel < 100; ++pixel)
  {
    problem.pixels.emplace_back(generator() % 12);
    std::generate(problem.pixels.back().begin(), problem.pixels.back().end(), anySegment);
  }
  problem.q = 0.1 * uniform(generator);
  problem.r = 0.1 * uniform(generator);
  problem.lambda = 0.5 + 2 * uniform(generator);
  problem.s = 10 * uniform(generator);
  return problem;
}

void TestClosedForms(Checks& checks)
{
  // Segment 0 is in front of segment 1 in three pixels.
  Problem two{ { 0.5, 0.25 }, { { 0, 1 }, { 0, 1 }, {}, { 0, 1 } }, { { 1 }, { 0 } }, 2, 3, 1.5 };
  const double d0 = std::pow(0.5, 3) * 2 * 9 * 0.0625;
  const double d1 = std::pow(0.75, 3) * 3 * 9 * 0.25;
  const auto apart = Solve(checks, two);
  checks.Near("two segments, in front", apart[0], 1 / (1 + d0), 1e-15);
  checks.Near("two segments, behind", apart[1], 1 / (1 + d1), 1e-15);
  two.s = 5;
  const auto joined = Solve(checks, two);
  const double determinant = (6 + d0) * (6 + d1) - 25;
  checks.Near("two neighbours, in front", joined[0], (11 + d1) / determinant, 1e-15);
  checks.Near("two neighbours, behind", joined[1], (11 + d0) / determinant, 1e-15);
  two.neighbors[1].clear();
  checks.Near("a neighbour of one only counts half", Solve(checks, two)[0],
    (6 + d1) / ((3.5 + d0) * (3.5 + d1) - 6.25), 1e-15);

  // The middle one of a line of three hides an important segment elsewhere, in two pixels.
  const Problem three{ { 0, 0, 0, 1 }, { { 1, 3 }, { 1, 3 } }, { { 1 }, { 0, 2 }, { 1 }, {} }, 10,
    0, 1, 2 };
  const auto line = Solve(checks, three);
  const double middle = 7 / ((1 + 40 + 4) * 3.0 - 8);
  checks.Near("a line of three, its middle", line[1], middle, 1e-15);
  checks.Near("a line of three, one end", line[0], (1 + 2 * middle) / 3, 1e-15);
  checks.Near("a line of three, the other end", line[2], line[0], 1e-15);
  checks.Near("what is hidden", line[3], 1, 0);
}

void TestDegrees(Checks& checks)
{
  const auto opacity = [&checks](const Lists& pixels, vtkIdType segment) {
    return Solve(checks, { { 0, 1, 0 }, pixels, {}, 1, 0 })[segment];
  };
  checks.Near("a pixel counts once", opacity({ { 0, 0, 1, 1 } }, 0), 0.5, 1e-15);
  checks.Near("and more pixels by their square", opacity({ { 0, 1 }, { 0, 1 } }, 0), 0.2, 1e-15);
  checks.Near("on both sides, in front", opacity({ { 1, 0, 1 } }, 0), 0.5, 1e-15);
  checks.Near("behind only", opacity({ { 1, 0, 2 } }, 0), 1, 0);
  checks.Near("through another one", opacity({ { 0, 2, 1 } }, 0), 0.5, 1e-15);

  std::mt19937 generator(2);
  Problem single = RandomProblem(generator, 20);
  single.pixels.clear();
  for (vtkIdType pixel = 0; pixel < 100; ++pixel)
  {
    single.pixels.push_back({ pixel % 20 });
  }
  single.q = single.r = 1e5;
  for (const double a : Solve(checks, single))
  {
    checks.Near("one fragment in each pixel", a, 1, 1e-14);
  }
}

void TestRandomProblems(Checks& checks)
{
  std::mt19937 generator(7);
  std::normal_distribution<double> normal(0, 0.01);
  for (int run = 0; run < 5; ++run)
  {
    Problem problem = RandomProblem(generator, 20);
    const DenseProblem dense(problem);
    const auto opacities = Solve(checks, problem);
    const auto expected = dense.ProjectedGradient();
    for (std::size_t i = 0; i < opacities.size(); ++i)
    {
      checks.Near("projected gradient", opacities[i], expected[i], 1e-9);
    }
    for (int k = 0; k < 20; ++k)
    {
      auto other = opacities;
      for (double& a : other)
      {
        a = std::clamp(a + normal(generator), 0.0, 1.0);
      }
      checks.True("least energy", dense.Energy(other) > dense.Energy(opacities));
    }

    // Without smoothness each segment is on its own, and neighbours are of no account.
    problem.s = 0;
    const auto alone = Solve(checks, problem);
    problem.neighbors.clear();
    checks.True("no smoothness, no neighbours", alone == Solve(checks, problem));
  }
}

void TestExtremes(Checks& checks)
{
  std::mt19937 generator(3);
  Problem problem = RandomProblem(generator, 500);
  problem.importance[0] = 1;
  problem.importance[1] = 0;
  for (const double weight : { 0.0, 1e5, 1e30 })
  {
    for (const double smoothness : { 0.0, 1.0, 1e6 })
    {
      for (const double lambda : { 0.1, 20.0 })
      {
        problem.q = problem.r = weight;
        problem.s = smoothness;
        problem.lambda = lambda;
        const auto opacities = Solve(checks, problem);
        checks.True("opaque", weight > 0 || smoothness > 1 || opacities[7] > 1 - 1e-14);
      }
    }
  }

  // Importance outside [0,1] is moved to its ends.
  problem.importance[0] = std::numeric_limits<double>::infinity();
  problem.importance[1] = -3;
  const auto outside = Solve(checks, problem);
  problem.importance[0] = 1;
  problem.importance[1] = 0;
  checks.True("importance outside [0,1]", Solve(checks, problem) == outside);

  std::vector<double> threads;
  vtkSMPTools::LocalScope(
    vtkSMPTools::Config(3, "STDThread", false), [&]() { threads = Solve(checks, problem); });
  checks.True("same bits with any number of threads", threads == outside);

  checks.True("no segments", Solve(checks, {}).empty());
}

void TestErrors(Checks& checks)
{
  vtkNew<vtkGlobalOpacitySolver> solver;
  vtkNew<vtkTest::ErrorObserver> observer;
  solver->AddObserver("ErrorEvent", observer);
  const auto refused = [&](const std::string& message)
  {
    checks.True(message + " is refused", !solver->Solve());
    checks.True(message, observer->CheckErrorMessage(message) == 0);
    checks.True("no opacities", solver->GetOpacity()->GetNumberOfTuples() == 0);
  };
  const Problem good{ { 0.1, 0.2, 0.3 }, { { 0, 1 }, { 2, 1 } }, { { 1 }, { 0, 2 }, { 1 } }, 1 };

  refused("Importance is not set: give an array of one component");
  solver->SetImportance(MakeArray(good.importance));
  refused("PixelLists is not set: give the segments of each pixel");

  SetUp(solver, good);
  checks.True("good", solver->Solve() && solver->GetOpacity()->GetNumberOfTuples() == 3);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  solver->SetImportance(vectors);
  refused("Importance is an array of more than one component");

  Problem bad = good;
  bad.importance[1] = std::numeric_limits<double>::quiet_NaN();
  SetUp(solver, bad);
  refused("Importance of segment 1 is NaN: give a number in [0,1]");
  bad = good;
  bad.neighbors.pop_back();
  SetUp(solver, bad);
  refused("Neighbors has 2 cells, but Importance has 3 segments");
  for (const vtkIdType wrong : { -1, 3 })
  {
    const std::string named =
      " names segment " + std::to_string(wrong) + ", but Importance has 3 segments";
    bad = good;
    bad.pixels[1][0] = wrong;
    SetUp(solver, bad);
    refused("PixelLists: pixel 1" + named);
    bad = good;
    bad.neighbors[2][0] = wrong;
    SetUp(solver, bad);
    refused("Neighbors: segment 2" + named);
  }

  SetUp(solver, good);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->InsertNextValue(0);
  offsets->InsertNextValue(9);
  vtkNew<vtkIdTypeArray> ids;
  ids->InsertNextValue(0);
  vtkNew<vtkCellArray> inconsistent;
  inconsistent->SetData(offsets, ids);
  solver->SetPixelLists(inconsistent);
  refused("PixelLists has offsets that do not fit its ids");
}
}

int TestGlobalOpacitySolver(int, char*[])
{
  Checks checks;
  TestClosedForms(checks);
  TestDegrees(checks);
  TestRandomProblems(checks);
  TestExtremes(checks);
  TestErrors(checks);
  return checks.Result();
}
