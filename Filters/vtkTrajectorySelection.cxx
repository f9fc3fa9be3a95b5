// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectorySelection.h"

#include "Private/vtkBatches.h"
#include "Private/vtkFillOutput.h"
#include "Private/vtkForEachCell.h"
#include "Private/vtkLeafCopies.h"
#include "Private/vtkRequirePointIds.h"
#include "Private/vtkScalarAttribute.h"
#include "Private/vtkShortArrays.h"
#include "Private/vtkTrajectoryParts.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrajectorySelection);

namespace
{
using ArrayPairs = std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>>;

// On which side of the range values lie; of several values both bits may be set.
enum Side : unsigned char
{
  Inside = 1,
  Outside = 2
};

//------------------------------------------------------------------------------
// The progress of one of the four kinds of cells.
vtkBatches GetQuarter(const vtkBatches& batches, std::size_t kind)
{
  return batches.GetPart(0.25 * static_cast<double>(kind), 0.25 * static_cast<double>(kind + 1));
}

//------------------------------------------------------------------------------
// Make the arrays of `to` those of `from`, with `newCount` tuples yet to be filled. Those that are
// too short for `count` tuples stay behind, and are named in `left`.
ArrayPairs AllocateArrays(vtkDataSetAttributes* from, vtkIdType count, vtkDataSetAttributes* to,
  vtkIdType newCount, std::set<std::string>& left)
{
  const auto complete = vtk::TakeSmartPointer(from->NewInstance());
  complete->ShallowCopy(from);
  vtkRemoveShortArrays(complete, count, left);
  to->Initialize();
  to->CopyAllOn(vtkDataSetAttributes::COPYTUPLE);
  to->CopyAllocate(complete, newCount);
  ArrayPairs pairs;
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    to->GetAbstractArray(i)->SetNumberOfTuples(newCount);
    pairs.emplace_back(complete->GetAbstractArray(i), to->GetAbstractArray(i));
  }
  return pairs;
}

//------------------------------------------------------------------------------
// Ascending ids that stay, as runs of successive ones: the points of a line mostly are.
class Runs
{
public:
  struct Run
  {
    vtkIdType Source;
    vtkIdType Destination;
    vtkIdType Length;
  };

  // Returns the new id.
  vtkIdType Append(vtkIdType id)
  {
    // A run is short enough for progress to go on.
    constexpr vtkIdType maximumLength = 1 << 16;
    if (this->List.empty() || id != this->List.back().Source + this->List.back().Length ||
      this->List.back().Length == maximumLength)
    {
      this->List.push_back({ id, this->Count, 0 });
    }
    ++this->List.back().Length;
    return this->Count++;
  }

  vtkIdType GetCount() const { return this->Count; }
  const std::vector<Run>& GetList() const { return this->List; }

private:
  std::vector<Run> List;
  vtkIdType Count = 0;
};

//------------------------------------------------------------------------------
// Copy the tuples of these ids, one thread for each pair of arrays.
bool CopyTuples(const vtkBatches& batches, const ArrayPairs& pairs, const Runs& runs)
{
  const auto copy = [&](vtkIdType begin, vtkIdType end)
  {
    const auto copyArrays = [&, begin, end](vtkIdType firstPair, vtkIdType lastPair)
    {
      for (vtkIdType pair = firstPair; pair < lastPair; ++pair)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const Runs::Run& run = runs.GetList()[i];
          pairs[pair].second->InsertTuples(
            run.Destination, run.Length, run.Source, pairs[pair].first);
        }
      }
    };
    vtkSMPTools::For(0, static_cast<vtkIdType>(pairs.size()), 1, copyArrays);
  };
  return batches.For(static_cast<vtkIdType>(runs.GetList().size()), copy, 1);
}

//------------------------------------------------------------------------------
// Thins out the lines of one leaf.
class LineSelection
{
public:
  LineSelection(vtkPolyData* input, const vtkBatches& batches)
    : Input(input)
    , Batches(batches)
    , Kept(input->GetNumberOfLines(), 0)
  {
    vtkRequirePointIds(input);
  }

  // Each step returns false when aborted.
  bool ChooseLines(const vtkScalarAttribute::Location& location, const std::array<double, 2>& range,
    bool allPoints);
  bool RemoveOthers(vtkPolyData* output, std::set<std::string>& leftArrays);

  vtkIdType GetNumberOfKeptLines() const
  {
    return std::count(this->Kept.begin(), this->Kept.end(), 1);
  }

private:
  using CellArrays = std::array<vtkCellArray*, 4>;

  void KeepTrajectories(const std::vector<unsigned char>& lineSides, bool allPoints);
  bool FindDiscardedPoints();
  bool CopyPoints(vtkPolyData* output, std::set<std::string>& leftArrays);
  bool CopyCells(vtkPolyData* output, std::set<std::string>& leftArrays);
  vtkSmartPointer<vtkCellArray> Renumber(
    vtkCellArray* cells, vtkIdType firstCell, const vtkBatches& batches, Runs& runs);

  CellArrays GetCells() const
  {
    return { this->Input->GetVerts(), this->Input->GetLines(), this->Input->GetPolys(),
      this->Input->GetStrips() };
  }

  bool IsKept(vtkCellArray* cells, vtkIdType cell) const
  {
    return cells != this->Input->GetLines() || this->Kept[cell] != 0;
  }

  vtkPolyData* Input;
  vtkBatches Batches;
  std::vector<unsigned char> Kept;                   // 1 for the lines that stay
  std::vector<std::atomic<unsigned char>> Discarded; // 1 for the points that go
  vtkNew<vtkIdTypeArray> NewPointIds;
};

//------------------------------------------------------------------------------
bool LineSelection::ChooseLines(
  const vtkScalarAttribute::Location& location, const std::array<double, 2>& range, bool allPoints)
{
  if (!location.Array)
  {
    return true;
  }
  std::vector<unsigned char> sides(
    location.OnCells ? this->Input->GetNumberOfCells() : this->Input->GetNumberOfPoints());
  const auto compare = [&](vtkIdType begin, vtkIdType end)
  {
    vtkScalarAttribute::ForEach(location.Array, begin, end,
      [&](vtkIdType id, double value)
      { sides[id] = value >= range[0] && value <= range[1] ? Inside : Outside; });
  };
  const vtkIdType firstLine = this->Input->GetNumberOfVerts();
  std::vector<unsigned char> lineSides(this->Kept.size(), 0);
  const auto combine = [&](vtkIdType begin, vtkIdType end)
  {
    vtkForEachCell(this->Input->GetLines(), begin, end,
      [&](vtkIdType line, vtkIdType count, const vtkIdType* points)
      {
        lineSides[line] = location.OnCells
          ? sides[firstLine + line]
          : std::accumulate(points, points + count, 0,
              [&sides](int found, vtkIdType point) { return found | sides[point]; });
      });
  };
  if (!this->Batches.GetPart(0.0, 0.1).ParallelFor(static_cast<vtkIdType>(sides.size()), compare) ||
    !this->Batches.GetPart(0.1, 0.2).ParallelFor(static_cast<vtkIdType>(lineSides.size()), combine))
  {
    return false;
  }
  this->KeepTrajectories(lineSides, allPoints);
  return true;
}

//------------------------------------------------------------------------------
// All parts of a trajectory, or none.
void LineSelection::KeepTrajectories(const std::vector<unsigned char>& lineSides, bool allPoints)
{
  const std::vector<vtkIdType> firstLines = vtkFindTrajectories(this->Input);
  for (std::size_t i = 0; i + 1 < firstLines.size(); ++i)
  {
    const auto sides = std::accumulate(lineSides.begin() + firstLines[i],
      lineSides.begin() + firstLines[i + 1], 0, [](int found, int side) { return found | side; });
    const bool isKept = allPoints ? sides == Inside : (sides & Inside) != 0;
    std::fill(this->Kept.begin() + firstLines[i], this->Kept.begin() + firstLines[i + 1], isKept);
  }
}

//------------------------------------------------------------------------------
bool LineSelection::RemoveOthers(vtkPolyData* output, std::set<std::string>& leftArrays)
{
  if (!this->FindDiscardedPoints() || !this->CopyPoints(output, leftArrays) ||
    !this->CopyCells(output, leftArrays))
  {
    return false;
  }
  // Since VTK 9.4 a shallow copy has those of the input, which new points and cells do not remove.
  output->DeleteLinks();
  return true;
}

//------------------------------------------------------------------------------
bool LineSelection::FindDiscardedPoints()
{
  this->Discarded = std::vector<std::atomic<unsigned char>>(this->Input->GetNumberOfPoints());
  // First the points of all discarded lines, then back those that something else uses.
  const auto mark = [this](const vtkBatches& batches, vtkCellArray* cells, bool isKept)
  {
    return batches.ParallelFor(cells->GetNumberOfCells(),
      [=](vtkIdType begin, vtkIdType end)
      {
        vtkForEachCell(cells, begin, end,
          [=](vtkIdType cell, vtkIdType count, const vtkIdType* points)
          {
            const vtkIdType markCount = this->IsKept(cells, cell) == isKept ? count : 0;
            for (vtkIdType i = 0; i < markCount; ++i)
            {
              this->Discarded[points[i]].store(isKept ? 0 : 1, std::memory_order_relaxed);
            }
          });
      });
  };
  const CellArrays cells = this->GetCells();
  bool isComplete = mark(this->Batches.GetPart(0.2, 0.25), this->Input->GetLines(), false);
  for (std::size_t kind = 0; kind < cells.size() && isComplete; ++kind)
  {
    isComplete = mark(GetQuarter(this->Batches.GetPart(0.25, 0.35), kind), cells[kind], true);
  }
  return isComplete;
}

//------------------------------------------------------------------------------
bool LineSelection::CopyPoints(vtkPolyData* output, std::set<std::string>& leftArrays)
{
  Runs runs;
  const vtkIdType pointCount = this->Input->GetNumberOfPoints();
  this->NewPointIds->SetNumberOfValues(pointCount);
  const auto number = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType point = begin; point < end; ++point)
    {
      if (this->Discarded[point].load(std::memory_order_relaxed) == 0)
      {
        this->NewPointIds->SetValue(point, runs.Append(point));
      }
    }
  };
  if (!this->Batches.GetPart(0.35, 0.4).For(pointCount, number))
  {
    return false;
  }
  if (!this->Input->GetPoints())
  {
    return true;
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(this->Input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(runs.GetCount());
  output->SetPoints(points);
  ArrayPairs pairs = AllocateArrays(
    this->Input->GetPointData(), pointCount, output->GetPointData(), runs.GetCount(), leftArrays);
  pairs.emplace_back(this->Input->GetPoints()->GetData(), points->GetData());
  return CopyTuples(this->Batches.GetPart(0.4, 0.7), pairs, runs);
}

//------------------------------------------------------------------------------
bool LineSelection::CopyCells(vtkPolyData* output, std::set<std::string>& leftArrays)
{
  Runs runs;
  std::array<vtkSmartPointer<vtkCellArray>, 4> newCells;
  const CellArrays oldCells = this->GetCells();
  vtkIdType cellCount = 0;
  for (std::size_t kind = 0; kind < oldCells.size(); ++kind)
  {
    newCells[kind] = this->Renumber(
      oldCells[kind], cellCount, GetQuarter(this->Batches.GetPart(0.7, 0.9), kind), runs);
    if (!newCells[kind])
    {
      return false;
    }
    cellCount += oldCells[kind]->GetNumberOfCells();
  }
  output->SetVerts(newCells[0]);
  output->SetLines(newCells[1]);
  output->SetPolys(newCells[2]);
  output->SetStrips(newCells[3]);
  const ArrayPairs pairs = AllocateArrays(
    this->Input->GetCellData(), cellCount, output->GetCellData(), runs.GetCount(), leftArrays);
  return CopyTuples(this->Batches.GetPart(0.9, 1.0), pairs, runs);
}

//------------------------------------------------------------------------------
// The cells that stay, with the new ids of their points; nullptr when aborted. `runs` gets their
// ids, which begin at `firstCell`.
vtkSmartPointer<vtkCellArray> LineSelection::Renumber(
  vtkCellArray* cells, vtkIdType firstCell, const vtkBatches& batches, Runs& runs)
{
  std::vector<vtkIdType> ids;
  vtkNew<vtkIdTypeArray> offsets;
  offsets->InsertNextValue(0);
  vtkIdType length = 0;
  const auto gather = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      if (this->IsKept(cells, cell))
      {
        ids.push_back(cell);
        runs.Append(firstCell + cell);
        length += cells->GetCellSize(cell);
        offsets->InsertNextValue(length);
      }
    }
  };
  if (!batches.GetPart(0.0, 0.3).For(cells->GetNumberOfCells(), gather))
  {
    return nullptr;
  }

  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(length);
  const vtkIdType* newPointIds = this->NewPointIds->GetPointer(0);
  const auto renumber = [&](vtkIdType begin, vtkIdType end)
  {
    vtkNew<vtkIdList> buffer;
    vtkIdType pointCount = 0;
    const vtkIdType* points = nullptr;
    for (vtkIdType i = begin; i < end; ++i)
    {
      cells->GetCellAtId(ids[i], pointCount, points, buffer);
      std::transform(points, points + pointCount, connectivity->GetPointer(offsets->GetValue(i)),
        [newPointIds](vtkIdType point) { return newPointIds[point]; });
    }
  };
  if (!batches.GetPart(0.3, 1.0).ParallelFor(static_cast<vtkIdType>(ids.size()), renumber))
  {
    return nullptr;
  }
  auto renumbered = vtkSmartPointer<vtkCellArray>::New();
  renumbered->SetData(offsets, connectivity);
  return renumbered;
}
}

//------------------------------------------------------------------------------
int vtkTrajectorySelection::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkTrajectorySelection::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* output = vtkDataObject::GetData(outputVector);
  this->EffectiveMinimum = this->EffectiveMaximum = std::numeric_limits<double>::quiet_NaN();
  this->NumberOfLines = this->NumberOfSelectedLines = 0;
  return vtkFillOutput(
    this, output, [&] { return this->Select(vtkDataObject::GetData(inputVector[0]), output); });
}

//------------------------------------------------------------------------------
bool vtkTrajectorySelection::Select(vtkDataObject* input, vtkDataObject* output)
{
  const vtkScalarAttribute attribute(input, this->ArrayName);
  const auto range = attribute.ComputeRange(
    { this->Minimum, this->MinimumIsPercentile }, { this->Maximum, this->MaximumIsPercentile });
  if (std::isnan(range[0]) || std::isnan(range[1]))
  {
    vtkWarningMacro("There is no finite value to take percentiles of in the array '"
      << this->ArrayName << "': no line is selected.");
  }
  this->EffectiveMinimum = range[0];
  this->EffectiveMaximum = range[1];

  std::set<std::string> leftArrays;
  const auto leaves = vtkCopyLeaves(input, output);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf)
  {
    auto* lines = vtkPolyData::SafeDownCast(leaves[leaf].first);
    if (!lines)
    {
      continue;
    }
    const double fraction = 1.0 / static_cast<double>(leaves.size());
    LineSelection selection(lines, vtkBatches(this, leaf * fraction, (leaf + 1) * fraction));
    if (!selection.ChooseLines(attribute.Locate(lines), range, this->AllPoints))
    {
      return false;
    }
    const vtkIdType keptCount = selection.GetNumberOfKeptLines();
    this->NumberOfLines += lines->GetNumberOfLines();
    this->NumberOfSelectedLines += keptCount;
    if (keptCount < lines->GetNumberOfLines() &&
      !selection.RemoveOthers(vtkPolyData::SafeDownCast(leaves[leaf].second), leftArrays))
    {
      return false;
    }
  }
  if (!leftArrays.empty())
  {
    vtkWarningMacro(<< vtkDescribeShortArrays(leftArrays));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTrajectorySelection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Minimum: " << this->Minimum << "\n";
  os << indent << "Maximum: " << this->Maximum << "\n";
  os << indent << "MinimumIsPercentile: " << this->MinimumIsPercentile << "\n";
  os << indent << "MaximumIsPercentile: " << this->MaximumIsPercentile << "\n";
  os << indent << "AllPoints: " << this->AllPoints << "\n";
  os << indent << "EffectiveMinimum: " << this->EffectiveMinimum << "\n";
  os << indent << "EffectiveMaximum: " << this->EffectiveMaximum << "\n";
  os << indent << "NumberOfLines: " << this->NumberOfLines << "\n";
  os << indent << "NumberOfSelectedLines: " << this->NumberOfSelectedLines << "\n";
}

VTK_ABI_NAMESPACE_END
