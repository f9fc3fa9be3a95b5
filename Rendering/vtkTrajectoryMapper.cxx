// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "vtkTrajectoryMapper.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCommand.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDisplayedLeaf.h"
#include "vtkHardwareSelector.h"
#include "vtkImportanceDrivenOpacity.h"
#include "vtkInformation.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolygonPartMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRoundedConeMapper.h"
#include "vtkScalarsToColors.h"
#include "vtkTrajectoryColors.h"
#include "vtkTrajectoryNodes.h"
#include "vtkTrajectoryOpacities.h"
#include "vtkTrajectorySegmentNodes.h"
#include "vtkTrivialProducer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

vtkStandardNewMacro(vtkTrajectoryMapper);

namespace
{
// What the COMPOSITE_INDEX pass of a hardware selection shows while it runs: the part that was hit.
constexpr unsigned int ConePart = 1;
constexpr unsigned int FirstPolygonPart = 2;

unsigned int DecodePixel(const unsigned char* low, const unsigned char* high, unsigned int pixel)
{
  const unsigned int id = low[pixel] | low[pixel + 1] << 8 | low[pixel + 2] << 16;
  return high ? id | static_cast<unsigned int>(high[pixel]) << 24 : id;
}

void EncodePixel(unsigned char* buffer, unsigned int pixel, vtkIdType value)
{
  for (int byte = 0; byte < 3; ++byte)
  {
    buffer[pixel + byte] = static_cast<unsigned char>(value >> 8 * byte & 0xff);
  }
}

// When each part of some data that nodes and polygons are made of has changed. Other arrays do not
// matter: while only they change, the geometry stays in the graphics memory.
using GeometryTimes = std::array<vtkMTimeType, 7>;

GeometryTimes GetGeometryTimes(vtkPolyData* data, const std::string& radiusArray, bool generated)
{
  vtkDataArray* radii =
    radiusArray.empty() ? nullptr : data->GetPointData()->GetArray(radiusArray.c_str());
  // A filter marks its whole output at each execution, also where it passes points and cells on.
  return { { generated ? 0 : data->vtkObject::GetMTime(), data->GetPoints()->GetMTime(),
    data->GetVerts()->GetMTime(), data->GetLines()->GetMTime(), data->GetPolys()->GetMTime(),
    data->GetStrips()->GetMTime(), radii ? radii->GetMTime() : 0 } };
}

std::array<unsigned char, 4> GetPlainColor(vtkProperty* property)
{
  const double* color = property->GetColor();
  std::array<unsigned char, 4> plain{ { 0, 0, 0, 255 } };
  std::transform(color, color + 3, plain.begin(),
    [](double value)
    { return vtkScalarsToColors::ColorToUChar(vtkMath::ClampValue(value, 0.0, 1.0)); });
  return plain;
}
}

//------------------------------------------------------------------------------
/** The mappers that draw a vtkTrajectoryMapper's input, and what they were made from. */
class vtkTrajectoryMapper::Parts
{
public:
  explicit Parts(vtkTrajectoryMapper* owner)
    : Owner(owner)
  {
  }

  /** Follow changes of the input, of its display and of the radius. */
  void UpdateNodes();

  void Render(vtkRenderer* renderer, vtkActor* actor);
  void ReleaseGraphicsResources(vtkWindow* window);
  void ReleaseFromWindow();
  bool IsTranslucent() const;
  vtkBoundingBox GetBounds();
  void Select(
    vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop);

  vtkTrajectoryNodes Nodes;

private:
  struct PolygonPart
  {
    std::size_t Leaf;
    vtkNew<vtkPolygonPartMapper> Mapper;
  };

  /** What the nodes were built from. */
  struct NodesKey
  {
    std::vector<std::pair<vtkPolyData*, unsigned int>> Leaves; // with their flat indices
    std::vector<GeometryTimes> Times;                          // of each leaf
    double Radius = -1.0;
    std::string RadiusArray;

    bool operator==(const NodesKey& other) const
    {
      return this->Leaves == other.Leaves && this->Times == other.Times &&
        this->Radius == other.Radius && this->RadiusArray == other.RadiusArray;
    }
  };

  std::vector<vtkTrajectoryNodes::Leaf> FindLeaves() const;
  vtkTrajectoryOpacities GetOpacities() const;
  bool HasTranslucentColors(vtkPolyData* data) const;
  vtkMTimeType GetAppearanceTime(vtkActor* actor) const;
  void UpdateAppearance(vtkActor* actor);
  void UpdateOpacities();
  void UpdateSegments(vtkActor* actor);
  void RenderPart(
    vtkPolyDataMapper* part, unsigned int index, vtkRenderer* renderer, vtkActor* actor);
  void SelectCones(vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels) const;

  vtkTrajectoryMapper* Owner;
  vtkNew<vtkRoundedConeMapper> Cones;
  std::vector<std::unique_ptr<PolygonPart>> Polygons;
  NodesKey Key;
  vtkMTimeType AppearanceTime = 0;
  vtkProperty* AppearanceProperty = nullptr; // compared, never used
  bool UsesPropertyColor = false;
  std::vector<vtkMTimeType> OpacityTimes;
  std::string ImportanceArray;
  pellucid::ImportanceRange<double> ImportanceRange;
  std::vector<vtkMTimeType> SegmentTimes;
  vtkWeakPointer<vtkWindow> Window;
};

//------------------------------------------------------------------------------
std::vector<vtkTrajectoryNodes::Leaf> vtkTrajectoryMapper::Parts::FindLeaves() const
{
  return vtkFindDisplayedLeaves(
    this->Owner->GetInputDataObject(0, 0), this->Owner->GetCompositeDataDisplayAttributes());
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::UpdateNodes()
{
  std::vector<vtkTrajectoryNodes::Leaf> leaves = this->FindLeaves();
  NodesKey key;
  key.Radius = this->Owner->GetRadius();
  key.RadiusArray = this->Owner->GetRadiusArray() ? this->Owner->GetRadiusArray() : "";
  const bool generated = this->Owner->GetNumberOfInputConnections(0) > 0 &&
    !vtkTrivialProducer::SafeDownCast(this->Owner->GetInputAlgorithm());
  for (const auto& leaf : leaves)
  {
    key.Leaves.emplace_back(leaf.Data, leaf.FlatIndex);
    key.Times.push_back(GetGeometryTimes(leaf.Data, key.RadiusArray, generated));
  }
  if (key == this->Key)
  {
    this->Nodes.UpdateDisplay(std::move(leaves));
    return;
  }
  this->Nodes.Build(std::move(leaves), key.Radius, key.RadiusArray);
  this->Key = std::move(key);
  this->AppearanceTime = 0;
  this->OpacityTimes.clear();
  this->SegmentTimes.clear();
  this->Cones->SetNodes(&this->Nodes);
  if (this->Nodes.GetNumberOfBadRadiusArrays() > 0)
  {
    vtkWarningWithObjectMacro(this->Owner,
      "The radius array '" << this->Key.RadiusArray
                           << "' has more than one component; expected one. The constant radius is "
                              "used instead.");
  }
  if (this->Nodes.GetNumberOfInvalidPoints() > 0)
  {
    vtkWarningWithObjectMacro(this->Owner,
      << this->Nodes.GetNumberOfInvalidPoints()
      << " points of lines and vertices have a coordinate or radius that is not finite: they are "
         "left out, and lines are split there.");
  }

  this->Polygons.clear();
  for (std::size_t i = 0; i < this->Nodes.GetLeaves().size(); ++i)
  {
    vtkPolyData* data = this->Nodes.GetLeaves()[i].Data;
    if (data->GetNumberOfPolys() + data->GetNumberOfStrips() > 0)
    {
      this->Polygons.push_back(std::make_unique<PolygonPart>());
      this->Polygons.back()->Leaf = i;
    }
  }
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTrajectoryMapper::Parts::GetAppearanceTime(vtkActor* actor) const
{
  // Without the attributes of blocks, which change neither colour nor vertex buffers.
  vtkMTimeType time = this->Owner->vtkPolyDataMapper::GetMTime();
  for (const auto& leaf : this->Nodes.GetLeaves())
  {
    time = std::max(time, leaf.Data->GetMTime());
  }
  return this->UsesPropertyColor ? std::max(time, actor->GetProperty()->GetMTime()) : time;
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::UpdateAppearance(vtkActor* actor)
{
  const bool sameProperty =
    !this->UsesPropertyColor || this->AppearanceProperty == actor->GetProperty();
  if (sameProperty && this->AppearanceTime == this->GetAppearanceTime(actor))
  {
    return;
  }
  this->Cones->SetClippingPlanes(this->Owner->GetClippingPlanes());

  vtkTrajectoryColors colors;
  colors.Map(this->Owner, this->Nodes, GetPlainColor(actor->GetProperty()));
  this->UsesPropertyColor = colors.UsesPlain;
  if (!colors.Coordinates.empty())
  {
    this->Cones->SetTextureColors(std::move(colors.Coordinates), colors.ColorMap);
  }
  else if (!colors.Direct.empty())
  {
    this->Cones->SetDirectColors(std::move(colors.Direct));
  }
  else
  {
    this->Cones->SetPropertyColors();
  }

  for (const auto& part : this->Polygons)
  {
    // A shallow copy takes the owner's input too: the part's own comes after it.
    part->Mapper->ShallowCopy(this->Owner);
    part->Mapper->SetInputData(this->Nodes.GetLeaves()[part->Leaf].Data);
    part->Mapper->SetPopulateSelectionSettings(0);
  }
  // Last: mapping may have made or changed the lookup table, which counts as a change of the owner.
  this->AppearanceTime = this->GetAppearanceTime(actor);
  this->AppearanceProperty = actor->GetProperty();
}

//------------------------------------------------------------------------------
vtkTrajectoryOpacities vtkTrajectoryMapper::Parts::GetOpacities() const
{
  return vtkTrajectoryOpacities(
    this->Owner->GetOpacityArray() ? this->Owner->GetOpacityArray() : "");
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::UpdateOpacities()
{
  const auto& leaves = this->Nodes.GetLeaves();
  const vtkTrajectoryOpacities opacities = this->GetOpacities();
  std::vector<vtkMTimeType> times = opacities.GetTimes(leaves);
  if (times == this->OpacityTimes)
  {
    return;
  }
  this->OpacityTimes = std::move(times);
  this->Cones->SetOpacities(opacities.GetNodeFactors(this->Nodes));
  for (const auto& part : this->Polygons)
  {
    part->Mapper->SetPointOpacities(opacities.GetPointFactors(leaves[part->Leaf].Data));
  }
  if (std::any_of(leaves.begin(), leaves.end(),
        [&opacities](const auto& leaf) { return opacities.IsBad(leaf.Data); }))
  {
    vtkWarningWithObjectMacro(this->Owner,
      "The opacity array '" << this->Owner->GetOpacityArray()
                            << "' is not used: expected one component and a value for each point.");
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::UpdateSegments(vtkActor* actor)
{
  vtkImportanceDrivenOpacity* parameters = vtkImportanceDrivenOpacity::Get(actor);
  const char* name = parameters ? parameters->GetImportanceArray() : nullptr;
  const std::string array = name ? name : "";
  pellucid::ImportanceRange<double> range;
  const auto& leaves = this->Nodes.GetLeaves();
  std::vector<vtkMTimeType> times;
  if (parameters)
  {
    range = pellucid::ImportanceRange<double>(parameters->GetImportanceRange());
    times = vtkTrajectorySegmentNodes::GetTimes(leaves, array);
  }
  const bool sameArrays = times == this->SegmentTimes && array == this->ImportanceArray;
  if (sameArrays && range == this->ImportanceRange)
  {
    return;
  }
  this->SegmentTimes = std::move(times);
  this->ImportanceArray = array;
  this->ImportanceRange = range;
  this->Cones->SetSegments(parameters ? vtkTrajectorySegmentNodes::Make(this->Nodes, array, range)
                                      : std::vector<vtkTrajectorySegmentNodes::Node>());
  // Polygons have the values as they are, for shaders to map; bringing them uploads all data.
  for (const auto& part : this->Polygons)
  {
    if (!sameArrays)
    {
      part->Mapper->MapDataArrayToVertexAttribute("pellucidImportanceMC",
        parameters ? name : nullptr, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::RenderPart(
  vtkPolyDataMapper* part, unsigned int index, vtkRenderer* renderer, vtkActor* actor)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector && selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
  {
    selector->RenderCompositeIndex(index);
  }
  part->RenderPiece(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::Render(vtkRenderer* renderer, vtkActor* actor)
{
  this->Window = renderer->GetRenderWindow();
  this->UpdateNodes();
  this->UpdateAppearance(actor);
  this->UpdateOpacities();
  this->UpdateSegments(actor);

  vtkHardwareSelector* selector = renderer->GetSelector();
  if (selector)
  {
    selector->BeginRenderProp();
    // Both the ids of the input and the nodes that stand for them have to fit.
    selector->UpdateMaximumPointId(this->Nodes.GetNumberOfNodes());
    selector->UpdateMaximumCellId(this->Nodes.GetNumberOfNodes());
    for (const auto& leaf : this->Nodes.GetLeaves())
    {
      selector->UpdateMaximumPointId(leaf.Data->GetNumberOfPoints());
      selector->UpdateMaximumCellId(leaf.Data->GetNumberOfCells());
    }
  }
  if (this->Nodes.GetNumberOfNodes() > 0)
  {
    this->RenderPart(this->Cones, ConePart, renderer, actor);
  }
  for (std::size_t i = 0; i < this->Polygons.size(); ++i)
  {
    vtkPolygonPartMapper* part = this->Polygons[i]->Mapper;
    const vtkBlockDisplay& display = this->Nodes.GetLeaves()[this->Polygons[i]->Leaf].Display;
    if (display.IsDrawn(selector != nullptr))
    {
      part->SetDisplay(display);
      this->RenderPart(part, FirstPolygonPart + static_cast<unsigned int>(i), renderer, actor);
    }
  }
  if (selector)
  {
    selector->EndRenderProp();
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Cones->ReleaseGraphicsResources(window);
  for (const auto& part : this->Polygons)
  {
    part->Mapper->ReleaseGraphicsResources(window);
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::ReleaseFromWindow()
{
  if (this->Window)
  {
    this->ReleaseGraphicsResources(this->Window);
  }
}

//------------------------------------------------------------------------------
bool vtkTrajectoryMapper::Parts::HasTranslucentColors(vtkPolyData* data) const
{
  vtkTrajectoryMapper* owner = this->Owner;
  if (!owner->GetScalarVisibility())
  {
    return false;
  }
  int cellFlag = 0;
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(data, owner->GetScalarMode(),
    owner->GetArrayAccessMode(), owner->GetArrayId(), owner->GetArrayName(), cellFlag);
  if (!scalars)
  {
    return false;
  }
  unsigned char ghostsToSkip = 0;
  vtkUnsignedCharArray* ghosts =
    vtkAbstractMapper::GetGhostArray(data, owner->GetScalarMode(), ghostsToSkip);
  vtkScalarsToColors* table = owner->GetLookupTable();
  table->Build();
  return !table->IsOpaque(
    scalars, owner->GetColorMode(), owner->GetArrayComponent(), ghosts, ghostsToSkip);
}

//------------------------------------------------------------------------------
bool vtkTrajectoryMapper::Parts::IsTranslucent() const
{
  const vtkTrajectoryOpacities opacities = this->GetOpacities();
  const auto leaves = this->FindLeaves();
  return std::any_of(leaves.begin(), leaves.end(),
    [&](const auto& leaf)
    {
      return leaf.Display.Visible &&
        (leaf.Display.Opacity.value_or(1.0) < 1.0 || opacities.IsTranslucent(leaf.Data) ||
          this->HasTranslucentColors(leaf.Data));
    });
}

//------------------------------------------------------------------------------
vtkBoundingBox vtkTrajectoryMapper::Parts::GetBounds()
{
  this->UpdateNodes();
  vtkBoundingBox bounds;
  const auto& leaves = this->Nodes.GetLeaves();
  for (std::size_t i = 0; i < leaves.size(); ++i)
  {
    if (leaves[i].Display.Visible)
    {
      bounds.AddBox(this->Nodes.GetBounds(i));
    }
  }
  for (const auto& part : this->Polygons)
  {
    if (leaves[part->Leaf].Display.Visible)
    {
      double cells[6];
      leaves[part->Leaf].Data->GetCellsBounds(cells);
      bounds.AddBounds(cells);
    }
  }
  return bounds;
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::Select(
  vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels, vtkProp* prop)
{
  const unsigned char* parts =
    selector->GetRawPixelBuffer(vtkHardwareSelector::COMPOSITE_INDEX_PASS);
  if (!parts)
  {
    return;
  }
  std::vector<unsigned int> conePixels;
  std::vector<std::vector<unsigned int>> polygonPixels(this->Polygons.size());
  for (const unsigned int pixel : pixels)
  {
    const unsigned int part = DecodePixel(parts, nullptr, pixel);
    if (part == ConePart)
    {
      conePixels.push_back(pixel);
    }
    else if (part - FirstPolygonPart < this->Polygons.size())
    {
      polygonPixels[part - FirstPolygonPart].push_back(pixel);
    }
  }
  this->SelectCones(selector, conePixels);

  unsigned char* composite = selector->GetPixelBuffer(vtkHardwareSelector::COMPOSITE_INDEX_PASS);
  for (std::size_t i = 0; i < this->Polygons.size(); ++i)
  {
    if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
    {
      for (const unsigned int pixel : polygonPixels[i])
      {
        EncodePixel(composite, pixel, this->Nodes.GetLeaves()[this->Polygons[i]->Leaf].FlatIndex);
      }
      continue;
    }
    vtkPolygonPartMapper* mapper = this->Polygons[i]->Mapper;
    mapper->SetPopulateSelectionSettings(1);
    mapper->ProcessSelectorPixelBuffers(selector, polygonPixels[i], prop);
    mapper->SetPopulateSelectionSettings(0);
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::Parts::SelectCones(
  vtkHardwareSelector* selector, const std::vector<unsigned int>& pixels) const
{
  const int pass = selector->GetCurrentPass();
  const bool points =
    pass == vtkHardwareSelector::POINT_ID_LOW24 || pass == vtkHardwareSelector::POINT_ID_HIGH24;
  const bool high =
    pass == vtkHardwareSelector::POINT_ID_HIGH24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
  const bool cells =
    pass == vtkHardwareSelector::CELL_ID_LOW24 || pass == vtkHardwareSelector::CELL_ID_HIGH24;
  const bool composite = pass == vtkHardwareSelector::COMPOSITE_INDEX_PASS;
  const unsigned char* rawLow = selector->GetRawPixelBuffer(
    points ? vtkHardwareSelector::POINT_ID_LOW24 : vtkHardwareSelector::CELL_ID_LOW24);
  const unsigned char* rawHigh = selector->GetRawPixelBuffer(
    points ? vtkHardwareSelector::POINT_ID_HIGH24 : vtkHardwareSelector::CELL_ID_HIGH24);
  unsigned char* buffer = selector->GetPixelBuffer(pass);
  // The selector renders the composite pass again once it has the ids that decide it.
  if (!(points || cells || composite) || !rawLow || !buffer)
  {
    return;
  }
  for (const unsigned int pixel : pixels)
  {
    const vtkIdType node = DecodePixel(rawLow, rawHigh, pixel);
    if (node >= this->Nodes.GetNumberOfNodes())
    {
      continue;
    }
    const vtkTrajectoryNodes::Run& run = this->Nodes.GetRun(node);
    const vtkIdType id = points ? this->Nodes.GetPointIds()[node]
      : cells                   ? run.Cell
                                : this->Nodes.GetLeaves()[run.Leaf].FlatIndex;
    EncodePixel(buffer, pixel, high ? id >> 24 : id);
  }
}

//------------------------------------------------------------------------------
vtkTrajectoryMapper::vtkTrajectoryMapper()
  : Drawing(std::make_unique<Parts>(this))
{
}

//------------------------------------------------------------------------------
vtkTrajectoryMapper::~vtkTrajectoryMapper()
{
  // While the parts are whole: their buffers belong to the window that drew them, which need not be
  // the one whose context is current.
  this->Drawing->ReleaseFromWindow();
  this->SetRadiusArray(nullptr);
  this->SetOpacityArray(nullptr);
}

//------------------------------------------------------------------------------
int vtkTrajectoryMapper::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::SetCompositeDataDisplayAttributes(
  vtkCompositeDataDisplayAttributes* attributes)
{
  if (this->BlockAttributes != attributes)
  {
    this->BlockAttributes = attributes;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkCompositeDataDisplayAttributes* vtkTrajectoryMapper::GetCompositeDataDisplayAttributes()
{
  return this->BlockAttributes;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkTrajectoryMapper::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->BlockAttributes ? std::max(time, this->BlockAttributes->GetMTime()) : time;
}

//------------------------------------------------------------------------------
double vtkTrajectoryMapper::GetEffectiveRadius()
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->Update();
  }
  this->Drawing->UpdateNodes();
  return this->Drawing->Nodes.GetRadius();
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::ComputeBounds()
{
  vtkMath::UninitializeBounds(this->Bounds);
  const vtkBoundingBox bounds = this->Drawing->GetBounds();
  if (bounds.IsValid())
  {
    bounds.GetBounds(this->Bounds);
  }
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor)
{
  this->InvokeEvent(vtkCommand::StartEvent, nullptr);
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  this->InvokeEvent(vtkCommand::EndEvent, nullptr);
  this->Drawing->Render(renderer, actor);
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Drawing->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
bool vtkTrajectoryMapper::HasTranslucentPolygonalGeometry()
{
  return this->Drawing->IsTranslucent();
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::ProcessSelectorPixelBuffers(
  vtkHardwareSelector* selector, std::vector<unsigned int>& pixels, vtkProp* prop)
{
  this->Drawing->Select(selector, pixels, prop);
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (vtkTrajectoryMapper* other = vtkTrajectoryMapper::SafeDownCast(mapper))
  {
    this->SetRadius(other->GetRadius());
    this->SetRadiusArray(other->GetRadiusArray());
    this->SetOpacityArray(other->GetOpacityArray());
    this->SetCompositeDataDisplayAttributes(other->GetCompositeDataDisplayAttributes());
  }
  this->Superclass::ShallowCopy(mapper);
}

//------------------------------------------------------------------------------
void vtkTrajectoryMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "RadiusArray: " << (this->RadiusArray ? this->RadiusArray : "(none)") << "\n";
  os << indent << "OpacityArray: " << (this->OpacityArray ? this->OpacityArray : "(none)") << "\n";
  os << indent << "CompositeDataDisplayAttributes: " << this->BlockAttributes.Get() << "\n";
}

VTK_ABI_NAMESPACE_END
