#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkImportance and vtkTrajectorySelection from Python, against numpy on random data, and on the
trajectories of a file.
"""

import unittest

import numpy
import readers
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_ID_TYPE, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from pellucid import vtkGeographicTrajectoryReader as Base
from pellucid import vtkImportance, vtkMet3DReader, vtkTrajectorySelection

PER_LINE = 20


def add_array(attributes, name, values):
    array = numpy_to_vtk(values, deep=True)
    array.SetName(name)
    attributes.AddArray(array)


def make_lines(values):
    """Lines of PER_LINE points each with the point array "a" and its means as the cell array "mean"."""
    count = len(values)
    points = vtkPoints()
    points.SetData(numpy_to_vtk(numpy.zeros((count, 3), numpy.float32), deep=True))
    lines = vtkCellArray()
    lines.SetData(PER_LINE, numpy_to_vtk(numpy.arange(count), deep=True, array_type=VTK_ID_TYPE))
    data = vtkPolyData()
    data.SetPoints(points)
    data.SetLines(lines)
    add_array(data.GetPointData(), "a", values)
    add_array(data.GetCellData(), "mean", values.reshape(-1, PER_LINE).mean(axis=1))
    return data


class TestImportance(unittest.TestCase):
    def setUp(self):
        self.generator = numpy.random.default_rng(3)

    def draw(self, kind):
        values = self.generator.normal(size=PER_LINE * 500) ** 3
        return {
            "double": values,
            "float": values.astype(numpy.float32),
            "ties": numpy.round(4 * values).astype(numpy.int16),
            "missing": numpy.where(self.generator.random(values.size) < 0.3, numpy.nan, values),
        }[kind]

    def test_percentiles_are_those_of_numpy(self):
        for kind in ("double", "float", "ties", "missing"):
            values = self.draw(kind)
            data = make_lines(values)
            present = values[numpy.isfinite(values)].astype(float)
            for low, high in ((0, 100), (5, 95), (33.3, 66.7), (99.99, 0.01)):
                expected = numpy.percentile(present, (low, high))
                importance = vtkImportance()
                importance.SetInputData(data)
                importance.AddCriterion("a", low, high, 1, True, True)
                importance.Update()
                found = importance.GetEffectiveMinimum(0), importance.GetEffectiveMaximum(0)
                numpy.testing.assert_allclose(found, expected, rtol=1e-13, atol=1e-13)

                selection = vtkTrajectorySelection()
                selection.SetInputData(data)
                selection.SetArrayName("a")
                selection.SetMinimum(low)
                selection.SetMinimumIsPercentile(True)
                selection.Update()
                self.assertEqual(selection.GetEffectiveMinimum(), found[0])
                above = (values.reshape(-1, PER_LINE) >= found[0]).any(axis=1)
                self.assertEqual(selection.GetNumberOfSelectedLines(), above.sum())

    def test_importance_and_histogram_are_those_of_numpy(self):
        values = self.draw("double")
        importance = vtkImportance()
        importance.SetInputData(make_lines(values))
        importance.AddCriterion("a", -1, 2)
        importance.AddCriterion("mean", 3, -3, 0.5)
        importance.SetExponent(3)
        importance.Update()
        means = numpy.repeat(values.reshape(-1, PER_LINE).mean(axis=1), PER_LINE)
        maps = numpy.clip((values + 1) / 3, 0, 1), numpy.clip((3 - means) / 6, 0, 1)
        expected = ((maps[0] + 0.5 * maps[1]) / 1.5) ** 3
        output = importance.GetOutput()
        found = vtk_to_numpy(output.GetPointData().GetArray("Importance"))
        self.assertEqual(found.dtype, numpy.float32)
        numpy.testing.assert_allclose(found, expected, atol=1e-7)
        counts = numpy.histogram(found, bins=100, range=(0, 1))[0]
        for histogram in (
            importance.GetHistogram(),
            output.GetFieldData().GetArray("ImportanceHistogram"),
        ):
            numpy.testing.assert_array_equal(vtk_to_numpy(histogram), counts)

    def test_selections_in_a_row_before_an_importance(self):
        values = self.draw("double")
        first = vtkTrajectorySelection()
        first.SetInputData(make_lines(values))
        first.SetArrayName("mean")
        first.SetMinimum(0)
        second = vtkTrajectorySelection()
        second.SetInputConnection(first.GetOutputPort())
        second.SetArrayName("a")
        second.SetMaximum(5)
        second.AllPointsOn()
        importance = vtkImportance()
        importance.SetInputConnection(second.GetOutputPort())
        importance.AddCriterion("a", 0, 1)
        importance.Update()
        lines = values.reshape(-1, PER_LINE)
        expected = lines[(lines.mean(axis=1) >= 0) & (lines <= 5).all(axis=1)]
        self.assertGreater(len(expected), 50)
        self.assertEqual(second.GetNumberOfSelectedLines(), len(expected))
        output = importance.GetOutput()
        found = vtk_to_numpy(output.GetPointData().GetArray("a")).reshape(-1, PER_LINE)
        numpy.testing.assert_array_equal(found, expected)
        numpy.testing.assert_allclose(
            vtk_to_numpy(output.GetPointData().GetArray("Importance")),
            numpy.clip(expected.ravel(), 0, 1),
            atol=1e-7,
        )

    def select_ids(self, data, minimum, maximum, all_points):
        selection = vtkTrajectorySelection()
        selection.SetInputData(data)
        selection.SetArrayName("pressure")
        selection.SetMinimum(minimum)
        selection.SetMaximum(maximum)
        selection.SetAllPoints(all_points)
        selection.Update()
        return readers.cells(selection.GetOutput(), "TrajectoryId")

    def test_the_same_trajectories_wherever_the_map_is_cut(self):
        whole, _ = readers.read(vtkMet3DReader)
        for bounds in ((0, 500, False), (500, 1100, True)):
            selected = self.select_ids(whole, *bounds)
            self.assertTrue(10 < len(selected) < whole.GetNumberOfLines() - 10)
            for center in range(-180, 180, 30):
                cut, _ = readers.read(
                    vtkMet3DReader, LongitudeMode=Base.CUT, CentralLongitude=center
                )
                parts = [i for i in readers.cells(cut, "TrajectoryId") if i in selected]
                self.assertEqual(self.select_ids(cut, *bounds), parts)


if __name__ == "__main__":
    unittest.main()
