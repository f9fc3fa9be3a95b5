// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkGlobalOpacitySolver.h"

#include "Private/vtkForEachCell.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtk_eigen.h"

#include VTK_EIGEN(SparseCholesky)

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkGlobalOpacitySolver);
vtkCxxSetSmartPointerMacro(vtkGlobalOpacitySolver, Importance, vtkDataArray);
vtkCxxSetSmartPointerMacro(vtkGlobalOpacitySolver, PixelLists, vtkCellArray);
vtkCxxSetSmartPointerMacro(vtkGlobalOpacitySolver, Neighbors, vtkCellArray);

namespace
{
using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, vtkIdType>;

//------------------------------------------------------------------------------
// Sums over the squares of the occlusion degrees h_ij, which are not kept: row i of their matrix is
// counted, added to the sums and forgotten, from the lists behind the first fragment of segment i
// in each pixel. A row fits into a cache, where the matrix would not.
//
// Threads share blocks of rows. Their number is fixed, so that the sums down the columns have the
// same order, and the same bits, with any number of threads.
class OcclusionSums
{
public:
  OcclusionSums(vtkCellArray* pixels, const std::vector<double>& importance)
    : Importance(importance)
    , Hidden(importance.size(), 0.0)
    , Hiding(importance.size(), 0.0)
  {
    this->JoinLists(pixels);
    this->FindFirstFragments();
    vtkSMPTools::For(0, NumberOfBlocks, 1,
      [this](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType block = begin; block < end; ++block)
        {
          this->ComputeBlock(static_cast<std::size_t>(block));
        }
      });
    for (const auto& columns : this->Columns)
    {
      std::transform(columns.begin(), columns.end(), this->Hiding.begin(), this->Hiding.begin(),
        std::plus<double>());
    }
  }

  // sum_j (h_ij g_j)^2 of segment i: the importance that it hides.
  double GetHidden(std::size_t i) const { return this->Hidden[i]; }

  // sum_j (h_ji g_j)^2 of segment i: the importance that hides it.
  double GetHiding(std::size_t i) const { return this->Hiding[i]; }

private:
  static constexpr vtkIdType EndOfList = -1;
  static constexpr std::size_t NoPixel = static_cast<std::size_t>(-1);
  static constexpr std::size_t NumberOfBlocks = 32;

  struct Row
  {
    struct Cell
    {
      double Degree = 0.0;
      std::size_t LastPixel = NoPixel;
    };
    std::vector<Cell> Cells;
    std::vector<vtkIdType> Used;
  };

  void JoinLists(vtkCellArray* pixels)
  {
    this->Lists.reserve(
      static_cast<std::size_t>(pixels->GetNumberOfConnectivityIds() + pixels->GetNumberOfCells()));
    vtkForEachCell(pixels, 0, pixels->GetNumberOfCells(),
      [this](vtkIdType, vtkIdType size, const vtkIdType* segments)
      {
        this->Lists.insert(this->Lists.end(), segments, segments + size);
        this->Lists.push_back(EndOfList);
      });
  }

  // Call `visit` with each segment and the position of its first fragment in each pixel.
  template <typename Visit>
  void VisitFirstFragments(Visit&& visit) const
  {
    std::vector<std::size_t> lastPixel(this->Importance.size(), NoPixel);
    std::size_t pixel = 0;
    for (std::size_t position = 0; position < this->Lists.size(); ++position)
    {
      const vtkIdType segment = this->Lists[position];
      if (segment == EndOfList)
      {
        ++pixel;
      }
      else if (lastPixel[segment] != pixel)
      {
        lastPixel[segment] = pixel;
        visit(segment, position);
      }
    }
  }

  void FindFirstFragments()
  {
    this->Offsets.assign(this->Importance.size() + 1, 0);
    this->VisitFirstFragments(
      [this](vtkIdType segment, std::size_t) { ++this->Offsets[segment + 1]; });
    std::partial_sum(this->Offsets.begin(), this->Offsets.end(), this->Offsets.begin());
    this->FirstFragments.resize(this->Offsets.back());
    auto next = this->Offsets;
    this->VisitFirstFragments([this, &next](vtkIdType segment, std::size_t position)
      { this->FirstFragments[next[segment]++] = position; });
  }

  void ComputeBlock(std::size_t block)
  {
    const std::size_t size = this->Importance.size();
    Row row;
    row.Cells.resize(size);
    auto& columns = this->Columns[block];
    columns.assign(size, 0.0);
    const std::size_t end = (block + 1) * size / NumberOfBlocks;
    for (std::size_t segment = block * size / NumberOfBlocks; segment < end; ++segment)
    {
      for (std::size_t k = this->Offsets[segment]; k < this->Offsets[segment + 1]; ++k)
      {
        this->CountPixel(row, segment, k);
      }
      for (const vtkIdType other : row.Used)
      {
        const double degree = std::exchange(row.Cells[other].Degree, 0.0);
        const double hidden = degree * this->Importance[other];
        const double hiding = degree * this->Importance[segment];
        this->Hidden[segment] += hidden * hidden;
        columns[other] += hiding * hiding;
      }
      row.Used.clear();
    }
  }

  // Add the pixel of the segment's first fragment k to the row. That number stands for the pixel,
  // too, since no other segment has it.
  void CountPixel(Row& row, std::size_t segment, std::size_t k) const
  {
    row.Cells[segment].LastPixel = k;
    const vtkIdType* other = &this->Lists[this->FirstFragments[k]];
    while (*++other != EndOfList)
    {
      auto& cell = row.Cells[*other];
      if (cell.LastPixel != k)
      {
        cell.LastPixel = k;
        if (cell.Degree == 0.0)
        {
          row.Used.push_back(*other);
        }
        cell.Degree += 1.0;
      }
    }
  }

  const std::vector<double>& Importance;
  std::vector<double> Hidden;
  std::vector<double> Hiding;
  std::vector<vtkIdType> Lists;            // of all pixels, each followed by EndOfList
  std::vector<std::size_t> FirstFragments; // positions in Lists, segment by segment
  std::vector<std::size_t> Offsets;        // into FirstFragments, of each segment
  std::array<std::vector<double>, NumberOfBlocks> Columns;
};

//------------------------------------------------------------------------------
// The pairs of segments and neighbours, each once.
std::vector<std::pair<vtkIdType, vtkIdType>> ListNeighbors(vtkCellArray* neighbors)
{
  std::vector<std::pair<vtkIdType, vtkIdType>> pairs;
  vtkForEachCell(neighbors, 0, neighbors->GetNumberOfCells(),
    [&pairs](vtkIdType segment, vtkIdType size, const vtkIdType* ids)
    {
      for (vtkIdType k = 0; k < size; ++k)
      {
        pairs.emplace_back(segment, ids[k]);
      }
    });
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

//------------------------------------------------------------------------------
Matrix AssembleHessian(
  const std::vector<double>& penalties, vtkCellArray* neighbors, double smoothness)
{
  std::vector<Eigen::Triplet<double, vtkIdType>> elements;
  const auto size = static_cast<vtkIdType>(penalties.size());
  for (vtkIdType i = 0; i < size; ++i)
  {
    elements.emplace_back(i, i, 1.0 + penalties[i]);
  }
  if (neighbors && smoothness > 0.0)
  {
    const double half = smoothness / 2.0;
    for (const auto& [i, j] : ListNeighbors(neighbors))
    {
      elements.emplace_back(i, i, half);
      elements.emplace_back(j, j, half);
      elements.emplace_back(i, j, -half);
      elements.emplace_back(j, i, -half);
    }
  }
  Matrix hessian(size, size);
  hessian.setFromTriplets(elements.begin(), elements.end());
  return hessian;
}

//------------------------------------------------------------------------------
// See GetResidual().
double ComputeResidual(const Matrix& hessian, const Eigen::VectorXd& opacities)
{
  const Eigen::VectorXd gradient = hessian * opacities - Eigen::VectorXd::Ones(opacities.size());
  const Eigen::VectorXd magnitude =
    hessian.cwiseAbs() * opacities + Eigen::VectorXd::Ones(opacities.size());
  double residual = 0.0;
  for (Eigen::Index i = 0; i < opacities.size(); ++i)
  {
    const bool blocked =
      (opacities[i] <= 0.0 && gradient[i] > 0.0) || (opacities[i] >= 1.0 && gradient[i] < 0.0);
    residual = std::max(residual, blocked ? 0.0 : std::abs(gradient[i]) / magnitude[i]);
  }
  return residual;
}
}

//------------------------------------------------------------------------------
vtkGlobalOpacitySolver::vtkGlobalOpacitySolver()
  : Opacity(vtkSmartPointer<vtkDoubleArray>::New())
{
  this->Opacity->SetName("Opacity");
}

//------------------------------------------------------------------------------
vtkGlobalOpacitySolver::~vtkGlobalOpacitySolver() = default;

//------------------------------------------------------------------------------
vtkDataArray* vtkGlobalOpacitySolver::GetImportance()
{
  return this->Importance;
}

//------------------------------------------------------------------------------
vtkCellArray* vtkGlobalOpacitySolver::GetPixelLists()
{
  return this->PixelLists;
}

//------------------------------------------------------------------------------
vtkCellArray* vtkGlobalOpacitySolver::GetNeighbors()
{
  return this->Neighbors;
}

//------------------------------------------------------------------------------
vtkDoubleArray* vtkGlobalOpacitySolver::GetOpacity()
{
  return this->Opacity;
}

//------------------------------------------------------------------------------
bool vtkGlobalOpacitySolver::CheckImportance()
{
  if (!this->Importance || this->Importance->GetNumberOfComponents() != 1)
  {
    vtkErrorMacro(<< "Importance is "
                  << (this->Importance ? "an array of more than one component" : "not set")
                  << ": give an array of one component with a value for each segment.");
    return false;
  }
  for (vtkIdType i = 0; i < this->Importance->GetNumberOfTuples(); ++i)
  {
    if (std::isnan(this->Importance->GetComponent(i, 0)))
    {
      vtkErrorMacro(<< "Importance of segment " << i << " is NaN: give a number in [0,1].");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkGlobalOpacitySolver::CheckSegments(const char* name, const char* cell, vtkCellArray* cells)
{
  if (!cells->IsValid())
  {
    vtkErrorMacro(<< name
                  << " has offsets that do not fit its ids: give offsets that begin with 0, "
                     "never fall and end with the number of ids.");
    return false;
  }
  const vtkIdType segments = this->Importance->GetNumberOfTuples();
  vtkIdType wrongCell = -1;
  vtkIdType wrongSegment = -1;
  vtkForEachCell(cells, 0, cells->GetNumberOfCells(),
    [&](vtkIdType index, vtkIdType size, const vtkIdType* ids)
    {
      const auto* found = std::find_if(
        ids, ids + size, [segments](vtkIdType id) { return id < 0 || id >= segments; });
      if (wrongCell < 0 && found != ids + size)
      {
        wrongCell = index;
        wrongSegment = *found;
      }
    });
  if (wrongCell >= 0)
  {
    vtkErrorMacro(<< name << ": " << cell << " " << wrongCell << " names segment " << wrongSegment
                  << ", but Importance has " << segments << " segments: count them from 0.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkGlobalOpacitySolver::Solve()
{
  this->Opacity->Initialize();
  this->Residual = 0.0;
  if (!this->CheckImportance())
  {
    return false;
  }
  const vtkIdType size = this->Importance->GetNumberOfTuples();
  if (!this->PixelLists)
  {
    vtkErrorMacro("PixelLists is not set: give the segments of each pixel, front to back.");
    return false;
  }
  if (this->Neighbors && this->Neighbors->GetNumberOfCells() != size)
  {
    vtkErrorMacro(<< "Neighbors has " << this->Neighbors->GetNumberOfCells()
                  << " cells, but Importance has " << size
                  << " segments: give one cell for each segment.");
    return false;
  }
  if (!this->CheckSegments("PixelLists", "pixel", this->PixelLists) ||
    (this->Neighbors && !this->CheckSegments("Neighbors", "segment", this->Neighbors)))
  {
    return false;
  }

  std::vector<double> importance(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    importance[i] = std::clamp(this->Importance->GetComponent(i, 0), 0.0, 1.0);
  }
  const OcclusionSums sums(this->PixelLists, importance);
  std::vector<double> penalties(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    penalties[i] = std::pow(1.0 - importance[i], 2.0 * this->Emphasis) *
      (this->OcclusionWeight * sums.GetHidden(i) + this->BackgroundWeight * sums.GetHiding(i));
  }

  const Matrix hessian = AssembleHessian(penalties, this->Neighbors, this->Smoothness);
  const Eigen::SimplicialLDLT<Matrix> factors(hessian);
  // The bounds are never active but for rounding: see the header.
  const Eigen::VectorXd opacities =
    factors.solve(Eigen::VectorXd::Ones(size)).cwiseMax(0.0).cwiseMin(1.0);
  this->Residual = ComputeResidual(hessian, opacities);
  this->Opacity->SetNumberOfTuples(size);
  std::copy(opacities.begin(), opacities.end(), this->Opacity->GetPointer(0));
  return true;
}

//------------------------------------------------------------------------------
void vtkGlobalOpacitySolver::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Importance: " << this->Importance << "\n";
  os << indent << "PixelLists: " << this->PixelLists << "\n";
  os << indent << "Neighbors: " << this->Neighbors << "\n";
  os << indent << "OcclusionWeight: " << this->OcclusionWeight << "\n";
  os << indent << "BackgroundWeight: " << this->BackgroundWeight << "\n";
  os << indent << "Emphasis: " << this->Emphasis << "\n";
  os << indent << "Smoothness: " << this->Smoothness << "\n";
  os << indent << "Opacity: " << this->Opacity << "\n";
  os << indent << "Residual: " << this->Residual << "\n";
}

VTK_ABI_NAMESPACE_END
