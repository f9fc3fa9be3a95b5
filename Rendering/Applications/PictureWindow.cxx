// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "PictureWindow.h"

#include "MessageLog.h"
#include "RenderError.h"

#include "vtkExactTransparencyPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <chrono>
#include <sstream>

namespace pellucid
{
namespace
{
//------------------------------------------------------------------------------
// VTK ends the process after some errors on the way to a context; here they become exceptions.
class ThrowingErrors
{
public:
  ThrowingErrors() { MessageLog::GetInstance().SetThrowing(true); }
  ~ThrowingErrors() { MessageLog::GetInstance().SetThrowing(false); }
};
}

//------------------------------------------------------------------------------
PictureWindow::PictureWindow(const std::array<int, 2>& size, const std::string& alternative)
{
  const std::string advice = alternative.empty() ? "" : ", or use " + alternative;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(this->Window);
  if (!window)
  {
    throw RenderError("this VTK has no OpenGL window; use another VTK" + advice);
  }
  window->OffScreenRenderingOn();
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetSize(1, 1);
  try
  {
    const ThrowingErrors throwing;
    window->Initialize();
  }
  catch (const RenderError& error)
  {
    throw RenderError(std::string("no OpenGL window could be opened (") + error.what() +
      "); run under Xvfb, for example by xvfb-run" + advice);
  }
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (std::max(size[0], size[1]) > limit)
  {
    throw RenderError("--size: OpenGL here draws at most " + std::to_string(limit) + "x" +
      std::to_string(limit) + " pixels, asked for are " + std::to_string(size[0]) + "x" +
      std::to_string(size[1]));
  }
  window->SetSize(size[0], size[1]);
  // VTK warns of every kind of window that it tried in vain.
  MessageLog::GetInstance().Clear();
}

//------------------------------------------------------------------------------
void PictureWindow::CheckExactTransparency(const std::string& alternative)
{
  const std::string reason = vtkExactTransparencyPass::GetReasonUnsupported(this->Window);
  if (!reason.empty())
  {
    throw RenderError(reason + (alternative.empty() ? "" : "; " + alternative));
  }
}

//------------------------------------------------------------------------------
double PictureWindow::Render()
{
  const auto start = std::chrono::steady_clock::now();
  this->Window->Render();
  this->Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> elapsed =
    std::chrono::steady_clock::now() - start;
  MessageLog& log = MessageLog::GetInstance();
  if (log.HasErrors())
  {
    throw RenderError("the picture cannot be drawn: " + log.GetFirstError());
  }
  log.PrintWarnings();
  return elapsed.count();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GrabPicture(vtkRenderWindow* window, bool withAlpha)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  grabber->ShouldRerenderOff();
  if (withAlpha)
  {
    grabber->SetInputBufferTypeToRGBA();
  }
  grabber->Update();
  return grabber->GetOutput();
}

//------------------------------------------------------------------------------
std::string GetOpenGLProperty(vtkRenderWindow* window, const std::string& name)
{
  std::istringstream lines(window->ReportCapabilities());
  for (std::string line; std::getline(lines, line);)
  {
    if (line.compare(0, name.size(), name) == 0)
    {
      const std::size_t value = line.find_first_not_of(": ", name.size());
      return value == std::string::npos ? std::string() : line.substr(value);
    }
  }
  return std::string();
}
}
