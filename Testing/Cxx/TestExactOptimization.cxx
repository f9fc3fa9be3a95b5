// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures with optimised opacities, of lines, points and surfaces with parameters of their own,
// are those of the double-precision reference.
#include "SegmentedScene.h"

namespace
{
//------------------------------------------------------------------------------
bool TestLines()
{
  bool success = true;
  for (const int steps : { 0, 5, 40 })
  {
    SphereScene scene(300, 300, 0, 0, 0);
    vtkActor* lines = AddLines(scene, MakeSegmentedLines(40, 600), 0.04, 1.0);
    Optimize(lines, 50.0, 100.0, 3.0, steps, steps == 5);
    success &= Compare(scene, "lines, " + std::to_string(steps) + " steps");
  }
  return success;
}

//------------------------------------------------------------------------------
// All lines together are one segment where the data do not say more.
bool TestUndivided()
{
  SphereScene scene(300, 300, 0, 0, 0);
  auto data = MakeLines(20, 40, 2);
  AddImportance(data, [](const double* p) { return p[0]; });
  Optimize(AddLines(scene, data, 0.05, 0.8), 1.0, 2.0, 1.5, 3, false);
  return Compare(scene, "lines without segments");
}

//------------------------------------------------------------------------------
template <typename Mapper>
bool TestMixture(const std::string& name)
{
  SphereScene scene(300, 300, 0, 0, 0);
  Optimize(AddLines(scene, MakeSegmentedLines(40, 500), 0.04, 1.0), 20.0, 10.0, 2.0, 4, false);
  Optimize(AddSurface<Mapper>(scene, MakeSegmentedSphere(1.6, 0.1), 0.9), 5.0, 0.0, 1.0, 2, false);
  Optimize(AddSurface<Mapper>(scene, MakeSegmentedSphere(0.7, 0.6), 1.0), 50.0, 3.0, 4.0, 0, true);
  AddSurface<Mapper>(scene, MakeSegmentedSphere(1.2, 1.0), 0.2); // takes no part
  return Compare(scene, name);
}
}

//------------------------------------------------------------------------------
int TestExactOptimization(int, char*[])
{
  bool success = TestLines();
  success &= TestUndivided();
  success &= TestMixture<vtkPolyDataMapper>("surfaces of VTK's mapper among lines");
  success &= TestMixture<vtkTrajectoryMapper>("surfaces among lines");
  return success ? EXIT_SUCCESS : EXIT_FAILURE;
}
