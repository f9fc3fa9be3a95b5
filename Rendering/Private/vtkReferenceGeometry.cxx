// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkReferenceGeometry.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpacityOptimization.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkQuaternion.h"
#include "vtkSmartPointer.h"
#include "vtkTrajectoryOpacities.h"
#include "vtkUnsignedCharArray.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Vec3 = pellucid::Vector3<double>;
using Vec4 = pellucid::Vector4<double>;

/** Maps scalars with the settings of another mapper, leaving that one's cached colours alone. */
class ColorMapper : public vtkMapper
{
public:
  static ColorMapper* New();
  vtkTypeMacro(ColorMapper, vtkMapper);
  void Render(vtkRenderer*, vtkActor*) override {}

  /** What MapScalars() found: colours of points or cells, or table and coordinates of points. */
  vtkUnsignedCharArray* GetColors() { return this->Colors; }
};
vtkStandardNewMacro(ColorMapper);

Vec4 ToColor(vtkUnsignedCharArray* colors, vtkIdType tuple)
{
  unsigned char rgba[4] = { 0, 0, 0, 255 };
  colors->GetTypedTuple(tuple, rgba);
  return Vec4(rgba[0], rgba[1], rgba[2], rgba[3]) / 255.0;
}

/** The colours of one data set, found as vtkOpenGLPolyDataMapper::BuildBufferObjects() does. */
class DataColors
{
public:
  /** A block's own colour replaces what is found, but not its opacity. */
  DataColors(vtkMapper* mapper, vtkPolyData* data, const vtkBlockDisplay& display)
    : Display(display)
  {
    mapper->GetLookupTable();
    this->Mapper->ShallowCopy(mapper);
    this->Mapper->MapScalars(data, 1.0);
    vtkUnsignedCharArray* colors = this->Mapper->GetColors();
    if (!mapper->GetScalarVisibility())
    {
      return;
    }
    if (this->Mapper->GetColorCoordinates() && this->Mapper->GetColorTextureMap())
    {
      this->Coordinates = this->Mapper->GetColorCoordinates();
      return;
    }
    if (!colors || colors->GetNumberOfTuples() == 0)
    {
      return;
    }
    const int mode = mapper->GetScalarMode();
    this->PerCell = mode != VTK_SCALAR_MODE_USE_POINT_FIELD_DATA &&
      (mode == VTK_SCALAR_MODE_USE_CELL_DATA || mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA ||
        mode == VTK_SCALAR_MODE_USE_FIELD_DATA || !data->GetPointData()->GetScalars());
    if (mode == VTK_SCALAR_MODE_USE_FIELD_DATA)
    {
      this->OneTuple = mapper->GetFieldDataTupleId();
    }
    if (this->PerCell || colors->GetNumberOfTuples() == data->GetNumberOfPoints())
    {
      this->Colors = colors;
    }
  }

  bool IsPerCell() const { return this->PerCell; }

  /** The colour attribute of a vertex; what it means is up to the surface's colour source. */
  Vec4 Get(vtkIdType point, vtkIdType cell) const
  {
    if (this->Coordinates)
    {
      const double s = this->Coordinates->GetComponent(point, 0);
      const double t = this->Coordinates->GetNumberOfComponents() > 1
        ? this->Coordinates->GetComponent(point, 1)
        : 0.0;
      return Vec4(s, t, 0.0, 0.0);
    }
    if (!this->Colors)
    {
      return Vec4(1.0);
    }
    const vtkIdType tuple = this->OneTuple >= 0 ? this->OneTuple : (this->PerCell ? cell : point);
    return this->Override(
      ToColor(this->Colors, std::min(tuple, this->Colors->GetNumberOfTuples() - 1)));
  }

  void ApplyTo(pellucid::Surface<double>& surface) const
  {
    if (this->Coordinates)
    {
      vtkImageData* image = this->Mapper->GetColorTextureMap();
      int size[3];
      image->GetDimensions(size);
      auto* texels = vtkArrayDownCast<vtkUnsignedCharArray>(image->GetPointData()->GetScalars());
      surface.colorSource = pellucid::ColorSource::Table;
      surface.table.width = size[0];
      surface.table.height = size[1];
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
      {
        surface.table.texels.push_back(this->Override(ToColor(texels, i)));
      }
    }
    else if (this->Colors)
    {
      surface.colorSource = pellucid::ColorSource::Vertices;
    }
    for (pellucid::Material<double>* material : { &surface.front, &surface.back })
    {
      material->opacity = this->Display.Opacity.value_or(material->opacity);
      material->ambientColor = this->Override(Vec4(material->ambientColor, 1.0));
      material->diffuseColor = this->Override(Vec4(material->diffuseColor, 1.0));
    }
  }

private:
  Vec4 Override(const Vec4& color) const
  {
    return this->Display.Color ? Vec4(glm::make_vec3(this->Display.Color->data()), color.a) : color;
  }

  vtkBlockDisplay Display;
  vtkNew<ColorMapper> Mapper;
  vtkUnsignedCharArray* Colors = nullptr;
  vtkFloatArray* Coordinates = nullptr;
  bool PerCell = false;
  vtkIdType OneTuple = -1;
};

/** The factors on the opacity at the points of one data set: 1 where there is no number. */
class DataOpacities
{
public:
  DataOpacities(const vtkReferenceTarget& target, vtkPolyData* data)
    : Factors(
        vtkTrajectoryOpacities(target.opacityArray ? target.opacityArray : "").FindGoodArray(data))
  {
  }

  double Get(vtkIdType point) const
  {
    const double factor = this->Factors ? this->Factors->GetComponent(point, 0) : 1.0;
    return factor < 0.0 ? 0.0 : factor < 1.0 ? factor : 1.0;
  }

private:
  vtkDataArray* Factors;
};

/** Importance and segment at the points of one data set, where its opacities follow from that. */
class DataSegments
{
public:
  DataSegments(const vtkReferenceTarget& target, vtkPolyData* data)
  {
    if (!target.member)
    {
      return;
    }
    const auto part = std::find_if(target.member->Parts.begin(), target.member->Parts.end(),
      [data](const vtkOptimizedScene::Part& candidate) { return candidate.Data == data; });
    this->Part = part == target.member->Parts.end() ? &target.member->Parts.front() : &*part;
    vtkImportanceDrivenOpacity* settings = target.member->Settings;
    this->Range = pellucid::ImportanceRange<double>(settings->GetImportanceRange());
    vtkPointData* points = data->GetPointData();
    this->Importance =
      this->Part->HasImportance ? points->GetArray(settings->GetImportanceArray()) : nullptr;
    if (!target.member->Avoids && vtkOptimizedScene::HasLineSegments(data))
    {
      this->Base = points->GetArray("SegmentBase");
      this->Weight = points->GetArray("SegmentWeight");
    }
    if (this->Part->HasCorners)
    {
      this->Nearest = points->GetArray("SegmentIds");
      this->FirstCorner = target.optimized->GetNumberOfSegments() + this->Part->FirstCorner;
    }
  }

  pellucid::SegmentNode<double> GetNode(vtkIdType point) const
  {
    pellucid::SegmentNode<double> node;
    if (this->Part)
    {
      vtkDataArray* base = this->Base ? this->Base : this->Nearest;
      node.importance =
        this->Importance ? this->Range.Map(this->Importance->GetComponent(point, 0)) : 0.0;
      node.base = this->Part->FirstSegment +
        (base ? std::max(static_cast<vtkIdType>(base->GetComponent(point, 0)), vtkIdType(0)) : 0);
      node.weight = this->Weight ? this->Weight->GetComponent(point, 0) : 0.0;
    }
    return node;
  }

  pellucid::SegmentId GetCorner(vtkIdType point) const
  {
    return this->Nearest ? this->FirstCorner + point : -1;
  }

private:
  const vtkOptimizedScene::Part* Part = nullptr;
  pellucid::ImportanceRange<double> Range;
  vtkDataArray* Importance = nullptr;
  vtkDataArray* Base = nullptr;
  vtkDataArray* Weight = nullptr;
  vtkDataArray* Nearest = nullptr;
  pellucid::SegmentId FirstCorner = 0;
};

std::uint32_t AddSurface(pellucid::Scene<double>& scene, const pellucid::Surface<double>& surface)
{
  scene.surfaces.push_back(surface);
  return static_cast<std::uint32_t>(scene.surfaces.size() - 1);
}

/** Calls visit(number of points, point ids, cell id) for the cells of an array. */
template <typename Visit>
void ForEachCell(vtkCellArray* cells, vtkIdType firstCell, Visit&& visit)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  vtkIdType cell = firstCell;
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count;
    const vtkIdType* points;
    iterator->GetCurrentCell(count, points);
    visit(count, points, cell++);
  }
}

/** Adds the polygons and strips of one data set, once for each place where they are drawn. */
class PolygonAdder
{
public:
  PolygonAdder(vtkReferenceTarget& target, vtkPolyData* data, std::uint32_t surface)
    : Scene(target.scene)
    , Data(data)
    , Surface(surface)
    , Opacities(target, data)
    , Segments(target, data)
  {
    // vtkOpenGLPolyDataMapper ignores the normals of points for flat interpolation only.
    if (target.property->GetInterpolation() != VTK_FLAT)
    {
      this->PointNormals = data->GetPointData()->GetNormals();
    }
    if (!this->PointNormals)
    {
      this->CellNormals = data->GetCellData()->GetNormals();
    }
  }

  /** `normalToView` need not be the inverse transpose of `modelToView`; `color(point, cell)` is the
   * colour attribute of a vertex, and `perCell` says whether it depends on the cell. */
  template <typename Color>
  vtkIdType Add(
    const glm::dmat4& modelToView, const glm::dmat3& normalToView, bool perCell, Color&& color)
  {
    const std::size_t offset = this->Scene.vertices.size();
    const bool shared = !perCell && !this->CellNormals;
    const auto makeVertex = [&](vtkIdType point, vtkIdType cell)
    {
      pellucid::Vertex<double> vertex;
      double position[3];
      this->Data->GetPoint(point, position);
      vertex.position = Vec3(modelToView * Vec4(glm::make_vec3(position), 1.0));
      vtkDataArray* normals = this->PointNormals ? this->PointNormals : this->CellNormals;
      if (normals)
      {
        double normal[3];
        normals->GetTuple(this->PointNormals ? point : cell, normal);
        vertex.normal = normalToView * glm::make_vec3(normal);
      }
      vertex.color = color(point, cell);
      vertex.opacity = this->Opacities.Get(point);
      vertex.segment = this->Segments.GetNode(point);
      vertex.corner = this->Segments.GetCorner(point);
      return vertex;
    };
    for (vtkIdType point = 0; shared && point < this->Data->GetNumberOfPoints(); ++point)
    {
      this->Scene.vertices.push_back(makeVertex(point, -1));
    }

    vtkIdType invalid = 0;
    const auto addTriangle = [&](vtkIdType a, vtkIdType b, vtkIdType c, vtkIdType cell)
    {
      pellucid::Triangle triangle{ {}, this->Surface };
      const vtkIdType points[3] = { a, b, c };
      bool finite = true;
      for (int i = 0; i < 3; ++i)
      {
        if (!shared)
        {
          this->Scene.vertices.push_back(makeVertex(points[i], cell));
        }
        triangle.vertices[i] = shared ? offset + points[i] : this->Scene.vertices.size() - 1;
        const Vec3& position = this->Scene.vertices[triangle.vertices[i]].position;
        finite = finite && std::isfinite(position.x + position.y + position.z);
      }
      if (finite)
      {
        this->Scene.triangles.push_back(triangle);
      }
      invalid += !finite;
    };

    vtkIdType cell = this->Data->GetNumberOfVerts() + this->Data->GetNumberOfLines();
    ForEachCell(this->Data->GetPolys(), cell,
      [&](vtkIdType count, const vtkIdType* points, vtkIdType id)
      {
        for (vtkIdType i = 2; i < count; ++i)
        {
          addTriangle(points[0], points[i - 1], points[i], id);
        }
      });
    cell += this->Data->GetNumberOfPolys();
    ForEachCell(this->Data->GetStrips(), cell,
      [&](vtkIdType count, const vtkIdType* points, vtkIdType id)
      {
        for (vtkIdType i = 2; i < count; ++i)
        {
          const bool odd = i % 2 != 0;
          addTriangle(points[i - 2], points[odd ? i : i - 1], points[odd ? i - 1 : i], id);
        }
      });
    return invalid;
  }

private:
  pellucid::Scene<double>& Scene;
  vtkPolyData* Data;
  std::uint32_t Surface;
  DataOpacities Opacities;
  DataSegments Segments;
  vtkDataArray* PointNormals = nullptr;
  vtkDataArray* CellNormals = nullptr;
};

vtkIdType AddPolygons(
  vtkReferenceTarget& target, vtkPolyData* data, const DataColors& colors, std::uint32_t surface)
{
  return PolygonAdder(target, data, surface)
    .Add(target.modelToView, glm::transpose(glm::inverse(glm::dmat3(target.modelToView))),
      colors.IsPerCell(),
      [&colors](vtkIdType point, vtkIdType cell) { return colors.Get(point, cell); });
}

/** The arrays that a glyph mapper has chosen, which only its derived classes may ask for. */
struct GlyphArrays : vtkGlyph3DMapper
{
  static constexpr auto Mask = &GlyphArrays::GetMaskArray;
  static constexpr auto Orientation = &GlyphArrays::GetOrientationArray;
  static constexpr auto Scale = &GlyphArrays::GetScaleArray;
  static constexpr auto SourceIndex = &GlyphArrays::GetSourceIndexArray;
};

/** The orientation of a glyph as vtkOpenGLGlyph3DMapper derives it from a tuple of its array. */
glm::dmat3 GlyphRotation(int mode, const double* orientation)
{
  vtkQuaterniond quaternion;
  if (mode == vtkGlyph3DMapper::ROTATION)
  {
    const auto about = [orientation](int axis)
    {
      const double half = vtkMath::RadiansFromDegrees(orientation[axis]) / 2;
      return vtkQuaterniond(std::cos(half), axis == 0 ? std::sin(half) : 0.0,
        axis == 1 ? std::sin(half) : 0.0, axis == 2 ? std::sin(half) : 0.0);
    };
    quaternion = about(2) * about(0) * about(1);
  }
  else if (mode == vtkGlyph3DMapper::QUATERNION)
  {
    quaternion.Set(orientation[0], orientation[1], orientation[2], orientation[3]);
  }
  else
  {
    // Half a turn about the bisector of the x axis and the direction.
    const Vec3 direction = glm::make_vec3(orientation);
    const Vec3 bisector = direction + Vec3(glm::length(direction), 0.0, 0.0);
    const bool alongX = orientation[1] == 0.0 && orientation[2] == 0.0;
    if (!alongX)
    {
      const Vec3 axis = glm::normalize(bisector);
      quaternion.Set(0.0, axis.x, axis.y, axis.z);
    }
    else if (orientation[0] < 0)
    {
      quaternion.Set(0.0, 0.0, 1.0, 0.0);
    }
  }
  double rows[3][3];
  quaternion.ToMatrix3x3(rows);
  return glm::transpose(glm::make_mat3(&rows[0][0]));
}

/** The three scale factors of a glyph. */
Vec3 GlyphScale(vtkGlyph3DMapper* mapper, vtkDataArray* array, vtkIdType point)
{
  Vec3 scale(1.0);
  const int mode = array ? mapper->GetScaleMode() : vtkGlyph3DMapper::NO_DATA_SCALING;
  if (mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
  {
    scale = Vec3(vtkMath::Norm(array->GetTuple(point), array->GetNumberOfComponents()));
  }
  else if (mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS && array->GetNumberOfComponents() == 3)
  {
    scale = glm::make_vec3(array->GetTuple(point));
  }
  if (mapper->GetClamping() && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
  {
    const double* range = mapper->GetRange();
    const double width = range[1] - range[0];
    scale = (glm::clamp(scale, range[0], range[1]) - range[0]) / (width == 0.0 ? 1.0 : width);
  }
  scale *= mapper->GetScaleFactor();
  // VTK keeps the matrix invertible in the same way.
  return Vec3(scale.x == 0.0 ? 1e-10 : scale.x, scale.y == 0.0 ? 1e-10 : scale.y,
    scale.z == 0.0 ? 1e-10 : scale.z);
}

/** The polygons of each source of a glyph mapper: one data set, or several of a composite. */
std::vector<std::vector<vtkPolyData*>> GlyphSources(vtkGlyph3DMapper* mapper)
{
  std::vector<std::vector<vtkPolyData*>> sources;
  if (!mapper->GetUseSourceTableTree())
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
    {
      sources.emplace_back();
      vtkForEachLeaf<vtkPolyData>(
        mapper->GetSource(i), [&sources](vtkPolyData* data) { sources.back().push_back(data); });
    }
  }
  else if (vtkDataObjectTree* tree = mapper->GetSourceTableTree())
  {
    vtkSmartPointer<vtkDataObjectTreeIterator> it;
    it.TakeReference(tree->NewTreeIterator());
    it->SetTraverseSubTree(false);
    it->SetVisitOnlyLeaves(false);
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      sources.emplace_back();
      vtkForEachLeaf<vtkPolyData>(it->GetCurrentDataObject(),
        [&sources](vtkPolyData* data) { sources.back().push_back(data); });
    }
  }
  return sources;
}

vtkReferenceRejects AddGlyphs(vtkReferenceTarget& target, vtkGlyph3DMapper* mapper,
  vtkDataSet* data, const std::vector<std::vector<vtkPolyData*>>& sources)
{
  vtkDataArray* indices = (mapper->*GlyphArrays::SourceIndex)(data);
  vtkDataArray* scales = (mapper->*GlyphArrays::Scale)(data);
  vtkDataArray* orientations = (mapper->*GlyphArrays::Orientation)(data);
  auto* mask = mapper->GetMasking()
    ? vtkArrayDownCast<vtkBitArray>((mapper->*GlyphArrays::Mask)(data))
    : nullptr;

  // VTK gives a glyph the opacity of the property twice: in its colour and in the shader. Colours
  // of 8 bit are what it uploads, also for glyphs that are not coloured by data.
  vtkNew<ColorMapper> colorMapper;
  mapper->GetLookupTable();
  colorMapper->ShallowCopy(mapper);
  const double opacity = target.property->GetOpacity();
  colorMapper->MapScalars(data, opacity);
  vtkUnsignedCharArray* colors = colorMapper->GetColors();
  const Vec4 plain(glm::make_vec3(target.property->GetColor()), opacity);
  const Vec4 plainColor = glm::floor(plain * 255.0 + 0.5) / 255.0;

  pellucid::Surface<double> surface = target.surface;
  surface.colorSource = pellucid::ColorSource::Vertices;
  const std::uint32_t surfaceIndex = AddSurface(target.scene, surface);
  const glm::dmat3 normalToView = glm::transpose(glm::inverse(glm::dmat3(target.modelToView)));
  const int lastSource = static_cast<int>(sources.size()) - 1;

  vtkReferenceRejects rejects;
  for (vtkIdType point = 0; point < data->GetNumberOfPoints(); ++point)
  {
    if (mask && mask->GetValue(point) == 0)
    {
      continue;
    }
    const double value =
      indices ? vtkMath::Norm(indices->GetTuple(point), indices->GetNumberOfComponents()) : 0.0;
    const auto& source = sources[vtkMath::ClampValue(static_cast<int>(value), 0, lastSource)];

    double position[3];
    data->GetPoint(point, position);
    const glm::dmat3 rotation = orientations
      ? GlyphRotation(mapper->GetOrientationMode(), orientations->GetTuple(point))
      : glm::dmat3(1.0);
    const Vec3 scale = mapper->GetScaling() ? GlyphScale(mapper, scales, point) : Vec3(1.0);
    const glm::dmat4 glyphToModel = glm::scale(
      glm::translate(glm::dmat4(1.0), glm::make_vec3(position)) * glm::dmat4(rotation), scale);
    const glm::dmat3 glyphNormal = rotation * glm::dmat3(glm::scale(glm::dmat4(1.0), 1.0 / scale));
    const Vec4 color = colors ? ToColor(colors, point) : plainColor;
    for (vtkPolyData* glyph : source)
    {
      rejects.invalid += PolygonAdder(target, glyph, surfaceIndex)
                           .Add(target.modelToView * glyphToModel, normalToView * glyphNormal,
                             false, [&color](vtkIdType, vtkIdType) { return color; });
      rejects.pixels += glyph->GetNumberOfVerts() + glyph->GetNumberOfLines();
    }
  }
  return rejects;
}
}

//------------------------------------------------------------------------------
vtkReferenceRejects vtkAddReferencePolygons(vtkReferenceTarget& target, vtkPolyData* data)
{
  const DataColors colors(target.mapper, data, target.display);
  pellucid::Surface<double> surface = target.surface;
  colors.ApplyTo(surface);
  vtkReferenceRejects rejects;
  rejects.invalid = AddPolygons(target, data, colors, AddSurface(target.scene, surface));
  rejects.pixels = data->GetNumberOfVerts() + data->GetNumberOfLines();
  return rejects;
}

//------------------------------------------------------------------------------
vtkReferenceRejects vtkAddReferenceTrajectories(
  vtkReferenceTarget& target, vtkPolyData* data, double radius, const char* radiusArray)
{
  const DataColors colors(target.mapper, data, target.display);
  pellucid::Surface<double> surface = target.surface;
  colors.ApplyTo(surface);
  const std::uint32_t index = AddSurface(target.scene, surface);
  vtkReferenceRejects rejects;
  rejects.invalid = AddPolygons(target, data, colors, index);

  vtkDataArray* radii =
    radiusArray && *radiusArray ? data->GetPointData()->GetArray(radiusArray) : nullptr;
  const DataOpacities opacities(target, data);
  const DataSegments segments(target, data);
  const auto makePoint = [&](vtkIdType point, vtkIdType cell)
  {
    double position[3];
    data->GetPoint(point, position);
    return pellucid::TubePoint<double>{ Vec3(
                                          target.modelToView * Vec4(glm::make_vec3(position), 1.0)),
      radii ? radii->GetComponent(point, 0) : radius, colors.Get(point, cell), opacities.Get(point),
      segments.GetNode(point) };
  };
  ForEachCell(data->GetVerts(), 0,
    [&](vtkIdType count, const vtkIdType* points, vtkIdType cell)
    {
      for (vtkIdType i = 0; i < count; ++i)
      {
        rejects.invalid += target.scene.AddTube({ makePoint(points[i], cell) }, index);
      }
    });
  ForEachCell(data->GetLines(), data->GetNumberOfVerts(),
    [&](vtkIdType count, const vtkIdType* points, vtkIdType cell)
    {
      std::vector<pellucid::TubePoint<double>> line;
      for (vtkIdType i = 0; i < count; ++i)
      {
        line.push_back(makePoint(points[i], cell));
      }
      rejects.invalid += target.scene.AddTube(line, index);
    });
  return rejects;
}

//------------------------------------------------------------------------------
vtkReferenceRejects vtkAddReferenceGlyphs(vtkReferenceTarget& target, vtkGlyph3DMapper* mapper)
{
  const auto sources = GlyphSources(mapper);
  vtkReferenceRejects rejects;
  if (!sources.empty())
  {
    vtkForEachLeaf<vtkDataSet>(mapper->GetInputDataObject(0, 0),
      [&](vtkDataSet* data) { rejects += AddGlyphs(target, mapper, data, sources); });
  }
  return rejects;
}
VTK_ABI_NAMESPACE_END
