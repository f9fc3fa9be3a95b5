// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "SceneMaking.h"

#include "LineAttributes.h"
#include "LineSelection.h"
#include "SceneSegments.h"

namespace pellucid
{
//------------------------------------------------------------------------------
MadeScene MakeScene(std::vector<Drawable> drawables, RenderOptions options)
{
  SceneStatistics statistics;
  const bool isChosen = ChooseImportance(drawables, options);
  AddNamedAttributes(drawables, options);
  for (const Drawable& drawable : drawables)
  {
    statistics.InputPoints += drawable.GetNumberOfPoints();
    statistics.InputLines += drawable.GetNumberOfLines();
  }
  SelectLines(drawables, options);
  for (const Drawable& drawable : drawables)
  {
    statistics.SelectedLines += drawable.GetNumberOfLines();
  }
  statistics.Importance = AddImportance(drawables, options);
  const Coloring colors(drawables, options);
  statistics.ColorBy = colors.GetName();
  if (options.Opacities.Rule == OpacityRule::Optimization)
  {
    AddSegments(drawables);
  }
  return { { std::move(drawables), colors }, statistics, isChosen };
}
}
