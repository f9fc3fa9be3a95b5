// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's lighting model against closed forms: headlight, directional lights, and positional lights
 * with attenuation and cone; colours that are not numbers do no harm.
 */

#include "ReferenceTesting.h"
#include "SurfaceShading.h"

namespace
{
using Vec = pellucid::Vector3<double>;

pellucid::Material<double> MakeMaterial()
{
  pellucid::Material<double> material;
  material.ambientColor = Vec(0.1, 0.2, 0.3);
  material.diffuseColor = Vec(0.4, 0.5, 0.6);
  material.specularColor = Vec(0.7, 0.8, 0.9);
  material.ambient = 0.5;
  material.diffuse = 0.8;
  material.specular = 0.25;
  material.specularPower = 10.0;
  return material;
}

void Compare(Checks& checks, const std::string& name, const Vec& found, double diffuse,
  double specular, const Vec& light)
{
  const auto material = MakeMaterial();
  const Vec expected = material.ambient * material.ambientColor +
    diffuse * material.diffuse * material.diffuseColor * light +
    specular * material.specular * material.specularColor * light;
  for (int i = 0; i < 3; ++i)
  {
    checks.Near(name, found[i], expected[i], 1e-13);
  }
}

void TestNotNumbers(Checks& checks)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  checks.Near("NaN saturates to 0", pellucid::Saturate(nan), 0, 0);
  checks.Near("infinity saturates to 1", pellucid::Saturate(infinity), 1, 0);
  checks.Near("minus infinity saturates to 0", pellucid::Saturate(-infinity), 0, 0);
  checks.Near("within the range nothing changes", pellucid::Saturate(0.3), 0.3, 0);
}
}

int TestReferenceShading(int, char*[])
{
  Checks checks;
  const auto material = MakeMaterial();
  const Vec lightColor(1.0, 0.9, 0.8);
  const Vec position(0, 0, -5);
  const Vec facing(0, 0, 1);
  const Vec tilted(0.6, 0, 0.8);

  pellucid::Lighting<double> headlight;
  headlight.lights.emplace_back();
  headlight.lights.front().color = lightColor;
  headlight.loneHeadlight = true;
  Compare(checks, "headlight at normal incidence", Shade(headlight, material, position, facing), 1,
    1, lightColor);
  Compare(checks, "headlight on a tilted surface", Shade(headlight, material, position, tilted),
    0.8, std::pow(0.8, 10), lightColor);
  Compare(checks, "headlight from behind has a floor",
    Shade(headlight, material, position, -facing), 1e-6, 1e-60, lightColor);

  // Without loneHeadlight the highlight is where the mirrored light meets the viewer.
  pellucid::Lighting<double> directional = headlight;
  directional.loneHeadlight = false;
  Compare(checks, "directional light at normal incidence",
    Shade(directional, material, position, facing), 1, 1, lightColor);
  Compare(checks, "directional light on a tilted surface",
    Shade(directional, material, position, tilted), 0.8, std::pow(0.28, 10), lightColor);
  Compare(checks, "directional light from behind", Shade(directional, material, position, -facing),
    0, 0, lightColor);

  pellucid::Lighting<double> two = directional;
  two.lights.push_back(two.lights.front());
  Compare(checks, "two equal lights", Shade(two, material, position, facing), 2, 2, lightColor);

  pellucid::Lighting<double> lamp = directional;
  lamp.lights.front().positional = true;
  lamp.lights.front().position = Vec(0, 0, -3);
  lamp.lights.front().attenuation = Vec(1.0, 0.5, 0.25);
  const double share = 1 / (1.0 + 0.5 * 2 + 0.25 * 4);
  Compare(
    checks, "attenuated lamp", Shade(lamp, material, position, facing), share, share, lightColor);

  lamp.lights.front().coneAngle = 30.0;
  lamp.lights.front().exponent = 3.0;
  lamp.lights.front().position = Vec(1, 0, -3);
  const double distance = std::sqrt(5.0);
  const double cosine = 2 / distance;
  const double spot = std::pow(cosine, 3) / (1.0 + 0.5 * distance + 0.25 * 5);
  Compare(checks, "spot light, within the cone", Shade(lamp, material, position, facing),
    spot * cosine, spot * std::pow(cosine, 10), lightColor);
  lamp.lights.front().coneAngle = 20.0;
  Compare(checks, "spot light, outside the cone", Shade(lamp, material, position, facing), 0, 0,
    lightColor);

  const Vec unlit = pellucid::Unlit(material);
  checks.Near("unlit", unlit.x, 0.5 * 0.1 + 0.8 * 0.4, 1e-15);
  TestNotNumbers(checks);
  return checks.Result();
}
