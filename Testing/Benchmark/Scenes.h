// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   What is drawn: data, camera and light, the same bits in every run.
 */

#ifndef Scenes_h
#define Scenes_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <functional> // for scenes that are made when they are wanted
#include <map>        // for the forms
#include <string>     // for names
#include <vector>     // for the list

class vtkActor;
class vtkRenderer;

namespace pellucid
{
namespace benchmark
{
/** In which form a method draws the lines and points of a scene. */
enum class Geometry
{
  Trajectories, // vtkTrajectoryMapper: ray-cast rounded cones and balls
  Segments,     // the same, divided into segments that have an importance
  Triangles     // vtkPolyDataMapper: tubes of 8 sides and balls of 8 x 8
};

/** Surfaces are triangles in all forms. */
class Scene
{
public:
  /** Lines and vertices get the radius, in world units; 0 stands for polygons. Points have colours
   * as scalars. */
  Scene(std::string name, vtkSmartPointer<vtkPolyData> data, double radius);

  const std::string& GetName() const { return this->Name; }

  /** Draw both walls of tubes and balls that are triangles, as VTK does by default; else only the
   * outer ones, which are all that vtkTrajectoryMapper draws. */
  void SetDrawsInnerWalls(bool draws) { this->DrawsInnerWalls = draws; }

  /** Whether the scene is of polygons, and so looks the same in all forms. */
  bool HasPolygons() const { return this->Radius == 0.0; }

  /** Number of segments of lines; of polygons, where these are all. */
  vtkIdType GetNumberOfSegments() const;

  /** Memory to draw the form, or to draw it and the reference beside it: a rough estimate for large
   * scenes, from what VTK 9.2 took with OpenGL on the processor. */
  double EstimateBytes(Geometry form, bool withReference) const;

  /** Forget the data of all forms but this one; what is wanted again is made again. */
  void ReleaseOtherForms(Geometry form);

  /** Put an actor of that form and opacity into the renderer, with background and camera. The data
   * of a form is made once. */
  vtkActor* AddTo(vtkRenderer* renderer, Geometry form, double opacity);

private:
  vtkPolyData* GetForm(Geometry form);

  std::string Name;
  double Radius;
  bool DrawsInnerWalls = false;
  std::map<Geometry, vtkSmartPointer<vtkPolyData>> Forms;
};

/** Scenes of one kind and different size. */
struct SceneFamily
{
  std::string Name; // of a single scene; the prefix "NAME-" of the others
  std::string Description;
  std::vector<int> Sizes; // those that --list names; empty for a single scene
  int LargestSize = 0;    // the others have any size from 1 to this
  std::function<Scene(const std::string& name, int size)> Make;
};

/** All scenes; `dataFolder` is Data/ of the source tree. */
std::vector<SceneFamily> MakeSceneFamilies(const std::string& dataFolder);

/** Streamlines of the ABC flow, 4.95 units long, in that many segments each, from random seeds. */
Scene MakeABCFlow(const std::string& name, int lines, int segmentsPerLine);
}
}

#endif
