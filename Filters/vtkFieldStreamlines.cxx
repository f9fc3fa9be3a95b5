// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkFieldStreamlines.h"

#include "Private/vtkFieldSeeds.h"
#include "Private/vtkFieldVectors.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamTracer.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkFieldStreamlines);

namespace
{
// Seeds traced at once: a hundredth of all, so that progress is smooth, but enough for every
// thread.
constexpr vtkIdType MinimumBatch = 16;

// Radius, as a part of the bounding box's diagonal, of what the eye takes for one place.
constexpr double CurlFraction = 1.0 / 500.0;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> SelectSeeds(vtkPoints* seeds, vtkIdType begin, vtkIdType end)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertPoints(0, end - begin, begin, seeds);
  auto batch = vtkSmartPointer<vtkPolyData>::New();
  batch->SetPoints(points);
  return batch;
}

//------------------------------------------------------------------------------
// Cut a line that ends by going round and round in a ball of that radius where it enters the ball;
// nothing is left of a line that never leaves it.
void CutCurledEnd(std::vector<vtkIdType>& line, vtkPoints* points, double radius)
{
  if (line.empty())
  {
    return;
  }
  double end[3];
  double previous[3];
  points->GetPoint(line.back(), end);
  std::copy(end, end + 3, previous);
  double lengthInside = 0.0;
  std::size_t entry = line.size();
  for (; entry > 0; --entry)
  {
    double point[3];
    points->GetPoint(line[entry - 1], point);
    if (vtkMath::Distance2BetweenPoints(point, end) > radius * radius)
    {
      break;
    }
    lengthInside += std::sqrt(vtkMath::Distance2BetweenPoints(point, previous));
    std::copy(point, point + 3, previous);
  }
  if (lengthInside > 4.0 * radius)
  {
    line.resize(entry > 0 ? entry + 1 : 0);
  }
}

//------------------------------------------------------------------------------
// The traces of a batch in one direction, looked up by seed.
class Traces
{
public:
  Traces(vtkPolyData* lines, vtkIdType seedCount, double curlRadius)
    : Data(lines)
    , LineOfSeed(seedCount, -1)
    , CurlRadius(curlRadius)
  {
    // In VTK 9.2 the tracer's threads compete for the arrays' number of tuples, though not for the
    // values, which are all there.
    vtkPointData* pointData = lines->GetPointData();
    for (int i = 0; i < pointData->GetNumberOfArrays(); ++i)
    {
      pointData->GetAbstractArray(i)->SetNumberOfTuples(lines->GetNumberOfPoints());
    }
    vtkDataArray* seeds = lines->GetCellData()->GetArray("SeedIds");
    for (vtkIdType line = 0; line < lines->GetNumberOfLines(); ++line)
    {
      this->LineOfSeed[static_cast<vtkIdType>(seeds->GetComponent(line, 0))] = line;
    }
  }

  vtkPointData* GetPointData() const { return this->Data->GetPointData(); }
  vtkPoints* GetPoints() const { return this->Data->GetPoints(); }

  // Point ids from the seed on; none if the seed has no trace of two points.
  std::vector<vtkIdType> GetPointIds(vtkIdType seed) const
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    if (this->LineOfSeed[seed] >= 0)
    {
      this->Data->GetLines()->GetCellAtId(this->LineOfSeed[seed], count, points);
    }
    std::vector<vtkIdType> line(points, points + count);
    CutCurledEnd(line, this->Data->GetPoints(), this->CurlRadius);
    return line;
  }

  int GetReason(vtkIdType seed) const
  {
    const vtkIdType line = this->LineOfSeed[seed];
    return line < 0
      ? static_cast<int>(vtkStreamTracer::NOT_INITIALIZED)
      : static_cast<int>(
          this->Data->GetCellData()->GetArray("ReasonForTermination")->GetComponent(line, 0));
  }

private:
  vtkSmartPointer<vtkPolyData> Data;
  std::vector<vtkIdType> LineOfSeed;
  double CurlRadius;
};

//------------------------------------------------------------------------------
// Collects one line for each seed, batch after batch.
class LineCollector
{
public:
  explicit LineCollector(vtkPolyData* output)
    : Output(output)
  {
    this->SeedIds->SetName("SeedIds");
    this->Reasons->SetName("ReasonForTermination");
    this->Reasons->SetNumberOfComponents(2);
    this->Reasons->SetComponentName(0, "Begin");
    this->Reasons->SetComponentName(1, "End");
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetCellData()->AddArray(this->SeedIds);
    output->GetCellData()->AddArray(this->Reasons);
  }

  // Join the traces of `seed`, counted from the batch's first one, which is seed `firstSeed`.
  void Add(const Traces& upstream, const Traces& downstream, vtkIdType firstSeed, vtkIdType seed)
  {
    auto pointsBefore = upstream.GetPointIds(seed);
    const auto pointsAfter = downstream.GetPointIds(seed);
    if (pointsBefore.empty() && pointsAfter.empty())
    {
      return;
    }
    std::reverse(pointsBefore.begin(), pointsBefore.end());
    if (!pointsBefore.empty() && !pointsAfter.empty())
    {
      pointsBefore.pop_back(); // the seed, which begins the other part
    }
    this->Lines->InsertNextCell(static_cast<int>(pointsBefore.size() + pointsAfter.size()));
    this->AddPoints(upstream, pointsBefore);
    this->AddPoints(downstream, pointsAfter);
    this->SeedIds->InsertNextValue(static_cast<int>(firstSeed + seed));
    this->Reasons->InsertNextTuple2(upstream.GetReason(seed), downstream.GetReason(seed));
  }

private:
  void AddPoints(const Traces& traces, const std::vector<vtkIdType>& points)
  {
    if (this->Points->GetNumberOfPoints() == 0 && !points.empty())
    {
      this->Output->GetPointData()->CopyAllocate(traces.GetPointData());
    }
    for (const vtkIdType point : points)
    {
      const vtkIdType id = this->Points->InsertNextPoint(traces.GetPoints()->GetPoint(point));
      this->Output->GetPointData()->CopyData(traces.GetPointData(), point, id);
      this->Lines->InsertCellPoint(id);
    }
  }

  vtkPolyData* Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkIntArray> SeedIds;
  vtkNew<vtkIntArray> Reasons;
};
}

//------------------------------------------------------------------------------
vtkFieldStreamlines::vtkFieldStreamlines()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, vtkDataSetAttributes::VECTORS);
}

//------------------------------------------------------------------------------
int vtkFieldStreamlines::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
int vtkFieldStreamlines::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);

  vtkFieldVectors field(input, this->GetInputArrayInformation(0));
  this->VectorsName = field.GetName();
  if (field.GetName().empty())
  {
    const char* wanted = this->GetInputArrayInformation(0)->Get(vtkDataObject::FIELD_NAME());
    vtkErrorMacro("There is no array of three components"
      << (wanted && *wanted ? std::string(" named '") + wanted + "'" : "")
      << " to trace streamlines of. The input has the arrays (association, components): "
      << vtkFieldVectors::ListArrays(input) << ".");
    return 0;
  }
  if (field.GetLeaves().empty())
  {
    vtkWarningMacro("No cell has finite vectors '" << field.GetName() << "': no streamline.");
    return 1;
  }

  const auto seeds = this->PlaceSeeds(field);
  if (seeds->GetNumberOfPoints() == 0)
  {
    vtkWarningMacro("No seed lies inside the field; choose another way of seeding.");
    return 1;
  }
  this->Trace(field, seeds, output);
  if (output->GetNumberOfLines() == 0 && !this->GetAbortOutput())
  {
    vtkWarningMacro("The field '" << field.GetName() << "' is zero at all "
                                  << seeds->GetNumberOfPoints() << " seeds: no streamline.");
  }
  return 1;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> vtkFieldStreamlines::PlaceSeeds(const vtkFieldVectors& field)
{
  vtkFieldSeeds seeds(field);
  const vtkBoundingBox box(field.GetBounds());
  if (this->SeedingMode == GRID)
  {
    return seeds.PlaceOnGrid(this->NumberOfSeeds);
  }
  if (this->SeedingMode == LINE)
  {
    const bool diagonal = std::equal(this->Point1, this->Point1 + 3, this->Point2);
    return seeds.PlaceOnLine(this->NumberOfSeeds, diagonal ? box.GetMinPoint() : this->Point1,
      diagonal ? box.GetMaxPoint() : this->Point2);
  }
  int boxDimension = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    boxDimension += box.GetLength(axis) > 0.0 ? 1 : 0;
  }
  return this->SeedingMode == VOLUME && field.GetDimension() >= boxDimension
    ? seeds.PlaceInVolume(this->NumberOfSeeds, this->SeedOffset)
    : seeds.PlaceAtPoints(this->NumberOfSeeds, this->SeedOffset);
}

//------------------------------------------------------------------------------
void vtkFieldStreamlines::Trace(vtkFieldVectors& field, vtkPoints* seeds, vtkPolyData* output)
{
  const double diagonal = vtkBoundingBox(field.GetBounds()).GetDiagonalLength();
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetContainerAlgorithm(this);
  tracer->SetInputData(field.GetDomain());
  tracer->SetInputArrayToProcess(0, 0, 0, field.GetAssociation(), field.GetName().c_str());
  tracer->SetIntegratorTypeToRungeKutta45();
  tracer->SetInterpolatorTypeToCellLocator();
  tracer->SetSurfaceStreamlines(field.GetDimension() == 2);
  tracer->SetComputeVorticity(false);
  tracer->SetMaximumPropagation(this->MaximumLength > 0.0 ? this->MaximumLength : 0.5 * diagonal);
  tracer->SetMaximumNumberOfSteps(this->MaximumNumberOfSteps);
  tracer->SetTerminalSpeed(this->TerminalSpeedFraction * field.GetMaximumMagnitude());

  const auto trace = [&](vtkPolyData* batch, int direction)
  {
    vtkNew<vtkPolyData> lines;
    if (direction == this->IntegrationDirection ||
      this->IntegrationDirection == vtkStreamTracer::BOTH)
    {
      tracer->SetSourceData(batch);
      tracer->SetIntegrationDirection(direction);
      tracer->Update();
      lines->ShallowCopy(tracer->GetOutput());
    }
    return Traces(lines, batch->GetNumberOfPoints(), CurlFraction * diagonal);
  };

  LineCollector lines(output);
  const vtkIdType seedCount = seeds->GetNumberOfPoints();
  const vtkIdType batchSize = std::max(MinimumBatch, seedCount / 100);
  for (vtkIdType first = 0; first < seedCount && !this->CheckAbort(); first += batchSize)
  {
    const auto batch = SelectSeeds(seeds, first, std::min(first + batchSize, seedCount));
    const Traces upstream = trace(batch, vtkStreamTracer::BACKWARD);
    const Traces downstream = trace(batch, vtkStreamTracer::FORWARD);
    for (vtkIdType seed = 0; seed < batch->GetNumberOfPoints(); ++seed)
    {
      lines.Add(upstream, downstream, first, seed);
    }
    this->UpdateProgress(
      static_cast<double>(std::min(first + batchSize, seedCount)) / static_cast<double>(seedCount));
  }
}

//------------------------------------------------------------------------------
void vtkFieldStreamlines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSeeds: " << this->NumberOfSeeds << "\n";
  os << indent << "SeedingMode: " << this->SeedingMode << "\n";
  os << indent << "SeedOffset: " << this->SeedOffset << "\n";
  os << indent << "Point1: " << this->Point1[0] << " " << this->Point1[1] << " " << this->Point1[2]
     << "\n";
  os << indent << "Point2: " << this->Point2[0] << " " << this->Point2[1] << " " << this->Point2[2]
     << "\n";
  os << indent << "IntegrationDirection: " << this->IntegrationDirection << "\n";
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "MaximumNumberOfSteps: " << this->MaximumNumberOfSteps << "\n";
  os << indent << "TerminalSpeedFraction: " << this->TerminalSpeedFraction << "\n";
  os << indent << "VectorsName: " << this->VectorsName << "\n";
}

VTK_ABI_NAMESPACE_END
