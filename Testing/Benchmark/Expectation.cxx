// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Expectation.h"

#include "PictureWindow.h"

#include "vtkCamera.h"
#include "vtkExactTransparencyPass.h"
#include "vtkNew.h"
#include "vtkReferenceRenderer.h"
#include "vtkRenderer.h"
#include "vtkTransparencyInstaller.h"

namespace pellucid
{
namespace benchmark
{
namespace
{
// Pixels, to either side of an edge of a surface, that may show any side of it. OpenGL rounds
// vertices to a grid of 1/256 pixel or finer, by half of that at most; a third more is for the
// single precision in which it has them before.
constexpr double EdgeWidth = 1.0 / 384.0;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkReferenceRenderer> DrawReference(
  vtkRenderer* renderer, const std::array<int, 2>& size)
{
  auto reference = vtkSmartPointer<vtkReferenceRenderer>::New();
  reference->SetRenderer(renderer);
  reference->SetSize(size[0], size[1]);
  reference->ComputeOrderChangesOn();
  reference->Update();
  return reference;
}
}

//------------------------------------------------------------------------------
// A point in one corner of a square is beyond every straight edge that is nearer to its middle than
// its sides.
Expectation DrawExpectation(vtkRenderer* renderer, const std::array<int, 2>& size)
{
  Expectation expectation;
  {
    const auto reference = DrawReference(renderer, size);
    expectation.Picture.emplace(reference->GetImage(), reference->GetFragmentCounts());
    expectation.Picture->AddOrderChanges(reference->GetOrderChanges());
    expectation.Fragments = reference->GetNumberOfFragments();
    expectation.LongestList = reference->GetLongestList();
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  for (const double x : { -EdgeWidth, EdgeWidth })
  {
    for (const double y : { -EdgeWidth, EdgeWidth })
    {
      camera->SetWindowCenter(2.0 * x / size[0], 2.0 * y / size[1]);
      const auto displaced = DrawReference(renderer, size);
      expectation.Picture->AddDisplaced(displaced->GetImage(), displaced->GetFragmentCounts());
      expectation.Picture->AddOrderChanges(displaced->GetOrderChanges());
    }
  }
  camera->SetWindowCenter(0.0, 0.0);
  return expectation;
}

//------------------------------------------------------------------------------
Expectation CountFragments(
  Scene& scene, Geometry form, double opacity, const std::array<int, 2>& size)
{
  PictureWindow window(size);
  vtkNew<vtkRenderer> renderer;
  window.AddRenderer(renderer);
  scene.AddTo(renderer, form, opacity);
  vtkTransparencyInstaller::Install(renderer);
  window.Render();
  auto* statistics = vtkTransparencyInstaller::GetPass(renderer)->GetStatistics();
  Expectation expectation;
  expectation.Fragments = statistics->GetFragments();
  expectation.LongestList = statistics->GetLongestList();
  return expectation;
}
}
}
