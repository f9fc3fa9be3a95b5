// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneCheck.h"

#include "OpenGLDebugOutput.h"
#include "ReferenceComparison.h"
#include "SceneBuilder.h"

#include "vtkActorCollection.h"
#include "vtkFloatArray.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkTrajectoryMapper.h"

#include <algorithm>
#include <cmath>

namespace pellucid
{
/** Keeps errors of VTK's objects; warnings, of points without a place for example, are expected. */
class MessageCounter : public vtkOutputWindow
{
public:
  static MessageCounter* New();
  vtkTypeMacro(MessageCounter, vtkOutputWindow);

  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayText(const char*) override {}

  std::vector<std::string> TakeErrors()
  {
    std::vector<std::string> errors;
    errors.swap(this->Errors);
    return errors;
  }

private:
  std::vector<std::string> Errors;
};
vtkStandardNewMacro(MessageCounter);

//------------------------------------------------------------------------------
/** A renderer in the window for as long as this lives. */
class SceneChecker::Frame
{
public:
  Frame(vtkRenderWindow* window, const SceneDescription& scene, BuildOrder order)
    : Window(window)
    , Renderer(MakeRenderer(scene, order))
  {
    this->Pass = vtkTransparencyInstaller::Install(this->Renderer);
    this->Pass->SetMemoryLimit(scene.MemoryLimit);
    this->Pass->SetGatherScale(scene.GatherScale);
    window->AddRenderer(this->Renderer);
  }

  ~Frame()
  {
    vtkTransparencyInstaller::Uninstall(this->Renderer);
    this->Window->RemoveRenderer(this->Renderer);
  }

  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  vtkRenderWindow* Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkExactTransparencyPass* Pass;
};

namespace
{
/** Opacities are in [0,1], or -1 for segments that no fragment shows. */
bool HasValidOpacities(vtkRenderer* renderer, vtkExactTransparencyPass* pass, bool& areOptimized)
{
  bool areValid = true;
  vtkCollectionSimpleIterator iterator;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal(iterator);
  while (vtkActor* actor = actors->GetNextActor(iterator))
  {
    const auto opacities = pass->GetOptimizedOpacities(actor);
    areOptimized |= opacities != nullptr;
    for (vtkIdType i = 0; opacities && i < opacities->GetNumberOfValues(); ++i)
    {
      const float opacity = opacities->GetValue(i);
      areValid &= opacity == -1.0f || (opacity >= 0.0f && opacity <= 1.0f);
    }
  }
  return areValid;
}

/** The automatic one follows from the data, and is large where the actor compensates a stretch. */
double GetRadiusOfLines(const SceneDescription& scene, const PropDescription& prop)
{
  const auto actor = MakeActor(scene, prop, BuildOrder::Forward);
  return vtkTrajectoryMapper::SafeDownCast(actor->GetMapper())->GetEffectiveRadius();
}

/**
 * Whether the eye or a plane opens a tube that bends within its own radius: pieces that are no
 * neighbours overlap, and which of their inner walls shows is nowhere defined.
 */
bool OpensOverlappingTubes(const SceneDescription& scene, const PropDescription& prop)
{
  if (prop.Kind != "lines" || prop.PointsPerCell <= 2)
  {
    return false;
  }
  const double radius = GetRadiusOfLines(scene, prop);
  const bool opens = scene.EyeInside || prop.ClippingPlane || radius > 0.5;
  return opens && (prop.Shape != "walk" || radius * prop.PointsPerCell > 0.5);
}

/**
 * Lines 500 times as long as they are apart turn back by less than 1e-3 from straight, and the
 * plane that halves such an angle is, in single precision and at the other end of the segment, off
 * by the radius. Such triangles are slivers, whose depths the rasteriser's grid of 1/256 pixel
 * moves.
 */
bool IsSteep(const SceneDescription& scene, const PropDescription& prop)
{
  const bool bends = prop.Kind == "lines" && prop.PointsPerCell > 2;
  const bool hasTriangles = prop.Kind == "sheets" || prop.Kind == "sphere";
  return scene.Stretch > 1.0 && !scene.Compensated && (bends || hasTriangles);
}

/**
 * From within tubes or balls far larger than the scene, their walls are too far away for depths of
 * single precision to tell which is nearer.
 */
bool HasDistantWalls(const SceneDescription& scene, const PropDescription& prop)
{
  return !scene.ParallelProjection && prop.Radius > 100.0 && prop.Cells > 1;
}

/**
 * A line that turns straight back has two surfaces at the same depth: which of their segments hides
 * the other is a matter of rounding.
 */
bool HasCoincidentSegments(const PropDescription& prop)
{
  return prop.Kind == "lines" && prop.Shape == "backward" && prop.Method != "none";
}

/** Two props of one form and seed are in the same places, so the same holds for them. */
bool HasCoincidentProps(const SceneDescription& scene)
{
  const auto& props = scene.Props;
  for (auto prop = props.begin(); prop != props.end(); ++prop)
  {
    const bool coincides = std::any_of(props.begin(), prop,
      [&](const PropDescription& other)
      {
        return other.Kind == prop->Kind && other.Seed == prop->Seed &&
          (other.Method != "none" || prop->Method != "none");
      });
    if (coincides)
    {
      return true;
    }
  }
  return false;
}

/**
 * The edges of opaque props are smoothed by samples, which the reference does not do. Nor does it
 * round depths to single precision, which in a perspective of 1e9 merges all of the scene.
 */
bool HasReference(const SceneDescription& scene)
{
  return KeepsDepths(scene) && !HasCoincidentProps(scene) &&
    std::none_of(scene.Props.begin(), scene.Props.end(),
      [&](const PropDescription& prop)
      {
        return (scene.Samples > 0 && IsOpaque(prop)) || OpensOverlappingTubes(scene, prop) ||
          IsSteep(scene, prop) || HasDistantWalls(scene, prop) || HasCoincidentSegments(prop);
      });
}

/**
 * How many pixels may show a part that is narrower than the grid of 1/256 pixel to which OpenGL
 * moves corners, so that no displaced ray meets it, or none that has the normal beyond its edge:
 * the tip of a cone, a sheet or the facet of a sphere that is seen from its edge.
 */
vtkIdType GetMostSliverPixels(const SceneDescription& scene)
{
  const bool hasSlivers = std::any_of(scene.Props.begin(), scene.Props.end(),
    [](const PropDescription& prop) { return prop.Kind != "lines" && prop.Kind != "balls"; });
  return hasSlivers ? 1 + scene.Width * scene.Height / 2000 : 0;
}

/** How many pixels may be nearer to an edge than OpenGL can tell: the more layers, the more edges;
 * a few of a small picture, but never more than a twentieth. */
vtkIdType GetMostSilhouettePixels(vtkIdType pixels, vtkIdType fragments)
{
  const vtkIdType most = std::max<vtkIdType>(1, pixels / 20);
  return std::clamp<vtkIdType>(
    std::max(pixels, fragments) / 200, std::min<vtkIdType>(8, most), most);
}

bool HasOptimization(const SceneDescription& scene)
{
  return std::any_of(scene.Props.begin(), scene.Props.end(),
    [](const PropDescription& prop) { return prop.Method == "optimization"; });
}

/** How many pixels may be unlike the reference at their centre and like it nearby. Smoothed
 * attributes and the opacities of segments depend on silhouette pixels; else it is the shading of
 * steep facets. */
vtkIdType GetMostDependentPixels(const SceneDescription& scene, vtkIdType silhouettePixels)
{
  const bool spreads = HasOptimization(scene) ||
    std::any_of(scene.Props.begin(), scene.Props.end(),
      [](const PropDescription& prop) { return prop.Method != "none" && prop.SmoothAttributes; });
  return spreads ? std::max<vtkIdType>(1, scene.Width * scene.Height / 200) + silhouettePixels : 2;
}
}

//------------------------------------------------------------------------------
void SceneFigures::Print(std::ostream& os) const
{
  const double root =
    this->ComparedPixels > 0 ? std::sqrt(this->SquaredErrors / this->ComparedPixels) : 0.0;
  os << this->Scenes << " scenes, " << this->OptimizedScenes << " with optimised opacities, "
     << this->TiledScenes << " in tiles; " << this->Frames << " frames, " << this->Fragments
     << " fragments, longest list " << this->LongestList << "; " << this->ComparedPixels
     << " pixels compared: maximum " << this->LargestDifference << ", RMSE " << root << " of 255; "
     << this->SilhouettePixels << " silhouette pixels, " << this->DependentPixels
     << " that depend on others of these, " << this->SliverPixels << " of slivers" << std::endl;
}

//------------------------------------------------------------------------------
SceneChecker::SceneChecker()
{
  vtkOutputWindow::SetInstance(this->Messages);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

//------------------------------------------------------------------------------
SceneChecker::~SceneChecker()
{
  vtkOutputWindow::SetInstance(nullptr);
}

//------------------------------------------------------------------------------
void SceneChecker::PrepareWindow(const SceneDescription& scene)
{
  // VTK and Mesa keep all shaders of a window, some megabytes for each scene.
  if (this->Figures.Scenes % 100 == 0)
  {
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Window->OffScreenRenderingOn();
  }
  this->Window->SetSize(scene.Width, scene.Height);
  this->Window->SetMultiSamples(scene.Samples);
  this->Window->SetAlphaBitPlanes(scene.TransparentBackground);
}

//------------------------------------------------------------------------------
void SceneChecker::CompareWithReference(
  const SceneDescription& scene, Frame& frame, std::vector<std::string>& problems)
{
  const ReferenceComparison comparison(this->Window, frame.Renderer);
  const vtkIdType pixels = static_cast<vtkIdType>(scene.Width) * scene.Height;
  const vtkIdType compared =
    pixels - comparison.GetSilhouettePixels() - comparison.GetUnexplainedPixels();
  const double root = comparison.GetRootMeanSquare();
  this->Figures.ComparedPixels += compared;
  this->Figures.SilhouettePixels += comparison.GetSilhouettePixels();
  this->Figures.DependentPixels += comparison.GetDependentPixels();
  this->Figures.Fragments += comparison.GetNumberOfFragments();
  this->Figures.LongestList = std::max(this->Figures.LongestList, comparison.GetLongestList());
  this->Figures.LargestDifference =
    std::max(this->Figures.LargestDifference, comparison.GetLargestDifference());
  this->Figures.SquaredErrors += root * root * compared;
  const auto complain = [&](vtkIdType count, const std::string& what)
  {
    problems.push_back(std::to_string(count) + " of " + std::to_string(pixels) + " pixels " + what);
  };
  const vtkIdType slivers = comparison.GetUnexplainedPixels() - comparison.GetDependentPixels();
  this->Figures.SliverPixels += slivers;
  if (slivers > GetMostSliverPixels(scene))
  {
    comparison.DescribeUnexplained();
    complain(slivers, "differ from the reference without explanation");
  }
  const vtkIdType silhouettes = HasOptimization(scene)
    ? std::min(comparison.GetSilhouettePixels(), comparison.GetFewestDifferences())
    : comparison.GetSilhouettePixels();
  if (silhouettes > GetMostSilhouettePixels(pixels, comparison.GetNumberOfFragments()))
  {
    complain(silhouettes, "show the other side of an edge, which is too many");
  }
  if (comparison.GetDependentPixels() > GetMostDependentPixels(scene, silhouettes))
  {
    complain(comparison.GetDependentPixels(), "depend on silhouette pixels, which is too many");
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> SceneChecker::Check(const SceneDescription& scene)
{
  std::vector<std::string> problems;
  this->PrepareWindow(scene);
  const OpenGLDebugOutput debugOutput(this->Window);
  const auto require = [&](bool holds, const std::string& problem)
  {
    ++this->Figures.Frames;
    if (!holds)
    {
      problems.push_back(problem);
    }
  };
  {
    Frame frame(this->Window, scene, BuildOrder::Forward);
    const Picture picture = Picture::Render(this->Window);
    bool areOptimized = false;
    require(HasValidOpacities(frame.Renderer, frame.Pass, areOptimized), "an opacity is invalid");
    this->Figures.OptimizedScenes += areOptimized;
    this->Figures.TiledScenes += frame.Pass->GetStatistics()->GetTiles() > 1;
    require(Picture::Render(this->Window) == picture, "the second frame has other bits");
    if (HasReference(scene))
    {
      this->CompareWithReference(scene, frame, problems);
    }
    if (scene.MemoryLimit == 1)
    {
      frame.Pass->SetMemoryLimit(1024);
      require(Picture::Render(this->Window) == picture, "the memory limit changes bits");
    }
    const Frame other(this->Window, scene, BuildOrder::Shuffled);
    this->Window->RemoveRenderer(frame.Renderer);
    require(Picture::Render(this->Window) == picture, "another order has other bits");
  }
  ++this->Figures.Scenes;
  for (const std::string& error : this->Messages->TakeErrors())
  {
    problems.push_back(error);
  }
  if (debugOutput.GetNumberOfMessages() > 0)
  {
    problems.emplace_back("OpenGL has complained");
  }
  return problems;
}
}
