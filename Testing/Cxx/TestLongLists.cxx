// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// Lists of every critical length are composited exactly, in any draw order with the same bits, and
// within any memory limit.
#include "LayerStack.h"
#include "OpenGLDebugOutput.h"
#include "Picture.h"

#include "vtkExactTransparencyPass.h"
#include "vtkTransparencyInstaller.h"

namespace
{
struct Result
{
  Picture Image;
  vtkIdType LongestList = 0;
  vtkIdType Fragments = 0;
};

Result RenderStack(const LayerStack& stack, unsigned int seed, int size, int memoryLimit)
{
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(size, size);
  window->OffScreenRenderingOn();
  OpenGLDebugOutput debugOutput(window);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 0.5, 0.0);
  renderer->AddActor(stack.MakeActor(seed));
  LayerStack::SetCamera(renderer);
  window->AddRenderer(renderer);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(renderer);
  pass->SetMemoryLimit(memoryLimit);
  Result result;
  result.Image = Picture::Render(window);
  result.LongestList = pass->GetStatistics()->GetLongestList();
  result.Fragments = pass->GetStatistics()->GetFragments();
  return result;
}

bool TestStack(int layers, double opacity, int size)
{
  const std::string name =
    std::to_string(layers) + " layers of opacity " + std::to_string(opacity) + ": ";
  const LayerStack stack(layers, opacity);
  const Result result = RenderStack(stack, 1, size, 1024);
  bool passed = Check(
    result.LongestList == layers, name + "longest list is " + std::to_string(result.LongestList));
  passed &= Check(result.Fragments == static_cast<vtkIdType>(layers) * size * size,
    name + "stored " + std::to_string(result.Fragments) + " fragments");

  const auto expected = stack.GetColor({ 255.0, 127.5, 0.0 });
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    largest =
      std::max(largest, std::abs(result.Image.GetPixel(size / 2, size / 2)[i] - expected[i]));
  }
  // Half a step is rounding; another half is the rounding of the background.
  passed &= Check(largest <= 1.0, name + "differs by " + std::to_string(largest));

  passed &= Check(RenderStack(stack, 2, size, 1024).Image == result.Image,
    name + "another draw order has other bits");
  return passed;
}
}

int TestLongLists(int, char*[])
{
  bool passed = true;
  const int run = 16;
  const int shaderLimit = 2048;
  for (int layers :
    { 1, 2, run - 1, run, run + 1, 2 * run, 2 * run + 1, 64, 500, 1000, 100 * run, shaderLimit - 1,
      shaderLimit, shaderLimit + 1, shaderLimit + run, shaderLimit + run + 1, 5000 })
  {
    passed &= TestStack(layers, 1.0 / (layers + 1), 3);
  }
  passed &= TestStack(500, 0.0019, 5);
  passed &= TestStack(10000, 1e-4, 2);
  passed &= TestStack(100 * shaderLimit, 1e-5, 1);
  passed &= TestStack(100000, 0.25, 1);
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
