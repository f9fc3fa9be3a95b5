// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneBuilder.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOcclusionAvoidance.h"
#include "vtkOpacityOptimization.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceSegments.h"
#include "vtkTrajectoryMapper.h"
#include "vtkTrajectorySegments.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkVector.h"
#include "vtkVectorOperators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace pellucid
{
namespace
{
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/** The same numbers everywhere: the distributions of the standard library differ. */
class Numbers
{
public:
  Numbers(int seed, int cell)
    : Random(static_cast<std::uint32_t>(seed) * 7919u + static_cast<std::uint32_t>(cell))
  {
  }

  double Get(double from, double to) { return from + (to - from) * this->Random() / 4294967296.0; }

  vtkVector3d GetPoint() { return { this->Get(-1, 1), this->Get(-1, 1), this->Get(-1, 1) }; }

private:
  std::mt19937 Random;
};

bool IsSurface(const PropDescription& prop)
{
  return prop.Kind == "sphere" || prop.Kind == "sheets";
}

//------------------------------------------------------------------------------
vtkVector3d Follow(const PropDescription& prop, Numbers& numbers, const vtkVector3d& previous,
  const vtkVector3d& beforeThat, vtkVector3d& direction)
{
  if (prop.Shape == "kinks")
  {
    return numbers.GetPoint();
  }
  if (prop.Shape == "repeats" && numbers.Get(0, 1) < 0.5)
  {
    return previous;
  }
  if (prop.Shape == "backward" && numbers.Get(0, 1) < 0.4)
  {
    return beforeThat;
  }
  direction = (direction + 0.6 * numbers.GetPoint()).Normalized();
  return previous + (1.0 / prop.PointsPerCell) * direction;
}

std::vector<vtkVector3d> MakeLine(const PropDescription& prop, int line)
{
  Numbers numbers(prop.Seed, line);
  std::vector<vtkVector3d> points{ numbers.GetPoint() };
  vtkVector3d direction = numbers.GetPoint().Normalized();
  while (static_cast<int>(points.size()) < prop.PointsPerCell)
  {
    const vtkVector3d& beforeThat = points[points.size() > 1 ? points.size() - 2 : 0];
    points.push_back(Follow(prop, numbers, points.back(), beforeThat, direction));
  }
  return points;
}

//------------------------------------------------------------------------------
/** Puts cells of points into poly data, in an order of its own. */
class Assembler
{
public:
  Assembler(const PropDescription& prop, BuildOrder order)
    : Prop(prop)
    , Order(prop.Cells)
  {
    std::iota(this->Order.begin(), this->Order.end(), 0);
    if (order == BuildOrder::Shuffled)
    {
      this->Shuffle();
    }
    this->Points->SetDataTypeToDouble();
  }

  vtkSmartPointer<vtkPolyData> MakeLines()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    for (const int cell : this->Order)
    {
      this->Add(MakeLine(this->Prop, cell));
    }
    data->SetPoints(this->Points);
    data->SetLines(this->Cells);
    return data;
  }

  vtkSmartPointer<vtkPolyData> MakeBalls()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    for (const int cell : this->Order)
    {
      this->Add({ Numbers(this->Prop.Seed, cell).GetPoint() });
    }
    data->SetPoints(this->Points);
    data->SetVerts(this->Cells);
    return data;
  }

  /// Quadrilaterals through the middle.
  vtkSmartPointer<vtkPolyData> MakeSheets()
  {
    auto data = vtkSmartPointer<vtkPolyData>::New();
    for (const int cell : this->Order)
    {
      Numbers numbers(this->Prop.Seed, cell);
      const vtkVector3d center = 0.5 * numbers.GetPoint();
      const vtkVector3d x = numbers.GetPoint();
      const vtkVector3d y = numbers.GetPoint();
      this->Add({ center - x, center - y, center + x, center + y });
    }
    data->SetPoints(this->Points);
    data->SetPolys(this->Cells);
    return data;
  }

private:
  /// By Fisher and Yates.
  void Shuffle()
  {
    Numbers numbers(this->Prop.Seed, 0);
    for (std::size_t left = this->Order.size(); left > 1; --left)
    {
      const auto chosen = static_cast<std::size_t>(numbers.Get(0.0, static_cast<double>(left)));
      std::swap(this->Order[left - 1], this->Order[chosen]);
    }
  }

  void Add(const std::vector<vtkVector3d>& points)
  {
    this->Cells->InsertNextCell(static_cast<int>(points.size()));
    for (const vtkVector3d& point : points)
    {
      this->Cells->InsertCellPoint(this->Points->InsertNextPoint(point.GetData()));
    }
  }

  const PropDescription& Prop;
  std::vector<int> Order;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
};

vtkSmartPointer<vtkPolyData> MakeGeometry(const PropDescription& prop, BuildOrder order)
{
  if (prop.Kind == "sphere")
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(0.4 + 0.05 * (prop.Seed % 10));
    sphere->SetThetaResolution(8 + prop.PointsPerCell);
    sphere->SetPhiResolution(6 + prop.PointsPerCell / 2);
    // Along the axes edges run through the centres of many pixels, each of which may show either
    // side, and no displaced view has all of their choices.
    vtkNew<vtkTransform> turn;
    if (prop.Turned)
    {
      turn->RotateWXYZ(17.0 + prop.Seed, 0.3, 0.5, 0.8);
      turn->Translate(0.011, 0.017, 0.013);
    }
    vtkNew<vtkTransformPolyDataFilter> turned;
    turned->SetInputConnection(sphere->GetOutputPort());
    turned->SetTransform(turn);
    turned->Update();
    return turned->GetOutput();
  }
  Assembler assembler(prop, order);
  if (prop.Kind == "sheets")
  {
    return assembler.MakeSheets();
  }
  return prop.Kind == "lines" ? assembler.MakeLines() : assembler.MakeBalls();
}

//------------------------------------------------------------------------------
/** A number of [0,1) that belongs to the place, so that it does not depend on the order of points.
 */
double Scatter(const double* point, double frequency)
{
  const double value =
    std::sin(frequency * (12.9898 * point[0] + 78.233 * point[1] + 37.719 * point[2]));
  return 0.5 + 0.49 * value;
}

double GetImportance(const PropDescription& prop, const double* point)
{
  if (prop.Importance == "constant")
  {
    return 0.6;
  }
  const double wave = 0.5 + 0.6 * std::sin(2.0 * point[0] + point[1] + 0.7 * point[2] + prop.Seed);
  if (prop.Importance == "wave")
  {
    return wave;
  }
  constexpr std::array<double, 6> wild{ { NotANumber, Infinity, -Infinity, -3.0, 7.0, 1e30 } };
  const auto choice = static_cast<std::size_t>(3.0 * wild.size() * Scatter(point, 3.0));
  return choice < wild.size() ? wild[choice] : wave;
}

double GetOpacityFactor(const double* point)
{
  const double value = Scatter(point, 2.0);
  return value > 0.9 ? NotANumber : value > 0.85 ? 2.0 : value < 0.15 ? -1.0 : value;
}

void AddArrays(vtkPolyData* data, const PropDescription& prop)
{
  const auto add = [&](const char* name, auto&& function)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double point[3];
      data->GetPoint(i, point);
      array->InsertNextValue(static_cast<float>(function(point)));
    }
    data->GetPointData()->AddArray(array);
  };
  add("Value", [](const double* point) { return 2.0 * Scatter(point, 0.05) - 1.0; });
  add("Radius",
    [&](const double* point)
    { return prop.Radius * std::max(2.0 * Scatter(point, 1.0) - 0.2, 0.0); });
  add("Opacity", GetOpacityFactor);
  add("Importance", [&](const double* point) { return GetImportance(prop, point); });
  data->GetPointData()->SetActiveScalars("Value");
}

//------------------------------------------------------------------------------
/** Surfaces have the actor moved instead: VTK's own mapper keeps their points in single precision.
 */
bool MovesData(const PropDescription& prop)
{
  return prop.Kind == "lines" || prop.Kind == "balls";
}

void MoveData(vtkPolyData* data, const SceneDescription& scene, const PropDescription& prop)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double offset = MovesData(prop) ? scene.Offset : 0.0;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    const bool isMissing = prop.MissingPoints && MovesData(prop) && Scatter(point, 5.0) > 0.8;
    points->InsertNextPoint(point[0] + offset, isMissing ? NotANumber : point[1] - offset,
      scene.Stretch * (point[2] + offset));
  }
  data->SetPoints(points);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Divide(vtkPolyData* data, const PropDescription& prop)
{
  if (prop.Segments == 0 || prop.Method == "none" || prop.Kind == "sheets")
  {
    return data;
  }
  if (IsSurface(prop))
  {
    vtkNew<vtkSurfaceSegments> divider;
    divider->SetInputData(data);
    divider->SetNumberOfSegments(prop.Segments);
    divider->Update();
    return divider->GetOutput();
  }
  vtkNew<vtkTrajectorySegments> divider;
  divider->SetInputData(data);
  divider->SetNumberOfSegments(prop.Segments);
  divider->Update();
  return divider->GetPolyDataOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkMapper> MakeMapper(
  const SceneDescription& scene, const PropDescription& prop, vtkPolyData* data)
{
  if (prop.Kind == "glyphs")
  {
    vtkNew<vtkConeSource> cone;
    cone->SetHeight(0.5);
    cone->SetRadius(0.2);
    cone->SetResolution(8);
    // Without normals VTK takes them from differences between pixels, too coarse for small
    // triangles.
    vtkNew<vtkPolyDataNormals> normals;
    normals->SetInputConnection(cone->GetOutputPort());
    auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
    mapper->SetInputData(data);
    mapper->SetSourceConnection(normals->GetOutputPort());
    return mapper;
  }
  if (IsSurface(prop) && prop.Mapper != "vtkTrajectoryMapper")
  {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    return mapper;
  }
  auto mapper = vtkSmartPointer<vtkTrajectoryMapper>::New();
  mapper->SetInputDataObject(data);
  mapper->SetRadius(prop.Radius);
  mapper->SetRadiusArray(prop.RadiusArray ? "Radius" : nullptr);
  mapper->SetOpacityArray(prop.OpacityArray ? "Opacity" : nullptr);
  if (prop.ClippingPlane)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(scene.Offset + 0.1, -scene.Offset, scene.Offset);
    plane->SetNormal(-0.8, 0.5, 0.1);
    mapper->AddClippingPlane(plane);
  }
  return mapper;
}

void SetColors(vtkActor* actor, const PropDescription& prop)
{
  Numbers numbers(prop.Seed, -1);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(numbers.Get(0, 1), numbers.Get(0, 1), numbers.Get(0, 1));
  property->SetOpacity(prop.Opacity);
  property->SetLighting(prop.Lighting);
  property->SetSpecular(numbers.Get(0, 0.5));
  property->SetSpecularPower(20.0);
  property->SetAmbient(numbers.Get(0, 0.5));
  vtkMapper* mapper = actor->GetMapper();
  mapper->SetScalarVisibility(prop.Colors != "property");
  mapper->SetScalarRange(-1.0, 1.0);
  mapper->SetInterpolateScalarsBeforeMapping(prop.Colors == "texture");
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(64);
  table->SetAlphaRange(prop.Colors == "opacities" ? 0.0 : 1.0, 1.0);
  table->SetRange(-1.0, 1.0);
  table->Build();
  mapper->SetLookupTable(table);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImportanceDrivenOpacity> MakeParameters(const PropDescription& prop)
{
  if (prop.Method == "optimization")
  {
    auto optimization = vtkSmartPointer<vtkOpacityOptimization>::New();
    optimization->SetOcclusionWeight(prop.OcclusionWeight);
    optimization->SetClutterWeight(prop.ClutterWeight);
    optimization->SetEmphasis(prop.Emphasis);
    optimization->SetSmoothingIterations(prop.SmoothingIterations);
    optimization->SetSelfOcclusion(prop.SelfOcclusion);
    return optimization;
  }
  auto avoidance = vtkSmartPointer<vtkOcclusionAvoidance>::New();
  avoidance->SetMode(prop.Method == "weighting");
  avoidance->SetSmoothAttributes(prop.SmoothAttributes);
  avoidance->SetPenalty(prop.Penalty);
  avoidance->SetImportanceExponent(prop.Emphasis);
  return avoidance;
}

void AddLights(vtkRenderer* renderer, const SceneDescription& scene)
{
  const auto add = [&](double x, double y, double z, bool isPositional, double intensity)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetFocalPoint(scene.Offset, -scene.Offset, scene.Offset);
    light->SetPosition(scene.Offset + x, -scene.Offset + y, scene.Offset + z);
    light->SetPositional(isPositional);
    light->SetConeAngle(40.0);
    light->SetIntensity(intensity);
    renderer->AddLight(light);
  };
  if (scene.Lights == "scene" || scene.Lights == "many")
  {
    add(1.0, 2.0, 3.0, false, 0.8);
  }
  if (scene.Lights == "spot" || scene.Lights == "many")
  {
    add(-3.0, 2.0, 2.0, true, 0.7);
  }
  if (scene.Lights == "many")
  {
    add(0.3, -1.0, 0.5, false, 0.3); // along no side of a glyph
  }
}

//------------------------------------------------------------------------------
void SetCamera(vtkRenderer* renderer, const SceneDescription& scene)
{
  const double height = scene.Compensated ? 1.0 : scene.Stretch;
  const vtkVector3d center(scene.Offset, -scene.Offset, height * scene.Offset);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetParallelProjection(scene.ParallelProjection);
  camera->SetFocalPoint(center[0], center[1], center[2]);
  camera->SetPosition(center[0], center[1], center[2] + 5.0 * height + 2.0);
  camera->SetParallelScale(1.5);
  camera->Azimuth(scene.Azimuth);
  camera->Elevation(scene.Elevation);
  camera->Zoom(scene.Zoom);
  camera->OrthogonalizeViewUp();
  if (scene.EyeInside && !scene.Props.empty())
  {
    double point[4] = { 0.0, 0.0, 0.0, 1.0 };
    const auto first = MakeActor(scene, scene.Props.front(), BuildOrder::Forward);
    vtkPolyData::SafeDownCast(first->GetMapper()->GetInputDataObject(0, 0))->GetPoint(0, point);
    first->GetMatrix()->MultiplyPoint(point, point);
    if (std::isfinite(point[1]))
    {
      camera->SetPosition(point);
    }
  }
  // Points that are not finite have no place in the bounds that VTK takes the range from.
  const double half = 2.5;
  renderer->ResetCameraClippingRange(center[0] - half, center[0] + half, center[1] - half,
    center[1] + half, center[2] - half * height, center[2] + half * height);
  if (scene.NearToFar > 0.0)
  {
    const double farthest = camera->GetClippingRange()[1];
    camera->SetClippingRange(farthest / scene.NearToFar, farthest);
  }
}
}

//------------------------------------------------------------------------------
bool IsOpaque(const PropDescription& prop)
{
  return prop.Opacity == 1.0 && prop.Method == "none";
}

//------------------------------------------------------------------------------
bool KeepsDepths(const SceneDescription& scene)
{
  return scene.ParallelProjection || scene.NearToFar <= 1e3;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeData(
  const SceneDescription& scene, const PropDescription& prop, BuildOrder order)
{
  auto data = MakeGeometry(prop, order);
  AddArrays(data, prop);
  MoveData(data, scene, prop);
  return Divide(data, prop);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeActor(
  const SceneDescription& scene, const PropDescription& prop, BuildOrder order)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(MakeMapper(scene, prop, MakeData(scene, prop, order)));
  SetColors(actor, prop);
  const double scale = scene.Compensated ? 1.0 / scene.Stretch : 1.0;
  actor->SetScale(1.0, 1.0, scale);
  if (!MovesData(prop))
  {
    const double height = scene.Compensated ? 1.0 : scene.Stretch;
    actor->SetPosition(scene.Offset, -scene.Offset, height * scene.Offset);
  }
  if (prop.Method != "none")
  {
    const auto parameters = MakeParameters(prop);
    parameters->SetImportanceRange(prop.Range[0], prop.Range[1]);
    vtkImportanceDrivenOpacity::Attach(actor, parameters);
  }
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderer> MakeRenderer(const SceneDescription& scene, BuildOrder order)
{
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  std::vector<PropDescription> props = scene.Props;
  // Of opaque fragments of one depth OpenGL shows the last. Segments of one depth, colour and
  // importance are told apart by their numbers.
  const auto needsOrder = [&](const PropDescription& prop)
  { return IsOpaque(prop) || (prop.Method == "optimization" && !KeepsDepths(scene)); };
  const auto fixed = std::stable_partition(props.begin(), props.end(), needsOrder);
  if (order == BuildOrder::Shuffled)
  {
    std::reverse(fixed, props.end());
  }
  for (auto prop = props.begin(); prop != props.end(); ++prop)
  {
    renderer->AddActor(MakeActor(scene, *prop, prop < fixed ? BuildOrder::Forward : order));
  }
  // Colours that 8 bits hold exactly, so that the background adds no rounding of its own.
  renderer->SetBackground(0.8, 0.6, 1.0);
  AddLights(renderer, scene);
  SetCamera(renderer, scene);
  return renderer;
}
}
