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

struct RenderOptions
{
  std::vector<std::string> Inputs;
  std::string Output;
  std::string StatisticsFile; // empty: none

  // picture
  std::array<int, 2> Size = { 1280, 960 };
  Vector3 Background = { 0.05, 0.06, 0.08 };
  bool TransparentBackground = false;

  // appearance
  std::string ColorBy; // empty: speed of traced lines, or the active or first array
  double Opacity = 0.3;
  double Radius = 0.0; // world units; 0: from the data
  bool Lighting = true;

  // camera; what is not given follows from the data
  std::optional<Vector3> CameraPosition;
  std::optional<Vector3> FocalPoint;
  std::optional<Vector3> ViewUp;
  double ParallelScale = 0.0; // 0: perspective

  // streamlines of fields
  long long Seeds = 1000;
  Seeding SeedingMode = Seeding::Volume;
  long long SeedOffset = 0;
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
