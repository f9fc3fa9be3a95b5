// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   An OpenGL window that nobody sees.
 */

#ifndef PictureWindow_h
#define PictureWindow_h

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"

#include <array>  // for the size
#include <string> // for OpenGL's names

class vtkRenderer;

namespace pellucid
{
/** The last frame of a window, in 3 components of unsigned char, or 4 with alpha. */
vtkSmartPointer<vtkImageData> GrabPicture(vtkRenderWindow* window, bool withAlpha);

/** "OpenGL renderer string", "OpenGL version string" of a window, as the driver says them. */
std::string GetOpenGLProperty(vtkRenderWindow* window, const std::string& name);

class PictureWindow
{
public:
  /** Open the window; throw RenderError without a display or OpenGL, or beyond OpenGL's limits.
   * `alternative` is what the user can take instead, for the message; also below. */
  explicit PictureWindow(const std::array<int, 2>& size, const std::string& alternative = "");

  /** Throw RenderError, saying what was found and is needed, if the exact pass cannot run. */
  void CheckExactTransparency(const std::string& alternative = "");

  /** Draw a frame; throw RenderError when OpenGL reports an error. Milliseconds that it took. */
  double Render();

  void AddRenderer(vtkRenderer* renderer) { this->Window->AddRenderer(renderer); }

  /** As GrabPicture() has it. */
  vtkSmartPointer<vtkImageData> Grab(bool withAlpha)
  {
    return GrabPicture(this->Window, withAlpha);
  }

  /** As GetOpenGLProperty() has it. */
  std::string GetProperty(const std::string& name) { return GetOpenGLProperty(this->Window, name); }

private:
  vtkNew<vtkRenderWindow> Window;
};
}

#endif
