// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    SceneDescription.h
 * @brief   A random scene in few numbers and words: what a failure prints and a replay reads, as
 * JSON.
 *
 * The first value that each comment lists is the simplest one, which shrinking aims at.
 */

#ifndef SceneDescription_h
#define SceneDescription_h

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>
#include <vector>

namespace pellucid
{
struct PropDescription
{
  std::string Kind = "lines"; ///< lines, balls, sphere, sheets, glyphs
  std::string Shape = "walk"; ///< of lines: walk, kinks, repeats, backward
  std::string Mapper = "";    ///< of surfaces: vtkPolyDataMapper, vtkTrajectoryMapper
  int Seed = 0;
  int Cells = 1; ///< lines, balls, sheets or glyphs
  int PointsPerCell = 2;
  bool Turned = true;  ///< of spheres: out of the axes
  double Radius = 0.1; ///< 0: the automatic one
  bool RadiusArray = false;
  double Opacity = 0.5;
  bool OpacityArray = false;
  std::string Colors = "property"; ///< property, table, opacities, texture
  bool Lighting = false;
  bool ClippingPlane = false;
  bool MissingPoints = false;             ///< coordinates that are not finite
  std::string Importance = "constant";    ///< constant, wave, wild
  std::vector<double> Range = { 0., 1. }; ///< of importance
  std::string Method = "none";            ///< none, optimization, penalty, weighting
  int Segments = 0;                       ///< 0: undivided
  double OcclusionWeight = 0.0;
  double ClutterWeight = 0.0;
  double Emphasis = 1.0;
  int SmoothingIterations = 0;
  bool SelfOcclusion = false;
  bool SmoothAttributes = false;
  double Penalty = 0.25;
};

struct SceneDescription
{
  int Width = 61;
  int Height = 47;
  int Samples = 0;
  int MemoryLimit = 1024; ///< MiB
  int GatherScale = 1;
  bool TransparentBackground = false;
  bool ParallelProjection = true;
  double Azimuth = 0.0;
  double Elevation = 0.0;
  double Zoom = 1.0;
  bool EyeInside = false;      ///< at a point of the first prop
  double NearToFar = 0.0;      ///< ratio of the clipping range; 0: the automatic range
  double Offset = 0.0;         ///< of all coordinates
  double Stretch = 1.0;        ///< factor on heights, in data
  bool Compensated = true;     ///< whether the actors undo that, as ParaView's scaled axes do
  std::string Lights = "none"; ///< none: the headlight; scene, spot, many
  std::vector<PropDescription> Props;
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PropDescription, Kind, Shape, Mapper, Seed, Cells, PointsPerCell,
  Turned, Radius, RadiusArray, Opacity, OpacityArray, Colors, Lighting, ClippingPlane,
  MissingPoints, Importance, Range, Method, Segments, OcclusionWeight, ClutterWeight, Emphasis,
  SmoothingIterations, SelfOcclusion, SmoothAttributes, Penalty)

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SceneDescription, Width, Height, Samples, MemoryLimit,
  GatherScale, TransparentBackground, ParallelProjection, Azimuth, Elevation, Zoom, EyeInside,
  NearToFar, Offset, Stretch, Compensated, Lights, Props)

/** As RapidCheck prints a counterexample. */
inline std::ostream& operator<<(std::ostream& os, const SceneDescription& scene)
{
  return os << nlohmann::json(scene).dump(2);
}
}

#endif
