// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    ReferencePicture.h
 * @brief   Compares the picture in a render window with that of vtkReferenceRenderer.
 */

#ifndef ReferencePicture_h
#define ReferencePicture_h

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkReferenceRenderer.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <ostream>

/** How two pictures differ; colours of 8 bit. */
struct PictureDifference
{
  double smooth = 0.0;     ///< largest, away from edges
  double largest = 0.0;    ///< largest anywhere
  double meanSquare = 0.0; ///< mean of the squares over all pixels and channels
  int visible = 0;         ///< pixels that differ by more than 2
};

inline std::ostream& operator<<(std::ostream& os, const PictureDifference& difference)
{
  return os << "smooth " << difference.smooth << ", largest " << difference.largest << ", RMSE "
            << std::sqrt(difference.meanSquare) << ", more than 2 in " << difference.visible
            << " pixels";
}

/** Is there an edge of the picture, a step of more than 6 of 255, next to a pixel? */
inline bool IsAtEdge(vtkImageData* image, int x, int y)
{
  const int* extent = image->GetExtent();
  const auto* center = static_cast<double*>(image->GetScalarPointer(x, y, 0));
  double step = 0.0;
  for (int j = std::max(extent[2], y - 1); j <= std::min(extent[3], y + 1); ++j)
  {
    for (int i = std::max(extent[0], x - 1); i <= std::min(extent[1], x + 1); ++i)
    {
      const auto* color = static_cast<double*>(image->GetScalarPointer(i, j, 0));
      for (int component = 0; component < 3; ++component)
      {
        step = std::max(step, std::abs(color[component] - center[component]));
      }
    }
  }
  return step > 6.0 / 255.0;
}

/** Render the window, which shows only that renderer, and the reference of the same scene. */
inline PictureDifference CompareWithReference(vtkRenderWindow* window, vtkRenderer* renderer)
{
  window->Render();
  const int width = window->GetSize()[0];
  const int height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels);

  vtkNew<vtkReferenceRenderer> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(width, height);
  reference->Update();
  vtkImageData* image = reference->GetImage();

  PictureDifference difference;
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const auto* expected = static_cast<double*>(image->GetScalarPointer(x, y, 0));
      double worst = 0.0;
      for (int i = 0; i < 3; ++i)
      {
        const double found = pixels->GetComponent(static_cast<vtkIdType>(y) * width + x, i);
        const double step = std::abs(found - std::round(255.0 * expected[i]));
        worst = std::max(worst, step);
        difference.meanSquare += step * step / (3.0 * width * height);
      }
      difference.largest = std::max(difference.largest, worst);
      difference.visible += worst > 2.0;
      if (!IsAtEdge(image, x, y))
      {
        difference.smooth = std::max(difference.smooth, worst);
      }
    }
  }
  return difference;
}

#endif
