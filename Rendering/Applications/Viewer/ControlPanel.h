// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   The panel beside the picture: method, opacities, view, statistics, messages.
 */

#ifndef ControlPanel_h
#define ControlPanel_h

#include "ViewedScene.h"

namespace pellucid
{
/** What the panel shows beside the scene. */
struct PanelContents
{
  FrameStatistics Statistics; // of the last frame
  std::string Message;        // what was done; empty: nothing to say
  std::string Error;          // what could not be done; empty: nothing
  std::string Unsupported;    // why the exact method cannot be chosen; empty: it can
};

/** What was asked for. */
struct PanelRequest
{
  Change Changed = Change::None;
  bool ResetsCamera = false;
  bool SavesPicture = false;
};

/** Width of the panel at scale 1, in the units of the desktop. */
constexpr int PanelWidth = 300;

/**
 * Draw the panel at the right side of the window, `width` wide, let it edit the options of the
 * scene and the seconds of the fade, and tell what has to follow.
 */
PanelRequest DrawPanel(
  ViewedScene& scene, double& fadeTime, const PanelContents& contents, float width);

/** Over the middle of a picture that shows nothing yet, `width` wide. */
void DrawHint(const std::string& text, float width);

/** Over the top of the picture, `width` wide, where there is no panel: what could not be done. */
void DrawError(const std::string& text, float width);
}

#endif
