# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""pellucid.add_lines and add_points bring data and arrays of NumPy into a renderer."""

import re
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkUnstructuredGrid
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer, vtkRenderWindow

import pellucid
from pictures import picture

FRONT = [(-1, 0, 0.3), (0, 0, 0.3), (1, 0, 0.3)]
BACK = [(0, -1, -0.3), (0, 0, -0.3), (0, 1, -0.3)]
HEIGHTS = [0.3, 0.3, 0.3, -0.3, -0.3, -0.3]


class ViewTest(unittest.TestCase):
    def setUp(self):
        self.renderer = vtkRenderer()
        self.renderer.GetActiveCamera().SetPosition(0, 0, 5)
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(60, 40)
        self.window.AddRenderer(self.renderer)

    def draw(self):
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        return picture(self.window)

    def assert_reference(self):
        """The picture, and what the reference renderer says, differ on outlines at most."""
        reference = 255 * pellucid.reference_picture(self.renderer)[::-1, :, :3]
        difference = abs(self.draw() - reference).max(axis=2)
        self.assertLess((difference > 1).mean(), 0.01)
        self.assertGreater(reference.max(), 30)


class TestData(ViewTest):
    def points_of(self, data):
        actor = pellucid.add_lines(self.renderer, data)
        mesh = actor.GetMapper().GetInput()
        cells = mesh.GetLines()
        self.assertIsInstance(actor.GetMapper(), pellucid.vtkTrajectoryMapper)
        return vtk_to_numpy(mesh.GetPoints().GetData()), vtk_to_numpy(cells.GetOffsetsArray()).tolist()

    def test_arrays_of_points(self):
        for data, offsets in (
            (numpy.array(FRONT), [0, 3]), ([numpy.array(FRONT), BACK[:2]], [0, 3, 5]),
            (FRONT, [0, 3]), (numpy.array((FRONT, BACK), numpy.float32), [0, 3, 6]), ([], [0]),
        ):
            points, found = self.points_of(data)
            self.assertEqual(found, offsets)
            self.assertEqual(len(points), offsets[-1])
        self.assertEqual(points.dtype, numpy.float64)
        self.assertEqual(self.points_of(numpy.array(FRONT, numpy.float32))[0].dtype, numpy.float32)

    def test_poly_data_is_taken_as_it_is(self):
        lines = pellucid.add_lines(self.renderer, [FRONT, BACK]).GetMapper().GetInput()
        self.assertIs(pellucid.add_lines(self.renderer, lines).GetMapper().GetInput(), lines)
        with_scalars = pellucid.add_lines(self.renderer, lines, scalars=HEIGHTS)
        self.assertIsNone(lines.GetPointData().GetArray("Scalars"))
        array = with_scalars.GetMapper().GetInput().GetPointData().GetArray("Scalars")
        self.assertEqual(vtk_to_numpy(array).tolist(), HEIGHTS)

    def test_types_of_numbers(self):
        for kind in ("?", "i1", "u8", "<i4", ">i4", "<f4", ">f4", ">f8", "f2", "g"):
            with self.subTest(kind=kind):
                values = numpy.array([0, 1, 1], kind)
                actor = pellucid.add_lines(
                    self.renderer, numpy.array(FRONT, ">f4"), scalars=values, radius=values)
                attributes = actor.GetMapper().GetInput().GetPointData()
                for name in ("Scalars", "Radius"):
                    self.assertEqual(vtk_to_numpy(attributes.GetArray(name)).tolist(), [0, 1, 1])
                self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 1))
                self.assertEqual(actor.GetMapper().GetBounds()[4], numpy.float32(0.3) - 1)

    def test_range_of_finite_values(self):
        nan, inf = numpy.nan, numpy.inf
        for values, expected in (
            ([nan, 2, 3], (2, 3)), ([-inf, 2, inf], (2, 2)), ([nan] * 3, (0, 1)),
            ([(0, 3, 4), (nan, 0, 0), (0, 0, 1)], (1, 5)),
        ):
            actor = pellucid.add_lines(self.renderer, FRONT, scalars=values)
            self.assertEqual(actor.GetMapper().GetScalarRange(), expected)

    def test_composite_data(self):
        blocks = vtkMultiBlockDataSet()
        for i, line in enumerate((FRONT, BACK)):
            lines = pellucid.add_lines(self.renderer, line, scalars=[i, i, i]).GetMapper().GetInput()
            blocks.SetBlock(i, lines)
        actor = pellucid.add_lines(self.renderer, blocks, scalars="Scalars")
        self.assertEqual(actor.GetMapper().GetScalarRange(), (0, 1))
        with self.assertRaisesRegex(TypeError, "scalars: of vtkMultiBlockDataSet, expected the name"):
            pellucid.add_lines(self.renderer, blocks, scalars=HEIGHTS)

    def test_points(self):
        actor = pellucid.add_points(self.renderer, numpy.array(FRONT + BACK))
        mesh = actor.GetMapper().GetInput()
        self.assertEqual(mesh.GetNumberOfVerts(), 6)
        self.assertIs(pellucid.add_points(self.renderer, mesh).GetMapper().GetInput(), mesh)
        lines = pellucid.add_lines(self.renderer, [FRONT], scalars=[1, 2, 3]).GetMapper().GetInput()
        balls = pellucid.add_points(self.renderer, lines, scalars="Scalars").GetMapper().GetInput()
        self.assertEqual((balls.GetNumberOfVerts(), balls.GetNumberOfLines()), (3, 0))


class TestPicture(ViewTest):
    def test_the_renderer_becomes_exact(self):
        pellucid.add_lines(self.renderer, [FRONT, BACK], radius=0.2, color="tomato", opacity=0.5)
        self.assert_reference()
        transparency = pellucid.install(self.renderer)
        self.assertGreater(transparency.GetStatistics().GetLongestList(), 1)
        self.assertIs(pellucid.install(self.window), transparency)
        pellucid.uninstall(self.window)
        self.assertIsNone(self.renderer.GetPass())

    def test_colors(self):
        table = vtkLookupTable()
        table.SetNumberOfTableValues(2)
        table.SetTableValue(0, 1, 0, 0, 1)
        table.SetTableValue(1, 0, 0, 1, 1)
        for cmap in (table, [(1, 0, 0), (0, 0, 1)], numpy.array([(1, 0, 0, 1), (0, 0, 1, 1.0)])):
            self.renderer.RemoveAllViewProps()
            actor = pellucid.add_lines(
                self.renderer, [FRONT, BACK], radius=0.2, scalars=HEIGHTS, cmap=cmap, lighting=False)
            self.assertEqual(actor.GetMapper().GetScalarRange(), (-0.3, 0.3))
            self.assertEqual(self.draw()[20, 30].tolist(), [0, 0, 255])
            pellucid.add_lines(self.renderer, [FRONT], scalars=HEIGHTS[:3], clim=(2, 4))

    def test_radius_for_each_point(self):
        constant = pellucid.add_lines(self.renderer, FRONT, radius=numpy.float32(0.5))
        self.assertEqual(constant.GetMapper().GetRadius(), 0.5)
        for radius in ([0.1, 0.2, 0.3], "Radius"):
            self.renderer.RemoveAllViewProps()
            if radius == "Radius":
                data = actor.GetMapper().GetInput()
            else:
                data = FRONT
            actor = pellucid.add_lines(self.renderer, data, radius=radius, color=(1, 1, 1))
            columns = (self.draw().sum(axis=2) > 0).sum(axis=0)
            self.assertGreater(columns[42], 1.5 * columns[18])

    def test_appearance(self):
        actor = pellucid.add_lines(
            self.renderer, FRONT, color="#336699", opacity=0.25, ambient=0.1, diffuse=0.5, specular=0.3,
            specular_power=20, lighting=False, pickable=False, nan_color="red")
        appearance = actor.GetProperty()
        self.assertEqual(
            (appearance.GetOpacity(), appearance.GetAmbient(), appearance.GetDiffuse(),
             appearance.GetSpecular(), appearance.GetSpecularPower(), appearance.GetLighting(),
             actor.GetPickable()), (0.25, 0.1, 0.5, 0.3, 20, False, False))
        numpy.testing.assert_allclose(appearance.GetColor(), (0.2, 0.4, 0.6))

    def test_importance(self):
        actor = pellucid.add_lines(
            self.renderer, [FRONT, BACK], radius=0.2, importance=HEIGHTS, importance_range=(0.3, -0.3),
            preset="focus", smoothing_iterations=0)
        found = pellucid.vtkImportanceDrivenOpacity.Get(actor)
        self.assertEqual((found.GetOcclusionWeight(), found.GetSmoothingIterations()), (1000, 0))
        with self.assertRaisesRegex(ValueError, "expected an actor whose opacities the last frame"):
            pellucid.optimized_opacities(self.renderer, actor)
        self.assert_reference()
        opacities = pellucid.optimized_opacities(self.renderer, actor)
        self.assertEqual(opacities.dtype, numpy.float32)
        self.assertLess(numpy.nanmin(opacities), 0.1)
        self.assertEqual(numpy.nanmax(opacities), 1)


class TestErrors(ViewTest):
    def test_wrong_arguments_change_nothing(self):
        for error, message, wrong in (
            (TypeError, "unknown parameter 'colour'; there are color, scalars, ", {"colour": "red"}),
            (TypeError, "unknown parameter 'line_width'; there are ", {"line_width": 3}),
            (ValueError, "opacity: expected a number from 0 to 1, found 2", {"opacity": 2}),
            (TypeError, "opacity: expected a number from 0 to 1, found 'linear'", {"opacity": "linear"}),
            (ValueError, "radius: expected 0 or more, found -1", {"radius": -1}),
            (ValueError, "radius: expected 0 or more, found nan", {"radius": float("nan")}),
            (ValueError, "radius: expected 6 values, one for each point, found an array of shape (2,)",
             {"radius": [1, 2]}),
            (ValueError, "radius: there is no point array 'x' of one component", {"radius": "x"}),
            (ValueError, "color: there is no color 'blau'", {"color": "blau"}),
            (ValueError, "color: expected red, green and blue in [0, 1], found (255, 0, 0)",
             {"color": (255, 0, 0)}),
            (ValueError, "scalars: there is no array 'x' of points or cells", {"scalars": "x"}),
            (TypeError, "scalars: expected numbers or the name of an array", {"scalars": ["a"] * 6}),
            (ValueError, "clim: expected two finite numbers, found (1,)",
             {"clim": (1,), "scalars": HEIGHTS}),
            (TypeError, "cmap: only a PyVista plotter knows names", {"cmap": "viridis"}),
            (ValueError, "cmap: expected colors as an array of shape", {"cmap": [1, 2]}),
            (ValueError, "importance: there is no point array 'x'", {"importance": "x"}),
            (ValueError, "emphasis: only with importance, which is missing", {"emphasis": 2}),
            (ValueError, "preset: expected one of", {"preset": "x", "importance": HEIGHTS}),
            (ValueError, "emphasis: expected 0.01 to 100, found 0",
             {"emphasis": 0, "importance": HEIGHTS}),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(error, re.escape(message)):
                pellucid.add_lines(self.renderer, [FRONT, BACK], **wrong)
        self.assertEqual(self.renderer.GetActors().GetNumberOfItems(), 0)
        self.assertIsNone(pellucid.vtkTransparencyInstaller.GetPass(self.renderer))

    def test_wrong_data(self):
        for error, message, wrong in (
            (TypeError, "lines: expected vtkPolyData or an array of points, found NoneType", None),
            (TypeError, "found vtkUnstructuredGrid; vtkGeometryFilter makes", vtkUnstructuredGrid()),
            (TypeError, "lines: expected numbers, found", ["a"]),
            (ValueError, "lines: expected points as an array of shape (n, 3), found (1, 2)", [(1, 2)]),
            (ValueError, "of shape (n, 3), found (3,)", [FRONT, (1, 2, 3)]),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(error, re.escape(message)):
                pellucid.add_lines(self.renderer, wrong)
        with self.assertRaisesRegex(ValueError, "points: expected points as an array of shape"):
            pellucid.add_points(self.renderer, [1, 2, 3])

    def test_wrong_views(self):
        for wrong in (None, self.window, vtkActor(), "renderer"):
            with self.assertRaisesRegex(TypeError, "expected a PyVista plotter or a vtkRenderer, found"):
                pellucid.add_lines(wrong, FRONT)
        with self.assertRaisesRegex(ValueError, "size: expected two positive integers"):
            pellucid.reference_picture(self.renderer, (0, 5))


if __name__ == "__main__":
    unittest.main()
