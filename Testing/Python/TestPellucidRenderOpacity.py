#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-render: optimised opacities, occlusion avoidance, and the views into a picture."""

import unittest

import numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter

from render_program import BACKGROUND, DATA, RenderTest, make_lines, make_polylines, write

CROSSING = (45, 60)  # row and column
BEHIND = ("--camera-position", "0,0,-4", "--focal-point", "0,0,0", "--view-up", "0,1,0")
FLAT = ("--radius", "0.1", "--lighting", "off", "--color-by", "Height")
HEIGHT = ("--importance", "Height:0:1")
# The lines of make_lines(): the first has importance 0 and is in front, the second 1.
OPTIMIZE = (*FLAT, *HEIGHT, "--optimize", "--r", "0", "--smoothing", "0")
PRESETS = {
    "balanced": (50, 100, 3, 5),
    "clear-front": (400, 50, 4, 5),
    "focus": (1000, 50, 3.5, 50),
    "clear-back": (50, 400, 2, 15),
    "points": (200, 50, 3, 0),
}


class OpacityTest(RenderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.mixed = cls.folder / "mixed.vtk"
        write(vtkPolyDataWriter(), cls.make_mixture(), cls.mixed, FileType=2)

    @staticmethod
    def make_mixture():
        """In one data set crossing lines, a point in front of them and a fan of triangles behind;
        the right is important."""
        data = make_lines()
        points = data.GetPoints()
        squares = vtkCellArray()
        for x in numpy.linspace(-0.8, 0.6, 8):
            squares.InsertNextCell(4)
            for dx, y in ((0, -0.5), (0.2, -0.5), (0.2, 0.5), (0, 0.5)):
                squares.InsertCellPoint(points.InsertNextPoint(x + dx, y, -0.5))
        vertices = vtkCellArray()
        for x in (-0.5, 0.5):
            vertices.InsertNextCell(1)
            vertices.InsertCellPoint(points.InsertNextPoint(x, 0, 0.5))
        lines = [points.GetPoint(i) for i in range(points.GetNumberOfPoints())]
        result = make_polylines([lines], (("x", [point[0] for point in lines]),))
        result.SetLines(data.GetLines())
        result.SetPolys(squares)
        result.SetVerts(vertices)
        return result

    def assert_reference(self, *arguments):
        """The picture is that of the reference renderer but for outlines; returns it."""
        picture, statistics = self.render(*arguments)
        reference, _ = self.render(*arguments, "--reference", environment={"DISPLAY": ""})
        difference = abs(picture - reference).max(axis=2)
        self.assertLess((difference > 1).mean(), 0.002, arguments)
        return picture, statistics

    def assert_same(self, first, second):
        self.assertTrue(numpy.array_equal(self.draw_lines(*first), self.draw_lines(*second)))

    def opacity_at_crossing(self, arguments, view=()):
        """That of the line in front, as the colours at the crossing tell."""
        opaque = self.draw_lines(*FLAT, "--opacity", "1", *view)
        # Away from the crossing, on the same lines.
        horizontal, vertical = opaque[45, 20], opaque[10, 60]
        front, back = (vertical, horizontal) if view else (horizontal, vertical)
        found = self.draw_lines(*arguments, *view)[CROSSING]
        return numpy.dot(found - back, front - back) / numpy.dot(front - back, front - back)


class TestOptimization(OpacityTest):
    def test_what_hides_fades(self):
        for q, expected in ((0, 1), (1, 1 / 2), (3, 1 / 4), (50, 1 / 51)):
            self.assertAlmostEqual(
                self.opacity_at_crossing((*OPTIMIZE, "--q", q)), expected, delta=0.02)

    def test_what_is_behind_fades(self):
        """Seen from behind, where the important line hides the other: it stays, and over its edge
        the other shows as it does without it."""
        options = (*FLAT, *HEIGHT, "--q", "0", "--smoothing", "0")
        self.assertAlmostEqual(
            self.opacity_at_crossing((*options, "--r", "9"), BEHIND), 1, delta=0.02)
        clear = self.draw_lines(*options, "--r", "9", *BEHIND)
        for row in (20, 70):
            self.assertTrue((clear[row, 60] == self.draw_lines(*FLAT, "--opacity", "1")[row, 60]).all())

    def test_lambda(self):
        half = (*FLAT, "--importance", "Height:-1:1", "--q", "4", "--r", "0", "--smoothing", "0")
        for exponent in (1, 3):
            self.assertAlmostEqual(self.opacity_at_crossing((*half, "--lambda", exponent)),
                                   1 / (1 + 4 * 0.5 ** (2 * exponent)), delta=0.02)
        squared = (*FLAT, "--importance", "Height:-1:1", "--exponent", "2", "--q", "4", "--r", "0",
                   "--smoothing", "0", "--lambda", "1")
        self.assertAlmostEqual(
            self.opacity_at_crossing(squared), 1 / (1 + 4 * 0.75**2), delta=0.02)

    def test_importance_is_no_factor(self):
        self.assert_same((*OPTIMIZE, "--q", "0"), (*FLAT, "--opacity", "1"))
        self.assert_same((*OPTIMIZE, "--q", "0", "--opacity", "0.3"), FLAT)

    def test_presets_and_parameters_over_them(self):
        for name, parameters in PRESETS.items():
            same = [part for pair in zip(("--q", "--r", "--lambda", "--smoothing"), parameters)
                    for part in pair]
            self.assert_same((*FLAT, *HEIGHT, "--preset", name), (*FLAT, *HEIGHT, *same))
        self.assert_same((*FLAT, *HEIGHT, "--optimize"), (*FLAT, *HEIGHT, "--preset", "balanced"))
        self.assert_same((*FLAT, *HEIGHT, "--preset", "focus", "--q", "2"),
                         (*FLAT, *HEIGHT, "--q", "2", "--r", "50", "--lambda", "3.5",
                          "--smoothing", "50"))

    def test_smoothing_spreads_along_lines(self):
        def faded(smoothing):
            picture = self.draw_lines(*FLAT, *HEIGHT, "--preset", "focus", "--smoothing", smoothing)
            return (abs(picture - opaque).max(axis=2) > 3).sum()
        opaque = self.draw_lines(*FLAT, "--opacity", "1")
        self.assertGreater(faded(50), 1.5 * faded(0))

    def test_points_lines_and_surfaces_of_one_data_set(self):
        """All kinds of cells stay, each fades, and the reference agrees."""
        options = (self.mixed, "--size", "120x90", "--radius", "0.1", "--color-by", "x",
                   "--background", "0,0,0")
        opaque, _ = self.render(*options, "--opacity", "1")
        for importance in ("x:-1:1", "x:1:-1"):
            picture, statistics = self.assert_reference(
                *options, "--optimize", "--importance", importance)
            self.assertGreater(statistics["solved_fragments"], 1000)
            for stage in ("solve", "smooth"):
                self.assertGreater(statistics["stages"][stage], 0)
            self.assertFalse(numpy.array_equal(picture, opaque))
        same, _ = self.render(*options, "--importance", "x:-1:1", "--q", "0", "--r", "0")
        self.assertTrue(numpy.array_equal(same != BACKGROUND, opaque != BACKGROUND))

    def test_self_occlusion(self):
        options = (self.mixed, "--size", "120x90", "--radius", "0.1", "--camera-position", "4,0,0",
                   "--focal-point", "0,0,0", "--importance", "x:-1:1", "--optimize")
        picture, _ = self.assert_reference(*options, "--self-occlusion")
        self.assertFalse(numpy.array_equal(picture, self.render(*options)[0]))

    def test_gather_scale(self):
        options = (self.mixed, "--size", "240x180", "--radius", "0.1", "--color-by", "x",
                   "--importance", "x:-1:1", "--optimize")
        full, _ = self.render(*options)
        self.assertTrue(numpy.array_equal(full, self.render(*options, "--gather-scale", "1")[0]))
        for scale in (2, 4):
            coarse, _ = self.assert_reference(*options, "--gather-scale", scale)
            self.assertGreater(abs(coarse - full).max(), 0)
            self.assertLess(abs(coarse - full).mean(), 5)

    def test_real_lines(self):
        options = (DATA / "combustor-lines.vtk", "--size", "160x120", "--optimize")
        picture, statistics = self.assert_reference(*options)
        self.assertFalse(
            numpy.array_equal(picture, self.render(*options[:3], "--opacity", "1")[0]))
        self.assertEqual(sum(statistics["importance_histogram"]["counts"]),
                         statistics["input_points"])

    def test_companions_keep_their_opacity(self):
        write(vtkPLYWriter(), self.sphere, self.folder / "sphere.ply")
        sphere = (self.folder / "sphere.ply", "--size", "120x90", *BEHIND, "--lighting", "off")
        alone, _ = self.render(*sphere)
        together, statistics = self.render(self.lines, *sphere, *HEIGHT, "--optimize")
        self.assertTrue((together[20, 45] == alone[20, 45]).all())
        self.assertGreater(statistics["fragments"], statistics["solved_fragments"])
        explicit, _ = self.render(self.lines, *sphere, *HEIGHT, "--optimize", "--opacity", "1")
        self.assertFalse((explicit[20, 45] == alone[20, 45]).all())

    def test_compare_shows_vtk_without(self):
        options = (*FLAT, "--background", "0,0,0")
        picture, _ = self.render(self.lines, "--size", "240x90", "--compare", *options, *HEIGHT,
                                 "--optimize")
        alone, _ = self.render(self.lines, "--size", "120x90", *options, *HEIGHT, "--optimize")
        stock, _ = self.render(self.lines, "--size", "120x90", "--method", "vtk", "--opacity", "1",
                               *options)
        lower = slice(30, None)  # below the titles
        self.assertTrue(numpy.array_equal(picture[lower, :120], alone[lower]))
        self.assertLessEqual(abs(picture[lower, 120:] - stock[lower]).max(), 1)


class TestDefaultImportance(OpacityTest):
    """Without --importance, the array that colours decides from its 50th to its 99th percentile."""

    def assert_default(self, name, *arguments):
        options = (*arguments, "--size", "80x60", "--optimize")
        default, statistics = self.render(*options)
        same, expected = self.render(
            *options, "--importance", name + ":50%:99%",
            *(() if "--color-by" in arguments else ("--color-by", name)))
        self.assertTrue(numpy.array_equal(default, same))
        self.assertEqual(statistics["importance_histogram"], expected["importance_histogram"])

    def test_array_that_colours(self):
        self.assert_default("Height", self.lines)
        self.assert_default("Line", self.lines, "--color-by", "Line")
        self.assert_default("SegmentLength", self.lines, "--color-by", "SegmentLength")
        self.assert_default("Height", self.lines, "--color-by", "Height", "--exponent", "2")

    def test_importance_may_colour(self):
        picture, _ = self.render(self.lines, "--size", "80x60", "--optimize", "--color-by", "Importance")
        self.assertTrue((picture != picture[0, 0]).any())

    def test_speed_of_traced_lines(self):
        self.assert_default("Velocity", DATA / "combustor.vtk", "--seeds", "50")

    def test_ascent_of_lines_with_pressure(self):
        self.assert_default("TotalPressureDifference", DATA / "pacific.nc")

    def test_lines_without_quantities(self):
        self.assert_default("Curvature", DATA / "fornix.trk")

    def test_nothing_to_tell_importance(self):
        write(vtkPLYWriter(), self.sphere, self.folder / "bare.ply")
        for option in (("--optimize",), ("--avoid", "penalty")):
            self.refuse(1, "--importance: no input has an array of numbers", self.folder / "bare.ply",
                        *option)
        self.refuse(1, "--color-by: there is no array 'q'", self.lines, "--optimize",
                    "--color-by", "q")


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
            self.assert_same((*avoid, "--avoid-opacity", "0.5"), (*avoid, "--opacity", "0.5"))

    def test_reference(self):
        for file in (self.mixed, DATA / "combustor-lines.vtk"):
            options = (file, "--size", "160x120", "--radius", "0.05")
            opaque, _ = self.render(*options, "--opacity", "1")
            for avoid in (("penalty",), ("weighting",), ("penalty", "--avoid-smoothing")):
                picture, _ = self.assert_reference(*options, "--avoid", *avoid)
                self.assertFalse(numpy.array_equal(picture, opaque))


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


class TestUsage(OpacityTest):
    def test_wrong_values(self):
        presets = "|".join(PRESETS)
        for option, expected, texts in (
            ("--preset", presets, ("strong", "")),
            ("--q", "a number of at least 0", ("-1", "x", "nan")),
            ("--r", "a number of at least 0", ("-1", "x", "inf")),
            ("--lambda", "a number of at least 0.01 and at most 100", ("0", "101", "x")),
            ("--smoothing", "a whole number of at least 0 and at most 10000", ("-1", "1.5", "10001")),
            ("--gather-scale", "a whole number of at least 1 and at most 4", ("0", "5", "1.5")),
            ("--avoid", "penalty|weighting", ("everything", "")),
            ("--avoid-penalty", "a number of at least 0 and at most 1", ("-1", "1.5")),
            ("--avoid-importance", "a number of at least 0", ("-1", "1e39")),
            ("--avoid-coverage", "a number of at least 0", ("-1", "x")),
            ("--avoid-variance", "a number of at least 0", ("-1", "x")),
            ("--avoid-depth", "a number of at least 0", ("-1", "x")),
            ("--avoid-opacity", "a number of at least 0 and at most 1", ("-1", "2")),
            ("--view", "picture|opacity|importance|segments|length|first:N|layer:N",
             ("depth", "first", "first:0", "layer:1.5", "layer:-1", "layer:x", "layer:3000000000",
              "opacity:1", "")),
        ):
            for text in texts:
                with self.subTest(option=option, text=text):
                    self.refuse(2, f"{option}: expected {expected}", self.lines, f"{option}={text}")

    def test_options_without_effect(self):
        weighting, penalty = ("--avoid", "weighting"), ("--avoid", "penalty")
        for text, *arguments in (
            ("--optimize: and --avoid replace each other", "--optimize", *penalty),
            *((f"{option[0]}: belongs to --optimize, which --avoid replaces", *option, *weighting)
              for option in (("--preset", "focus"), ("--q", "1"), ("--r", "1"), ("--smoothing", "1"),
                             ("--self-occlusion",), ("--gather-scale", "2"))),
            ("--lambda: has no effect with --avoid penalty", "--lambda", "2", *penalty),
            ("--gather-scale: belongs to --optimize; add", "--gather-scale", "2"),
            ("--avoid-penalty: belongs to --avoid penalty", "--avoid-penalty", "0.5"),
            ("--avoid-penalty: belongs to --avoid penalty", "--avoid-penalty", "0.5", *weighting),
            *((f"{option}: belongs to --avoid weighting", option, "1", *rule)
              for option in ("--avoid-importance", "--avoid-coverage", "--avoid-variance",
                             "--avoid-depth")
              for rule in ((), penalty, ("--optimize",))),
            ("--avoid-opacity: belongs to --avoid;", "--avoid-opacity", "1"),
            ("--avoid-smoothing: belongs to --avoid;", "--avoid-smoothing", "--optimize"),
            ("--view opacity: shows what --optimize or --avoid finds", "--view", "opacity"),
            ("--view importance: shows what", "--view", "importance", *HEIGHT),
            ("--view segments: shows what --optimize works with", "--view", "segments", *penalty),
            ("--optimize: is not for VTK's own methods", "--method", "vtk", "--q", "1"),
            ("--avoid: is not for VTK's own methods", "--method", "vtk-peeling", *penalty),
            ("--view: is not for VTK's own methods", "--method", "vtk", "--view", "length"),
        ):
            with self.subTest(arguments=arguments):
                self.refuse(2, text, self.lines, *arguments)

    def test_help(self):
        text = self.run_program("--help").stdout
        for part in ("Opacity that clears the view", "|".join(PRESETS), "--avoid-depth", "--optimize"):
            self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main()
