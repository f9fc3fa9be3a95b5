// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "GLWindow.h"

#include "RenderError.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace pellucid
{
namespace
{
// VTK's least, and that of the exact pass.
constexpr std::array<int, 2> OpenGLVersions[] = { { 4, 3 }, { 3, 2 } };

//------------------------------------------------------------------------------
std::string GetReason()
{
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

//------------------------------------------------------------------------------
// GLFW names keys by where American keyboards have them.
int FollowLabel(int key, int scancode)
{
  const char* label = glfwGetKeyName(key, scancode);
  const bool isLetter = label && label[0] >= 'a' && label[0] <= 'z' && label[1] == 0;
  return isLetter ? GLFW_KEY_A + (label[0] - 'a') : key;
}

//------------------------------------------------------------------------------
GLWindow* GetWindow(GLFWwindow* handle)
{
  return static_cast<GLWindow*>(glfwGetWindowUserPointer(handle));
}

//------------------------------------------------------------------------------
GLFWwindow* Open(const std::array<int, 2>& size, bool isVisible)
{
  for (const auto& version : OpenGLVersions)
  {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version[0]);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version[1]);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_VISIBLE, isVisible ? GLFW_TRUE : GLFW_FALSE);
    if (GLFWwindow* handle = glfwCreateWindow(size[0], size[1], "Pellucid", nullptr, nullptr))
    {
      return handle;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
struct Area
{
  std::array<int, 2> Position;
  std::array<int, 2> Size;
};

//------------------------------------------------------------------------------
// Where the inside of a window can lie on the first monitor, beside the bars of the desktop.
Area GetRoom(GLFWwindow* handle)
{
  Area area = {};
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
  {
    glfwGetMonitorWorkarea(
      monitor, &area.Position[0], &area.Position[1], &area.Size[0], &area.Size[1]);
  }
  std::array<int, 4> frame = {}; // left, top, right, bottom
  glfwGetWindowFrameSize(handle, &frame[0], &frame[1], &frame[2], &frame[3]);
  for (int axis = 0; axis < 2; ++axis)
  {
    area.Position[axis] += frame[axis];
    area.Size[axis] -= frame[axis] + frame[axis + 2];
  }
  return area;
}
}

//------------------------------------------------------------------------------
GLWindow::GLWindow(const std::array<int, 2>& size, bool isVisible, WindowListener& listener)
  : Listener(listener)
{
  if (!glfwInit())
  {
    throw RenderError("no window can be opened (" + GetReason() +
      "); run on a display, or under xvfb-run; pellucid-render draws into files");
  }
  this->Handle = Open(size, isVisible);
  if (!this->Handle)
  {
    const std::string reason = GetReason();
    glfwTerminate();
    throw RenderError(
      "no window with OpenGL 3.2 or newer can be opened (" + reason + "); update the driver");
  }
  glfwMakeContextCurrent(this->Handle);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(this->Handle, this);
  this->ListenTo();
}

//------------------------------------------------------------------------------
GLWindow::~GLWindow()
{
  glfwDestroyWindow(this->Handle);
  glfwTerminate();
}

//------------------------------------------------------------------------------
void GLWindow::ListenTo()
{
  glfwSetMouseButtonCallback(this->Handle,
    [](GLFWwindow* handle, int button, int action, int)
    {
      const GLWindow* window = GetWindow(handle);
      window->Listener.OnButton(button, action == GLFW_PRESS, window->MakePointer());
    });
  glfwSetCursorPosCallback(this->Handle,
    [](GLFWwindow* handle, double, double)
    {
      const GLWindow* window = GetWindow(handle);
      window->Listener.OnMove(window->MakePointer());
    });
  glfwSetScrollCallback(this->Handle,
    [](GLFWwindow* handle, double, double steps)
    {
      const GLWindow* window = GetWindow(handle);
      window->Listener.OnScroll(steps, window->MakePointer());
    });
  glfwSetKeyCallback(this->Handle,
    [](GLFWwindow* handle, int key, int scancode, int action, int)
    {
      if (action == GLFW_PRESS)
      {
        GetWindow(handle)->Listener.OnKey(FollowLabel(key, scancode));
      }
    });
  glfwSetDropCallback(this->Handle,
    [](GLFWwindow* handle, int count, const char** fileNames) {
      GetWindow(handle)->Listener.OnDrop({ fileNames, fileNames + count });
    });
  glfwSetFramebufferSizeCallback(
    this->Handle, [](GLFWwindow* handle, int, int) { GetWindow(handle)->Listener.OnRefresh(); });
  glfwSetWindowRefreshCallback(
    this->Handle, [](GLFWwindow* handle) { GetWindow(handle)->Listener.OnRefresh(); });
}

//------------------------------------------------------------------------------
Pointer GLWindow::MakePointer() const
{
  double x = 0.0;
  double y = 0.0;
  glfwGetCursorPos(this->Handle, &x, &y);
  const auto pixels = this->GetSize();
  const auto isHeld = [this](int left, int right)
  {
    return glfwGetKey(this->Handle, left) == GLFW_PRESS ||
      glfwGetKey(this->Handle, right) == GLFW_PRESS;
  };
  const float density = this->GetDensity();
  return { static_cast<int>(density * x), pixels[1] - 1 - static_cast<int>(density * y),
    isHeld(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
    isHeld(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL) };
}

//------------------------------------------------------------------------------
void GLWindow::MakeCurrent()
{
  glfwMakeContextCurrent(this->Handle);
}

//------------------------------------------------------------------------------
bool GLWindow::IsCurrent() const
{
  return glfwGetCurrentContext() == this->Handle;
}

//------------------------------------------------------------------------------
std::array<int, 2> GLWindow::GetSize() const
{
  std::array<int, 2> size = { 0, 0 };
  glfwGetFramebufferSize(this->Handle, &size[0], &size[1]);
  return size;
}

//------------------------------------------------------------------------------
void GLWindow::SetSize(const std::array<int, 2>& size)
{
  const float density = this->GetDensity();
  const std::array<int, 2> wanted = { static_cast<int>(size[0] / density),
    static_cast<int>(size[1] / density) };
  const Area area = GetRoom(this->Handle);
  if (area.Size[0] <= 0 || area.Size[1] <= 0)
  {
    glfwSetWindowSize(this->Handle, wanted[0], wanted[1]);
    return;
  }
  const std::array<int, 2> given = { std::min(wanted[0], area.Size[0]),
    std::min(wanted[1], area.Size[1]) };
  std::array<int, 2> position = { 0, 0 };
  glfwGetWindowPos(this->Handle, &position[0], &position[1]);
  glfwSetWindowSize(this->Handle, given[0], given[1]);
  for (int axis = 0; axis < 2; ++axis)
  {
    const int last = area.Position[axis] + area.Size[axis] - given[axis];
    position[axis] = std::clamp(position[axis], area.Position[axis], last);
  }
  glfwSetWindowPos(this->Handle, position[0], position[1]);
}

//------------------------------------------------------------------------------
float GLWindow::GetDensity() const
{
  int width = 0;
  glfwGetWindowSize(this->Handle, &width, nullptr);
  const int pixels = this->GetSize()[0];
  return width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1.0F;
}

//------------------------------------------------------------------------------
float GLWindow::GetScale() const
{
  float scale = 1.0F;
  glfwGetWindowContentScale(this->Handle, &scale, nullptr);
  return scale / this->GetDensity();
}

//------------------------------------------------------------------------------
void GLWindow::SetTitle(const std::string& title)
{
  glfwSetWindowTitle(this->Handle, title.c_str());
}

//------------------------------------------------------------------------------
bool GLWindow::IsClosed() const
{
  return glfwWindowShouldClose(this->Handle);
}

//------------------------------------------------------------------------------
void GLWindow::Close()
{
  glfwSetWindowShouldClose(this->Handle, GLFW_TRUE);
}

//------------------------------------------------------------------------------
void GLWindow::SwapBuffers()
{
  glfwSwapBuffers(this->Handle);
}

//------------------------------------------------------------------------------
void GLWindow::HandleEvents(bool waits)
{
  if (waits)
  {
    glfwWaitEvents();
  }
  else
  {
    glfwPollEvents();
  }
}
}
