#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid-render: importance, selection, computed arrays and the table of arrays."""

import unittest

import numpy
import pellucid
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter

from render_program import BACKGROUND, DATA, RenderTest, make_polylines, write

POINTS = 9
VIEW = ("--camera-position", "1,0,6", "--focal-point", "1,0,0", "--view-up", "0,1,0",
        "--size", "160x120", "--background", "0,0,0")


class ImportanceTest(RenderTest):
    """Four horizontal lines, one above the other, along which pressure falls by 100, 200, ... hPa;
    the second lacks two values."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        x = numpy.linspace(0, 2, POINTS)
        cls.positions = [[(value, 0.5 * row - 0.75, 0.1 * row) for value in x] for row in range(4)]
        cls.pressure = numpy.array([1000 - 50 * (row + 1) * x for row in range(4)])
        cls.pressure[1, 3:5] = numpy.nan
        cls.wind = numpy.array([(3 * row, 4 * row, 0) for row in range(4) for _ in range(POINTS)])
        cls.data = make_polylines(
            cls.positions,
            (("p", cls.pressure.ravel()), ("wind", cls.wind), ("a:b:2", cls.pressure.ravel())),
            (("number", range(4)),),
            {"p": "hPa", "wind": "m s-1"})
        cls.file = cls.folder / "rising.vtk"
        write(vtkPolyDataWriter(), cls.data, cls.file, FileType=2)
        cls.difference = numpy.nanmax(cls.pressure, axis=1) - numpy.nanmin(cls.pressure, axis=1)

    def draw(self, *arguments, **keywords):
        return self.render(self.file, *VIEW, *arguments, **keywords)

    def row_of(self, line):
        """The row of the picture in whose middle the line is."""
        return round(60 - (0.5 * line - 0.75) / (6 - 0.1 * line) * 60 / numpy.tan(numpy.pi / 12))


class TestImportance(ImportanceTest):
    def test_importance_is_a_factor_on_the_opacity(self):
        options = ("--lighting", "off", "--radius", "0.1", "--color-by", "number")
        opaque, _ = self.draw("--opacity", "1", *options)
        for exponent in (1, 3):
            for opacity in (None, 0.5):
                picture, _ = self.draw(
                    "--importance", "TotalPressureDifference:100:400", "--exponent", exponent,
                    *(("--opacity", opacity) if opacity else ()), *options)
                for line, value in enumerate((self.difference - 100) / 300):
                    row = self.row_of(line)
                    expected = numpy.clip(value, 0, 1)**exponent * (opacity or 1) * opaque[row, 80]
                    self.assertLessEqual(abs(picture[row, 80] - expected).max(), 1, (line, exponent))

    def test_histogram(self):
        """Bins are closed below; NaN is importance 0."""
        _, statistics = self.draw("--importance", "p:1000:600")
        histogram = statistics["importance_histogram"]
        self.assertEqual((histogram["minimum"], histogram["maximum"]), (0, 1))
        counts = histogram["counts"]
        self.assertEqual(sum(counts), 4 * POINTS)
        values = numpy.nan_to_num((1000 - numpy.float32(self.pressure)) / 400)
        self.assertEqual(counts[0], (values < 1 / len(counts)).sum())
        self.assertEqual(counts[-1], (values >= 1 - 1 / len(counts)).sum())

    def test_weights_percentiles_and_names_with_colons(self):
        same = [
            self.draw("--importance", text)[0]
            for text in ("p:1000:600", "a:b:2:1000:600:1", "p:100%:0%", "p:1000:600:-0.5")
        ]
        for picture in same[1:3]:
            self.assertTrue(numpy.array_equal(picture, same[0]))
        self.assertFalse(numpy.array_equal(same[3], same[0]))
        penalty, _ = self.draw("--importance", "p:600:1000:-1")
        self.assertTrue(numpy.array_equal(penalty, same[0]))
        vector, _ = self.draw("--importance", "wind:0:15")
        number, _ = self.draw("--importance", "number:0:3")
        self.assertTrue(numpy.array_equal(vector, number))

    def test_color_by_importance(self):
        picture, _ = self.draw("--importance", "number:-3:3", "--color-by", "Importance",
                               "--radius", "0.1", "--lighting", "off")
        self.assertGreater(picture[self.row_of(0), 80, 2], picture[self.row_of(0), 80, 0])
        self.assertGreater(picture[self.row_of(3), 80, 0], picture[self.row_of(3), 80, 2])

    def test_reference_and_stock_methods(self):
        options = ("--importance", "TotalPressureDifference:0:400", "--radius", "0.1",
                   "--lighting", "off")
        exact, _ = self.draw(*options)
        reference, _ = self.draw(*options, "--reference", environment={"DISPLAY": ""})
        difference = abs(exact - reference).max(axis=2)
        self.assertLess((difference > 1).mean(), 0.002)
        for method in ("vtk", "vtk-peeling"):
            for color in ("p", "number"):
                exact, _ = self.draw(*options, "--color-by", color)
                stock, _ = self.draw(*options, "--color-by", color, "--method", method)
                for line in range(4):
                    row = self.row_of(line)
                    self.assertLessEqual(abs(stock[row, 80] - exact[row, 80]).max(), 4)

    def test_companions_keep_their_opacity(self):
        write(vtkPLYWriter(), self.sphere, self.folder / "sphere.ply")
        options = ("--importance", "p:2000:3000", "--lighting", "off")
        picture, _ = self.render(self.file, self.folder / "sphere.ply", *VIEW, *options)
        alone, _ = self.render(self.folder / "sphere.ply", *VIEW, "--lighting", "off")
        self.assertTrue((picture != BACKGROUND).any())
        self.assertTrue(numpy.array_equal(picture, alone))

    def test_importance_of_nothing_is_told(self):
        picture = self.folder / "picture.png"
        result = self.run_program(self.file, "-o", picture, "--importance", "p:0:1:1",
                                  "--importance", "number:0:1:-1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, "^pellucid-render: warning: .*weights.*\n$")

    def test_up_turns_the_camera(self):
        pictures = [
            self.render(self.file, "--size", "80x60", "--up", axis)[0].tobytes() for axis in "xyz"
        ]
        self.assertEqual(len(set(pictures)), 3)
        default, _ = self.render(self.file, "--size", "80x60")
        self.assertEqual(default.tobytes(), pictures[2])


class TestSelection(ImportanceTest):
    def select(self, *texts):
        selection = [part for text in texts for part in ("--select", text)]
        picture, statistics = self.draw(*selection)
        self.assertEqual(statistics["input_lines"], 4)
        self.assertEqual(statistics["input_points"], 4 * POINTS)
        return picture, statistics["selected_lines"]

    def test_counts(self):
        for text, expected in (
            ("TotalPressureDifference:250:", 2),
            ("TotalPressureDifference:200:300", 2),
            ("TotalPressureDifference::150", 1),
            ("TotalPressureDifference:0%:50%", 2),
            ("p::650", 1),
            ("p:950:", 4),
            ("number:1:1", 1),
            ("wind:10:", 2),
            ("a:b:2::750", 2),
        ):
            with self.subTest(text=text):
                self.assertEqual(self.select(text)[1], expected)

    def test_all_must_hold_and_percentiles_are_of_all_lines(self):
        for texts in (("number:1:", "TotalPressureDifference:0%:70%"),
                      ("TotalPressureDifference:0%:70%", "number:1:")):
            self.assertEqual(self.select(*texts)[1], 2, texts)

    def test_selected_lines_look_as_in_the_whole_picture(self):
        whole, _ = self.draw("--opacity", "1", "--radius", "0.05", "--color-by", "number")
        some, statistics = self.draw("--opacity", "1", "--radius", "0.05", "--color-by", "wind",
                                     "--select", "number:2:")
        self.assertEqual(statistics["selected_lines"], 2)
        covered = (some != BACKGROUND).any(axis=2)
        self.assertTrue((whole[covered] != BACKGROUND).any(axis=1).all())
        self.assertFalse(covered[self.row_of(0)].any())
        self.assertTrue(covered[self.row_of(3)].any())

    def test_lines_without_the_array_stay(self):
        other = self.folder / "other.vtk"
        write(vtkPolyDataWriter(), make_polylines([((0, 0, 0), (1, 1, 1))]), other, FileType=2)
        _, statistics = self.render(self.file, other, *VIEW, "--select", "p:0:1")
        self.assertEqual(statistics["selected_lines"], 1)

    def test_nothing_left(self):
        self.refuse(1, "--select: leaves nothing to draw", self.file, "--select", "p:0:1")
        write(vtkPLYWriter(), self.sphere, self.folder / "sphere.ply")
        result = self.run_program(self.file, self.folder / "sphere.ply", "-o",
                                  self.folder / "picture.png", "--select", "p:0:1")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stderr, "^pellucid-render: warning: --select: leaves no line.*\n$")

    def test_sample(self):
        """The streams of the sample against a loop over its pressures."""
        reader = pellucid.vtkMet3DReader()
        reader.SetFileName(str(DATA / "pacific-streams.nc"))
        reader.Update()
        lines = reader.GetOutput().GetLines()
        pressure = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray("pressure"))
        offsets = vtk_to_numpy(lines.GetOffsetsArray())
        points = vtk_to_numpy(lines.GetConnectivityArray())
        rising = [points[first:last] for first, last in zip(offsets, offsets[1:])
                  if numpy.ptp(pressure[points[first:last]]) > 500]
        self.assertEqual(len(rising), 24)
        _, statistics = self.render(DATA / "pacific-streams.nc", "--size", "60x20", "--select",
                                    "TotalPressureDifference:500:")
        self.assertEqual(statistics["input_lines"], len(offsets) - 1)
        self.assertEqual(statistics["selected_lines"], len(rising))

    def test_time_window(self):
        """One unit of time is an eighth of a line."""
        timed = self.folder / "timed.vtk"
        time = numpy.tile(numpy.arange(POINTS), 4)
        write(vtkPolyDataWriter(), make_polylines(
            self.positions, (("p", self.pressure.ravel()), ("time", time))), timed, FileType=2)
        for window, least, expected in ((0, 140, 3), (4, 140, 2), (2, 90, 1)):
            _, statistics = self.render(timed, *VIEW, "--time-window", window, "--select",
                                        f"TotalPressureDifference:{least}:")
            self.assertEqual(statistics["selected_lines"], expected, window)


    def test_percentiles_of_nothing_are_told_once(self):
        missing = self.folder / "missing.vtk"
        write(vtkPolyDataWriter(), make_polylines(
            self.positions, (("p", self.pressure.ravel()), ("none", numpy.nan * self.pressure.ravel())),
            (("number", range(4)),)), missing, FileType=2)
        for others in ((), ("--select", "number:10%:")):
            result = self.run_program(missing, "-o", self.folder / "picture.png", "--select",
                                      "none:5%:", *others)
            self.assertEqual(result.returncode, 1)
            warning, error = result.stderr.splitlines()
            self.assertIn("no finite value to take percentiles of", warning)
            self.assertIn("--select: leaves nothing to draw", error)


class TestListing(ImportanceTest):
    def test_table(self):
        lines = self.list_arrays(self.file)
        self.assertEqual(lines[0], f"{self.file}: {4 * POINTS} points, 4 lines")
        self.assertIn("length", lines[-1])
        rows = self.table(lines)
        self.assertEqual(list(rows)[:3], ["p", "wind", "a:b:2"])
        self.assertEqual(rows["p"], {
            "name": "p", "on": "points", "components": "1", "minimum": "600", "maximum": "1000",
            "unit": "hPa", "missing": "2", "from": "input"})
        self.assertEqual((rows["wind"]["components"], rows["wind"]["maximum"]), ("3", "15"))
        self.assertEqual(rows["number"]["on"], "lines")
        for name, place in (("TotalPressureDifference", "lines"), ("TurningAngle", "points"),
                            ("SegmentPressureDifference", "points"), ("SegmentLength", "points")):
            self.assertEqual((rows[name]["on"], rows[name]["from"]), (place, "computed"))
        self.assertEqual(float(rows["TotalPressureDifference"]["maximum"]), self.difference.max())
        self.assertNotIn("Velocity", rows)

    def test_options_of_computed_arrays(self):
        rows = self.table(self.list_arrays(self.file, "--pressure", "a:b:2"))
        self.assertEqual(float(rows["TotalPressureDifference"]["maximum"]), self.difference.max())
        for axis, expected in (("x", 0.25), ("y", 0), ("z", 0)):
            row = self.table(self.list_arrays(self.file, "--up", axis))["SegmentHeightDifference"]
            self.assertAlmostEqual(float(row["maximum"]), expected, 6)

    def test_height(self):
        rows = self.table(self.list_arrays(self.file, "--height", "p"))
        self.assertEqual(rows["SegmentHeightDifference"]["maximum"], "-12.5")
        self.assertEqual(rows["SegmentHeightDifference"]["unit"], "hPa")
        lines = self.list_arrays(self.file, self.lines, "--height", "p", "--up", "y")
        row = self.table(lines[lines.index("") + 1:])["SegmentHeightDifference"]
        self.assertEqual(row["maximum"], "2")

    def test_numbers_of_any_size(self):
        """Large and small ones are neither lost nor written with an exponent without need."""
        data = make_polylines([[(0, 0, 0), (1, 0, 0)]], (
            ("id", (100000, 2000000)), ("small", (0.1, -1e-4)), ("tiny", (1e-5, 1e20))))
        for name, values in (("large", [1e300, 1e305]), ("long", [(1e200, 0), (0, -5e250)]),
                             ("exact", [1e15, 999999999999999])):
            array = numpy_to_vtk(numpy.array(values), deep=True)
            array.SetName(name)
            data.GetPointData().AddArray(array)
        path = self.folder / "sizes.vtk"
        write(vtkPolyDataWriter(), data, path, FileType=2)
        rows = self.table(self.list_arrays(path))
        for name, expected in (
            ("id", ("100000", "2000000")), ("small", ("-0.0001", "0.1")), ("tiny", ("1e-05", "1e+20")),
            ("large", ("1e+300", "1e+305")), ("long", ("1e+200", "5e+250")),
            ("exact", ("999999999999999", "1e+15")),
        ):
            self.assertEqual((rows[name]["minimum"], rows[name]["maximum"]), expected)
            self.assertEqual(rows[name]["missing"], "0")

    def test_control_characters_do_not_reach_the_terminal(self):
        name, unit = "r\x1b[31m\u00e9\x9b\x7fd", "\x07\u00b0C"
        path = self.folder / "control.vtk"
        write(vtkPolyDataWriter(), make_polylines(
            self.positions, ((name, self.pressure.ravel()),), (), {name: unit}), path, FileType=2)
        row = self.table(self.list_arrays(path))["r?[31m\u00e9???d"]
        self.assertEqual(row["unit"], "?\u00b0C")
        self.refuse(1, "r?[31m\u00e9???d (points)", path, "--color-by", "q")

    def test_arrays_of_the_file_come_first(self):
        """An array that bears the name of a computed one is not replaced."""
        named = self.folder / "named.vtk"
        write(vtkPolyDataWriter(), make_polylines(
            self.positions, (("p", self.pressure.ravel()),), (("TotalPressureDifference", range(4)),)),
            named, FileType=2)
        row = self.table(self.list_arrays(named))["TotalPressureDifference"]
        self.assertEqual((row["maximum"], row["from"]), ("3", "input"))

    def test_several_inputs(self):
        lines = self.list_arrays(self.file, DATA / "combustor.vtk", "--seeds", "20")
        self.assertEqual(sum(" lines" in line and "points, " in line for line in lines), 2)
        self.assertTrue(any(line.startswith("Density ") for line in lines))


class TestRefusals(ImportanceTest):
    def test_wrong_usage(self):
        for option, texts in (
            ("--importance", ("p", "p:1", ":0:1", "p:0:1:2", "p:0:1:x", "p:a:1", "p:101%:0", "p:0:",
                              "p:nan:1", "p:0:inf", "p:-1%:2", "")),
            ("--select", ("p", "p:1", "p::", ":0:1", "p:a:", "p::101%", "p:nan:", "")),
            ("--exponent", ("-1", "x", "nan", "inf")),
            ("--time-window", ("-1", "x")),
            ("--up", ("w", "X ", "")),
        ):
            for text in texts:
                with self.subTest(option=option, text=text):
                    self.refuse(2, option, self.file, f"{option}={text}")
        self.refuse(2, "add --importance", self.file, "--exponent", "2")

    def test_unknown_arrays(self):
        existing = "TotalPressureDifference (lines, computed), TurningAngle (points, computed)"
        for arguments in (("--importance", "q:0:1"), ("--select", "q:0:"), ("--color-by", "q"),
                          ("--pressure", "q"), ("--height", "q"), ("--color-by", "Importance")):
            with self.subTest(arguments=arguments):
                self.refuse(1, existing, self.file, *arguments)
                self.refuse(1, f"{arguments[0]}: there is no array", self.file, *arguments)

    def test_attributes_that_cannot_be_computed(self):
        write(vtkPLYWriter(), self.sphere, self.folder / "sphere.ply")
        for file, name, needs in (
            (self.lines, "TotalPressureDifference", "lines with pressure, which --pressure names;"),
            (self.lines, "SegmentPressureDifference", "lines with pressure"),
            (self.lines, "Velocity", "lines with time"),
            (self.folder / "sphere.ply", "TurningAngle", "lines;"),
        ):
            self.refuse(1, f"{name} is computed from {needs}", file, "--color-by", name)
        for name in ("TotalPressureDifference", "p"):
            self.refuse(1, "--time-window: needs the time of the points", self.file,
                        "--time-window", "1", "--color-by", name)

    def test_time_in_another_input(self):
        timed = self.folder / "without-pressure.vtk"
        time = numpy.tile(numpy.arange(POINTS), 4)
        write(vtkPolyDataWriter(), make_polylines(self.positions, (("Time", time),)), timed, FileType=2)
        self.refuse(1, "--pressure names, and with time, for --time-window", self.file, timed,
                    "--time-window", "1", "--color-by", "TotalPressureDifference")

    def test_roles_are_of_points(self):
        for option in ("--pressure", "--height"):
            self.refuse(1, f"{option}: there is no array 'number' with numbers of the points",
                        self.file, option, "number")

    def test_arrays_of_different_inputs(self):
        self.refuse(1, "no input has all of the arrays", self.file, self.lines,
                    "--importance", "p:0:1", "--importance", "Height:0:1")


class MissingValuesTest(RenderTest):
    def test_missing_values_are_gray(self):
        path = self.folder / "missing.vtk"
        values = [0, numpy.nan, numpy.nan, 1]
        data = make_polylines([[(x, 0, 0) for x in range(-3, 5, 2)]], (("a", values),))
        write(vtkPolyDataWriter(), data, path, FileType=2)
        picture, _ = self.render(
            path, "--size", "160x120", "--color-by", "a", "--lighting", "off", "--opacity", "1",
            "--camera-position", "0,0,6", "--focal-point", "0,0,0", "--view-up", "0,1,0",
            "--radius", "0.5")
        numpy.testing.assert_allclose(picture[60, 80][:3], 128, atol=1)


if __name__ == "__main__":
    unittest.main()
