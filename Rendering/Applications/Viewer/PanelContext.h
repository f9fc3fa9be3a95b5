// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Dear ImGui in a window.
 */

#ifndef PanelContext_h
#define PanelContext_h

struct GLFWwindow;

namespace pellucid
{
/** One at a time; listens to the window's events behind the listeners that are already there. */
class PanelContext
{
public:
  /** Text and controls `scale` times as large as on an ordinary screen. */
  PanelContext(GLFWwindow* window, float scale);
  ~PanelContext();
  PanelContext(const PanelContext&) = delete;
  void operator=(const PanelContext&) = delete;

  void SetScale(float scale);

  void BeginFrame();

  /** Draw all since BeginFrame() into the framebuffer that is bound. */
  void EndFrame();

  /** Close the lists that are open; whether there was one. */
  bool CloseLists();

  /** Whether the mouse, or the keyboard, is the panel's at the moment. */
  bool WantsMouse() const;
  bool WantsKeyboard() const;

private:
  float Scale = 0.0F;
};
}

#endif
