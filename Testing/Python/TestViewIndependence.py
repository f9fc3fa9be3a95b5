#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The same parameters give the same opacities from far, near and close, beyond the sampling by
pixels (figure 8 of Guenther, Theisel and Gross 2017); those of the global problem change."""

import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow

import pellucid

Q, R, EMPHASIS = 5.0, 2.0, 1.5
IMPORTANCES = numpy.array([0.1, 0.8, 0.3, 0.0, 1.0, 0.5, 0.2])
EXACT = 1e-5
CLOSE = 0.8  # half of the height of the closest view on lines


def solution(importances):
    """Equation 9 of the paper, for a list from front to back."""
    squares = importances ** 2
    before = numpy.cumsum(squares) - squares
    behind = numpy.cumsum(squares[::-1])[::-1] - squares
    return 1.0 / (1.0 + (1.0 - importances) ** (2.0 * EMPHASIS) * (R * before + Q * behind))


def poly_data(points, lengths, importances, kind):
    data = vtkPolyData()
    coordinates = vtkPoints()
    coordinates.SetData(numpy_to_vtk(numpy.asarray(points, dtype=float), deep=True))
    data.SetPoints(coordinates)
    offsets = numpy.concatenate([[0], numpy.cumsum(lengths)]).astype(numpy.int64)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(numpy.arange(offsets[-1]), deep=True))
    getattr(data, kind)(cells)
    add_importance(data, importances)
    return data


def add_importance(data, importances):
    array = numpy_to_vtk(numpy.asarray(importances, dtype=numpy.float32), deep=True)
    array.SetName("Importance")
    data.GetPointData().AddArray(array)


def layer(depth, importance):
    source = vtkPlaneSource()
    source.SetOrigin(-5.0, -5.0, depth)
    source.SetPoint1(5.0, -5.0, depth)
    source.SetPoint2(-5.0, 5.0, depth)
    source.Update()
    add_importance(source.GetOutput(), numpy.full(4, importance))
    return source.GetOutput()


def divide(data):
    divider = pellucid.vtkTrajectorySegments()
    divider.SetInputData(data)
    divider.SetNumberOfSegments(600)
    divider.Update()
    return divider.GetOutput()


def helices(lines=60, points=80):
    """Lines around tilted axes, half of them important, in segments."""
    t = numpy.linspace(0.0, 1.0, points)
    line = numpy.arange(lines)[:, None]
    angle, turn = 9.0 * t + line, 0.4 + 0.3 * numpy.sin(1.3 * line)
    x = 3.0 * (t - 0.5) + 0.3 * numpy.sin(5.1 * line)
    y = turn * numpy.cos(angle) + 0.8 * numpy.sin(2.2 * line)
    z = turn * numpy.sin(angle) + 0.8 * numpy.cos(3.7 * line)
    importances = numpy.clip(numpy.sin(2.0 * x + y), 0.0, 1.0)
    data = poly_data(numpy.stack([x, y, z], axis=2).reshape(-1, 3), [points] * lines,
                     importances.ravel(), "SetLines")
    return divide(data)


def lies_in_close_view(data):
    """Whether a segment lies in the picture of the closest view with all of its points."""
    reach = numpy.abs(vtk_to_numpy(data.GetPoints().GetData())[:, :2]).max(axis=1)
    inside = numpy.ones(data.GetFieldData().GetArray("TotalNumberOfSegments").GetValue(0), dtype=bool)
    inside[vtk_to_numpy(data.GetPointData().GetArray("SegmentBase"))[reach > CLOSE - 0.05]] = False
    return inside


def global_solver(data):
    """The global problem with the mean importance of the points of each segment."""
    base = vtk_to_numpy(data.GetPointData().GetArray("SegmentBase"))
    importances = vtk_to_numpy(data.GetPointData().GetArray("Importance"))
    solver = pellucid.vtkGlobalOpacitySolver()
    solver.SetImportance(numpy_to_vtk(numpy.bincount(base, importances) / numpy.bincount(base),
                                      deep=True))
    solver.SetOcclusionWeight(0.05)
    solver.SetBackgroundWeight(0.4)
    solver.SetEmphasis(2.0)
    solver.SetSmoothness(0.0)
    return solver


class Scene:
    def __init__(self, parts, radius=0.0, size=200):
        self.renderer = vtkRenderer()
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(size, size)
        self.window.AddRenderer(self.renderer)
        self.optimization = pellucid.vtkOpacityOptimization()
        self.optimization.SetOcclusionWeight(Q)
        self.optimization.SetClutterWeight(R)
        self.optimization.SetEmphasis(EMPHASIS)
        self.optimization.SetSmoothingIterations(0)
        self.actors = []
        for data in parts:
            mapper = pellucid.vtkTrajectoryMapper() if radius else vtkPolyDataMapper()
            if radius:
                mapper.SetRadius(radius)
            mapper.SetInputData(data)
            mapper.ScalarVisibilityOff()
            actor = vtkActor()
            actor.SetMapper(mapper)
            pellucid.vtkOpacityOptimization.Attach(actor, self.optimization)
            self.renderer.AddActor(actor)
            self.actors.append(actor)
        self.transparency = pellucid.install(self.renderer)

    def opacities(self, distance, parallel_scale=0.0):
        """Those of all segments; negative for a segment that is not seen."""
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.0, 0.0, distance)
        camera.SetParallelProjection(parallel_scale > 0.0)
        camera.SetParallelScale(parallel_scale or 1.0)
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        return numpy.concatenate([vtk_to_numpy(self.transparency.GetOptimizedOpacities(actor))
                                  for actor in self.actors]).astype(float)

    def pixel_lists(self):
        reference = pellucid.vtkReferenceRenderer()
        reference.SetRenderer(self.renderer)
        reference.SetSize(*self.window.GetSize())
        reference.Update()
        lists = vtkCellArray()
        reference.GetPixelSegments(lists)
        return lists


class TestViewIndependence(unittest.TestCase):
    def test_layers_from_any_distance(self):
        scene = Scene([layer(-0.1 * i, g) for i, g in enumerate(IMPORTANCES)])
        views = [(10.0, scale) for scale in (0.01, 1.0, 20.0, 300.0)]
        views += [(distance, 0.0) for distance in (0.01, 1.0, 20.0, 500.0)]
        for view in views:
            with self.subTest(view=view):
                numpy.testing.assert_allclose(
                    scene.opacities(*view), solution(IMPORTANCES), atol=EXACT)

    def test_layers_as_lists_of_pixels(self):
        scene = Scene([layer(-0.1 * i, g) for i, g in enumerate(IMPORTANCES)], size=20)
        scene.opacities(10.0, 20.0)
        lists = scene.pixel_lists()
        self.assertEqual(lists.GetNumberOfCells(), 20 * 20)
        lengths = numpy.diff(vtk_to_numpy(lists.GetOffsetsArray()))
        self.assertEqual(sorted(set(lengths)), [0, 7])
        self.assertEqual((lengths == 7).sum(), 5 * 5)  # a quarter of the picture in each direction
        ids = vtk_to_numpy(lists.GetConnectivityArray()).reshape(-1, 7)
        numpy.testing.assert_array_equal(ids, numpy.tile(numpy.arange(7), (25, 1)))

    def test_rows_of_balls_at_any_scale(self):
        heights = (1, 2, 4, 7)
        points = [(1.5 * column, 0.0, -2.5 * i)
                  for column, height in enumerate(heights) for i in range(height)]
        importances = numpy.concatenate([IMPORTANCES[:height] for height in heights])
        balls = divide(poly_data(points, [1] * len(points), importances, "SetVerts"))
        scene = Scene([balls], radius=0.7)
        expected = numpy.concatenate([solution(IMPORTANCES[:height]) for height in heights])
        for scale in (6.0, 12.0, 40.0):
            with self.subTest(scale=scale):
                numpy.testing.assert_allclose(
                    scene.opacities(10.0, scale), expected, atol=EXACT)

    def test_lines_far_near_and_close(self):
        """Pixels sample the least opacity of a segment: four times as many change it little. The
        weights of the global problem count pixels, so that more of them fade more."""
        data = helices()
        scene = Scene([data], radius=0.03, size=500)
        scene.optimization.UsePreset("clear-back")
        scene.optimization.SetSmoothingIterations(0)
        solver = global_solver(data)
        decoupled, globally = [], []
        for scale in (3.2, 1.6, CLOSE):
            decoupled.append(scene.opacities(10.0, scale))
            solver.SetPixelLists(scene.pixel_lists())
            self.assertTrue(solver.Solve())
            globally.append(vtk_to_numpy(solver.GetOpacity()).copy())
        compared = lies_in_close_view(data)
        for opacities in decoupled:
            compared &= opacities >= 0.0
        self.assertGreater(compared.sum(), 100)
        far, near, close = (opacities[compared] for opacities in decoupled)
        self.assertLess(close.mean(), 0.8)  # much fades, so that there is something to compare
        for other in (far, near):
            change = numpy.abs(other - close)
            self.assertLess(change.mean(), 0.02)
            self.assertLess(numpy.quantile(change, 0.9), 0.05)
        far, near, close = (opacities[compared].mean() for opacities in globally)
        self.assertGreater(far, near + 0.05)
        self.assertGreater(near, close + 0.05)


if __name__ == "__main__":
    unittest.main()
