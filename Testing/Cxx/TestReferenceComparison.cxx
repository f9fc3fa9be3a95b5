// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// The comparison that the other tests rest on finds pictures that are wrong in few steps, in few
// pixels, or by less than the width of a pixel.
#include "HelixScene.h"

namespace
{
/** Pixels that the comparison finds when a picture is the reference's but for a damage. */
class Comparison
{
public:
  Comparison()
    : Scene(200, 150, 0, 0, 0)
  {
    AddLines(this->Scene, MakeLines(10, 40, 1), 0.08, 0.5);
    vtkTransparencyInstaller::Install(this->Scene.Renderer);
    this->Shown = Picture::Render(this->Scene.Window);
  }

  vtkIdType Count(const Picture& picture) const
  {
    return ReferenceComparison(picture, this->Scene.Renderer, false).GetUnexplainedPixels();
  }

  SphereScene Scene;
  Picture Shown;
};

bool TestDamage(const Comparison& comparison)
{
  bool passed = Check(comparison.Count(comparison.Shown) == 0, "the picture itself differs");
  const std::size_t pixels = comparison.Shown.Rgba.size() / 4;
  for (const int steps : { 2, 10, 16, 40 })
  {
    Picture damaged = comparison.Shown;
    for (std::size_t i = 0; i < damaged.Rgba.size(); ++i)
    {
      damaged.Rgba[i] += damaged.Rgba[i] < 128 ? steps : -steps;
    }
    const vtkIdType found = comparison.Count(damaged);
    std::cout << steps << " of 255 off: " << found << " of " << pixels << " pixels found"
              << std::endl;
    passed &=
      Check(found > static_cast<vtkIdType>(0.99 * pixels), "a picture that is wrong everywhere");
  }
  return passed;
}

bool TestDamagedPixel(const Comparison& comparison)
{
  const std::size_t middle = comparison.Shown.Rgba.size() / 8 * 4;
  Picture damaged = comparison.Shown;
  damaged.Rgba[middle] += damaged.Rgba[middle] < 128 ? 3 : -3;
  return Check(comparison.Count(damaged) == 1, "one wrong pixel");
}

bool TestMovedPicture(const Comparison& comparison)
{
  Picture moved = comparison.Shown;
  std::rotate(moved.Rgba.begin(), moved.Rgba.begin() + 4, moved.Rgba.end());
  bool passed = Check(comparison.Count(moved) > 1000, "a picture that is moved by a pixel");
  vtkCamera* camera = comparison.Scene.Renderer->GetActiveCamera();
  camera->SetWindowCenter(2.0 * 0.1 / comparison.Shown.Width, 0.0);
  passed &= Check(comparison.Count(comparison.Shown) > 500, "a picture moved by 0.1 pixels");
  camera->SetWindowCenter(0.0, 0.0);
  return passed;
}

/** Translucent squares that fill a parallel view along z. */
class Squares
{
public:
  Squares()
    : Scene(Width, Height, 0, 0, 0)
  {
    this->Scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    vtkTransparencyInstaller::Install(this->Scene.Renderer);
  }

  vtkActor* Add(double red, double green, double blue, double opacity = 0.5)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-9.0, -9.0, 0.0);
    source->SetPoint1(9.0, -9.0, 0.0);
    source->SetPoint2(-9.0, 9.0, 0.0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(red, green, blue);
    actor->GetProperty()->SetOpacity(opacity);
    this->Scene.Renderer->AddActor(actor);
    return actor;
  }

  Picture Render()
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->SetClippingRange(camera->GetDistance() - 1.0, camera->GetDistance() + 1.0);
    return Picture::Render(this->Scene.Window);
  }

  Picture RenderWithout(vtkActor* square)
  {
    square->VisibilityOff();
    Picture picture = this->Render();
    square->VisibilityOn();
    return picture;
  }

  vtkExactTransparencyPass* GetPass()
  {
    return vtkTransparencyInstaller::GetPass(this->Scene.Renderer);
  }

  /// Whether the comparison finds no fault in a picture.
  bool IsExcused(const Picture& picture) { return this->CountFaults(picture) == 0; }

  /// Whether it finds one in each pixel.
  bool IsRefused(const Picture& picture) { return this->CountFaults(picture) == Width * Height; }

private:
  static constexpr int Width = 60;
  static constexpr int Height = 40;

  vtkIdType CountFaults(const Picture& picture)
  {
    return ReferenceComparison(picture, this->Scene.Renderer, false).GetUnexplainedPixels();
  }

  SphereScene Scene;
};

// Two translucent squares that are closer than single precision resolves may be in either order.
bool TestUnresolvedOrder()
{
  Squares squares;
  squares.Add(1.0, 0.0, 0.0);
  vtkActor* blue = squares.Add(0.0, 0.0, 1.0);
  const auto render = [&](double offset)
  {
    blue->SetPosition(0.0, 0.0, offset);
    return squares.Render();
  };
  const Picture redFirst = render(-0.1);
  const Picture blueFirst = render(0.1);
  bool passed = Check(squares.IsRefused(redFirst), "the order of squares that are far apart");
  render(6e-7);
  passed &= Check(squares.IsExcused(redFirst) && squares.IsExcused(blueFirst),
    "an order that single precision does not resolve is not excused");
  render(-2e-6);
  passed &= Check(squares.IsRefused(blueFirst), "an order that is resolved is excused");
  // The two first layers are the same picture, but excuses are for that as a whole.
  render(6e-7);
  squares.GetPass()->SetView(vtkExactTransparencyPass::VIEW_FIRST_LAYERS);
  squares.GetPass()->SetLayer(2);
  passed &= Check(squares.IsRefused(redFirst), "an order is excused in a view of layers");
  return passed;
}

// Whatever else is wrong where two squares are in no order is found.
bool TestLossInUnresolvedOrder()
{
  Squares squares;
  vtkActor* red = squares.Add(1.0, 0.0, 0.0);
  vtkActor* blue = squares.Add(0.0, 0.0, 1.0);
  blue->SetPosition(0.0, 0.0, 6e-7);
  bool passed = Check(squares.IsRefused(squares.RenderWithout(blue)), "the front one is lost");
  passed &= Check(squares.IsRefused(squares.RenderWithout(red)), "the rear one is lost");
  // Behind both, and such that losing it takes from red what another order would add.
  vtkActor* rear = squares.Add(1.0, 0.6, 1.0);
  rear->SetPosition(0.0, 0.0, -0.1);
  for (vtkActor* lost : { red, blue, rear })
  {
    passed &= Check(squares.IsRefused(squares.RenderWithout(lost)), "one of three is lost");
  }
  return passed;
}
}

//------------------------------------------------------------------------------
int TestReferenceComparison(int, char*[])
{
  const Comparison comparison;
  bool passed = TestDamage(comparison);
  passed &= TestDamagedPixel(comparison);
  passed &= TestMovedPicture(comparison);
  passed &= TestUnresolvedOrder();
  passed &= TestLossInUnresolvedOrder();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
