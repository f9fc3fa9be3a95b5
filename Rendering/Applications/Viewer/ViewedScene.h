// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What the viewer shows: files, options, and the renderer that follows from them.
 */

#ifndef ViewedScene_h
#define ViewedScene_h

#include "SceneMaking.h"

#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <memory> // for what is made anew
#include <string>
#include <vector>

class vtkCamera;
class vtkExactTransparencyPass;

namespace pellucid
{
/** What a change of options needs, the least first. */
enum class Change
{
  None,
  Appearance, // other numbers for the same actors
  Renderer,   // other actors
  Scene       // other importance or colours
};

class ViewedScene
{
public:
  /** Of what changes it, what the panel may edit; Update() puts it into effect. */
  RenderOptions Options;

  explicit ViewedScene(const RenderOptions& options);

  /**
   * Take the files of the options, seen as the options say. Throw RenderError, and keep what is
   * shown, where one cannot be read or drawn.
   */
  void Open();

  /** Take other files; options that name arrays, ranges, radius or camera of the old ones end. */
  void Open(const std::vector<std::string>& fileNames);

  /** Let the options have effect; the camera stays. Throw RenderError where they cannot. */
  void Update(Change change);

  /** Put the camera where it was at first, for the size that the picture has now. */
  void ResetCamera();

  /** Of the picture. A camera that nobody has moved follows it, as ResetCamera() would. */
  void SetSize(int width, int height);

  /** Null before a file was opened, and another one after some changes. */
  vtkRenderer* GetRenderer() const { return this->Renderer; }

  /** The pass that draws the renderer; null where VTK's own methods do. */
  vtkExactTransparencyPass* GetPass() const { return this->Pass; }

  /** Counts of the data, and what importance came to. */
  const MadeScene* GetMade() const { return this->Made.get(); }

  /** Of lines and points, in world units: that of the options, or from the data. */
  double GetRadius() const;

  /** The arrays of the files, and those that can be computed. */
  const std::vector<std::string>& GetArrayNames() const { return this->ArrayNames; }

  /** As options of pellucid-render that make the same view: "--size 800x600 --camera-position...".
   */
  std::string DescribeView() const;

private:
  RenderOptions GetEffectiveOptions() const;
  std::string DescribeCamera() const;
  double GetAspect() const;

  /** By the camera of the options where there is none. Change nothing before all has succeeded. */
  void Show(const MadeScene& made, const RenderOptions& options, vtkCamera* camera);

  std::vector<Drawable> Drawables; // as read and traced
  std::vector<std::string> ArrayNames;
  std::string UnmovedCamera; // as DescribeCamera() told of it before anybody moved it
  std::unique_ptr<MadeScene> Made;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkExactTransparencyPass* Pass = nullptr; // of the renderer
};
}

#endif
