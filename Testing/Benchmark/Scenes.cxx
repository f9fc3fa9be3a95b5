// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Scenes.h"

#include "MessageLog.h"
#include "RenderError.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkContourFilter.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3D.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataReader.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkRenderer.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTrajectorySegments.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVector.h"
#include "vtkVectorOperators.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace pellucid
{
namespace benchmark
{
namespace
{
constexpr double LineLength = 4.95;
constexpr int SegmentsPerLine = 99;
constexpr double LineRadius = 0.03;
constexpr double PointRadius = 0.06;
constexpr int TubeSides = 8;
constexpr double TrianglesOfSegment = 2.0 * TubeSides;
constexpr double TrianglesOfBall = 96.0; // of 8 x 8

// Peaks of resident memory for 100,000 to 500,000 segments, rounded up.
constexpr double BytesOfCone = 700.0;
constexpr double BytesOfReferenceCone = 1000.0;
constexpr double BytesOfTriangle = 75.0;
constexpr double BytesOfReferenceTriangle = 300.0;

constexpr double HalfSideOfLayers = 0.1; // for a stack of depth 1
constexpr double LowestContour = 80.0;
constexpr double HighestContour = 240.0;
constexpr double LastHue = 2.0 / 3.0; // blue, beginning with red
constexpr double Zoom = 1.6;
constexpr double TwoPi = 2.0 * vtkMath::Pi();

//------------------------------------------------------------------------------
// The same numbers with every standard library, which std::uniform_real_distribution does not give.
class RandomNumbers
{
public:
  /** In [0,1). */
  double Next() { return static_cast<double>(this->Engine() >> 11) * 0x1p-53; }

  vtkVector3d NextPoint()
  {
    const double x = this->Next();
    const double y = this->Next();
    return TwoPi * vtkVector3d(x, y, this->Next());
  }

private:
  std::mt19937_64 Engine;
};

//------------------------------------------------------------------------------
void InsertColor(vtkUnsignedCharArray* colors, double hue)
{
  double color[3];
  vtkMath::HSVToRGB(hue, 0.7, 0.9, &color[0], &color[1], &color[2]);
  for (const double component : color)
  {
    colors->InsertNextValue(static_cast<unsigned char>(std::lround(255.0 * component)));
  }
}

//------------------------------------------------------------------------------
// Colours, one for each object of several consecutive points.
vtkSmartPointer<vtkUnsignedCharArray> MakeColors(
  vtkIdType objects, const std::function<vtkIdType(vtkIdType)>& countPoints)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  RandomNumbers random;
  for (vtkIdType object = 0; object < objects; ++object)
  {
    const double hue = random.Next();
    for (vtkIdType point = 0; point < countPoints(object); ++point)
    {
      InsertColor(colors, hue);
    }
  }
  return colors;
}

//------------------------------------------------------------------------------
// Unit velocity of the flow with its usual constants.
vtkVector3d GetABCVelocity(const vtkVector3d& point)
{
  const double a = std::sqrt(3.0);
  const double b = std::sqrt(2.0);
  const double c = 1.0;
  return vtkVector3d(a * std::sin(point[2]) + c * std::cos(point[1]),
    b * std::sin(point[0]) + a * std::cos(point[2]),
    c * std::sin(point[1]) + b * std::cos(point[0]))
    .Normalized();
}

//------------------------------------------------------------------------------
// The classic Runge-Kutta scheme.
vtkVector3d FollowABCFlow(const vtkVector3d& point, double step)
{
  const vtkVector3d k1 = GetABCVelocity(point);
  const vtkVector3d k2 = GetABCVelocity(point + 0.5 * step * k1);
  const vtkVector3d k3 = GetABCVelocity(point + 0.5 * step * k2);
  const vtkVector3d k4 = GetABCVelocity(point + step * k3);
  return point + step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
}

//------------------------------------------------------------------------------
// Cells of so many consecutive points each.
vtkSmartPointer<vtkCellArray> MakeCells(vtkIdType cells, vtkIdType pointsPerCell)
{
  vtkNew<vtkIdTypeArray> points;
  points->SetNumberOfValues(cells * pointsPerCell);
  std::iota(points->GetPointer(0), points->GetPointer(0) + cells * pointsPerCell, 0);
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(pointsPerCell, points);
  return result;
}

//------------------------------------------------------------------------------
Scene MakePointCloud(const std::string& name, int size)
{
  RandomNumbers random;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < size; ++i)
  {
    points->InsertNextPoint(random.NextPoint().GetData());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(MakeCells(size, 1));
  data->GetPointData()->SetScalars(MakeColors(size, [](vtkIdType) { return 1; }));
  return Scene(name, data, PointRadius);
}

//------------------------------------------------------------------------------
Scene MakeSurfaces(const std::string& name, int size)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-20, 20, -20, 20, -20, 20);
  vtkNew<vtkContourFilter> contours;
  contours->SetInputConnection(wavelet->GetOutputPort());
  contours->GenerateValues(size, LowestContour, HighestContour);
  contours->Update();
  vtkPolyData* data = contours->GetOutput();
  vtkDataArray* values = data->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Color");
  colors->SetNumberOfComponents(3);
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    const double height =
      (values->GetTuple1(point) - LowestContour) / (HighestContour - LowestContour);
    InsertColor(colors, LastHue * height);
  }
  data->GetPointData()->SetScalars(colors);
  return Scene(name, data, 0.0);
}

//------------------------------------------------------------------------------
// Squares of different colours, as far apart as they are many, drawn in no order of theirs.
Scene MakeLayers(const std::string& name, int size)
{
  std::vector<int> order(size);
  std::iota(order.begin(), order.end(), 0);
  RandomNumbers random;
  for (int i = size - 1; i > 0; --i)
  {
    std::swap(order[i], order[static_cast<int>((i + 1) * random.Next())]);
  }
  vtkNew<vtkPoints> points;
  for (const int layer : order)
  {
    const double z = (layer + 0.5) / size - 0.5;
    points->InsertNextPoint(-HalfSideOfLayers, -HalfSideOfLayers, z);
    points->InsertNextPoint(HalfSideOfLayers, -HalfSideOfLayers, z);
    points->InsertNextPoint(HalfSideOfLayers, HalfSideOfLayers, z);
    points->InsertNextPoint(-HalfSideOfLayers, HalfSideOfLayers, z);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(MakeCells(size, 4));
  data->GetPointData()->SetScalars(MakeColors(size, [](vtkIdType) { return 4; }));
  return Scene(name, data, 0.0);
}

//------------------------------------------------------------------------------
Scene ReadLines(const std::string& name, const std::string& fileName)
{
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkSmartPointer<vtkPolyData> data = reader->GetOutput();
  if (data->GetNumberOfLines() == 0)
  {
    const MessageLog& log = MessageLog::GetInstance();
    throw RenderError(fileName + ": no lines could be read" +
      (log.HasErrors() ? ": " + log.GetFirstError() : "; is --data the folder of the samples?"));
  }
  // Without its radius the mapper finds one that suits the data, and the tubes need the same.
  vtkNew<vtkTrajectoryMapper> mapper;
  mapper->SetInputData(data);
  vtkCellArray* lines = data->GetLines();
  data->GetPointData()->SetScalars(MakeColors(
    data->GetNumberOfLines(), [lines](vtkIdType line) { return lines->GetCellSize(line); }));
  return Scene(name, data, mapper->GetEffectiveRadius());
}

//------------------------------------------------------------------------------
// The higher, the more important.
vtkSmartPointer<vtkPolyData> Divide(vtkPolyData* data)
{
  double bounds[6];
  data->GetBounds(bounds);
  const double height = bounds[5] > bounds[4] ? bounds[5] - bounds[4] : 1.0;
  vtkNew<vtkFloatArray> importance;
  importance->SetName("Importance");
  importance->SetNumberOfValues(data->GetNumberOfPoints());
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    importance->SetValue(
      point, static_cast<float>((data->GetPoint(point)[2] - bounds[4]) / height));
  }
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(data);
  copy->GetPointData()->AddArray(importance);
  vtkNew<vtkTrajectorySegments> segments;
  segments->SetInputData(copy);
  segments->Update();
  return segments->GetPolyDataOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* data, double radius)
{
  if (data->GetNumberOfLines() > 0)
  {
    vtkNew<vtkTubeFilter> tubes;
    tubes->SetInputData(data);
    tubes->SetNumberOfSides(TubeSides);
    tubes->SetRadius(radius);
    tubes->CappingOn();
    tubes->Update();
    return tubes->GetOutput();
  }
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  vtkNew<vtkGlyph3D> balls;
  balls->SetInputData(data);
  balls->SetSourceConnection(ball->GetOutputPort());
  balls->ScalingOff();
  balls->OrientOff();
  balls->SetColorModeToColorByScalar();
  balls->Update();
  return balls->GetOutput();
}
}

//------------------------------------------------------------------------------
Scene MakeABCFlow(const std::string& name, int lines, int segmentsPerLine)
{
  RandomNumbers random;
  std::vector<vtkVector3d> seeds(lines);
  std::generate(seeds.begin(), seeds.end(), [&random] { return random.NextPoint(); });
  const vtkIdType pointsPerLine = segmentsPerLine + 1;
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(lines * pointsPerLine);
  vtkSMPTools::For(0, lines,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType line = first; line < last; ++line)
      {
        vtkVector3d point = seeds[line];
        for (vtkIdType i = 0; i < pointsPerLine; ++i)
        {
          points->SetPoint(line * pointsPerLine + i, point.GetData());
          point = FollowABCFlow(point, LineLength / segmentsPerLine);
        }
      }
    });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(MakeCells(lines, pointsPerLine));
  data->GetPointData()->SetScalars(
    MakeColors(lines, [pointsPerLine](vtkIdType) { return pointsPerLine; }));
  return Scene(name, data, LineRadius);
}

//------------------------------------------------------------------------------
Scene::Scene(std::string name, vtkSmartPointer<vtkPolyData> data, double radius)
  : Name(std::move(name))
  , Radius(radius)
{
  this->Forms[Geometry::Trajectories] = std::move(data);
}

//------------------------------------------------------------------------------
vtkIdType Scene::GetNumberOfSegments() const
{
  vtkPolyData* data = this->Forms.at(Geometry::Trajectories);
  vtkCellArray* lines = data->GetLines();
  return lines->GetNumberOfConnectivityIds() - lines->GetNumberOfCells() +
    data->GetNumberOfVerts() + data->GetNumberOfPolys();
}

//------------------------------------------------------------------------------
double Scene::EstimateBytes(Geometry form, bool withReference) const
{
  const auto segments = static_cast<double>(this->GetNumberOfSegments());
  if (form != Geometry::Triangles && !this->HasPolygons())
  {
    return segments * (withReference ? BytesOfReferenceCone : BytesOfCone);
  }
  const bool hasLines = this->Forms.at(Geometry::Trajectories)->GetNumberOfLines() > 0;
  const double triangles = this->HasPolygons() ? 1.0
    : hasLines                                 ? TrianglesOfSegment
                                               : TrianglesOfBall;
  return segments * triangles * (withReference ? BytesOfReferenceTriangle : BytesOfTriangle);
}

//------------------------------------------------------------------------------
vtkPolyData* Scene::GetForm(Geometry form)
{
  vtkPolyData* data = this->Forms.at(Geometry::Trajectories);
  if (this->HasPolygons())
  {
    return data;
  }
  auto& result = this->Forms[form];
  if (!result)
  {
    result = form == Geometry::Segments ? Divide(data) : Triangulate(data, this->Radius);
  }
  return result;
}

//------------------------------------------------------------------------------
void Scene::ReleaseOtherForms(Geometry form)
{
  for (auto& [other, data] : this->Forms)
  {
    if (other != form && other != Geometry::Trajectories)
    {
      data = nullptr;
    }
  }
}

//------------------------------------------------------------------------------
vtkActor* Scene::AddTo(vtkRenderer* renderer, Geometry form, double opacity)
{
  vtkNew<vtkActor> actor;
  if (this->HasPolygons() || form == Geometry::Triangles)
  {
    actor->SetMapper(vtkNew<vtkPolyDataMapper>());
    actor->GetProperty()->SetBackfaceCulling(!this->HasPolygons() && !this->DrawsInnerWalls);
  }
  else
  {
    vtkNew<vtkTrajectoryMapper> mapper;
    mapper->SetRadius(this->Radius);
    actor->SetMapper(mapper);
  }
  actor->GetMapper()->SetInputDataObject(this->GetForm(form));
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
  renderer->SetBackground(1.0, 1.0, 1.0);
  // All forms get the camera of the lines and points themselves.
  renderer->ResetCamera(this->Forms.at(Geometry::Trajectories)->GetBounds());
  renderer->GetActiveCamera()->Zoom(Zoom);
  renderer->ResetCameraClippingRange();
  return actor;
}

//------------------------------------------------------------------------------
std::vector<SceneFamily> MakeSceneFamilies(const std::string& dataFolder)
{
  return {
    { "abc", "streamlines of the ABC flow, of 100 points", { 100, 1000, 5000, 10000, 100000 },
      1000000,
      [](const std::string& name, int lines)
      { return MakeABCFlow(name, lines, SegmentsPerLine); } },
    { "tubes", "the lines of abc; triangles have both walls, as VTK draws tubes by default",
      { 1000, 5000 }, 1000000,
      [](const std::string& name, int lines)
      {
        Scene scene = MakeABCFlow(name, lines, SegmentsPerLine);
        scene.SetDrawsInnerWalls(true);
        return scene;
      } },
    { "combustor", "150 streamlines of the air in a combustor", {}, 0,
      [dataFolder](const std::string& name, int)
      { return ReadLines(name, dataFolder + "/combustor-lines.vtk"); } },
    { "points", "balls at random", { 1000, 10000, 100000 }, 10000000, MakePointCloud },
    { "surfaces", "iso-surfaces of the wavelet", { 4, 16 }, 1000, MakeSurfaces },
    { "layers", "squares one behind the other, drawn in no order", { 8, 64, 512 }, 1000000,
      MakeLayers },
  };
}
}
}
