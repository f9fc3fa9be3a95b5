#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-render: opacities that are optimised, and what the options of opacities refuse."""

import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter

from opacities import BEHIND, CROSSING, FLAT, HEIGHT, OpacityTest
from render_program import DATA, NEAR, make_polylines, write

OPTIMIZE = (*FLAT, *HEIGHT, "--optimize", "--r", "0", "--smoothing", "0")
PRESETS = {
    "clear-front": (400, 50, 4, 5),
    "balanced": (50, 100, 3, 5),
    "focus": (1000, 50, 3.5, 50),
    "clear-back": (50, 400, 2, 15),
    "points": (200, 50, 3, 0),
}


class TestOptimization(OpacityTest):
    def write_ball(self):
        """With the array x."""
        ball = self.folder / "ball.vtk"
        data = vtkPolyData()
        data.ShallowCopy(self.sphere)
        x = numpy.ascontiguousarray(vtk_to_numpy(data.GetPoints().GetData())[:, 0])
        array = numpy_to_vtk(x, deep=True)
        array.SetName("x")
        data.GetPointData().AddArray(array)
        write(vtkPolyDataWriter(), data, ball, FileType=2)
        return ball

    def test_what_hides_fades(self):
        for q, expected in ((0, 1), (1, 1 / 2), (3, 1 / 4), (50, 1 / 51)):
            self.assertAlmostEqual(
                self.opacity_at_crossing((*OPTIMIZE, "--q", q)), expected, delta=0.02)

    def test_what_is_behind_fades(self):
        """From behind, the important line is in front."""
        opaque = self.draw_lines(*FLAT, "--opacity", "1", *BEHIND)
        front, back = opaque[10, 60], opaque[45, 20]
        for r in (0, 1, 9):
            found = self.draw_lines(*FLAT, *HEIGHT, "--q", "0", "--r", r, "--smoothing", "0",
                                    "--opacity", "0.5", *BEHIND)[CROSSING]
            expected = 0.5 * front + 0.5 * 0.5 / (1 + r) * back
            self.assertLessEqual(abs(found - expected).max(), 1)

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
        self.assert_same((*FLAT, *HEIGHT, "--optimize"), (*FLAT, *HEIGHT, "--preset", "clear-front"))
        self.assert_same((*FLAT, *HEIGHT, "--preset", "focus", "--q", "2"),
                         (*FLAT, *HEIGHT, "--q", "2", "--r", "50", "--lambda", "3.5",
                          "--smoothing", "50"))

    def test_smoothing_spreads_along_lines(self):
        def faded(smoothing):
            picture = self.draw_lines(*FLAT, *HEIGHT, "--preset", "focus", "--smoothing", smoothing)
            return (abs(picture - opaque).max(axis=2) > 3).sum()
        opaque = self.draw_lines(*FLAT, "--opacity", "1")
        self.assertGreater(faded(50), 1.5 * faded(0))

    def test_surfaces_take_few_steps_of_presets(self):
        ball = (self.write_ball(), "--size", "120x90", *NEAR, "--importance", "x:-1:1")
        picture, _ = self.render(*ball, "--preset", "focus")
        few, _ = self.render(*ball, "--preset", "focus", "--smoothing", "5")
        many, _ = self.render(*ball, "--preset", "focus", "--smoothing", "50")
        self.assertTrue(numpy.array_equal(picture, few))
        self.assertFalse(numpy.array_equal(picture, many))

    def test_points_lines_and_surfaces_of_one_data_set(self):
        """All kinds of cells stay, each fades, and the reference agrees."""
        options = (self.mixed, "--size", "120x90", "--radius", "0.1", "--color-by", "x",
                   "--camera-position", "1,-2,4", "--focal-point", "0,0,0")
        opaque, _ = self.render(*options, "--opacity", "1")
        for importance in ("x:-1:1", "x:1:-1"):
            picture, statistics = self.assert_reference(
                *options, "--optimize", "--importance", importance)
            self.assertGreater(statistics["solved_fragments"], 1000)
            for stage in ("solve", "smooth"):
                self.assertGreater(statistics["stages"][stage], 0)
            self.assertFalse(numpy.array_equal(picture, opaque))
        same, _ = self.render(*options, "--importance", "x:-1:1", "--q", "0", "--r", "0")
        self.assertLess((abs(same - opaque).max(axis=2) > 1).mean(), 0.01)

    def test_self_occlusion(self):
        """Of a ball of few segments, near whose outline one is in front of itself."""
        options = (self.write_ball(), "--size", "120x90", *NEAR, "--importance", "x:-1:1", "--optimize")
        picture, _ = self.assert_reference(*options, "--self-occlusion")
        self.assertFalse(numpy.array_equal(picture, self.render(*options)[0]))

    def test_real_lines(self):
        options = (DATA / "combustor-lines.vtk", "--size", "160x120", "--optimize")
        picture, statistics = self.assert_reference(*options)
        self.assertFalse(
            numpy.array_equal(picture, self.render(*options[:3], "--opacity", "1")[0]))
        self.assertEqual(sum(statistics["importance_histogram"]["counts"]),
                         statistics["input_points"])

    def test_inputs_without_the_array_are_unimportant(self):
        """A ball around the lines is opaque but where it would hide them, in any order of inputs."""
        ball = self.folder / "bare.ply"
        write(vtkPLYWriter(), self.sphere, ball)
        options = ("--size", "120x90", *NEAR, *FLAT)
        on_line = (30, 60)
        opaque, _ = self.render(ball, self.lines, *options, "--opacity", "1")
        lines, _ = self.render(self.lines, *options, "--opacity", "1")
        hidden, _ = self.render(ball, self.lines, *options, *HEIGHT, "--q", "0", "--r", "0")
        self.assertLessEqual(abs(hidden - opaque)[on_line].max(), 1)
        for rule in (("--optimize",), ("--optimize", *HEIGHT), ("--avoid", "penalty")):
            picture, statistics = self.render(ball, self.lines, *options, *rule)
            swapped, _ = self.render(self.lines, ball, *options, *rule)
            self.assertLessEqual(abs(picture - swapped).max(), 1)
            self.assertEqual(statistics["importance"][0]["array"], "Height")
            to_line, to_ball = (abs(picture - other)[on_line].max() for other in (lines, opaque))
            self.assertLess(to_line, to_ball)

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
    """Without --importance, one array decides from its 50th to its 99th percentile."""

    def assert_default(self, name, *arguments):
        options = (*arguments, "--size", "80x60", "--optimize")
        default, statistics = self.render(*options)
        same, expected = self.render(
            *options, "--importance", name + ":50%:99%",
            *(() if "--color-by" in arguments else ("--color-by", name)))
        self.assertTrue(numpy.array_equal(default, same))
        for key in ("importance", "importance_histogram", "color_by"):
            self.assertEqual(statistics[key], expected[key])

    def test_array_that_colours(self):
        self.assert_default("Height", self.lines)
        self.assert_default("Line", self.lines, "--color-by", "Line")
        self.assert_default("SegmentLength", DATA / "combustor-lines.vtk", "--color-by", "SegmentLength")
        self.assert_default("Height", self.lines, "--color-by", "Height", "--exponent", "2")

    def test_importance_may_colour(self):
        picture, _ = self.render(self.lines, "--size", "80x60", "--optimize", "--color-by", "Importance")
        self.assertTrue((picture != picture[0, 0]).any())

    def test_speed_of_traced_lines(self):
        self.assert_default("Velocity", DATA / "combustor.vtk", "--seeds", "50")

    def test_ascent_of_lines_with_pressure(self):
        self.assert_default("TotalPressureDifference", DATA / "pacific.nc")

    def test_colors_change_no_ascent_and_no_speed(self):
        self.assert_default(
            "TotalPressureDifference", DATA / "pacific.nc", "--color-by", "pressure")
        self.assert_default(
            "Velocity", DATA / "combustor.vtk", "--seeds", "50", "--color-by", "Density")

    def test_lines_before_points_before_surfaces(self):
        """In any order of inputs."""
        files = {}
        for kind in ("Lines", "Verts", "Polys"):
            data = make_polylines([[(0, 0, 0), (1, 0, 0), (0, 1, 0)]], ((kind, (0, 1, 2)),))
            cells = data.GetLines()
            data.SetLines(None)
            getattr(data, "Set" + kind)(cells)
            files[kind] = self.folder / (kind + ".vtk")
            write(vtkPolyDataWriter(), data, files[kind], FileType=2)
        for kinds, expected in ((("Polys", "Verts", "Lines"), "Lines"), (("Polys", "Verts"), "Verts"),
                                (("Verts", "Polys"), "Verts")):
            self.assert_default(expected, *(files[kind] for kind in kinds))

    def test_choice_is_told(self):
        result = self.run_program(self.lines, "--size", "80x60", "--optimize", "-o",
                                  self.folder / "told.png")
        self.assertEqual(result.stdout, "Importance: Height, from 0.5 (50 %) to 1 (99 %)\n")

    def test_statistics_tell_importance(self):
        _, statistics = self.render(self.lines, "--importance", "Height:0%:100%:0.5")
        self.assertEqual(statistics["importance"],
                         [{"array": "Height", "minimum": 0, "maximum": 1, "weight": 0.5}])
        _, statistics = self.render(self.lines, "--color-by", "Line")
        self.assertEqual((statistics["importance"], statistics["color_by"]), ([], "Line"))

    def test_the_same_importance_everywhere(self):
        for option, value, arguments in (
            ("--optimize", 0, ("--optimize", "--importance", "Height:2:3")),
            ("--avoid", 1, ("--avoid", "penalty", "--importance", "Constant:0:1")),
        ):
            result = self.run_program(self.lines, "-o", self.folder / "same.png", *arguments)
            self.assertEqual(result.returncode, 0)
            self.assertIn(f"{option}: importance is {value} everywhere, so that nothing fades",
                          result.stderr)

    def test_lines_without_quantities(self):
        self.assert_default("Curvature", DATA / "fornix.trk")

    def test_nothing_to_tell_importance(self):
        write(vtkPLYWriter(), self.sphere, self.folder / "bare.ply")
        for option in (("--optimize",), ("--avoid", "penalty")):
            self.refuse(1, "--importance: no input has an array of numbers", self.folder / "bare.ply",
                        *option)
        self.refuse(1, "--color-by: there is no array 'q'", self.lines, "--optimize",
                    "--color-by", "q")


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
