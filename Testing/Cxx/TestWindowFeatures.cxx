// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

// What a window and its renderers can do besides works as before: volumes, overlays, SSAO and FXAA,
// transparent backgrounds, tiled screenshots, and props that take no part.
#include "Picture.h"
#include "ReferenceComparison.h"
#include "SphereScene.h"

#include "vtkActor2D.h"
#include "vtkColorTransferFunction.h"
#include "vtkConeSource.h"
#include "vtkExactTransparencyPass.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLActor.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRTAnalyticSource.h"
#include "vtkTestErrorObserver.h"
#include "vtkTextMapper.h"
#include "vtkTextProperty.h"
#include "vtkTransparencyInstaller.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"
#include "vtkWindowToImageFilter.h"

namespace
{
void AddVolume(vtkRenderer* renderer)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-8, 8, -8, 8, -8, 8);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputConnection(wavelet->GetOutputPort());
  mapper->UseJitteringOff();
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(100.0, 0.0);
  opacity->AddPoint(280.0, 0.3);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(100.0, 0.0, 0.0, 1.0);
  color->AddRGBPoint(280.0, 1.0, 0.5, 0.0);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetScale(0.1);
  volume->GetProperty()->ShadeOn();
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(color);
  renderer->AddVolume(volume);
}

void AddGlyphs(vtkRenderer* renderer)
{
  vtkNew<vtkSphereSource> places;
  vtkNew<vtkConeSource> cone;
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(places->GetOutputPort());
  mapper->SetSourceConnection(cone->GetOutputPort());
  mapper->SetScaleFactor(0.2);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetScale(2.5);
  renderer->AddActor(actor);
}

void AddText(vtkRenderer* renderer)
{
  vtkNew<vtkTextMapper> mapper;
  mapper->SetInput("overlay");
  mapper->GetTextProperty()->SetFontSize(30);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(20, 20);
  renderer->AddViewProp(actor);
}

bool TestNothingTranslucent()
{
  // Without OpenGLDebugOutput: compilers warn of VTK's volume shader.
  SphereScene scene(200, 160, 0, 0, 4);
  AddVolume(scene.Renderer);
  AddGlyphs(scene.Renderer);
  AddText(scene.Renderer);
  bool passed = true;
  for (const bool fancy : { false, true })
  {
    scene.Renderer->SetUseFXAA(fancy);
    scene.Renderer->SetUseSSAO(fancy);
    scene.Renderer->SetSSAORadius(0.3);
    vtkTransparencyInstaller::Uninstall(scene.Renderer);
    const Picture stock = Picture::Render(scene.Window);
    vtkTransparencyInstaller::Install(scene.Renderer);
    passed &= Check(Picture::Render(scene.Window) == stock,
      std::string("surfaces, glyphs, volume or overlay changed with SSAO and FXAA ") +
        (fancy ? "on" : "off"));
  }
  return passed;
}

// A sphere of an opacity that no 8-bit picture shows runs all our stages.
bool TestAroundOurStages()
{
  // Without OpenGLDebugOutput: compilers warn of VTK's volume shader.
  SphereScene scene(200, 160, 0, 0, 4);
  AddVolume(scene.Renderer);
  AddText(scene.Renderer);
  scene.Renderer->SetUseFXAA(true);
  scene.Renderer->SetUseSSAO(true);
  scene.Renderer->SetSSAORadius(0.3);
  const Picture stock = Picture::Render(scene.Window);
  scene.AddSphere(0, 1e-6);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  const Picture exact = Picture::Render(scene.Window);
  bool passed = Check(pass->GetStatistics()->GetFragments() > 0, "our stages did not run");
  const int difference = exact.GetLargestDifference(stock);
  passed &= Check(difference == 0,
    "SSAO, FXAA, volume or overlay differ by " + std::to_string(difference) +
      " when our stages run between them");
  return passed;
}

bool TestTransparentBackground()
{
  SphereScene scene(200, 150, 0, 12, 1);
  scene.Window->SetAlphaBitPlanes(1);
  vtkTransparencyInstaller::Install(scene.Renderer);
  scene.Window->Render();
  const Picture shown = Picture::Render(scene.Window);
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(scene.Renderer);
  reference->SetSize(200, 150);
  reference->TransparentBackgroundOn();
  reference->Update();
  double largest = 0.0;
  int differing = 0;
  for (int y = 0; y < 150; ++y)
  {
    for (int x = 0; x < 200; ++x)
    {
      const double expected = 255.0 * reference->GetImage()->GetScalarComponentAsDouble(x, y, 0, 3);
      const double difference = std::abs(shown.GetPixel(x, y)[3] - expected);
      differing += difference > 1.0 ? 1 : 0;
      largest = std::max(largest, difference > 1.0 ? 0.0 : difference);
    }
  }
  bool passed = Check(shown.GetPixel(0, 0)[3] == 0, "the background is not transparent");
  passed &= Check(differing <= 6, std::to_string(differing) + " pixels have another alpha");
  return passed;
}

bool TestTiledScreenshot()
{
  SphereScene large(402, 300, 0, 20, 2);
  vtkTransparencyInstaller::Install(large.Renderer);
  const Picture whole = Picture::Render(large.Window);
  SphereScene small(201, 150, 0, 20, 2);
  vtkTransparencyInstaller::Install(small.Renderer);
  small.Window->Render();
  vtkNew<vtkWindowToImageFilter> screenshot;
  screenshot->SetInput(small.Window);
  screenshot->SetScale(2);
  screenshot->SetInputBufferTypeToRGB();
  screenshot->ReadFrontBufferOff();
  screenshot->Update();
  int differing = 0;
  for (int y = 0; y < 300; ++y)
  {
    for (int x = 0; x < 402; ++x)
    {
      const auto* pixel =
        static_cast<unsigned char*>(screenshot->GetOutput()->GetScalarPointer(x, y, 0));
      int largest = 0;
      for (int i = 0; i < 3; ++i)
      {
        largest = std::max(largest, std::abs(pixel[i] - whole.GetPixel(x, y)[i]));
      }
      differing += largest > 1 ? 1 : 0;
    }
  }
  // The tiles have projections of their own, so a few edges fall on the other side of a pixel.
  return Check(differing <= 20, std::to_string(differing) + " pixels differ in a tiled screenshot");
}

/** An actor whose mapper never learns of render passes. */
class IgnorantActor : public vtkOpenGLActor
{
public:
  static IgnorantActor* New();
  vtkTypeMacro(IgnorantActor, vtkOpenGLActor);
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override
  {
    const vtkSmartPointer<vtkInformation> keys = this->GetPropertyKeys();
    this->SetPropertyKeys(nullptr);
    const int rendered = this->Superclass::RenderTranslucentPolygonalGeometry(viewport);
    this->SetPropertyKeys(keys);
    return rendered;
  }
};
vtkStandardNewMacro(IgnorantActor);

bool TestPropThatTakesNoPart()
{
  SphereScene scene(200, 150, 0, 0, 1);
  const Picture without = Picture::Render(scene.Window);
  vtkActor* model = scene.AddSphere(5, 0.5);
  vtkNew<IgnorantActor> ignorant;
  ignorant->SetMapper(model->GetMapper());
  ignorant->SetProperty(model->GetProperty());
  scene.Renderer->RemoveActor(model);
  scene.Renderer->AddActor(ignorant);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  vtkNew<vtkTest::ErrorObserver> observer;
  pass->AddObserver(vtkCommand::WarningEvent, observer);
  const Picture picture = Picture::Render(scene.Window);
  bool passed =
    Check(pass->GetStatistics()->GetBlendedProps() == 1, "the prop is not counted as blended");
  passed &= Check(observer->GetWarning(), "no warning of the prop that takes no part");
  int covered = 0;
  for (std::size_t i = 0; i < picture.Rgba.size(); i += 4)
  {
    covered += std::equal(&picture.Rgba[i], &picture.Rgba[i] + 3, &without.Rgba[i]) ? 0 : 1;
  }
  passed &=
    Check(covered > 300, std::to_string(covered) + " pixels show the prop that takes no part");
  return passed;
}

/** As labels of points draw themselves. */
class TranslucentOverlay : public vtkActor2D
{
public:
  static TranslucentOverlay* New();
  vtkTypeMacro(TranslucentOverlay, vtkActor2D);
  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 1; }
  int RenderOverlay(vtkViewport*) override { return 0; }
};
vtkStandardNewMacro(TranslucentOverlay);

bool TestOverlayHasNoDepthOrder()
{
  SphereScene scene(200, 150, 0, 2, 1);
  vtkNew<TranslucentOverlay> overlay;
  scene.Renderer->AddViewProp(overlay);
  vtkExactTransparencyPass* pass = vtkTransparencyInstaller::Install(scene.Renderer);
  vtkNew<vtkTest::ErrorObserver> observer;
  pass->AddObserver(vtkCommand::WarningEvent, observer);
  Picture::Render(scene.Window);
  bool passed =
    Check(pass->GetStatistics()->GetBlendedProps() == 0, "the overlay is counted as blended");
  passed &=
    Check(!observer->GetWarning(), "a warning of an overlay: " + observer->GetWarningMessage());
  return passed;
}
}

int TestWindowFeatures(int, char*[])
{
  bool passed = TestNothingTranslucent();
  passed &= TestAroundOurStages();
  passed &= TestTransparentBackground();
  passed &= TestTiledScreenshot();
  passed &= TestPropThatTakesNoPart();
  passed &= TestOverlayHasNoDepthOrder();
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
