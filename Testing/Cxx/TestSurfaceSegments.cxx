// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Segments of surfaces: nearly equal areas, weights that blend without jumps, the geodesically
 * nearest neighbors, what becomes of the data, bad input, and the same bits for any number of
 * threads.
 */

#include "ReferenceTesting.h"
#include "SurfaceMeshes.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSurfaceSegments.h"
#include "vtkTestErrorObserver.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <thread>
#include <tuple>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** The output with its arrays. */
struct Segments
{
  explicit Segments(vtkPolyData* data)
    : Data(data)
    , Ids(vtkTypeInt32Array::SafeDownCast(data->GetPointData()->GetArray("SegmentIds")))
    , Weights(vtkFloatArray::SafeDownCast(data->GetPointData()->GetArray("SegmentWeights")))
    , Areas(vtkDoubleArray::SafeDownCast(data->GetFieldData()->GetArray("SegmentArea")))
    , Neighbors(vtkTypeInt32Array::SafeDownCast(data->GetFieldData()->GetArray("SegmentNeighbors")))
    , Number(vtkTypeInt32Array::SafeDownCast(data->GetFieldData()->GetArray("NumberOfSegments")))
  {
  }

  bool IsComplete() const
  {
    return this->Ids && this->Weights && this->Areas && this->Neighbors && this->Number;
  }

  vtkVector3d GetPoint(vtkIdType id) const
  {
    vtkVector3d point;
    this->Data->GetPoint(id, point.GetData());
    return point;
  }

  /** Weight of each segment at a point. */
  std::vector<double> GetWeights(vtkIdType point) const
  {
    std::vector<double> weights(this->Number->GetValue(0), 0.0);
    for (int i = 0; i < 4; ++i)
    {
      weights[this->Ids->GetTypedComponent(point, i)] += this->Weights->GetTypedComponent(point, i);
    }
    return weights;
  }

  /** The vertex of each segment at which it alone has weight. */
  std::vector<vtkVector3d> GetSamples() const
  {
    std::vector<vtkVector3d> samples(this->Number->GetValue(0), vtkVector3d(Infinity));
    for (vtkIdType point = 0; point < this->Data->GetNumberOfPoints(); ++point)
    {
      if (this->Weights->GetTypedComponent(point, 0) == 1.0F)
      {
        samples[this->Ids->GetTypedComponent(point, 0)] = this->GetPoint(point);
      }
    }
    return samples;
  }

  /** Coefficient of variation of the areas. */
  double GetSpread() const
  {
    const auto count = static_cast<double>(this->Areas->GetNumberOfTuples());
    const double mean = std::accumulate(this->Areas->Begin(), this->Areas->End(), 0.0) / count;
    const double squares = std::accumulate(this->Areas->Begin(), this->Areas->End(), 0.0,
      [mean](double sum, double area) { return sum + (area - mean) * (area - mean); });
    return std::sqrt(squares / count) / mean;
  }

  vtkSmartPointer<vtkPolyData> Data;
  vtkTypeInt32Array* Ids;
  vtkFloatArray* Weights;
  vtkDoubleArray* Areas;
  vtkTypeInt32Array* Neighbors;
  vtkTypeInt32Array* Number;
};

/** Runs the filter and keeps what it says. */
class Filter
{
public:
  Filter() { this->Segmentation->AddObserver(vtkCommand::WarningEvent, this->Observer); }

  vtkSurfaceSegments* operator->() { return this->Segmentation; }

  Segments Run(vtkPolyData* input)
  {
    this->Segmentation->SetInputData(input);
    this->Segmentation->Update();
    vtkNew<vtkPolyData> output;
    output->ShallowCopy(this->Segmentation->GetOutput());
    return Segments(output);
  }

  Segments Run(const Mesh& mesh, int numberOfSegments)
  {
    this->Segmentation->SetNumberOfSegments(numberOfSegments);
    return this->Run(MakePolyData(mesh));
  }

  bool HasWarned(const std::string& message) const
  {
    return this->Observer->GetWarningMessage().find(message) != std::string::npos;
  }

  bool IsSilent() const { return this->Observer->GetWarningMessage().empty(); }

private:
  vtkNew<vtkSurfaceSegments> Segmentation;
  vtkNew<vtkTest::ErrorObserver> Observer;
};

/** What is true of every output. */
void ExpectConsistent(Checks& checks, const std::string& what, const Segments& segments)
{
  checks.True(what + ": arrays", segments.IsComplete());
  if (!segments.IsComplete())
  {
    return;
  }
  const vtkIdType pointCount = segments.Data->GetNumberOfPoints();
  const int count = segments.Number->GetValue(0);
  checks.Near(what + ": points", pointCount, 3 * segments.Data->GetNumberOfPolys(), 0);
  checks.Near(what + ": sizes",
    segments.Ids->GetNumberOfTuples() + segments.Weights->GetNumberOfTuples(), 2 * pointCount, 0);
  checks.Near(what + ": sizes by segment",
    segments.Areas->GetNumberOfTuples() + segments.Neighbors->GetNumberOfTuples(), 2 * count, 0);

  double area = 0.0;
  std::map<std::tuple<double, double, double>, vtkIdType> copies;
  std::set<int> used;
  bool isSoup = true;
  bool isPartition = true;
  bool isSame = true;
  for (vtkIdType point = 0; point < pointCount; ++point)
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    segments.Data->GetPolys()->GetCellAtId(point / 3, corners, ids);
    isSoup = isSoup && corners == 3 && ids[point % 3] == point;

    const vtkVector3d p = segments.GetPoint(point);
    if (point % 3 == 0)
    {
      area +=
        0.5 * (segments.GetPoint(point + 1) - p).Cross(segments.GetPoint(point + 2) - p).Norm();
    }
    double sum = 0.0;
    const vtkIdType copy = copies.emplace(std::make_tuple(p[0], p[1], p[2]), point).first->second;
    for (int i = 0; i < 4; ++i)
    {
      const int id = segments.Ids->GetTypedComponent(point, i);
      const float weight = segments.Weights->GetTypedComponent(point, i);
      sum += weight;
      isPartition = isPartition && id >= 0 && id < count && weight >= 0.0F;
      isSame = isSame && id == segments.Ids->GetTypedComponent(copy, i) &&
        weight == segments.Weights->GetTypedComponent(copy, i);
    }
    isPartition = isPartition && std::abs(sum - 1.0) <= 1e-6;
    used.insert(segments.Ids->GetTypedComponent(point, 0));
  }
  checks.True(what + ": no two triangles share a point", isSoup);
  checks.True(what + ": weights are a partition of unity", isPartition);
  checks.True(what + ": copies of a vertex have the same values", isSame);
  checks.Near(what + ": segments with points", used.size(), count, 0);
  checks.Near(what + ": area of all segments",
    std::accumulate(segments.Areas->Begin(), segments.Areas->End(), 0.0), area, 1e-5 * area);
}

void TestSphere(Checks& checks)
{
  Filter filter;
  const Segments segments = filter.Run(MakeSphere(6), 200);
  ExpectConsistent(checks, "sphere", segments);
  checks.Near("sphere, segments", segments.Number->GetValue(0), 200, 0);
  checks.Near("sphere, spread of the areas", segments.GetSpread(), 0.0, 0.06);
  checks.True("sphere, nothing to warn of", filter.IsSilent());

  // The neighbors are the nearest of all, up to the error of the distances.
  const auto samples = segments.GetSamples();
  int wrong = 0;
  for (int segment = 0; segment < 200; ++segment)
  {
    std::vector<double> angles;
    for (const auto& sample : samples)
    {
      angles.push_back(MeasureAngle(samples[segment], sample));
    }
    auto sorted = angles;
    std::sort(sorted.begin(), sorted.end());
    std::set<int> distinct{ segment };
    for (int i = 0; i < 8; ++i)
    {
      const int neighbor = segments.Neighbors->GetTypedComponent(segment, i);
      distinct.insert(neighbor);
      wrong += std::abs(angles[neighbor] - sorted[i + 1]) > 0.04 * sorted[i + 1];
    }
    wrong += distinct.size() != 9;
  }
  checks.Near("sphere, wrong neighbors", wrong, 0, 0);

  // Every point belongs to the nearest sample, and no weight jumps: along an edge, the weights
  // change by at most a few times its part of the distance between samples.
  const double spacing = std::sqrt(4.0 * vtkMath::Pi() / 200.0);
  double steepest = 0.0;
  wrong = 0;
  for (vtkIdType point = 0; point < segments.Data->GetNumberOfPoints(); ++point)
  {
    const vtkVector3d here = segments.GetPoint(point);
    const int own = segments.Ids->GetTypedComponent(point, 0);
    double nearest = Infinity;
    for (const auto& sample : samples)
    {
      nearest = std::min(nearest, MeasureAngle(here, sample));
    }
    wrong += MeasureAngle(here, samples[own]) > nearest + 0.04 * spacing;

    const vtkIdType next = point % 3 == 2 ? point - 2 : point + 1;
    const auto a = segments.GetWeights(point);
    const auto b = segments.GetWeights(next);
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      const double edge = (segments.GetPoint(next) - here).Norm() / spacing;
      steepest = std::max(steepest, std::abs(a[i] - b[i]) / edge);
    }
  }
  checks.Near("sphere, points that are nearer to another sample", wrong, 0, 0);
  checks.Near("sphere, steepest weight", steepest, 0.0, 5.0);
}

void TestBorders(Checks& checks)
{
  const Segments square = Filter().Run(MakePlane(101, 101), 100);
  ExpectConsistent(checks, "square", square);
  checks.Near("square, spread of the areas", square.GetSpread(), 0.0, 0.13);
  const Segments cylinder = Filter().Run(MakeCylinder(128, 64), 100);
  ExpectConsistent(checks, "cylinder", cylinder);
  checks.Near("cylinder, spread of the areas", cylinder.GetSpread(), 0.0, 0.13);
}

void TestComponents(Checks& checks)
{
  // Areas 1 : 4, a far triangle of hardly any area, and a point of no triangle.
  const Mesh triangle{ { { 0, 9, 0 }, { 1e-3, 9, 0 }, { 0, 9.001, 0 }, { 5, 5, 5 } }, { 0, 1, 2 } };
  const Mesh mesh = Join(
    Join(Transform(MakeSphere(4), 1.0, { -9, 0, 0 }), Transform(MakeSphere(4), 2.0, { 9, 0, 0 })),
    triangle);
  Filter filter;
  const Segments segments = filter.Run(mesh, 20);
  ExpectConsistent(checks, "components", segments);
  checks.Near("components, segments", segments.Number->GetValue(0), 20, 0);
  bool isSeparate = true;
  for (vtkIdType point = 0; point < segments.Data->GetNumberOfPoints(); ++point)
  {
    const double x = segments.GetPoint(point)[0];
    for (int i = 0; i < 4; ++i)
    {
      const int id = segments.Ids->GetTypedComponent(point, i);
      isSeparate = isSeparate && (x < -5 ? id < 4 : x > 5 ? id >= 4 && id < 19 : id == 19);
    }
  }
  checks.True("components, each has its own segments", isSeparate);
  const auto countNeighbors = [&](int segment)
  {
    int count = 0;
    for (int i = 0; i < 8; ++i)
    {
      count += segments.Neighbors->GetTypedComponent(segment, i) >= 0;
    }
    return count;
  };
  checks.Near("components, neighbors among 4", countNeighbors(0), 3, 0);
  checks.Near("components, neighbors among 15", countNeighbors(4), 8, 0);
  checks.Near("components, neighbors of a lonely one", countNeighbors(19), 0, 0);

  filter->SetSegmentArea(vtkMath::Pi());
  checks.Near("area of a segment", filter.Run(mesh, 400).Number->GetValue(0), 4 + 16 + 1, 1);
}

void TestData(Checks& checks)
{
  // A vertex, a line, a square and a strip of two triangles; every cell and point knows its id.
  vtkNew<vtkPolyData> input;
  Mesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 2, 0 }, { 1, 2, 0 } };
  input->SetPoints(MakePoints(mesh));
  const auto cell = [](std::initializer_list<vtkIdType> ids)
  {
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->InsertNextCell(ids);
    return cells;
  };
  input->SetVerts(cell({ 0 }));
  input->SetLines(cell({ 0, 1 }));
  input->SetPolys(cell({ 0, 1, 2, 3 }));
  input->SetStrips(cell({ 3, 2, 4, 5 }));
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName("cell");
  vtkNew<vtkIdTypeArray> pointIds;
  pointIds->SetName("point");
  vtkNew<vtkFloatArray> normals;
  normals->SetName("normals");
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    cellIds->InsertNextValue(i);
    pointIds->InsertNextValue(i);
    normals->InsertNextTuple3(0, 0, 1);
  }
  cellIds->SetNumberOfTuples(4);
  input->GetCellData()->AddArray(cellIds);
  input->GetPointData()->AddArray(pointIds);

  Filter filter;
  const Segments bare = filter.Run(input);
  ExpectConsistent(checks, "square and strip", bare);
  checks.Near("square and strip, triangles", bare.Data->GetNumberOfPolys(), 4, 0);
  checks.Near("square and strip, one segment at most for a vertex", bare.Number->GetValue(0), 6, 0);
  checks.True("no normals are made", !bare.Data->GetPointData()->GetNormals());
  input->GetPointData()->SetNormals(normals);
  const Segments lit = filter.Run(input);
  checks.True("normals stay", lit.Data->GetPointData()->GetNormals());
  for (vtkIdType point = 0; point < 12; ++point)
  {
    const auto id =
      static_cast<vtkIdType>(lit.Data->GetPointData()->GetArray("point")->GetComponent(point, 0));
    checks.True("points keep their data", lit.GetPoint(point) == mesh.Points[id]);
    checks.Near("triangles keep the data of their cell",
      lit.Data->GetCellData()->GetArray("cell")->GetComponent(point / 3, 0), point < 6 ? 2 : 3, 0);
  }
}

void TestBadInput(Checks& checks)
{
  const auto expect = [&checks](const std::string& what, const Mesh& mesh, double triangles)
  {
    Filter filter;
    const Segments segments = filter.Run(mesh, 40);
    ExpectConsistent(checks, what, segments);
    checks.Near(what + ": triangles", segments.Data->GetNumberOfPolys(), triangles, 0);
    return segments;
  };

  checks.Near("one triangle, segments",
    expect("one triangle", { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { 0, 1, 2 } }, 1)
      .Number->GetValue(0),
    3, 0);
  expect(
    "no area", { { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, { 0, 1, 2, 0, 0, 1, 2, 2, 2 } }, 3);
  expect("one place", { { { 3, 3, 3 }, { 3, 3, 3 } }, { 0, 1, 0 } }, 1);

  // Three half-planes that share an edge, a triangle twice, needles, triangles turned round.
  Mesh book = MakePlane(11, 11);
  for (const double angle : { 2.0, 4.0 })
  {
    Mesh page = MakePlane(11, 11);
    for (auto& point : page.Points)
    {
      point = { point[0] * std::cos(angle), point[1], point[0] * std::sin(angle) };
    }
    book = Join(book, page);
  }
  expect("book", book, 600);
  const std::vector<vtkIdType> again(book.Corners.begin(), book.Corners.begin() + 3);
  book.Corners.insert(book.Corners.end(), again.begin(), again.end());
  expect("book, a triangle twice", book, 601);
  Mesh needles = MakePlane(400, 4);
  for (std::size_t i = 0; i < needles.Corners.size(); i += 9)
  {
    std::swap(needles.Corners[i], needles.Corners[i + 1]);
  }
  expect("needles", needles, 2394);
  checks.Near(
    "as many segments as vertices", Filter().Run(MakeSphere(3), 1000).Number->GetValue(0), 258, 0);
  checks.Near("hardly fewer segments than vertices",
    Filter().Run(MakeSphere(3), 200).Number->GetValue(0), 200, 0);

  // Far from the origin or small, the segments are the same.
  const Segments unit = expect("noisy plane", MakePlane(31, 31, 0.0, 0.4), 1800);
  const Segments small =
    expect("small", Transform(MakePlane(31, 31, 0.0, 0.4), 1e-6, { 0, 0, 0 }), 1800);
  const Segments large =
    expect("large", Transform(MakePlane(31, 31, 0.0, 0.4), 6.4e6, { 6.4e6, 0, 6.4e6 }), 1800);
  checks.Near("small, area", small.Areas->GetValue(0), 1e-12 * unit.Areas->GetValue(0), 1e-17);
  checks.Near("large, spread", large.GetSpread(), unit.GetSpread(), 0.02);

  // Without shared points the result is the same: places count, not points.
  Filter filter;
  filter->SetNumberOfSegments(40);
  const Segments repeated = filter.Run(unit.Data);
  checks.True("soup of a soup",
    std::equal(repeated.Ids->Begin(), repeated.Ids->End(), unit.Ids->Begin()) &&
      std::equal(repeated.Weights->Begin(), repeated.Weights->End(), unit.Weights->Begin()));
}

void TestMessages(Checks& checks)
{
  Filter empty;
  vtkNew<vtkPolyData> nothing;
  checks.Near("nothing, points", empty.Run(nothing).Data->GetNumberOfPoints(), 0, 0);
  checks.True("nothing to warn of", empty.IsSilent());

  Filter lines;
  vtkNew<vtkPolyData> line;
  line->SetPoints(MakePoints({ { { 0, 0, 0 }, { 1, 0, 0 } }, {} }));
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1 });
  line->SetLines(cells);
  checks.Near("a line, points", lines.Run(line).Data->GetNumberOfPoints(), 0, 0);
  checks.True("a line, warning", lines.HasWarned("no polygon or triangle strip"));

  Filter holes;
  Mesh mesh = MakePlane(11, 11);
  mesh.Points[0][1] = std::numeric_limits<double>::quiet_NaN();
  mesh.Points[60][2] = Infinity;
  const Segments segments = holes.Run(mesh, 10);
  ExpectConsistent(checks, "not finite", segments);
  checks.Near("not finite, triangles", segments.Data->GetNumberOfPolys(), 200 - 2 - 6, 0);
  checks.True("not finite, warning", holes.HasWarned("Left out 8 of 200 triangles"));

  // Aborted at the start, among the samples, and among the distances.
  for (double progress : { 0.0, 0.1, 0.7 })
  {
    Filter aborted;
    vtkNew<vtkCallbackCommand> abort;
    abort->SetClientData(&progress);
    abort->SetCallback(
      [](vtkObject* caller, unsigned long, void* limit, void*)
      {
        auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
        if (algorithm->GetProgress() >= *static_cast<double*>(limit))
        {
          algorithm->SetAbortExecuteAndUpdateTime();
        }
      });
    aborted->AddObserver(vtkCommand::ProgressEvent, abort);
    checks.True("aborted, no segments", !aborted.Run(mesh, 10).IsComplete());
  }
}

void TestThreads(Checks& checks)
{
  const Mesh mesh = MakePlane(61, 61, 0.3, 0.4);
  const Mesh triangle = { { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { 0, 1, 2 } };
  std::set<std::thread::id> reporting;
  vtkNew<vtkCallbackCommand> report;
  report->SetClientData(&reporting);
  report->SetCallback([](vtkObject*, unsigned long, void* ids, void*)
    { static_cast<std::set<std::thread::id>*>(ids)->insert(std::this_thread::get_id()); });
  std::vector<Segments> results;
  for (const int threads : { 1, 2, 3 })
  {
    const auto run = [&]
    {
      Filter filter;
      filter->AddObserver(vtkCommand::ProgressEvent, report);
      results.push_back(filter.Run(mesh, 60));
      checks.True("threads, less work than there are", Filter().Run(triangle, 3).IsComplete());
    };
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads, "STDThread", false), run);
  }
  checks.True("threads, progress from the one that called",
    reporting == std::set<std::thread::id>{ std::this_thread::get_id() });
  for (const Segments& result : results)
  {
    checks.True("threads, same bits",
      std::equal(result.Ids->Begin(), result.Ids->End(), results[0].Ids->Begin()) &&
        std::equal(result.Weights->Begin(), result.Weights->End(), results[0].Weights->Begin()) &&
        std::equal(result.Areas->Begin(), result.Areas->End(), results[0].Areas->Begin()) &&
        std::equal(
          result.Neighbors->Begin(), result.Neighbors->End(), results[0].Neighbors->Begin()));
  }
}
}

int TestSurfaceSegments(int, char*[])
{
  Checks checks;
  TestSphere(checks);
  TestBorders(checks);
  TestComponents(checks);
  TestData(checks);
  TestBadInput(checks);
  TestMessages(checks);
  TestThreads(checks);
  return checks.Result();
}
