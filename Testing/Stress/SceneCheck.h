// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    SceneCheck.h
 * @brief   What has to hold for the picture of any scene.
 */

#ifndef SceneCheck_h
#define SceneCheck_h

#include "SceneDescription.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <memory>
#include <ostream>
#include <string>
#include <vector>

class OpenGLDebugOutput;
class ReferenceComparison;

namespace pellucid
{
class MessageCounter;

/** What the checked scenes come to. */
struct SceneFigures
{
  vtkIdType Scenes = 0;
  vtkIdType Frames = 0;
  vtkIdType ComparedPixels = 0;
  vtkIdType SilhouettePixels = 0;
  vtkIdType DependentPixels = 0; ///< on silhouette pixels
  vtkIdType SliverPixels = 0;    ///< that no displaced ray explains
  vtkIdType Fragments = 0;
  vtkIdType LongestList = 0;
  vtkIdType OptimizedScenes = 0;
  vtkIdType TiledScenes = 0;
  double LargestDifference = 0.0; ///< of compared pixels, of 255
  double SquaredErrors = 0.0;     ///< summed over compared pixels

  void Print(std::ostream& os) const;
};

/** Draws scenes in one window that they all share, and checks them. */
class SceneChecker
{
public:
  SceneChecker();
  ~SceneChecker();

  /// What is wrong with a scene; nothing as a rule.
  std::vector<std::string> Check(const SceneDescription& scene);

  const SceneFigures& GetFigures() const { return this->Figures; }

private:
  class Frame;

  void PrepareWindow(const SceneDescription& scene);
  void CompareWithReference(
    const SceneDescription& scene, Frame& frame, std::vector<std::string>& problems);

  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<MessageCounter> Messages;
  SceneFigures Figures;
};
}

#endif
