#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line of pellucid-render: every option's effect on the picture, every refusal."""

import os
import unittest

import numpy
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import (
    vtkCellArray,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
    vtkTable,
)
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkStructuredPointsWriter, vtkTableWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import (
    vtkXMLImageDataWriter,
    vtkXMLMultiBlockDataWriter,
    vtkXMLPolyDataWriter,
)

from render_program import BACKGROUND, DATA, NEAR, RenderTest, make_lines, make_polylines, write

FRONT = ("--camera-position", "0,0,10", "--focal-point", "0,0,0", "--view-up", "0,1,0")
KEYS = [
    "input_points",
    "input_lines",
    "selected_lines",
    "color_by",
    "importance",
    "importance_histogram",
    "fragments",
    "solved_fragments",
    "longest_list",
    "buffer_bytes",
    "tiles",
    "stages",
    "renderer",
    "opengl",
]


class TestPicture(RenderTest):
    def test_help_and_version(self):
        result = self.run_program("--help")
        self.assertEqual(result.returncode, 0)
        for text in ("Picture", "Camera", "Streamlines", "Examples", "--memory-limit"):
            self.assertIn(text, result.stdout)
        result = self.run_program("--version")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stdout, r"^pellucid-render \d+\.\d+\.\d+\n$")

    def test_size(self):
        for width, height in ((1, 1), (31, 17), (200, 100)):
            picture, _ = self.render(self.lines, "--size", f"{width}x{height}")
            self.assertEqual(picture.shape, (height, width, 3))

    def test_background(self):
        picture, _ = self.render(self.lines, "--size", "60x60", "--background", "1,0.5,0")
        self.assertEqual(tuple(picture[0, 0]), (255, 128, 0))

    def test_transparent_background(self):
        picture, _ = self.render(
            self.lines, "--size", "60x60", "--transparent-background", "--opacity", "0.5")
        self.assertEqual(picture.shape, (60, 60, 4))
        self.assertEqual(tuple(picture[0, 0]), (0, 0, 0, 0))
        alphas = set(picture[:, :, 3].flat)
        self.assertTrue({127, 128} & alphas, alphas)
        opaque, _ = self.render(self.lines, "--size", "60x60", "--background", "0,0,0",
                                "--opacity", "1")
        covered = (picture[:, :, 3] == 127) | (picture[:, :, 3] == 128)
        difference = abs(picture[:, :, :3] - opaque)[covered]
        self.assertLessEqual(difference.max(), 3)

    def test_color_by(self):
        by_height = self.draw_lines("--color-by", "Height", "--radius", "0.1", "--opacity", "1")
        row = by_height[45]
        self.assertGreater(row[30][2], row[30][0])  # cool
        column = by_height[:, 60]
        self.assertGreater(column[20][0], column[20][2])  # warm
        by_line = self.draw_lines("--color-by", "Line", "--radius", "0.1", "--opacity", "1")
        self.assertTrue(numpy.array_equal(by_height, by_line))
        constant = self.draw_lines("--color-by", "Constant", "--radius", "0.05")
        self.assertFalse(numpy.array_equal(by_height, constant))

    def test_color_range(self):
        """A line keeps its colour whatever else is drawn."""
        options = ("--radius", "0.1", "--opacity", "1", "--color-by", "Line")
        only = ("--select", "Line:1:1")
        whole = self.draw_lines(*options, "--color-range", "0:3")
        some = self.draw_lines(*options, "--color-range", "0:3", *only)
        self.assertTrue((some[20, 60] != BACKGROUND).any())
        self.assertTrue(numpy.array_equal(whole[20, 60], some[20, 60]))
        self.assertFalse(numpy.array_equal(whole[20, 60], self.draw_lines(*options, *only)[20, 60]))
        self.assertGreater(whole[20, 60, 2], whole[20, 60, 0])  # a third of the range is cool
        self.assertTrue(numpy.array_equal(
            self.draw_lines(*options), self.draw_lines(*options, "--color-range", "0:1")))
        write(vtkSTLWriter(), self.sphere, self.folder / "plain.stl")
        self.refuse(1, "--color-range: there is no array", self.folder / "plain.stl",
                    "--color-range", "0:1")

    def test_opacity_blends_in_depth_order(self):
        options = ("--radius", "0.1", "--lighting", "off")
        opaque = self.draw_lines("--opacity", "1", *options)
        front, back = opaque[45, 30], opaque[20, 60]
        for opacity in (0.1, 0.5, 0.9):
            crossing = self.draw_lines("--opacity", opacity, *options)[45, 60]
            expected = opacity * front + (1 - opacity) * opacity * back
            self.assertLessEqual(abs(crossing - expected).max(), 1)

    def test_opaque_picture_costs_no_stage(self):
        _, statistics = self.render(self.lines, "--size", "50x50", "--opacity", "1")
        self.assertEqual(statistics["fragments"], 0)
        self.assertEqual(statistics["stages"], {})

    def test_radius(self):
        covered = [
            (self.draw_lines("--radius", radius) != BACKGROUND).any(axis=2).sum()
            for radius in (0, 0.02, 0.1)
        ]
        self.assertGreater(covered[0], 100)
        self.assertGreater(covered[2], 3 * covered[1])

    def test_numbers(self):
        """Of any notation; what is too small for a double is 0."""
        pictures = [self.draw_lines("--radius", text).tobytes()
                    for text in ("0.1", "+.1", "1e-1", "0", "1e-999")]
        self.assertEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])
        self.assertEqual(pictures[3], pictures[4])

    def test_lighting(self):
        shaded = self.draw_lines("--radius", "0.2", "--opacity", "1", "--lighting", "on")
        flat = self.draw_lines("--radius", "0.2", "--opacity", "1", "--lighting", "off")
        self.assertGreater(len(set(map(tuple, shaded[:, 20]))), 5)
        self.assertEqual(len(set(map(tuple, flat[:, 20]))), 2)
        self.assertTrue(numpy.array_equal(
            shaded, self.draw_lines("--radius", "0.2", "--opacity", "1")))

    def test_camera(self):
        view = (*FRONT, "--radius", "0.1", "--opacity", "1")
        upright = self.draw_lines(*view)
        self.assertTrue((upright[45, 60] != BACKGROUND).any())
        turned = self.draw_lines(*view[:4], "--view-up", "1,0,0", *view[6:])
        self.assertFalse(numpy.array_equal(upright, turned))
        aside = self.draw_lines(*view[:2], "--focal-point", "100,0,0", *view[4:])
        self.assertFalse((aside != BACKGROUND).any())

    def test_parallel_scale(self):
        view = (*FRONT, "--radius", "0.1", "--opacity", "1")
        for scale, half_height in ((1, 45), (2, 22.5), (4, 11.25)):
            picture = self.draw_lines(*view, "--parallel-scale", scale)
            rows = numpy.nonzero((picture != BACKGROUND).any(axis=(1, 2)))[0]
            self.assertAlmostEqual(len(rows) / 2, half_height, delta=2.5)
        self.assertTrue(numpy.array_equal(
            self.draw_lines(*view), self.draw_lines(*view, "--parallel-scale", "0")))

    def test_default_camera_fills_picture(self):
        for size in ("120x90", "60x120"):
            picture, _ = self.render(DATA / "combustor-lines.vtk", "--size", size,
                                     "--background", "0,0,0", "--opacity", "1")
            covered = (picture != BACKGROUND).any(axis=2)
            rows = numpy.nonzero(covered.any(axis=1))[0]
            columns = numpy.nonzero(covered.any(axis=0))[0]
            share = max(numpy.ptp(rows) / picture.shape[0], numpy.ptp(columns) / picture.shape[1])
            self.assertGreater(share, 0.85)
            self.assertLess(share, 0.99)

    def test_formats_of_pictures(self):
        for suffix, magic in ((".jpg", b"\xff\xd8"), (".tiff", b"II*"), (".bmp", b"BM")):
            path = self.folder / ("picture" + suffix)
            result = self.run_program(self.lines, "-o", path, "--size", "40x30")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertTrue(path.read_bytes().startswith(magic))

    def test_memory_limit_keeps_the_picture(self):
        options = (DATA / "combustor-lines.vtk", "--size", "500x400", "--opacity", "0.2",
                   "--radius", "0.25")
        free, statistics = self.render(*options)
        self.assertEqual(statistics["tiles"], 1)
        bound, statistics = self.render(*options, "--memory-limit", "1")
        self.assertGreater(statistics["tiles"], 1)
        self.assertTrue(numpy.array_equal(free, bound))

    def test_statistics(self):
        _, statistics = self.render(self.lines, "--size", "100x100", "--radius", "0.1")
        self.assertEqual(list(statistics), KEYS)
        self.assertEqual(statistics["input_points"], 4)
        self.assertEqual(statistics["input_lines"], 2)
        self.assertEqual(statistics["selected_lines"], 2)
        self.assertIsNone(statistics["importance_histogram"])
        self.assertGreater(statistics["fragments"], 100)
        self.assertEqual(statistics["longest_list"], 2)
        self.assertGreater(statistics["buffer_bytes"], 0)
        for stage in ("gather", "sort", "resolve"):
            self.assertGreater(statistics["stages"][stage], 0)
        self.assertTrue(statistics["renderer"])
        self.assertRegex(statistics["opengl"], r"^\d+\.\d+")

    def test_methods(self):
        pictures = {}
        for method in ("pellucid", "vtk", "vtk-peeling"):
            pictures[method], statistics = self.render(
                self.lines, "--size", "120x90", "--method", method, "--radius", "0.05",
                "--lighting", "off")
            self.assertEqual(list(statistics), KEYS)
            self.assertEqual(statistics["input_lines"], 2)
            if method != "pellucid":
                self.assertEqual(statistics["fragments"], 0)
                self.assertGreater(statistics["stages"]["render"], 0)
        self.assertFalse(numpy.array_equal(pictures["vtk"], pictures["pellucid"]))

    def test_methods_color_other_cells_alike(self):
        """The values of cells stay with theirs where lines become tubes."""
        data = make_polylines(
            (((-1, 0.5, 0), (1, 0.5, 0)), ((-1, 0.7, 0), (1, 0.7, 0))), (),
            (("value", (0, 0, 0, 1)),))
        squares = vtkCellArray()
        for x in (-0.8, 0.2):
            squares.InsertNextCell(4)
            for corner in ((x, -0.6, 0), (x + 0.6, -0.6, 0), (x + 0.6, 0, 0), (x, 0, 0)):
                squares.InsertCellPoint(data.GetPoints().InsertNextPoint(corner))
        data.SetPolys(squares)
        write(vtkPolyDataWriter(), data, self.folder / "squares.vtk", FileType=2)
        options = (self.folder / "squares.vtk", "--size", "120x90", *NEAR, "--opacity", "1",
                   "--lighting", "off", "--color-by", "value", "--radius", "0.02")
        exact, _ = self.render(*options)
        stock, _ = self.render(*options, "--method", "vtk")
        for column in (40, 80):
            self.assertLessEqual(abs(exact[57, column] - stock[57, column]).max(), 1, column)
        self.assertGreater(abs(exact[57, 40] - exact[57, 80]).max(), 50)

    def test_compare(self):
        options = ("--radius", "0.05", "--background", "0,0,0")
        picture, _ = self.render(self.lines, "--size", "240x90", "--compare", *options)
        self.assertEqual(picture.shape, (90, 240, 3))
        left, right = picture[:, :120], picture[:, 120:]
        alone, _ = self.render(self.lines, "--size", "120x90", *options)
        stock, _ = self.render(self.lines, "--size", "120x90", "--method", "vtk", *options)
        lower = slice(30, None)  # below the titles
        self.assertTrue(numpy.array_equal(left[lower], alone[lower]))
        self.assertLessEqual(abs(right[lower] - stock[lower]).max(), 1)
        for half in (left, right):
            self.assertTrue((half[:20, :40] != BACKGROUND).any())

    def test_reference(self):
        options = (DATA / "combustor-lines.vtk", "--size", "160x120")
        picture, statistics = self.render(*options)
        exact, reference = self.render(*options, "--reference", environment={"DISPLAY": ""})
        difference = abs(picture - exact).max(axis=2)
        self.assertLess((difference > 1).mean(), 0.002)
        self.assertAlmostEqual(
            reference["fragments"] / statistics["fragments"], 1, delta=0.002)
        self.assertEqual(reference["opengl"], "")

    def test_same_bits(self):
        options = (DATA / "combustor.vtk", "--seeds", "50", "--size", "160x120")
        self.assertTrue(numpy.array_equal(self.render(*options)[0], self.render(*options)[0]))


class TestInputs(RenderTest):
    def test_formats(self):
        sphere = self.sphere
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, sphere)
        blocks.SetBlock(1, make_lines())
        for name, writer, data in (
            ("a.vtp", vtkXMLPolyDataWriter(), sphere),
            ("a.ply", vtkPLYWriter(), sphere),
            ("a.stl", vtkSTLWriter(), sphere),
            ("a.obj", vtkOBJWriter(), sphere),
            ("a.vtm", vtkXMLMultiBlockDataWriter(), blocks),
        ):
            if name[-3:-1] == "vt":
                writer.SetDataModeToBinary()
            write(writer, data, self.folder / name)
            picture, statistics = self.render(
                self.folder / name, "--size", "60x60", "--background", "0,0,0")
            self.assertTrue((picture != BACKGROUND).any())
            self.assertGreater(statistics["input_points"], 10)

    def test_plot3d(self):
        """A uniform flow along x on a grid of 9x5x5 points, in either byte order."""
        x, y, z = numpy.meshgrid(*(numpy.linspace(0, 1, n) for n in (9, 5, 5)), indexing="ij")
        zero, one = numpy.zeros_like(x), numpy.ones_like(x)
        for order in "<>":
            sizes = numpy.array((9, 5, 5), order + "i4").tobytes()
            grid = self.folder / "flowxyz.bin"
            solution = self.folder / "flowq.bin"
            for path, header, fields in (
                (grid, b"", (x, y, z)),
                (solution, numpy.zeros(4, order + "f4").tobytes(), (2 * one, one, zero, zero, one)),
            ):
                path.write_bytes(sizes + header + b"".join(
                    field.astype(order + "f4").tobytes("F") for field in fields))
            (self.folder / "a.bin").write_bytes(grid.read_bytes())
            (self.folder / "b.bin").write_bytes(solution.read_bytes())
            for inputs in ((grid,), (solution,), (grid, solution), (solution, grid),
                           (self.folder / "a.bin", self.folder / "b.bin")):
                with self.subTest(order=order, inputs=inputs):
                    _, statistics = self.render(*inputs, "--seeds", "20", "--size", "40x30")
                    self.assertEqual(statistics["input_lines"], 20)

    def test_several_inputs_make_one_scene(self):
        write(vtkPLYWriter(), self.sphere, self.folder / "sphere.ply")
        both, statistics = self.render(
            self.lines, self.folder / "sphere.ply", "--size", "60x60", "--opacity", "0.5")
        self.assertEqual(
            statistics["input_points"], 4 + self.sphere.GetNumberOfPoints())
        self.assertEqual(statistics["input_lines"], 2)
        swapped, _ = self.render(
            self.folder / "sphere.ply", self.lines, "--size", "60x60", "--opacity", "0.5",
            "--color-by", "Height")
        self.assertEqual(both.shape, swapped.shape)

    def test_field_is_traced(self):
        field = DATA / "combustor.vtk"
        _, statistics = self.render(field, "--seeds", "40", "--size", "80x60")
        self.assertGreater(statistics["input_lines"], 30)
        self.assertLessEqual(statistics["input_lines"], 40)
        _, more = self.render(field, "--seeds", "80", "--size", "80x60", "--vectors", "Velocity")
        self.assertGreater(more["input_lines"], 60)
        _, shorter = self.render(field, "--seeds", "40", "--size", "80x60",
                                 "--maximum-length", "1")
        self.assertLess(shorter["input_points"], statistics["input_points"] / 2)

    def test_seeding(self):
        pictures = []
        for options in (("volume",), ("points",), ("grid",), ("line",),
                        ("volume", "--seed-offset", "40"),
                        ("line", "--seed-line-first", "8,-3,30", "--seed-line-last", "8,3,30")):
            picture, statistics = self.render(
                DATA / "combustor.vtk", "--size", "80x60", "--seeds", "40", "--seeding", *options)
            self.assertGreater(statistics["input_lines"], 5, options)
            pictures.append(picture.tobytes())
        self.assertEqual(len(set(pictures)), len(pictures))

    def test_input_refusals(self):
        folder = self.folder
        files = {
            "empty.vtk": b"",
            "unknown.foo": b"hello",
            "noise.vtk": bytes(i * 7919 % 251 for i in range(3000)),
            "noise.vtp": bytes(i * 7919 % 251 for i in range(3000)),
            "noise.stl": bytes(i * 7919 % 251 for i in range(3000)),
            "noise.ply": bytes(i * 7919 % 251 for i in range(3000)),
            "huge.vtk": b"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\n"
                        b"POINTS 4000000000000 float\n",
            "index.vtk": b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
                         b"POINTS 2 float\n0 0 0 1 1 1\nLINES 1 4\n3 0 1 99999999\n",
            "nocells.vtk": b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"
                           b"POINTS 2 float\n0 0 0 1 1 1\n",
            "lonelyxyz.bin": b"\0" * 100,
            "brokenxyz.bin": b"\1" * 1000,
            "brokenq.bin": b"\1" * 1000,
        }
        for name, content in files.items():
            (folder / name).write_bytes(content)
        write(vtkPolyDataWriter(), vtkPolyData(), folder / "nothing.vtk")
        write(vtkTableWriter(), vtkTable(), folder / "table.vtk")
        for name, text in (
            ("missing.vtk", "there is no such file"),
            ("", "is a folder"),
            ("empty.vtk", "the file is empty"),
            ("unknown.foo", "is of no known kind; known are .vtk"),
            ("noise.vtk", "damaged"),
            ("noise.vtp", "damaged"),
            ("noise.stl", "damaged"),
            ("noise.ply", "damaged"),
            ("huge.vtk", "damaged"),
            ("index.vtk", "refers to point 99999999 of 2"),
            ("nocells.vtk", "no cell"),
            ("nothing.vtk", "it holds no points"),
            ("table.vtk", "holds a vtkTable"),
            ("lonelyxyz.bin", "lonelyq.bin"),
            ("brokenxyz.bin", "damaged"),
        ):
            with self.subTest(name=name):
                self.refuse(1, text, folder / name)

    def test_truncated_inputs(self):
        for suffix, writer, properties in (
            ("vtk", vtkPolyDataWriter(), {"FileType": 2}),
            ("vtp", vtkXMLPolyDataWriter(), {"DataMode": 1}),
            ("ply", vtkPLYWriter(), {}),
            ("ply", vtkPLYWriter(), {"FileType": 1}),
            ("stl", vtkSTLWriter(), {"FileType": 2}),
            ("obj", vtkOBJWriter(), {}),
        ):
            whole = self.folder / ("whole." + suffix)
            write(writer, self.sphere, whole, **properties)
            content = whole.read_bytes()
            for length in (len(content) * 6 // 10, len(content) - 7):
                with self.subTest(suffix=suffix, length=length):
                    cut = self.folder / ("cut." + suffix)
                    cut.write_bytes(content[:length])
                    self.refuse(1, "cut." + suffix, cut)

    def test_field_refusals(self):
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        scalars = vtkFloatArray()
        scalars.SetName("Pressure")
        scalars.SetNumberOfTuples(27)
        scalars.Fill(1)
        image.GetPointData().AddArray(scalars)
        write(vtkXMLImageDataWriter(), image, self.folder / "scalars.vti", DataMode=1)
        self.refuse(1, "Pressure (points, 1)", self.folder / "scalars.vti")
        vectors = vtkFloatArray()
        vectors.SetName("Calm")
        vectors.SetNumberOfComponents(3)
        vectors.SetNumberOfTuples(27)
        vectors.Fill(0)
        image.GetPointData().AddArray(vectors)
        write(vtkStructuredPointsWriter(), image, self.folder / "calm.vtk")
        self.refuse(1, "is zero at all", self.folder / "calm.vtk")
        self.refuse(1, "Velocity (points, 3)", DATA / "combustor.vtk", "--vectors", "Wind")

    def test_points_that_are_not_finite_are_told(self):
        lines = make_lines()
        lines.GetPoints().SetPoint(0, float("nan"), 0, 0)
        write(vtkPolyDataWriter(), lines, self.folder / "nan.vtk", FileType=2)
        for renderer in ((), ("--reference",)):
            picture = self.folder / "nan.png"
            result = self.run_program(
                self.folder / "nan.vtk", "-o", picture, "--size", "50x50", *renderer)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertTrue(result.stderr)
            for line in result.stderr.splitlines():
                self.assertRegex(line, "^pellucid-render: warning: .*finite")

    def test_unknown_array_names_those_that_exist(self):
        self.refuse(1, "Constant (points), Curvature (points, computed), Height (points), Line (lines)",
                    self.lines, "--color-by", "Temperature")


class TestUsage(RenderTest):
    def test_wrong_usage(self):
        for text, *arguments in (
            ("--size", "--size", "0x0"),
            ("--size", "--size", "100"),
            ("--size", "--size", "10x10x10"),
            ("--size", "--size", "70000x10"),
            ("--size", "--size", "nanxnan"),
            ("--background", "--background", "1,2,3"),
            ("--background", "--background", "1,1"),
            ("--opacity", "--opacity", "nan"),
            ("--opacity", "--opacity", "1.5"),
            ("--radius", "--radius", "-1"),
            ("--radius", "--radius", "inf"),
            *(("--radius", "--radius", text) for text in ("", " 1", "1 ", "0x1", "1e999", "1e", ".")),
            *(("--color-range", "--color-range=" + text)
              for text in ("1", "1:1", "2:1", "a:1", ":", "0:", "0:nan", "0:1:2", "")),
            ("and at most 1000000,", "--vertical-scale", "2e6"),
            ("--lighting", "--lighting", "maybe"),
            ("--camera-position", "--camera-position", "1,2"),
            ("--focal-point", "--focal-point", "a,b,c"),
            ("--parallel-scale", "--parallel-scale", "-1"),
            ("--memory-limit", "--memory-limit", "0"),
            ("--seeds", "--seeds", "0"),
            ("--seeds", "--seeds", "1.5"),
            ("--seeding", "--seeding", "everywhere"),
            ("--method", "--method", "magic"),
            ("--bogus", "--bogus"),
            ("--compare", "--compare", "--reference"),
            ("--reference", "--reference", "--method", "vtk"),
        ):
            with self.subTest(arguments=arguments):
                self.refuse(2, text, self.lines, *arguments)
        result = self.run_program(self.lines)
        self.assertEqual(result.returncode, 2)
        self.assertIn("--output", result.stderr)
        self.refuse(2, "input")
        self.refuse(2, ".png", self.lines, output=self.folder / "picture.xyz")

    def test_camera_without_direction(self):
        self.refuse(1, "--camera-position", self.lines, "--camera-position", "1,1,1",
                    "--focal-point", "1,1,1")
        self.refuse(1, "--view-up", self.lines, "--view-up", "0,0,0")
        self.refuse(1, "--view-up", self.lines, "--camera-position", "0,0,5",
                    "--focal-point", "0,0,0", "--view-up", "0,0,1")

    def test_unwritable_outputs(self):
        self.refuse(1, "cannot be written", self.lines, output="/nonexistent/picture.png")
        self.refuse(1, "cannot be written", self.lines, "--statistics", "/nonexistent/s.json")

    def test_picture_beyond_opengl(self):
        self.refuse(1, "at most", self.lines, "--size", "60000x2")

    def test_old_opengl(self):
        old = {"MESA_GL_VERSION_OVERRIDE": "3.3"}
        self.refuse(1, "needs OpenGL 4.3", self.lines, environment=old)
        picture, _ = self.render(
            self.lines, "--size", "50x50", "--method", "vtk", "--background", "0,0,0",
            environment=old)
        self.assertTrue((picture != BACKGROUND).any())

    def test_no_display(self):
        if os.environ.get("VTK_DEFAULT_OPENGL_WINDOW", "vtkXOpenGLRenderWindow").startswith("vtkX"):
            self.refuse(1, "no OpenGL window", self.lines, environment={"DISPLAY": ""})


if __name__ == "__main__":
    unittest.main()
