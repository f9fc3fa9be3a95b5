// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectorySelection.h"

#include "Private/vtkBatches.h"
#include "Private/vtkLeafCopies.h"
#include "Private/vtkScalarAttribute.h"

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
#include <stdexcept>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrajectorySelection);

namespace
{
using ArrayPairs = std::vector<std::pair<vtkAbstractArray*, vtkAbstractArray*>>;

//------------------------------------------------------------------------------
// Call `function(i, count, points)` for the cells of [begin, end), from any thread.
template <typename Function>
void ForEachCell(vtkCellArray* cells, vtkIdType begin, vtkIdType end, Function&& function)
{
  vtkNew<vtkIdList> ids;
  vtkIdType count = 0;
  const vtkIdType* points = nullptr;
  for (vtkIdType cell = begin; cell < end; ++cell)
  {
    cells->GetCellAtId(cell, count, points, ids);
    function(cell, count, points);
  }
}

//------------------------------------------------------------------------------
// Make the arrays of `to` those of `from`, with `count` tuples yet to be filled.
ArrayPairs AllocateArrays(vtkDataSetAttributes* from, vtkDataSetAttributes* to, vtkIdType count)
{
  to->Initialize();
  to->CopyAllOn(vtkDataSetAttributes::COPYTUPLE);
  to->CopyAllocate(from, count);
  ArrayPairs pairs;
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    to->GetAbstractArray(i)->SetNumberOfTuples(count);
    pairs.emplace_back(from->GetAbstractArray(i), to->GetAbstractArray(i));
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
  }

  // Each step returns false when aborted.
  bool ChooseLines(const vtkScalarAttribute::Location& location, const std::array<double, 2>& range,
    bool allPoints);
  bool RemoveOthers(vtkPolyData* output);

  vtkIdType GetNumberOfKeptLines() const
  {
    return std::count(this->Kept.begin(), this->Kept.end(), 1);
  }

private:
  using CellArrays = std::array<vtkCellArray*, 4>;

  bool FindDiscardedPoints();
  bool CopyPoints(vtkPolyData* output);
  bool CopyCells(vtkPolyData* output);
  vtkSmartPointer<vtkCellArray> Renumber(vtkCellArray* cells, const std::vector<vtkIdType>& ids);

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
  const vtkIdType firstLine = this->Input->GetNumberOfVerts();
  const auto lineCount = static_cast<vtkIdType>(this->Kept.size());
  std::vector<unsigned char> isInRange(
    location.OnCells ? this->Input->GetNumberOfCells() : this->Input->GetNumberOfPoints());
  const auto compare = [&](vtkIdType begin, vtkIdType end)
  {
    vtkScalarAttribute::ForEach(location.Array, begin, end,
      [&](vtkIdType id, double value) { isInRange[id] = value >= range[0] && value <= range[1]; });
  };
  const auto choose = [&](vtkIdType begin, vtkIdType end)
  {
    const auto test = [&isInRange](vtkIdType point) { return isInRange[point] != 0; };
    ForEachCell(this->Input->GetLines(), begin, end,
      [&](vtkIdType line, vtkIdType count, const vtkIdType* points)
      {
        this->Kept[line] = location.OnCells ? isInRange[firstLine + line]
          : allPoints                       ? count > 0 && std::all_of(points, points + count, test)
                                            : std::any_of(points, points + count, test);
      });
  };
  return this->Batches.GetPart(0.0, 0.1).ParallelFor(
           static_cast<vtkIdType>(isInRange.size()), compare) &&
    this->Batches.GetPart(0.1, 0.2).ParallelFor(lineCount, choose);
}

//------------------------------------------------------------------------------
bool LineSelection::RemoveOthers(vtkPolyData* output)
{
  return this->FindDiscardedPoints() && this->CopyPoints(output) && this->CopyCells(output);
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
        ForEachCell(cells, begin, end,
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
  return mark(this->Batches.GetPart(0.2, 0.3), this->Input->GetLines(), false) &&
    std::all_of(cells.begin(), cells.end(),
      [&](vtkCellArray* part) { return mark(this->Batches.GetPart(0.3, 0.4), part, true); });
}

//------------------------------------------------------------------------------
bool LineSelection::CopyPoints(vtkPolyData* output)
{
  Runs runs;
  const vtkIdType pointCount = this->Input->GetNumberOfPoints();
  this->NewPointIds->SetNumberOfValues(pointCount);
  for (vtkIdType point = 0; point < pointCount; ++point)
  {
    if (this->Discarded[point].load(std::memory_order_relaxed) == 0)
    {
      this->NewPointIds->SetValue(point, runs.Append(point));
    }
  }
  if (!this->Input->GetPoints())
  {
    return true;
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(this->Input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(runs.GetCount());
  output->SetPoints(points);
  ArrayPairs pairs =
    AllocateArrays(this->Input->GetPointData(), output->GetPointData(), runs.GetCount());
  pairs.emplace_back(this->Input->GetPoints()->GetData(), points->GetData());
  return CopyTuples(this->Batches.GetPart(0.4, 0.7), pairs, runs);
}

//------------------------------------------------------------------------------
bool LineSelection::CopyCells(vtkPolyData* output)
{
  Runs runs;
  std::array<vtkSmartPointer<vtkCellArray>, 4> newCells;
  const CellArrays oldCells = this->GetCells();
  vtkIdType firstCell = 0;
  for (std::size_t part = 0; part < oldCells.size(); ++part)
  {
    std::vector<vtkIdType> ids;
    for (vtkIdType cell = 0; cell < oldCells[part]->GetNumberOfCells(); ++cell)
    {
      if (this->IsKept(oldCells[part], cell))
      {
        ids.push_back(cell);
        runs.Append(firstCell + cell);
      }
    }
    firstCell += oldCells[part]->GetNumberOfCells();
    newCells[part] = this->Renumber(oldCells[part], ids);
    if (!newCells[part])
    {
      return false;
    }
  }
  output->SetVerts(newCells[0]);
  output->SetLines(newCells[1]);
  output->SetPolys(newCells[2]);
  output->SetStrips(newCells[3]);
  const ArrayPairs pairs =
    AllocateArrays(this->Input->GetCellData(), output->GetCellData(), runs.GetCount());
  return CopyTuples(this->Batches.GetPart(0.9, 1.0), pairs, runs);
}

//------------------------------------------------------------------------------
// The cells of these ids with the new ids of their points; nullptr when aborted.
vtkSmartPointer<vtkCellArray> LineSelection::Renumber(
  vtkCellArray* cells, const std::vector<vtkIdType>& ids)
{
  const auto count = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(count + 1);
  offsets->SetValue(0, 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    offsets->SetValue(i + 1, offsets->GetValue(i) + cells->GetCellSize(ids[i]));
  }
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(offsets->GetValue(count));
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
  if (!this->Batches.GetPart(0.7, 0.9).ParallelFor(count, renumber))
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
  bool success = true;
  bool isComplete = false;
  try
  {
    isComplete = this->Select(vtkDataObject::GetData(inputVector[0]), output);
  }
  catch (const std::invalid_argument& error)
  {
    vtkErrorMacro(<< error.what());
    success = false;
  }
  if (!isComplete)
  {
    output->Initialize();
  }
  return success;
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
      !selection.RemoveOthers(vtkPolyData::SafeDownCast(leaves[leaf].second)))
    {
      return false;
    }
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
