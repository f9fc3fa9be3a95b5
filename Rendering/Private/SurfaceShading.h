// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    SurfaceShading.h
 * @brief   The colour of a surface point under VTK's lighting model.
 *
 * Restates, on any scalar type, what the fragment shader of vtkOpenGLPolyDataMapper computes for
 * flat, Gouraud and Phong interpolation (VTK lights every fragment in all three): its three cases
 * of a lone headlight, of directional lights, and of lights with a position, including their floors
 * of 1e-6 and 1e-5. Positions, directions and normals are in view coordinates: the eye at the
 * origin, looking along -z. As in VTK, the direction to the viewer is that to the origin also when
 * the projection is parallel.
 */

#ifndef SurfaceShading_h
#define SurfaceShading_h

#include "RayIntersection.h"

#include <vector>

namespace pellucid
{
/** Into [0,1], as a framebuffer of 8 bits takes it; NaN becomes 0. */
template <typename Real>
Real Saturate(Real value)
{
  return value > 0 ? std::min(value, Real(1)) : Real(0);
}

/** Reflection of a surface: straight colours in [0,1], each with its factor. */
template <typename Real>
struct Material
{
  Vector3<Real> ambientColor{ Real(1) };
  Vector3<Real> diffuseColor{ Real(1) };
  Vector3<Real> specularColor{ Real(1) };
  Real ambient = 0;
  Real diffuse = 1;
  Real specular = 0;
  Real specularPower = 1;
  Real opacity = 1;
};

/** A light that is on. `color` includes the intensity; `coneAngle` is in degrees, from the axis,
 * and 90 or more stands for a light that shines all round. */
template <typename Real>
struct Light
{
  Vector3<Real> color{ Real(1) };
  Vector3<Real> direction{ Real(0), Real(0), Real(-1) };
  Vector3<Real> position{ Real(0) };
  Vector3<Real> attenuation{ Real(1), Real(0), Real(0) };
  Real exponent = 1;
  Real coneAngle = 90;
  bool positional = false;
};

/** All lights of a scene. A lone headlight has a shorter formula than the general one. */
template <typename Real>
struct Lighting
{
  std::vector<Light<Real>> lights;
  bool loneHeadlight = false;
};

/** Direction in which light travels at a point, and the share of it that arrives. */
template <typename Real>
struct Illumination
{
  Vector3<Real> direction;
  Real share;
};

template <typename Real>
Illumination<Real> Illuminate(const Light<Real>& light, const Vector3<Real>& position)
{
  if (!light.positional)
  {
    return { light.direction, Real(1) };
  }
  const Vector3<Real> path = position - light.position;
  const Real distance = glm::length(path);
  if (!(distance > 0))
  {
    return { light.direction, Real(0) };
  }
  const Vector3<Real> direction = path / distance;
  Real share = 1 / glm::dot(light.attenuation, Vector3<Real>(1, distance, distance * distance));
  if (light.coneAngle < 90)
  {
    const Real cosine = glm::dot(direction, light.direction);
    share = cosine >= std::cos(glm::radians(light.coneAngle))
      ? share * std::pow(cosine, light.exponent)
      : Real(0);
  }
  return { direction, share };
}

/**
 * The lit colour at `position`, not clamped. `normal` is a unit vector, turned to the side that is
 * seen.
 */
template <typename Real>
Vector3<Real> Shade(const Lighting<Real>& lighting, const Material<Real>& material,
  const Vector3<Real>& position, const Vector3<Real>& normal)
{
  const Vector3<Real> ambient = material.ambient * material.ambientColor;
  Vector3<Real> diffuse(Real(0));
  Vector3<Real> specular(Real(0));
  if (lighting.loneHeadlight)
  {
    const Real cosine = std::max(Real(0.000001), normal.z);
    diffuse = cosine * lighting.lights.front().color;
    specular = std::pow(cosine, material.specularPower) * lighting.lights.front().color;
  }
  else
  {
    const Vector3<Real> toViewer = glm::normalize(-position);
    for (const auto& light : lighting.lights)
    {
      const auto [direction, share] = Illuminate(light, position);
      const Real cosine = share * glm::dot(normal, -direction);
      if (cosine > 0)
      {
        const Real mirrored = glm::dot(glm::reflect(direction, normal), toViewer);
        diffuse += cosine * light.color;
        specular +=
          share * std::pow(std::max(Real(1e-5), mirrored), material.specularPower) * light.color;
      }
    }
  }
  return ambient + material.diffuse * material.diffuseColor * diffuse +
    material.specular * material.specularColor * specular;
}

/** The colour of a surface that takes no part in lighting, not clamped. */
template <typename Real>
Vector3<Real> Unlit(const Material<Real>& material)
{
  return material.ambient * material.ambientColor + material.diffuse * material.diffuseColor;
}
}

#endif
