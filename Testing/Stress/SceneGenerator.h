// SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file    SceneGenerator.h
 * @brief   Random scenes for RapidCheck, which shrink towards few props of simple values.
 */

#ifndef SceneGenerator_h
#define SceneGenerator_h

#include "SceneDescription.h"

#include <rapidcheck.h>

#include <string>
#include <utility>
#include <vector>

namespace pellucid
{
/** One of the values, each as likely; the first is the simplest. */
template <typename T>
rc::Gen<T> OneOf(std::vector<T> values)
{
  const auto count = static_cast<int>(values.size());
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, count)),
    [values = std::move(values)](int index) { return T(values[index]); });
}

/** One of several words. */
inline rc::Gen<std::string> Word(std::vector<std::string> words)
{
  return OneOf(std::move(words));
}

/** Once in so many times. */
inline rc::Gen<bool> Sometimes(int times)
{
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, times)),
    [times](int value) { return value == times - 1; });
}

inline rc::Gen<PropDescription> MakePropGenerator()
{
  using P = PropDescription;
  using rc::gen::set;
  return rc::gen::build<P>(
    set(&P::Kind, Word({ "lines", "lines", "lines", "balls", "sphere", "sheets", "glyphs" })),
    set(&P::Shape, Word({ "walk", "walk", "kinks", "repeats", "backward" })),
    set(&P::Mapper, Word({ "vtkPolyDataMapper", "vtkTrajectoryMapper" })),
    set(&P::Seed, rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1000))),
    set(&P::Cells, OneOf<int>({ 1, 2, 5, 20, 60 })),
    set(&P::PointsPerCell, OneOf<int>({ 2, 1, 3, 10, 40 })),
    set(&P::Radius, OneOf<double>({ 0.1, 0.0, 0.02, 0.03, 0.04, 0.3, 1e-3, 1e-7, 3.0, 1e3 })),
    set(&P::RadiusArray, rc::gen::arbitrary<bool>()),
    set(&P::Opacity, OneOf<double>({ 0.5, 1.0, 0.1, 0.9, 0.01, 1e-4, 0.3, 0.7 })),
    set(&P::OpacityArray, Sometimes(4)),
    set(&P::Colors, Word({ "property", "table", "opacities", "texture" })),
    set(&P::Lighting, rc::gen::arbitrary<bool>()), set(&P::ClippingPlane, Sometimes(6)),
    set(&P::MissingPoints, Sometimes(8)),
    set(&P::Importance, Word({ "constant", "wave", "wave", "wild" })),
    set(&P::Range,
      OneOf<std::vector<double>>({ { 0.0, 1.0 }, { 0.0, 1.0 }, { 1.0, 0.0 }, { 0.5, 0.5 } })),
    set(
      &P::Method, Word({ "none", "none", "optimization", "optimization", "penalty", "weighting" })),
    set(&P::Segments, OneOf<int>({ 0, 1, 30, 300 })),
    set(&P::OcclusionWeight, OneOf<double>({ 0.0, 1.0, 50.0, 400.0, 1e5 })),
    set(&P::ClutterWeight, OneOf<double>({ 0.0, 1.0, 50.0, 400.0, 1e5 })),
    set(&P::Emphasis, OneOf<double>({ 1.0, 0.01, 2.0, 3.5, 100.0 })),
    set(&P::SmoothingIterations, OneOf<int>({ 0, 1, 5, 50 })),
    set(&P::SelfOcclusion, rc::gen::arbitrary<bool>()),
    set(&P::SmoothAttributes, rc::gen::arbitrary<bool>()),
    set(&P::Penalty, OneOf<double>({ 0.25, 0.0, 1.0, 0.9 })));
}

inline rc::Gen<SceneDescription> MakeSceneGenerator(int largestNumberOfProps = 5)
{
  using S = SceneDescription;
  using rc::gen::set;
  return rc::gen::build<S>(set(&S::Width, OneOf<int>({ 61, 1, 17, 80, 120, 301 })),
    set(&S::Height, OneOf<int>({ 47, 1, 16, 79, 199 })),
    set(&S::Samples, OneOf<int>({ 0, 0, 0, 4 })), set(&S::MemoryLimit, OneOf<int>({ 1024, 1 })),
    set(&S::GatherScale, OneOf<int>({ 1, 1, 1, 2, 4 })),
    set(&S::TransparentBackground, Sometimes(4)),
    set(&S::ParallelProjection, rc::gen::map(Sometimes(2), [](bool is) { return !is; })),
    set(&S::Azimuth, OneOf<double>({ 0.0, 30.0, 200.0 })),
    set(&S::Elevation, OneOf<double>({ 0.0, 40.0, -89.0 })),
    set(&S::Zoom, OneOf<double>({ 1.0, 3.0, 0.2 })), set(&S::EyeInside, Sometimes(6)),
    set(&S::NearToFar, OneOf<double>({ 0.0, 0.0, 0.0, 1e2, 1e9 })),
    set(&S::Offset, OneOf<double>({ 0.0, 0.0, 0.0, 180.0, 6.4e6 })),
    set(&S::Stretch, OneOf<double>({ 1.0, 1.0, 500.0 })),
    set(&S::Compensated, OneOf<bool>({ true, false })),
    set(&S::Lights, Word({ "none", "scene", "spot", "many" })),
    set(&S::Props,
      rc::gen::resize(largestNumberOfProps,
        rc::gen::container<std::vector<PropDescription>>(MakePropGenerator()))));
}
}

#endif
