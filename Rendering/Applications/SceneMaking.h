// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   From drawables to a scene: attributes, selection, importance, colours, segments.
 */

#ifndef SceneMaking_h
#define SceneMaking_h

#include "FrameStatistics.h"
#include "RenderScene.h"

namespace pellucid
{
struct MadeScene
{
  Scene Drawn;
  SceneStatistics Statistics;
  bool IsImportanceChosen = false; // by ChooseImportance(), not by the options
};

/**
 * The scene that the options make of drawables. Throw RenderError where the options ask for what
 * the data lacks, or leave nothing to draw.
 */
MadeScene MakeScene(std::vector<Drawable> drawables, RenderOptions options);
}

#endif
