// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// In a multisampled window opaque edges keep their antialiasing under, and beside, translucent
// layers, and the fragments are those of a window without samples.
#include "LayerStack.h"
#include "OpenGLDebugOutput.h"
#include "Picture.h"
#include "SphereScene.h"

#include "vtkExactTransparencyPass.h"
#include "vtkTransparencyInstaller.h"

namespace
{
constexpr int Size = 200;
constexpr double Opacity = 0.4;

/** An opaque lit sphere of radius 0.5 about (0, 0, depth), and a layer at depth 0, if any. */
void MakeScene(SphereScene& scene, double depth, const LayerStack* stack)
{
  vtkActor* sphere = scene.AddSphere(0, 1.0);
  sphere->SetPosition(0.0, -1.2, depth);
  LayerStack::SetCamera(scene.Renderer);
  scene.Renderer->SetBackground(1.0, 0.5, 0.0);
  if (stack)
  {
    scene.Renderer->AddActor(stack->MakeActor(3));
    vtkTransparencyInstaller::Install(scene.Renderer);
  }
}
}

int TestMultisampling(int, char*[])
{
  // One layer in front of everything: the result is a blend of the antialiased opaque picture.
  SphereScene opaque(Size, Size, 4, 0, 0);
  MakeScene(opaque, -1.0, nullptr);
  const Picture behind = Picture::Render(opaque.Window);

  const LayerStack stack(1, Opacity);
  SphereScene scene(Size, Size, 4, 0, 0);
  OpenGLDebugOutput debugOutput(scene.Window);
  MakeScene(scene, -1.0, &stack);
  const Picture picture = Picture::Render(scene.Window);
  bool passed = Check(scene.Window->GetMultiSamples() == 4, "the window has no samples");

  const auto front = stack.GetColor({ 0.0, 0.0, 0.0 });
  double largest = 0.0;
  int partlyCovered = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      for (int i = 0; i < 3; ++i)
      {
        const double expected = front[i] + (1.0 - Opacity) * behind.GetPixel(x, y)[i];
        largest = std::max(largest, std::abs(picture.GetPixel(x, y)[i] - expected));
      }
      const unsigned char* color = behind.GetPixel(x, y);
      partlyCovered += color[2] > 0 && color[2] < 20 && color[0] > 60 ? 1 : 0;
    }
  }
  passed &= Check(partlyCovered > 20, "the opaque picture has no antialiased edge");
  // Each of the two pictures rounds at each sample.
  passed &= Check(largest <= 2.0, "the blend differs by " + std::to_string(largest));

  // A layer through the middle of the sphere, compared with the same picture without samples.
  SphereScene sampled(Size, Size, 4, 0, 0);
  OpenGLDebugOutput sampledDebugOutput(sampled.Window);
  MakeScene(sampled, 0.0, &stack);
  SphereScene plain(Size, Size, 0, 0, 0);
  MakeScene(plain, 0.0, &stack);
  const Picture sampledPicture = Picture::Render(sampled.Window);
  const Picture plainPicture = Picture::Render(plain.Window);
  int differing = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const unsigned char* a = sampledPicture.GetPixel(x, y);
      const unsigned char* b = plainPicture.GetPixel(x, y);
      differing +=
        std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) > 6 ? 1 : 0;
    }
  }
  passed &= Check(differing > 0 && differing < 3 * Size,
    std::to_string(differing) + " pixels differ from the picture without samples");
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
