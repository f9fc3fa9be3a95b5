// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief   Scenes and methods by their names.
 */

#ifndef Choices_h
#define Choices_h

#include "Methods.h"
#include "RenderError.h"
#include "Scenes.h"

#include <functional> // for scenes that are made when they are wanted
#include <iosfwd>     // for the list
#include <string>     // for names
#include <vector>     // for choices

namespace pellucid
{
namespace benchmark
{
/** Thrown where no scene or method has that name; what() names those that there are. */
class UnknownName : public RenderError
{
public:
  using RenderError::RenderError;
};

struct SceneChoice
{
  std::string Name;
  std::string Description;
  std::function<Scene()> Make;
};

/**
 * The scenes that match a name or pattern, in the order of the patterns, none twice. A name may
 * have any size that its family allows; patterns match those that are listed.
 */
std::vector<SceneChoice> ChooseScenes(
  const std::vector<std::string>& patterns, const std::string& dataFolder);

/** The methods that match, in the order of GetMethods(). */
std::vector<Method> ChooseMethods(const std::vector<std::string>& patterns);

/** Those of the methods that say something of the scene. */
std::vector<Method> ChooseSuitable(const std::vector<Method>& methods, const Scene& scene);

/** Name and describe everything that can be chosen. */
void WriteList(std::ostream& stream, const std::string& dataFolder);
}
}

#endif
