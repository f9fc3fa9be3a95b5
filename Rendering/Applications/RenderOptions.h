// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The command line of pellucid-render, as a value.
 */

#ifndef RenderOptions_h
#define RenderOptions_h

#include <array>    // for vectors and colours
#include <optional> // for what has no default
#include <string>   // for names
#include <vector>   // for the inputs

namespace pellucid
{
using Vector3 = std::array<double, 3>;
using NumberRange = std::array<double, 2>; // minimum, maximum

enum class Method
{
  Pellucid,  // exact transparency, ray-cast trajectories
  VTK,       // VTK's default translucent pass, tubes of eight sides
  VTKPeeling // VTK's dual depth peeling until nothing is left, tubes of eight sides
};

/** Where the seeds of streamlines lie; the values are those of vtkFieldStreamlines. */
enum class Seeding
{
  Volume = 0,
  Points = 1,
  Grid = 2,
  Line = 3
};

/** What z is; the values are those of vtkGeographicTrajectoryReader, here and below. */
enum class Vertical
{
  LogPressure = 0,
  Height = 1
};

enum class Longitudes
{
  Unwrap = 0,
  Cut = 1
};

/** How opacities follow from importance. */
enum class OpacityRule
{
  Factor,       // the importance is a factor on them
  Optimization, // vtkOpacityOptimization
  Penalty,      // vtkOcclusionAvoidance, and its other mode
  Weighting
};

/** What of the scene is shown; the values are those of vtkExactTransparencyPass. */
enum class ViewKind
{
  Picture = 0,
  Opacity = 1,
  Importance = 2,
  Segments = 3,
  Length = 4,
  FirstLayers = 5,
  Layer = 6
};

struct ViewChoice
{
  ViewKind Kind = ViewKind::Picture;
  int Layer = 1; // of the last two
};

/** Opacities that follow from importance; what has no value is as the class of the rule has it. */
struct OpacityOptions
{
  OpacityRule Rule = OpacityRule::Factor;
  std::optional<double> Emphasis;

  // optimisation
  bool Optimize = false;
  std::string Preset; // empty: the default one
  std::optional<double> OcclusionWeight;
  std::optional<double> ClutterWeight;
  std::optional<int> SmoothingIterations;
  bool SelfOcclusion = false;
  std::optional<int> GatherScale;

  // avoidance
  std::optional<double> Penalty;
  std::optional<double> ImportanceWeight;
  std::optional<double> CoverageWeight;
  std::optional<double> VarianceWeight;
  std::optional<double> DepthWeight;
  std::optional<double> GlobalOpacity;
  bool SmoothAttributes = false;

  ViewChoice Shown;
};

/** A limit of the range of an array: a number, or a percentile of its values. */
struct RangeLimit
{
  double Value = 0.0;
  bool IsPercentile = false; // then Value is 0 to 100
};

/** One array's part of the importance. */
struct ImportanceTerm
{
  std::string Array;
  RangeLimit Minimum;
  RangeLimit Maximum;
  double Weight = 1.0;
};

/** The lines to draw: those that have a value in the range. */
struct SelectionRange
{
  std::string Array;
  std::optional<RangeLimit> Minimum; // none: open
  std::optional<RangeLimit> Maximum;
};

struct RenderOptions
{
  std::vector<std::string> Inputs;
  std::string Output; // empty only where arrays are listed
  bool ListArrays = false;
  std::string StatisticsFile; // empty: none

  // picture
  std::array<int, 2> Size = { 1280, 960 };
  Vector3 Background = { 0.05, 0.06, 0.08 };
  bool TransparentBackground = false;

  // appearance
  std::string ColorBy; // empty: speed of traced lines, or the active or first array
  std::optional<NumberRange> ColorRange; // none: most of the values
  std::optional<double> Opacity;         // none: 1 with importance, else 0.3
  double Radius = 0.0;                   // world units; 0: from the data
  bool Lighting = true;

  // camera; what is not given follows from the data
  std::optional<Vector3> CameraPosition;
  std::optional<Vector3> FocalPoint;
  std::optional<Vector3> ViewUp;
  double ParallelScale = 0.0; // 0: perspective

  // importance and attributes
  std::vector<ImportanceTerm> Importance;
  double Exponent = 1.0;
  std::vector<SelectionRange> Selections;
  std::string Pressure;    // empty: the array that is commonly called so
  std::string Height;      // empty: the coordinate along the axis that points up
  int UpAxis = 2;          // 0 x, 1 y, 2 z
  double TimeWindow = 0.0; // unit of the time array; 0: the whole line

  OpacityOptions Opacities;

  // geographic trajectories
  int EnsembleMember = 0;
  Vertical VerticalAxis = Vertical::LogPressure;
  double VerticalScale = 0.0; // degrees; 0: the reader's default
  Longitudes LongitudeMode = Longitudes::Unwrap;
  double CentralLongitude = 0.0; // degrees

  // streamlines of fields
  int Seeds = 1000;
  Seeding SeedingMode = Seeding::Volume;
  int SeedOffset = 0;
  std::optional<Vector3> SeedLineFirst;
  std::optional<Vector3> SeedLineLast;
  std::string Vectors;        // empty: the active or first vectors
  double MaximumLength = 0.0; // world units; 0: from the data

  // renderer
  Method RenderMethod = Method::Pellucid;
  bool Reference = false;
  bool Compare = false;
  int MemoryLimit = 1024; // MiB
};

/**
 * The options of a command line. Where the program has nothing left to do (help, version, or an
 * error, which is printed), `exitCode` is set: 0, or 2 for wrong usage.
 */
RenderOptions ParseCommandLine(int argc, char* argv[], std::optional<int>& exitCode);
}

#endif
