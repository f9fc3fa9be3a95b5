// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PictureMaking.h"

#include "MessageLog.h"
#include "PictureWindow.h"
#include "ProgressLine.h"

#include "vtkCoordinate.h"
#include "vtkExactTransparencyPass.h"
#include "vtkPointData.h"
#include "vtkReferenceRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTransparencyInstaller.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
const char* GetTitle(Method method)
{
  switch (method)
  {
    case Method::VTK:
      return "VTK";
    case Method::VTKPeeling:
      return "VTK, depth peeling";
    default:
      return "Pellucid";
  }
}

//------------------------------------------------------------------------------
void AddTitle(vtkRenderer* renderer, const std::string& title, const RenderOptions& options)
{
  const double brightness =
    (options.Background[0] + options.Background[1] + options.Background[2]) / 3.0;
  const double gray = brightness > 0.5 ? 0.1 : 0.9;
  const int size = std::max(10, options.Size[1] / 30);
  vtkNew<vtkTextActor> text;
  text->SetInput(title.c_str());
  text->GetTextProperty()->SetFontSize(size);
  text->GetTextProperty()->SetColor(gray, gray, gray);
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition(0.02, 0.98);
  text->GetTextProperty()->SetVerticalJustificationToTop();
  renderer->AddViewProp(text);
}

//------------------------------------------------------------------------------
// Of the pass or the reference.
template <typename Renderer>
void SetView(Renderer* renderer, const OpacityOptions& options)
{
  renderer->SetView(static_cast<int>(options.Shown.Kind));
  renderer->SetLayer(options.Shown.Layer);
  renderer->SetGatherScale(options.GatherScale.value_or(1));
}

//------------------------------------------------------------------------------
// One renderer, or two side by side, in one window; the exact one, if any, is the first.
Frame MakePictureWithOpenGL(const Scene& scene, const RenderOptions& options)
{
  std::vector<Method> methods = { options.RenderMethod };
  if (options.Compare)
  {
    const bool isStock = options.RenderMethod != Method::Pellucid;
    methods = { Method::Pellucid, isStock ? options.RenderMethod : Method::VTK };
  }

  PictureWindow window(options.Size, "--reference, which needs none");
  if (methods.front() == Method::Pellucid)
  {
    window.CheckExactTransparency(
      "--reference draws without OpenGL, --method vtk without exactness");
  }
  const auto count = static_cast<double>(methods.size());
  const double aspect = options.Size[0] / count / options.Size[1];
  vtkExactTransparencyPass* pass = nullptr;
  for (std::size_t i = 0; i < methods.size(); ++i)
  {
    const auto renderer = MakeRenderer(scene, options, methods[i], aspect);
    renderer->SetViewport(i / count, 0.0, (i + 1) / count, 1.0);
    if (options.Compare)
    {
      AddTitle(renderer, GetTitle(methods[i]), options);
    }
    if (methods[i] == Method::Pellucid)
    {
      pass = MakeExact(renderer, options);
    }
    window.AddRenderer(renderer);
  }

  Frame frame;
  const double milliseconds = window.Render();
  if (pass)
  {
    frame.Statistics.Take(pass->GetStatistics());
  }
  else
  {
    frame.Statistics.Stages.emplace_back("render", milliseconds);
  }
  frame.Statistics.Renderer = window.GetProperty("OpenGL renderer string");
  frame.Statistics.OpenGL = window.GetProperty("OpenGL version string");
  frame.Picture = window.Grab(options.TransparentBackground);
  return frame;
}

//------------------------------------------------------------------------------
// The nearest bytes to colours in [0, 1].
vtkSmartPointer<vtkImageData> Quantize(vtkImageData* image, int components)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(image->GetDimensions());
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  vtkDataArray* colors = image->GetPointData()->GetScalars();
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  for (vtkIdType pixel = 0; pixel < colors->GetNumberOfTuples(); ++pixel)
  {
    for (int component = 0; component < components; ++component)
    {
      bytes->SetTypedComponent(pixel, component,
        static_cast<unsigned char>(std::lround(255.0 * colors->GetComponent(pixel, component))));
    }
  }
  return picture;
}

//------------------------------------------------------------------------------
Frame MakePictureWithReference(const Scene& scene, const RenderOptions& options)
{
  const double aspect = static_cast<double>(options.Size[0]) / options.Size[1];
  const auto renderer = MakeRenderer(scene, options, Method::Pellucid, aspect);
  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetTransparentBackground(options.TransparentBackground);
  reference->SetSize(options.Size[0], options.Size[1]);
  SetView(reference.Get(), options.Opacities);
  const auto start = std::chrono::steady_clock::now();
  {
    const ProgressLine progress(reference, "Drawing");
    reference->Update();
  }
  const std::chrono::duration<double, std::milli> elapsed =
    std::chrono::steady_clock::now() - start;
  MessageLog::GetInstance().PrintWarnings();

  Frame frame;
  frame.Picture = Quantize(reference->GetImage(), options.TransparentBackground ? 4 : 3);
  frame.Statistics.Fragments = reference->GetNumberOfFragments();
  frame.Statistics.LongestList = reference->GetLongestList();
  frame.Statistics.Tiles = 1;
  frame.Statistics.Stages.emplace_back("render", elapsed.count());
  frame.Statistics.Renderer = "Pellucid reference renderer";
  return frame;
}

//------------------------------------------------------------------------------
// Colours come premultiplied out of blending over transparent black; picture files hold them
// straight.
void DivideByAlpha(vtkImageData* picture)
{
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(picture->GetPointData()->GetScalars());
  for (vtkIdType pixel = 0; pixel < pixels->GetNumberOfTuples(); ++pixel)
  {
    unsigned char* color = pixels->GetPointer(4 * pixel);
    const int alpha = color[3];
    std::transform(color, color + 3, color,
      [alpha](int component)
      {
        return static_cast<unsigned char>(
          alpha > 0 ? std::min(255, (component * 255 + alpha / 2) / alpha) : 0);
      });
  }
}
}

//------------------------------------------------------------------------------
vtkExactTransparencyPass* MakeExact(vtkRenderer* renderer, const RenderOptions& options)
{
  auto* pass = vtkTransparencyInstaller::Install(renderer);
  pass->SetMemoryLimit(options.MemoryLimit);
  SetView(pass, options.Opacities);
  return pass;
}

//------------------------------------------------------------------------------
Frame MakePicture(const Scene& scene, const RenderOptions& options)
{
  Frame frame = options.Reference ? MakePictureWithReference(scene, options)
                                  : MakePictureWithOpenGL(scene, options);
  if (options.TransparentBackground)
  {
    DivideByAlpha(frame.Picture);
  }
  return frame;
}
}
