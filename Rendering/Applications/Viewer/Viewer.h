// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The window of pellucid-view: a picture, a panel, and what the user does.
 */

#ifndef Viewer_h
#define Viewer_h

#include "ControlPanel.h"
#include "EmbeddedView.h"
#include "PanelContext.h"

namespace pellucid
{
class Viewer : public WindowListener
{
public:
  /** Throw RenderError where no window can be opened, or a file of the options not be drawn. */
  explicit Viewer(const RenderOptions& options);

  /** Show the window until it is closed. Sleeps while nothing happens and nothing fades. */
  void Run();

  /** Draw once, without the panel, and write the picture; throw RenderError where that fails. */
  void WriteScreenshot();

  void OnButton(int button, bool isPressed, const Pointer& pointer) override;
  void OnMove(const Pointer& pointer) override;
  void OnScroll(double steps, const Pointer& pointer) override;
  void OnKey(int key) override;
  void OnDrop(const std::vector<std::string>& fileNames) override;
  void OnRefresh() override;

private:
  template <typename Work>
  void Try(const Work& work);

  void ShowError(const std::string& text);
  void CheckOpenGL();
  void OpenDropped();
  void DrawFrame();
  void DrawView(double fadeTime);
  PanelRequest DrawControls();
  void Obey(const PanelRequest& request);
  void ShowScene();
  void TakeStatistics();
  void SavePicture();
  bool IsFading() const;
  bool IsHidden() const;
  bool IsOverPanel(const Pointer& pointer) const;
  int GetPanelWidth() const;

  ViewedScene Scene;
  GLWindow Window;
  EmbeddedView View;
  PanelContext Panel;
  PanelContents Contents;
  double FadeTime = 0.3; // seconds
  bool IsPanelShown = true;
  bool IsSaving = false;
  bool IsDrawn = false;             // the last picture, without an error
  int DraggingButton = -1;          // the one that was pressed over the picture; -1: none
  int FramesToDraw = 0;             // until the panel has come to rest
  std::vector<std::string> Dropped; // files to open
};
}

#endif
