// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Picture_h
#define Picture_h

#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

/** The RGBA bytes of a window, row by row from the bottom. */
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Rgba;

  /// What the window shows after one more frame.
  static Picture Render(vtkRenderWindow* window)
  {
    window->Render();
    Picture picture;
    picture.Width = window->GetSize()[0];
    picture.Height = window->GetSize()[1];
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetRGBACharPixelData(0, 0, picture.Width - 1, picture.Height - 1, 0, pixels);
    picture.Rgba.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
    return picture;
  }

  const unsigned char* GetPixel(int x, int y) const
  {
    return &this->Rgba[4 * (static_cast<std::size_t>(y) * this->Width + x)];
  }

  bool operator==(const Picture& other) const { return this->Rgba == other.Rgba; }

  /// Largest difference of any component; 256 when the sizes differ.
  int GetLargestDifference(const Picture& other) const
  {
    int largest = this->Rgba.size() == other.Rgba.size() ? 0 : 256;
    for (std::size_t i = 0; i < this->Rgba.size() && largest < 256; ++i)
    {
      largest = std::max(largest, std::abs(this->Rgba[i] - other.Rgba[i]));
    }
    return largest;
  }
};

/** Print an error, which fails the test, unless the condition holds. */
inline bool Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "ERROR: " << what << std::endl;
  }
  return condition;
}

#endif
