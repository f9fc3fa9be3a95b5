// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkSurfaceSegments.h"

#include "Private/vtkHeatGeodesics.h"
#include "Private/vtkSegmentDistances.h"
#include "Private/vtkSurfaceGraph.h"
#include "Private/vtkSurfaceSampling.h"
#include "Private/vtkTriangleSurface.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkTriangleFilter.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkSurfaceSegments);

namespace
{
constexpr int WeightCount = 4;
constexpr int NeighborCount = 8;
static_assert(WeightCount + 1 <= vtkSegmentDistances::Count, "the fifth distance ends the weights");
static_assert(NeighborCount + 1 <= vtkSegmentDistances::Count, "a segment is not its neighbor");

// Where the stages of the work end, in parts of its time.
constexpr double ShapeDone = 0.05;
constexpr double SamplesDone = 0.3;
constexpr double FactorsDone = 0.6;
constexpr double DistancesDone = 0.98;

//------------------------------------------------------------------------------
bool IsFinite(vtkPoints* points, vtkIdType id)
{
  const double* point = points->GetPoint(id);
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

//------------------------------------------------------------------------------
// Copy the triangles of finite corners, each with points of its own. Returns the corners' ids in
// `triangles`.
std::vector<vtkIdType> CopyTriangles(vtkPolyData* triangles, vtkPolyData* output)
{
  vtkPoints* points = triangles->GetPoints();
  vtkNew<vtkIdList> cells;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfPolys(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    triangles->GetPolys()->GetCellAtId(cell, count, ids);
    if (std::all_of(ids, ids + count, [points](vtkIdType id) { return IsFinite(points, id); }))
    {
      cells->InsertNextId(cell);
      std::for_each(ids, ids + count, [&corners](vtkIdType id) { corners->InsertNextId(id); });
    }
  }

  vtkNew<vtkPoints> copies;
  copies->SetDataType(points->GetDataType());
  copies->SetNumberOfPoints(corners->GetNumberOfIds());
  points->GetPoints(corners, copies);
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(corners->GetNumberOfIds());
  std::iota(connectivity->Begin(), connectivity->End(), 0);
  vtkNew<vtkCellArray> polys;
  polys->SetData(3, connectivity);
  output->SetPoints(copies);
  output->SetPolys(polys);
  output->GetPointData()->CopyAllocate(triangles->GetPointData(), corners->GetNumberOfIds());
  output->GetPointData()->CopyData(triangles->GetPointData(), corners);
  output->GetCellData()->CopyAllocate(triangles->GetCellData(), cells->GetNumberOfIds());
  output->GetCellData()->CopyData(triangles->GetCellData(), cells);
  return { corners->begin(), corners->end() };
}

//------------------------------------------------------------------------------
// The formula of the header, every f multiplied by the square of the first distance: at a sample
// that distance is 0.
std::array<double, WeightCount> ComputeWeights(const vtkSegmentDistances::Sample* nearest)
{
  const double reach = (1.0 + 1e-6) * nearest[WeightCount].Distance;
  std::array<double, WeightCount> weights{};
  for (int i = 0; i < WeightCount && nearest[i].Id >= 0; ++i)
  {
    const double ratio = i == 0 ? 1.0 : nearest[0].Distance / nearest[i].Distance;
    const double root = ratio * (1.0 - nearest[i].Distance / reach);
    weights[i] = root * root;
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

//------------------------------------------------------------------------------
template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

//------------------------------------------------------------------------------
void AddPointArrays(
  const vtkTriangleSurface& surface, const vtkSegmentDistances& distances, vtkPointData* pointData)
{
  const auto& triangles = surface.GetTriangles();
  const auto count = static_cast<vtkIdType>(triangles.size());
  const auto ids = NewArray<vtkTypeInt32Array>("SegmentIds", WeightCount, 3 * count);
  const auto weights = NewArray<vtkFloatArray>("SegmentWeights", WeightCount, 3 * count);
  vtkSMPTools::For(0, 3 * count,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType point = begin; point < end; ++point)
      {
        const auto* nearest = distances.Begin(triangles[point / 3][point % 3]);
        const auto values = ComputeWeights(nearest);
        for (int i = 0; i < WeightCount; ++i)
        {
          ids->SetTypedComponent(point, i, nearest[i].Id >= 0 ? nearest[i].Id : nearest[0].Id);
          weights->SetTypedComponent(point, i, static_cast<float>(values[i]));
        }
      }
    });
  pointData->AddArray(ids);
  pointData->AddArray(weights);
}

//------------------------------------------------------------------------------
void AddFieldArrays(const vtkTriangleSurface& surface, const vtkSegmentDistances& distances,
  const std::vector<vtkIdType>& samples, vtkFieldData* fieldData)
{
  const auto count = static_cast<vtkIdType>(samples.size());
  const auto number = NewArray<vtkTypeInt32Array>("NumberOfSegments", 1, 1);
  number->SetValue(0, static_cast<int>(count));

  const auto areas = NewArray<vtkDoubleArray>("SegmentArea", 1, count);
  areas->Fill(0.0);
  for (vtkIdType vertex = 0; vertex < surface.GetNumberOfVertices(); ++vertex)
  {
    const int segment = distances.Begin(vertex)->Id;
    areas->SetValue(segment,
      areas->GetValue(segment) +
        surface.GetVertexArea(vertex) * surface.GetUnit() * surface.GetUnit());
  }

  const auto neighbors = NewArray<vtkTypeInt32Array>("SegmentNeighbors", NeighborCount, count);
  for (vtkIdType segment = 0; segment < count; ++segment)
  {
    // The nearest sample of a sample is itself.
    const auto* others = distances.Begin(samples[segment]) + 1;
    for (int i = 0; i < NeighborCount; ++i)
    {
      neighbors->SetTypedComponent(segment, i, others[i].Id);
    }
  }
  fieldData->AddArray(number);
  fieldData->AddArray(areas);
  fieldData->AddArray(neighbors);
}
}

//------------------------------------------------------------------------------
int vtkSurfaceSegments::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->GetFieldData()->PassData(input->GetFieldData());
  if (input->GetNumberOfPoints() == 0 || input->GetNumberOfCells() == 0)
  {
    return 1;
  }

  vtkNew<vtkTriangleFilter> triangulation;
  triangulation->SetContainerAlgorithm(this);
  triangulation->SetInputData(input);
  triangulation->PassVertsOff();
  triangulation->PassLinesOff();
  triangulation->Update();
  if (this->CheckAbort())
  {
    return 1;
  }
  const auto corners = CopyTriangles(triangulation->GetOutput(), output);
  this->WarnOfLoss(triangulation->GetOutput(), output);
  if (!corners.empty() &&
    !this->AddSegments(triangulation->GetOutput()->GetPoints(), corners, output))
  {
    output->Initialize();
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceSegments::WarnOfLoss(vtkPolyData* triangles, vtkPolyData* output)
{
  const vtkIdType before = triangles->GetNumberOfPolys();
  const vtkIdType after = output->GetNumberOfPolys();
  if (after < before)
  {
    vtkWarningMacro("Left out " << before - after << " of " << before
                                << " triangles: a corner has a coordinate that is not finite.");
  }
  if (after == 0)
  {
    vtkWarningMacro("The input has no polygon or triangle strip with finite points: no segments.");
  }
}

//------------------------------------------------------------------------------
// The number of segments, not more than a surface can have.
double vtkSurfaceSegments::GetTarget(const vtkTriangleSurface& surface) const
{
  const double area = surface.GetArea() * surface.GetUnit() * surface.GetUnit();
  const double target = this->SegmentArea > 0.0 ? area / this->SegmentArea : this->NumberOfSegments;
  return std::min(target, static_cast<double>(surface.GetNumberOfVertices()));
}

//------------------------------------------------------------------------------
// Returns false if the work was aborted.
bool vtkSurfaceSegments::AddSegments(
  vtkPoints* points, const std::vector<vtkIdType>& corners, vtkPolyData* output)
{
  const auto report = [this](double from, double to)
  { return [=](double part) { return this->ReportProgress(from + part * (to - from)); }; };

  const vtkTriangleSurface surface(points, corners);
  const vtkSurfaceGraph graph(surface);
  const auto samples = vtkSurfaceSampling(surface, graph, report(ShapeDone, SamplesDone))
                         .Place(this->GetTarget(surface));
  if (!this->ReportProgress(SamplesDone))
  {
    return false;
  }
  const vtkHeatGeodesics geodesics(surface);
  if (!this->ReportProgress(FactorsDone))
  {
    return false;
  }
  vtkSegmentDistances distances(surface, graph, samples);
  if (geodesics.IsFactored())
  {
    distances.Refine(geodesics, report(FactorsDone, DistancesDone));
  }
  else
  {
    vtkWarningMacro("The systems of the heat method cannot be factored; distances are those along "
                    "edges and across pairs of triangles, some per cent too long.");
  }
  AddPointArrays(surface, distances, output->GetPointData());
  AddFieldArrays(surface, distances, samples, output->GetFieldData());
  return this->ReportProgress(1.0);
}

//------------------------------------------------------------------------------
// Returns whether to go on.
bool vtkSurfaceSegments::ReportProgress(double progress)
{
  if (progress >= this->GetProgress() + 0.01)
  {
    this->UpdateProgress(progress);
  }
  return !this->CheckAbort();
}

//------------------------------------------------------------------------------
void vtkSurfaceSegments::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfSegments: " << this->NumberOfSegments << "\n";
  os << indent << "SegmentArea: " << this->SegmentArea << "\n";
}

VTK_ABI_NAMESPACE_END
