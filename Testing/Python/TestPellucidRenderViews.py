#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-render: occlusion avoidance, opacities found in a smaller picture, and views into one."""

import unittest

import numpy

from opacities import CROSSING, FLAT, HEIGHT, OpacityTest
from render_program import BACKGROUND, DATA


class TestAvoidance(OpacityTest):
    def test_penalty(self):
        options = (*FLAT, *HEIGHT, "--avoid", "penalty")
        self.assertAlmostEqual(self.opacity_at_crossing(options), 0.25, delta=0.02)
        for penalty in (0, 0.5, 1):
            self.assertAlmostEqual(
                self.opacity_at_crossing((*options, "--avoid-penalty", penalty)), penalty, delta=0.02)

    def test_weighting(self):
        """At the crossing M = 1, C = 2 and V = 1 - sqrt(1/2)."""
        weights = ("--avoid-importance", "--avoid-coverage", "--avoid-variance", "--avoid-depth")
        options = (*FLAT, *HEIGHT, "--avoid", "weighting")
        variance = 1 - 0.5**0.5
        default = 1 / (1 + 1 + 0.02 * 2 + 0.5 * variance + 10)
        self.assertAlmostEqual(self.opacity_at_crossing(options), default, delta=0.02)
        for weight, value in zip(weights, (1, 2, variance, 1)):
            alone = [part for name in weights for part in (name, "3" if name == weight else "0")]
            self.assertAlmostEqual(
                self.opacity_at_crossing((*options, *alone)), 1 / (1 + 3 * value), delta=0.02)

    def test_lambda(self):
        options = (*FLAT, "--importance", "Height:-1:1", "--avoid", "weighting",
                   "--avoid-importance", "4", "--avoid-coverage", "0", "--avoid-variance", "0",
                   "--avoid-depth", "0")
        for exponent in (1, 3):
            self.assertAlmostEqual(self.opacity_at_crossing((*options, "--lambda", exponent)),
                                   1 / (1 + 4 * (1 - 0.5**exponent)), delta=0.02)

    def test_global_opacity(self):
        for mode in ("penalty", "weighting"):
            avoid = (*FLAT, *HEIGHT, "--avoid", mode)
            self.assert_same((*avoid, "--avoid-opacity", "0.5"), (*avoid, "--opacity", "0.5"), 1)

    def test_reference(self):
        for file in (self.mixed, DATA / "combustor-lines.vtk"):
            options = (file, "--size", "160x120", "--radius", "0.05")
            opaque, _ = self.render(*options, "--opacity", "1")
            for avoid in (("penalty",), ("weighting",), ("penalty", "--avoid-smoothing")):
                picture, _ = self.assert_reference(*options, "--avoid", *avoid)
                self.assertFalse(numpy.array_equal(picture, opaque))


class TestGatherScale(OpacityTest):
    def test_coarse_opacities(self):
        options = (self.mixed, "--size", "240x180", "--radius", "0.1", "--color-by", "x",
                   "--importance", "x:-1:1", "--optimize")
        full, _ = self.render(*options)
        self.assertTrue(numpy.array_equal(full, self.render(*options, "--gather-scale", "1")[0]))
        for scale in (2, 4):
            coarse, _ = self.assert_reference(*options, "--gather-scale", scale)
            self.assertGreater(abs(coarse - full).max(), 0)
            self.assertLess(abs(coarse - full).mean(), 5)


class TestViews(OpacityTest):
    OPTIONS = (*FLAT, *HEIGHT, "--optimize")

    def test_numbers(self):
        """From black (0) through red and yellow to white (1)."""
        importance = self.draw_lines(*self.OPTIONS, "--view", "importance")
        self.assertEqual(importance[45, 20].tolist(), [0, 0, 0])
        self.assertEqual(importance[10, 60].tolist(), [255, 255, 255])
        opacity = self.draw_lines(*self.OPTIONS, "--view", "opacity")
        self.assertEqual(opacity[10, 60].tolist(), [255, 255, 255])
        self.assertLess(opacity[CROSSING].sum(), opacity[45, 20].sum())
        length = self.draw_lines(*FLAT, "--view", "length")
        self.assertEqual(length[CROSSING].tolist(), [255, 255, 255])
        self.assertTrue(0 < length[10, 60].sum() < 3 * 255)
        self.assertTrue((length[10, 60] == length[45, 20]).all())

    def test_layers(self):
        self.assert_same((*FLAT, "--view", "first:2"), FLAT)
        self.assert_same((*FLAT, "--view", "first:1"), (*FLAT, "--view", "layer:1"))
        self.assert_same((*FLAT, "--view", "picture"), FLAT)
        second = self.draw_lines(*FLAT, "--view", "layer:2")
        self.assertTrue((second[CROSSING] != BACKGROUND).any())
        self.assertTrue((second[45, 20] == BACKGROUND).all())
        self.assertTrue((self.draw_lines(*FLAT, "--view", "layer:3") == BACKGROUND).all())

    def test_segments(self):
        segments = self.draw_lines(*self.OPTIONS, "--view", "segments")
        colors = {tuple(color) for color in segments.reshape(-1, 3).tolist()}
        self.assertGreater(len(colors), 20)

    def test_reference(self):
        for view in ("opacity", "importance", "segments", "length", "first:2", "layer:2"):
            with self.subTest(view=view):
                self.assert_reference(self.mixed, "--size", "120x90", "--radius", "0.1",
                                      "--optimize", "--importance", "x:-1:1", "--view", view)
        self.assert_reference(self.mixed, "--size", "120x90", "--radius", "0.1", "--avoid",
                              "penalty", "--importance", "x:-1:1", "--view", "opacity")


if __name__ == "__main__":
    unittest.main()
