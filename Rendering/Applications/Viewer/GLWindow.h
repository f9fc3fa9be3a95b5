// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   A window of the desktop with an OpenGL context, by GLFW.
 */

#ifndef GLWindow_h
#define GLWindow_h

#include <array>  // for sizes
#include <string> // for titles and names
#include <vector> // for dropped files

struct GLFWwindow;

namespace pellucid
{
/** Where the mouse is, in pixels from the lower left corner, and what is held. */
struct Pointer
{
  int X = 0;
  int Y = 0;
  bool Shift = false;
  bool Control = false;
};

/** What happens to a window. */
class WindowListener
{
public:
  virtual ~WindowListener() = default;
  virtual void OnButton(int button, bool isPressed, const Pointer& pointer) = 0; // GLFW_MOUSE_...
  virtual void OnMove(const Pointer& pointer) = 0;
  virtual void OnScroll(double steps, const Pointer& pointer) = 0;
  virtual void OnKey(int key) = 0; // GLFW_KEY_... of its label; once while it is held
  virtual void OnDrop(const std::vector<std::string>& fileNames) = 0;
  virtual void OnRefresh() = 0; // a new size, or uncovered
};

/** One at a time. Its context is current from the start, in the thread that made it. */
class GLWindow
{
public:
  /**
   * Open a window, of OpenGL 4.3 or, where there is none, of at least 3.2, which VTK needs. Throw
   * RenderError without a display or such an OpenGL.
   */
  GLWindow(const std::array<int, 2>& size, bool isVisible, WindowListener& listener);
  ~GLWindow();
  GLWindow(const GLWindow&) = delete;
  void operator=(const GLWindow&) = delete;

  GLFWwindow* GetHandle() const { return this->Handle; }
  void MakeCurrent();
  bool IsCurrent() const;

  ///@{
  /**
   * Width and height in pixels; 0 while minimised. A window is made no larger than the first
   * monitor has room for, and moved into it; the desktop may give another size.
   */
  void SetSize(const std::array<int, 2>& size);
  std::array<int, 2> GetSize() const;
  ///@}

  /** Pixels for each unit of the desktop, in which positions of windows and the mouse are. */
  float GetDensity() const;

  /** How much larger than on an ordinary screen text and controls are to be, in desktop units. */
  float GetScale() const;

  void SetTitle(const std::string& title);
  bool IsClosed() const;
  void Close();

  /** Show what was drawn. */
  void SwapBuffers();

  /** Handle events; with `waits` sleep until there is one. */
  void HandleEvents(bool waits);

private:
  Pointer MakePointer() const;
  void ListenTo();

  WindowListener& Listener;
  GLFWwindow* Handle = nullptr;
};
}

#endif
