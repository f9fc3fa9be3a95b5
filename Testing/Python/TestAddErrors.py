# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid.add_lines and its like tell what is wrong with their arguments, and change nothing then."""

import pathlib
import re
import unittest

import numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

import pellucid
from views import BACK, FRONT, HEIGHTS, ViewTest


MESH = pellucid.add_lines(vtkRenderer(), [FRONT, BACK], scalars=numpy.zeros((6, 2))).GetMapper().GetInput()
POINTS = pellucid.add_points(vtkRenderer(), FRONT).GetMapper().GetInput()


class ErrorTest(ViewTest):
    def assert_refused(self, add, data, error, message, **wrong):
        with self.subTest(**wrong):
            with self.assertRaisesRegex(error, "^" + re.escape(message)) as caught:
                add(self.renderer, data, **wrong)
            self.assertLess(len(str(caught.exception)), 500)
        self.assertEqual(self.renderer.GetActors().GetNumberOfItems(), 0)
        self.assertIsNone(pellucid.vtkTransparencyInstaller.GetPass(self.renderer))


class TestArguments(ErrorTest):
    def assert_all_refused(self, *rows):
        for error, message, wrong in rows:
            self.assert_refused(pellucid.add_lines, [FRONT, BACK], error, message, **wrong)

    def test_unknown_names(self):
        self.assert_all_refused(
            (TypeError, "unknown parameter 'size'; there are radius, importance, importance_range, "
             "preset, occlusion_weight, ", {"size": 2}),
            (TypeError, "unknown parameter 'line_width'; use radius", {"line_width": 3}),
            (TypeError, "unknown parameter 'point_size'; use radius", {"point_size": 3}),
            (TypeError, "unknown parameter 'colour'; use color", {"colour": "red"}),
            (TypeError, "unknown parameter 'alpha'; use opacity", {"alpha": 0.5}),
            (TypeError, "unknown parameter 'q'; use occlusion_weight", {"q": 3}),
            (TypeError, "unknown parameter 'r'; use clutter_weight", {"r": 3}),
            (TypeError, "unknown parameter 'lambda'; use emphasis", {"lambda": 3}),
            (TypeError, "unknown parameter 's'; use smoothing_iterations", {"s": 3}),
            (TypeError, "unknown parameter 'm'; there are ", {"m": 3}),
            (TypeError, "unknown parameter 'render_lines_as_tubes'; leave it out: lines are tubes already, "
             "with the radius of add_lines()", {"render_lines_as_tubes": True}),
            (TypeError, "unknown parameter 'render_points_as_spheres'; leave it out: points are balls already",
             {"render_points_as_spheres": True}),
            (TypeError, "unknown parameter 'style'; lines are tubes and points balls; only add_surface() to a "
             "PyVista plotter has it", {"style": "wireframe"}),
            (TypeError, "unknown parameter 'use_transparency'; use opacity, which is 1 - transparency",
             {"use_transparency": True}))
        self.assert_refused(
            pellucid.add_surface, vtkPolyData(), TypeError,
            "unknown parameter 'radius'; there are importance, ", radius=3)

    def test_radius(self):
        self.assert_all_refused(
            (ValueError, "radius: expected a number of at least 0, found -1", {"radius": -1}),
            (ValueError, "radius: expected a number of at least 0, found nan", {"radius": float("nan")}),
            (ValueError, "radius: expected a number of at least 0, found inf", {"radius": float("inf")}),
            (ValueError, "radius: expected 6 values, one for each point, or 2, one for each cell, found "
             "an array of shape (3,)", {"radius": [1, 2, 3]}),
            (ValueError, "radius: expected numbers of at least 0, found -2 among them",
             {"radius": [1, 2, 3, -2, -1, 1]}),
            (ValueError, "radius: there is no point array 'x' of one component; there are none",
             {"radius": "x"}),
            (ValueError, "radius: there is no point array 'Scalars' of one component",
             {"radius": "Scalars", "scalars": HEIGHTS}))
        heights = pellucid.add_lines(vtkRenderer(), [FRONT, BACK], scalars=HEIGHTS).GetMapper().GetInput()
        self.assert_refused(
            pellucid.add_lines, heights, ValueError,
            "radius: expected numbers of at least 0, found -0.3 among them", radius="Scalars")

    def test_colors(self):
        self.assert_all_refused(
            (ValueError, "color: there is no color 'blau'", {"color": "blau"}),
            (ValueError, "color: expected red, green and blue in [0, 1], found (255, 0, 0)",
             {"color": (255, 0, 0)}),
            (TypeError, "color: expected numbers, found ['a', 'b']", {"color": ["a", "b"]}),
            (ValueError, "scalars: there is no array 'x' of points or cells; there are Radius",
             {"scalars": "x", "radius": [1] * 6}),
            (TypeError, "scalars: expected numbers or the name of an array, found ['a', 'a', ",
             {"scalars": ["a"] * 6}),
            (TypeError, "scalars: expected numbers or the name of an array, found a list of 600",
             {"scalars": ["a"] * 600}),
            (TypeError, "scalars: expected numbers or the name of an array, found an array of str32 of "
             "shape (9,)",
             {"scalars": numpy.array(["a"] * 9)}),
            (ValueError, "scalars: expected numbers or the name of an array, found rows of unequal "
             "lengths", {"scalars": [(1, 2, 3), (4, 5)]}),
            (ValueError, "scalars: expected 6 values, one for each point, or 2, one for each cell, found "
             "an array of shape (3, 2)", {"scalars": numpy.zeros((3, 2))}),
            (ValueError, "clim: expected two finite numbers, found (1,)", {"clim": (1,)}),
            (ValueError, "clim: expected the lower number first, found (2, 1)", {"clim": (2, 1)}),
            (ValueError, "clim: expected the lower number first, found -2", {"clim": -2}),
            (ValueError, "nan_color: expected with colors as an array or without cmap, found with a "
             "vtkLookupTable; set it there",
             {"nan_color": "red", "cmap": vtkLookupTable(), "scalars": HEIGHTS}),
            (ValueError, "nan_color: there is no color 'blau'", {"nan_color": "blau", "scalars": HEIGHTS}),
            (ValueError, "nan_color: expected red, green and blue in [0, 1], found (255, 0, 0)",
             {"nan_color": (255, 0, 0), "scalars": HEIGHTS}),
            (ValueError, "scalars: expected 6 values, one for each point, or 2, one for each cell, found "
             "an array of shape ()", {"scalars": numpy.array(5)}),
            (TypeError, "cmap: only a PyVista plotter knows names", {"cmap": "viridis"}),
            (ValueError, "cmap: expected colors in [0, 1] as an array of shape (n, 3) or (n, 4), found [1, 2]",
             {"cmap": [1, 2]}),
            (ValueError, "cmap: expected colors in [0, 1]", {"cmap": [(0, 0, 255), (255, 0, 0)]}),
            (TypeError, "cmap: expected numbers, found ['a']", {"cmap": ["a"]}))

    def test_materials(self):
        self.assert_all_refused(
            (ValueError, "opacity: expected a number from 0 to 1, found 2", {"opacity": 2}),
            (TypeError, "opacity: expected a number from 0 to 1, found 'linear'", {"opacity": "linear"}),
            (TypeError, "specular: expected a number from 0 to 1, found 'a'", {"specular": "a"}),
            (ValueError, "ambient: expected a number from 0 to 1, found -1", {"ambient": -1}),
            (ValueError, "diffuse: expected a number from 0 to 1, found 2", {"diffuse": 2}),
            (ValueError, "specular_power: expected a number from 0 to 128, found 129",
             {"specular_power": 129}),
            (TypeError, "lighting: expected True or False, found 'on'", {"lighting": "on"}),
            (TypeError, "pickable: expected True or False, found 2", {"pickable": 2}))

    def test_importance(self):
        pairs = numpy.zeros((6, 2))
        self.assert_all_refused(
            (ValueError, "importance: there is no point array 'x' of one component; there are none",
             {"importance": "x"}),
            (ValueError, "importance: expected 6 values, one for each point, or 2, one for each cell, "
             "found an array of shape (6, 2)", {"importance": pairs}),
            (ValueError, "importance: there is no point array 'Scalars' of one component",
             {"importance": "Scalars", "scalars": HEIGHTS}),
            (ValueError, "importance: expected 6 values, one for each point, or 2, one for each cell, "
             "found an array of shape ()", {"importance": 5}),
            (ValueError, "importance: expected 6 values, one for each point, or 2, one for each cell, "
             "found an array of shape ()", {"importance": numpy.array(5)}),
            (ValueError, "emphasis: only with importance, which is missing", {"emphasis": 2}),
            (ValueError, "preset: only with importance, which is missing", {"preset": "focus"}),
            (ValueError, "importance_range: only with importance, which is missing",
             {"importance_range": (0, 2)}),
            (ValueError, "preset: expected one of clear-front, balanced, focus, clear-back, points; "
             "found 'x'", {"preset": "x", "importance": HEIGHTS}),
            (ValueError, "preset: expected one of clear-front, balanced, focus, clear-back, points; "
             "found an array of str", {"preset": numpy.array(["focus"]), "importance": HEIGHTS}),
            (ValueError, "emphasis: expected a number from 0.01 to 100, found 0",
             {"emphasis": 0, "importance": HEIGHTS}),
            (TypeError, "emphasis: expected a number from 0.01 to 100, found 'a'",
             {"emphasis": "a", "importance": HEIGHTS}),
            (TypeError, "smoothing_iterations: expected an integer ",
             {"smoothing_iterations": 2.5, "importance": HEIGHTS}),
            (TypeError, "self_occlusion: expected True or False, found 2",
             {"self_occlusion": 2, "importance": HEIGHTS}))
        self.assert_refused(
            pellucid.add_lines, MESH, ValueError,
            "importance: there is no point array 'Scalars' of one component", importance="Scalars")


class TestData(ErrorTest):
    def test_lines(self):
        nan = float("nan")
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, MESH)
        blocks.SetBlock(1, vtkUnstructuredGrid())
        array = "lines: expected vtkPolyData or an array of points, found "
        poly_data = "lines: expected vtkPolyData or composite data of it, found a "
        surface = "; vtkGeometryFilter, or extract_surface() of PyVista, makes poly data of it"
        for error, message, wrong in (
            (TypeError, array + "None", None),
            (TypeError, array + "{'x': 1}", {"x": 1}),
            (TypeError, array + "array(5)", numpy.array(5)),
            (TypeError, poly_data + "vtkUnstructuredGrid" + surface, vtkUnstructuredGrid()),
            (TypeError, poly_data + "vtkUnstructuredGrid", blocks),
            (TypeError, poly_data + "vtkPoints", vtkPoints()),
            (TypeError, array + "'a.vtk'; read the file first", "a.vtk"),
            (TypeError, array + "PosixPath('a.vtk'); read the file first", pathlib.PosixPath("a.vtk")),
            (TypeError, "lines: expected numbers, found 'a'", ["a"]),
            (ValueError, "lines: expected points as an array of shape (n, 3), found (1, 2)", [(1, 2)]),
            (ValueError, "lines: expected points as an array of shape (n, 3), found (3,)",
             [FRONT, (1, 2, 3)]),
            (ValueError, "lines: expected numbers, found rows of unequal lengths",
             [[(0, 0, 0), (1, 1)]]),
            (ValueError, "lines: expected finite coordinates, found others in 2 of 4 points; leave these "
             "out, or split the line there", [(0, 0, 0), (0, nan, nan), (1, 1, 1), (nan, 0, 0)]),
            (ValueError, "lines: expected finite coordinates, found others in 3 of 3 points",
             numpy.ma.masked_greater(FRONT, 0.2)),
            (ValueError, "lines: expected finite coordinates, found others in 3 of 6 points",
             [numpy.ma.masked_greater(FRONT, 0.2), BACK]),
            (ValueError, "lines: expected poly data with lines, found 3 points and none; there are "
             "add_lines(), add_points() and add_surface()", POINTS),
        ):
            self.assert_refused(pellucid.add_lines, wrong, error, message)

    def test_points_and_surfaces(self):
        self.assert_refused(
            pellucid.add_points, [1, 2, 3], ValueError,
            "points: expected points as an array of shape (n, 3), found (3,)")
        self.assert_refused(
            pellucid.add_points, [(0, 0, float("inf"))], ValueError, "points: expected finite coordinates")
        self.assert_refused(
            pellucid.add_points, vtkUnstructuredGrid(), TypeError, "points: expected vtkPolyData or ")
        self.assert_refused(
            pellucid.add_surface, MESH, ValueError,
            "mesh: expected poly data with polys or strips, found 6 points and none")
        self.assert_refused(
            pellucid.add_surface, numpy.zeros((3, 3)), TypeError,
            "mesh: expected vtkPolyData or composite data of it, found an array of float64 of shape")
        self.assert_refused(
            pellucid.add_surface, "a.ply", TypeError,
            "mesh: expected vtkPolyData or composite data of it, found 'a.ply'; read the file first")

    def test_views(self):
        for wrong in (None, self.window, vtkActor(), "renderer"):
            with self.assertRaisesRegex(TypeError, "expected a PyVista plotter or a vtkRenderer, found"):
                pellucid.add_lines(wrong, FRONT)


class TestReferencePicture(ViewTest):
    def test_sizes(self):
        expected = "size: expected two integers from 1 to 65536, found "
        for error, size in ((ValueError, (0, 5)), (ValueError, (1, 2, 3)), (ValueError, (2**40, 5)),
                            (ValueError, (True, True)), (TypeError, 5), (TypeError, (2.5, 3)),
                            (TypeError, "a")):
            with self.assertRaisesRegex(error, re.escape(f"{expected}{size!r}")):
                pellucid.reference_picture(self.renderer, size)
        with self.assertRaisesRegex(ValueError, "size: the renderer has none before its window has "
                                                "rendered; give width and height"):
            pellucid.reference_picture(vtkRenderer())
        with self.assertRaisesRegex(TypeError, "expected a vtkRenderer, found vtk.*Actor"):
            pellucid.reference_picture(vtkActor(), (3, 4))


if __name__ == "__main__":
    unittest.main()
