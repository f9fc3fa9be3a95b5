// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Visibility, colour, opacity and pickability of blocks: pictures as of one actor for each block
// and as the reference draws them, selections, bounds, translucency, and what a change makes again.
#include "FrameStages.h"
#include "SegmentedScene.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

#include <functional>
#include <optional>
#include <set>
#include <sstream>

namespace
{
constexpr int NumberOfLeaves = 4;
constexpr double Red[3] = { 0.9, 0.1, 0.2 };
constexpr double Green[3] = { 0.1, 0.7, 0.3 };

/** Lines, balls and a quad, elsewhere for each number. */
vtkSmartPointer<vtkPolyData> MakeLeaf(int number)
{
  vtkSmartPointer<vtkPolyData> data = MakeLines(3, 40, 0);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(4);
  for (int i = 0; i < 4; ++i)
  {
    const double angle = 0.5 * vtkMath::Pi() * i;
    polygons->InsertCellPoint(
      data->GetPoints()->InsertNextPoint(0.9 * std::cos(angle), 0.2, 1.0 + 0.6 * std::sin(angle)));
    data->GetPointData()->GetScalars()->InsertNextTuple1(0.5 * i - 1.0);
    data->GetPointData()->GetArray("Radius")->InsertNextTuple1(0.05);
  }
  data->SetPolys(polygons);
  const double cosine = std::cos(1.5 * number);
  const double sine = std::sin(1.5 * number);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    data->GetPoints()->SetPoint(i, p[0], cosine * p[1] - sine * p[2], sine * p[1] + cosine * p[2]);
  }
  return data;
}

/** Composite data with leaves 0 to 3, of which 1 and 2 are in a group. */
struct Blocks
{
  vtkSmartPointer<vtkPolyData> Leaves[NumberOfLeaves];
  unsigned int FlatIndices[NumberOfLeaves];
  vtkSmartPointer<vtkDataObject> Group;
  vtkSmartPointer<vtkDataObject> Root;
};

using LeafMaker = std::function<vtkSmartPointer<vtkPolyData>(int)>;

Blocks MakeMultiBlock(const LeafMaker& makeLeaf = MakeLeaf)
{
  Blocks blocks{ {}, { 1, 5, 6, 7 }, nullptr, nullptr };
  std::generate(blocks.Leaves, blocks.Leaves + NumberOfLeaves,
    [&makeLeaf, number = 0]() mutable { return makeLeaf(number++); });
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, blocks.Leaves[1]);
  group->SetBlock(1, blocks.Leaves[2]);
  vtkNew<vtkMultiBlockDataSet> root;
  root->SetBlock(0, blocks.Leaves[0]);
  root->SetBlock(1, vtkNew<vtkPolyData>()); // without points
  root->SetBlock(3, group);                 // the one before is missing
  root->SetBlock(4, blocks.Leaves[3]);
  blocks.Group = group.Get();
  blocks.Root = root.Get();
  return blocks;
}

Blocks MakeCollection()
{
  Blocks blocks{ {}, { 2, 4, 5, 7 }, nullptr, nullptr };
  std::generate(blocks.Leaves, blocks.Leaves + NumberOfLeaves,
    [number = 0]() mutable { return MakeLeaf(number++); });
  vtkNew<vtkPartitionedDataSetCollection> root;
  root->SetPartition(0, 0, blocks.Leaves[0]);
  root->SetPartition(1, 0, blocks.Leaves[1]);
  root->SetPartition(1, 1, blocks.Leaves[2]);
  root->SetPartition(2, 0, blocks.Leaves[3]);
  blocks.Group = root->GetPartitionedDataSet(1);
  blocks.Root = root.Get();
  return blocks;
}

struct BlockScene : SphereScene
{
  explicit BlockScene(const Blocks& blocks)
    : SphereScene(200, 150, 0, 0, 1)
    , Data(blocks)
  {
    this->Actor = this->AddTrajectories(blocks.Root);
    this->Mapper = vtkTrajectoryMapper::SafeDownCast(this->Actor->GetMapper());
    this->Mapper->SetCompositeDataDisplayAttributes(this->Attributes);
  }

  vtkSmartPointer<vtkActor> AddTrajectories(vtkDataObject* data)
  {
    vtkNew<vtkTrajectoryMapper> mapper;
    mapper->SetInputDataObject(data);
    mapper->SetRadius(0.06);
    mapper->SetScalarRange(-1.0, 1.0);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor.Get();
  }

  Picture RenderExact()
  {
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
    return Picture::Render(this->Window);
  }

  bool CanSelect(unsigned int index)
  {
    vtkNew<vtkHardwareSelector> selector;
    selector->SetRenderer(this->Renderer);
    selector->SetArea(0, 0, 199, 149);
    const auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
    for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
    {
      vtkInformation* properties = selection->GetNode(i)->GetProperties();
      if (properties->Get(vtkSelectionNode::PROP()) == this->Actor &&
        properties->Get(vtkSelectionNode::COMPOSITE_INDEX()) == static_cast<int>(index))
      {
        return true;
      }
    }
    return false;
  }

  Blocks Data;
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  vtkSmartPointer<vtkActor> Actor;
  vtkTrajectoryMapper* Mapper;
  vtkExactTransparencyPass* Pass = nullptr;
};

/** How a leaf looks in the end. */
struct Look
{
  std::optional<double> Opacity;
  const double* Color = nullptr;
  bool Visible = true;
};

/** What is set for blocks, and what the leaves look like. */
struct Case
{
  std::string Name;
  std::function<void(BlockScene&)> Prepare;
  Look Looks[NumberOfLeaves];
};

const Case Cases[] = {
  { "nothing set", [](BlockScene&) {}, {} },
  { "colours",
    [](BlockScene& s)
    {
      s.Attributes->SetBlockColor(s.Data.Leaves[0], Red);
      s.Attributes->SetBlockColor(s.Data.Group, Green);
      s.Attributes->SetBlockColor(s.Data.Leaves[2], Red);
    },
    { { {}, Red }, { {}, Green }, { {}, Red }, {} } },
  { "colours without scalars",
    [](BlockScene& s)
    {
      s.Mapper->ScalarVisibilityOff();
      s.Actor->GetProperty()->SetColor(0.2, 0.3, 0.9);
      s.Actor->GetProperty()->SetAmbient(0.2);
      s.Actor->GetProperty()->SetSpecular(0.4);
      s.Attributes->SetBlockColor(s.Data.Group, Green);
    },
    { {}, { {}, Green }, { {}, Green }, {} } },
  { "opacities",
    [](BlockScene& s)
    {
      s.Attributes->SetBlockOpacity(s.Data.Leaves[0], 0.3);
      s.Attributes->SetBlockOpacity(s.Data.Group, 0.6);
      s.Attributes->SetBlockOpacity(s.Data.Leaves[1], 0.8);
    },
    { { 0.3 }, { 0.8 }, { 0.6 }, {} } },
  { "opacities in place of the property's",
    [](BlockScene& s)
    {
      s.Actor->GetProperty()->SetOpacity(0.5);
      s.Attributes->SetBlockOpacity(s.Data.Group, 1.0);
      s.Attributes->SetBlockOpacity(s.Data.Leaves[3], 0.2);
    },
    { {}, { 1.0 }, { 1.0 }, { 0.2 } } },
  { "visibilities",
    [](BlockScene& s)
    {
      s.Attributes->SetBlockVisibility(s.Data.Root, false);
      s.Attributes->SetBlockVisibility(s.Data.Group, true);
      s.Attributes->SetBlockVisibility(s.Data.Leaves[2], false);
      s.Attributes->SetBlockVisibility(s.Data.Leaves[3], true);
      s.Attributes->SetBlockColor(s.Data.Root, Red);
      s.Attributes->SetBlockOpacity(s.Data.Root, 0.7);
    },
    { { 0.7, Red, false }, { 0.7, Red }, { 0.7, Red, false }, { 0.7, Red } } },
};

/** Pixels that differ by more than rounding. */
int CountDifferences(const Picture& a, const Picture& b)
{
  int count = 0;
  for (std::size_t i = 0; i < a.Rgba.size(); i += 4)
  {
    count += std::abs(a.Rgba[i] - b.Rgba[i]) > 1 || std::abs(a.Rgba[i + 1] - b.Rgba[i + 1]) > 1 ||
      std::abs(a.Rgba[i + 2] - b.Rgba[i + 2]) > 1;
  }
  return count;
}

// One actor for each leaf shows the same, and has the same bounds.
bool TestAsActors(const Case& test, const Blocks& blocks)
{
  BlockScene scene(blocks);
  OpenGLDebugOutput debugOutput(scene.Window);
  test.Prepare(scene);
  const Picture shown = scene.RenderExact();
  const std::string name = test.Name + " in a " + blocks.Root->GetClassName();
  bool passed =
    Check(CountDifferences(shown, BlockScene(blocks).RenderExact()) > 500 || &test == Cases,
      name + ": not seen");

  scene.Renderer->RemoveActor(scene.Actor);
  vtkBoundingBox bounds;
  for (int i = 0; i < NumberOfLeaves; ++i)
  {
    const Look& look = test.Looks[i];
    const vtkSmartPointer<vtkActor> actor = scene.AddTrajectories(blocks.Leaves[i]);
    actor->GetMapper()->SetScalarVisibility(!look.Color && scene.Mapper->GetScalarVisibility());
    actor->GetProperty()->DeepCopy(scene.Actor->GetProperty());
    actor->GetProperty()->SetOpacity(look.Opacity.value_or(actor->GetProperty()->GetOpacity()));
    if (look.Color)
    {
      actor->GetProperty()->SetDiffuseColor(look.Color[0], look.Color[1], look.Color[2]);
      actor->GetProperty()->SetAmbientColor(look.Color[0], look.Color[1], look.Color[2]);
    }
    actor->SetVisibility(look.Visible);
    if (look.Visible)
    {
      bounds.AddBounds(actor->GetMapper()->GetBounds());
    }
  }
  // Outlines: nodes are rounded about the middle of what a mapper draws.
  const int differences = CountDifferences(shown, Picture::Render(scene.Window));
  std::cout << name << ": " << differences << " pixels\n";
  passed &= Check(differences <= 10, name + ": not as one actor for each block");
  passed &= Check(vtkBoundingBox(scene.Mapper->GetBounds()) == bounds, name + ": wrong bounds");
  return passed;
}

// A block keeps the opacity of scalars and of the opacity array, whatever its colour.
bool TestReference()
{
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(0.1, 1.0);
  table->SetRange(-1.0, 1.0);
  table->Build();
  const std::pair<const char*, std::function<void(BlockScene&)>> ways[] = {
    { "", [](BlockScene&) {} },
    { " and a table with opacities",
      [&](BlockScene& s)
      {
        s.Mapper->SetLookupTable(table);
        s.Attributes->SetBlockColor(s.Data.Leaves[3], Red);
      } },
    { " and interpolated scalars",
      [&](BlockScene& s)
      {
        s.Mapper->SetLookupTable(table);
        s.Mapper->InterpolateScalarsBeforeMappingOn();
        s.Attributes->SetBlockColor(s.Data.Leaves[3], Red);
      } },
    { " and factors",
      [](BlockScene& s)
      {
        s.Mapper->SetOpacityArray("Value");
        s.Mapper->SetRadiusArray("Radius");
      } },
  };
  bool passed = true;
  for (const Case& test : Cases)
  {
    for (const auto& [name, prepare] : ways)
    {
      BlockScene scene(MakeMultiBlock());
      test.Prepare(scene);
      prepare(scene);
      passed &= Compare(scene, test.Name + name);
    }
  }
  return passed;
}

// Segments are numbered over all blocks, also those that are invisible or empty.
bool TestImportance()
{
  const auto makeLeaf = [](int number)
  {
    vtkSmartPointer<vtkPolyData> data = MakeLeaf(number);
    data->SetPolys(nullptr);
    AddImportance(data, Wave);
    return DivideLines(data, 40);
  };
  bool passed = true;
  for (const bool optimizes : { true, false })
  {
    BlockScene scene(MakeMultiBlock(makeLeaf));
    scene.Attributes->SetBlockVisibility(scene.Data.Leaves[1], false);
    scene.Attributes->SetBlockOpacity(scene.Data.Leaves[2], 0.6);
    scene.Attributes->SetBlockColor(scene.Data.Leaves[3], Red);
    scene.Actor->GetProperty()->SetOpacity(0.9);
    if (optimizes)
    {
      Optimize(scene.Actor, 20.0, 5.0, 1.5, 5, true);
    }
    else
    {
      Avoid(scene.Actor, vtkOcclusionAvoidance::PENALTY, false);
    }
    passed &= Compare(scene, optimizes ? "optimised opacities" : "occlusion avoidance");
  }
  return passed;
}

bool TestSelection(const Blocks& blocks)
{
  BlockScene scene(blocks);
  scene.Window->Render();
  bool passed = true;
  const auto check = [&](const std::string& when, const std::set<int>& expected)
  {
    for (int i = 0; i < NumberOfLeaves; ++i)
    {
      passed &= Check(scene.CanSelect(blocks.FlatIndices[i]) == (expected.count(i) > 0),
        "selection of leaf " + std::to_string(i) + " " + when);
    }
  };
  check("where nothing is set", { 0, 1, 2, 3 });
  scene.Attributes->SetBlockVisibility(blocks.Leaves[0], false);
  scene.Attributes->SetBlockPickability(blocks.Group, false);
  scene.Attributes->SetBlockPickability(blocks.Leaves[1], true);
  check("where two are left", { 1, 3 });
  scene.Attributes->SetBlockOpacity(blocks.Leaves[1], 0.4);
  scene.RenderExact();
  check("where one is translucent", { 1, 3 });
  scene.Attributes->RemoveBlockPickabilities();
  check("where all visible ones are left", { 1, 2, 3 });
  return passed;
}

bool TestInvisible()
{
  BlockScene scene(MakeMultiBlock());
  scene.Actor->VisibilityOff();
  const Picture nothing = scene.RenderExact();
  scene.Actor->VisibilityOn();
  scene.Actor->GetProperty()->SetOpacity(0.5);
  scene.Attributes->SetBlockVisibility(scene.Data.Root, false);
  bool passed = Check(Picture::Render(scene.Window) == nothing, "what is invisible is seen");
  passed &=
    Check(scene.Pass->GetStatistics()->GetFragments() == 0, "what is invisible leaves fragments");
  passed &= Check(!vtkMath::AreBoundsInitialized(scene.Mapper->GetBounds()),
    "what is invisible counts for the bounds");
  return passed;
}

bool TestIsTranslucent()
{
  BlockScene scene(MakeMultiBlock());
  const auto isTranslucent = [&scene]
  { return scene.Actor->HasTranslucentPolygonalGeometry() && !scene.Actor->HasOpaqueGeometry(); };
  bool passed = Check(!isTranslucent(), "translucent where nothing is set");
  scene.Attributes->SetBlockOpacity(scene.Data.Group, 0.5);
  passed &= Check(isTranslucent(), "a translucent group is not seen");
  scene.Attributes->SetBlockOpacity(scene.Data.Leaves[1], 1.0);
  passed &= Check(isTranslucent(), "a translucent leaf is not seen");
  scene.Attributes->SetBlockVisibility(scene.Data.Leaves[2], false);
  passed &= Check(!isTranslucent(), "translucent by an invisible leaf");
  return passed;
}

// A change shows in the next frame, makes neither nodes nor vertices again, and costs no more then.
bool TestChanges()
{
  const std::pair<const char*, std::function<void(BlockScene&)>> changes[] = {
    { "visibility", [](BlockScene& s) { s.Attributes->SetBlockVisibility(s.Data.Group, false); } },
    { "colour", [](BlockScene& s) { s.Attributes->SetBlockColor(s.Data.Leaves[0], Green); } },
    { "opacity", [](BlockScene& s) { s.Attributes->SetBlockOpacity(s.Data.Leaves[3], 0.2); } },
    { "removed opacity", [](BlockScene& s) { s.Attributes->RemoveBlockOpacities(); } },
    { "no attributes",
      [](BlockScene& s) { s.Mapper->SetCompositeDataDisplayAttributes(nullptr); } },
  };
  bool passed = true;
  for (const auto& change : changes)
  {
    const std::string name = change.first;
    const auto prepare = [](BlockScene& scene)
    {
      scene.Actor->GetProperty()->SetOpacity(0.7);
      scene.Attributes->SetBlockOpacity(scene.Data.Group, 0.4);
    };
    BlockScene scene(MakeMultiBlock());
    prepare(scene);
    const Picture before = scene.RenderExact();
    // In memory only, so they stay in the picture as long as nothing is made again from them.
    const bool keepsBuffers = name != "no attributes";
    for (vtkPolyData* leaf : scene.Data.Leaves)
    {
      for (vtkIdType i = 0; keepsBuffers && i < leaf->GetNumberOfPoints(); ++i)
      {
        leaf->GetPoints()->SetPoint(i, 0.0, 0.0, 0.0);
      }
    }
    change.second(scene);
    const Picture after = Picture::Render(scene.Window);
    passed &= Check(RanStage(scene.Pass, "gather"), name + ": no new fragments");
    BlockScene fresh(MakeMultiBlock());
    prepare(fresh);
    change.second(fresh);
    passed &= Check(after == fresh.RenderExact(), name + ": not as in a new scene");
    passed &= Check(CountDifferences(after, before) > 500, name + ": not seen");
    passed &=
      Check(Picture::Render(scene.Window) == after && GetStages(scene.Pass) == UnchangedStages,
        name + ": the third frame is not as the second");
  }
  return passed;
}

bool TestCopy()
{
  BlockScene scene(MakeMultiBlock());
  scene.Attributes->SetBlockOpacity(scene.Data.Group, 0.5);
  vtkNew<vtkTrajectoryMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  std::ostringstream printed;
  copy->Print(printed);
  bool passed = Check(copy->GetCompositeDataDisplayAttributes() == scene.Attributes &&
      copy->HasTranslucentPolygonalGeometry() &&
      printed.str().find("CompositeDataDisplayAttributes: 0x") != std::string::npos,
    "a copy lacks the attributes");
  const vtkMTimeType time = copy->GetMTime();
  scene.Attributes->SetBlockOpacity(scene.Data.Group, 0.6);
  passed &= Check(copy->GetMTime() > time, "the time of the mapper is not that of the attributes");
  return passed;
}
}

int TestTrajectoryMapperBlocks(int, char*[])
{
  bool passed = true;
  for (const Blocks& blocks : { MakeMultiBlock(), MakeCollection() })
  {
    for (const Case& test : Cases)
    {
      passed &= TestAsActors(test, blocks);
    }
    passed &= TestSelection(blocks);
  }
  passed &= TestReference();
  passed &= TestImportance();
  passed &= TestInvisible();
  passed &= TestIsTranslucent();
  passed &= TestChanges();
  passed &= TestCopy();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
