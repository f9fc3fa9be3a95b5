#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkFieldStreamlines on fields whose streamlines are known, and on fields that cannot be traced."""

import math
import unittest

from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkFloatArray
from vtkmodules.vtkCommonDataModel import (
    vtkDataObject,
    vtkDataSetAttributes,
    vtkImageData,
    vtkMultiBlockDataSet,
    vtkPolyData,
)
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersSources import vtkSphereSource

from pellucid import vtkFieldStreamlines
from readers import lines_of


def make_image(velocity, dimensions=(17, 17, 17), name="Velocity"):
    """The field `velocity(x, y, z)` on the cube [-1, 1]^3, or the part of it with z = 0."""
    image = vtkImageData()
    image.SetDimensions(dimensions)
    image.SetSpacing([2 / max(1, count - 1) for count in dimensions])
    image.SetOrigin([-1 if count > 1 else 0 for count in dimensions])
    vectors = vtkDoubleArray()
    vectors.SetName(name)
    vectors.SetNumberOfComponents(3)
    for point in range(image.GetNumberOfPoints()):
        vectors.InsertNextTuple(velocity(*image.GetPoint(point)))
    image.GetPointData().AddArray(vectors)
    return image


def rotation(x, y, _):
    return (-y, x, 0)


def trace(data, seeds=50, **properties):
    tracer = vtkFieldStreamlines()
    tracer.SetInputData(data)
    tracer.SetNumberOfSeeds(seeds)
    for name, value in properties.items():
        getattr(tracer, "Set" + name)(value)
    messages = []

    def note(_, event, text):
        messages.append((event, text))

    note.CallDataType = "string0"
    tracer.AddObserver("ErrorEvent", note)
    tracer.AddObserver("WarningEvent", note)
    tracer.GetExecutive().AddObserver("ErrorEvent", note)
    tracer.Update()
    return tracer.GetOutput(), messages


def bits_of(output):
    arrays = [output.GetPoints().GetData()]
    for data in (output.GetPointData(), output.GetCellData()):
        arrays += [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return [bytes(memoryview(array)) for array in arrays]


class TestFieldStreamlines(unittest.TestCase):
    def test_circles(self):
        output, messages = trace(make_image(rotation))
        self.assertEqual(messages, [])
        self.assertEqual(output.GetNumberOfLines(), 50)
        self.assertEqual(output.GetNumberOfCells(), 50)
        for line in lines_of(output):
            radii = [math.hypot(x, y) for x, y, _ in line]
            self.assertLess(max(radii) - min(radii), 1e-3)
            heights = [z for _, _, z in line]
            self.assertLess(max(heights) - min(heights), 1e-6)

    def test_one_line_through_each_seed_in_flow_direction(self):
        output, _ = trace(make_image(lambda x, y, z: (1, 0, 0)), seeds=10)
        self.assertEqual(output.GetNumberOfLines(), 10)
        seed_ids = output.GetCellData().GetArray("SeedIds")
        self.assertEqual([seed_ids.GetValue(i) for i in range(10)], list(range(10)))
        time = output.GetPointData().GetArray("IntegrationTime")
        self.assertEqual(time.GetNumberOfTuples(), output.GetNumberOfPoints())
        for line in lines_of(output):
            xs = [point[0] for point in line]
            self.assertEqual(xs, sorted(xs))
            self.assertEqual(len(set(xs)), len(xs))
            self.assertLess(xs[0], -0.75)
            self.assertGreater(xs[-1], 0.75)
        self.assertLess(time.GetRange()[0], 0)
        self.assertGreater(time.GetRange()[1], 0)
        reasons = output.GetCellData().GetArray("ReasonForTermination")
        self.assertEqual(reasons.GetTuple(0), (vtkStreamTracer.OUT_OF_DOMAIN,) * 2)

    def test_directions_and_length(self):
        image = make_image(lambda x, y, z: (1, 0, 0))
        forward, _ = trace(image, IntegrationDirection=vtkStreamTracer.FORWARD, MaximumLength=0.1)
        backward, _ = trace(image, IntegrationDirection=vtkStreamTracer.BACKWARD, MaximumLength=0.1)
        self.assertGreaterEqual(forward.GetPointData().GetArray("IntegrationTime").GetRange()[0], 0)
        self.assertLessEqual(backward.GetPointData().GetArray("IntegrationTime").GetRange()[1], 0)
        for output in (forward, backward):
            for line in lines_of(output):
                self.assertLess(line[-1][0] - line[0][0], 0.1 + 1e-6)
        reasons = forward.GetCellData().GetArray("ReasonForTermination")
        self.assertEqual(reasons.GetComponent(0, 0), vtkStreamTracer.NOT_INITIALIZED)
        self.assertEqual(reasons.GetComponent(0, 1), vtkStreamTracer.OUT_OF_LENGTH)

    def test_same_bits(self):
        image = make_image(rotation)
        for mode in range(4):
            first, _ = trace(image, SeedingMode=mode)
            again, _ = trace(image, SeedingMode=mode)
            self.assertGreater(first.GetNumberOfLines(), 5)
            self.assertEqual(bits_of(first), bits_of(again))

    def test_offset_moves_seeds(self):
        image = make_image(rotation)
        first, _ = trace(image)
        other, _ = trace(image, SeedOffset=50)
        self.assertNotEqual(bits_of(first), bits_of(other))

    def test_seeding_line(self):
        output, _ = trace(
            make_image(lambda x, y, z: (1, 0, 0)),
            seeds=3,
            SeedingMode=vtkFieldStreamlines.LINE,
            Point1=(0, -0.5, 0.25),
            Point2=(0, 0.5, 0.25),
        )
        self.assertEqual([line[0][1:] for line in lines_of(output)], [(y, 0.25) for y in (-0.5, 0, 0.5)])

    def test_blanked_cells_are_outside(self):
        image = make_image(lambda x, y, z: (1, 0, 0))
        image.AllocateCellGhostArray()
        ghosts = image.GetCellGhostArray()
        for cell in range(image.GetNumberOfCells()):
            if image.GetCell(cell).GetBounds()[0] >= 0:
                ghosts.SetValue(cell, vtkDataSetAttributes.HIDDENCELL)
        output, _ = trace(image)
        self.assertEqual(output.GetNumberOfLines(), 50)
        self.assertLess(output.GetBounds()[1], 1e-3)

    def test_vectors_that_are_not_finite_are_outside(self):
        for bad in (math.nan, math.inf):
            image = make_image(lambda x, y, z: (1, bad if x > 0.5 else 0, 0))
            output, messages = trace(image)
            self.assertEqual(messages, [])
            self.assertEqual(output.GetNumberOfLines(), 50)
            self.assertLess(output.GetBounds()[1], 0.5 + 1e-3)
            for value in output.GetPointData().GetArray("Velocity").GetRange(-1):
                self.assertTrue(math.isfinite(value))
        output, messages = trace(make_image(lambda x, y, z: (math.nan,) * 3))
        self.assertEqual(output.GetNumberOfPoints(), 0)
        self.assertIn("No cell has finite vectors", messages[0][1])

    def test_lines_that_circle_a_point_are_cut(self):
        output, _ = trace(make_image(lambda x, y, z: (-y - 0.3 * x, x - 0.3 * y, 0)))
        curl_radius = math.sqrt(12) / 500
        self.assertGreater(output.GetNumberOfLines(), 40)
        for line in lines_of(output):
            inside = [p for p in line if math.hypot(p[0], p[1]) < 0.5 * curl_radius]
            self.assertLess(len(inside), 20)

    def test_zero_field(self):
        output, messages = trace(make_image(lambda x, y, z: (0, 0, 0)))
        self.assertEqual(output.GetNumberOfPoints(), 0)
        self.assertIn("is zero at all 50 seeds", messages[0][1])

    def test_plane(self):
        output, messages = trace(make_image(rotation, (17, 17, 1)))
        self.assertEqual(messages, [])
        self.assertGreater(output.GetNumberOfLines(), 45)
        self.assertEqual(output.GetBounds()[4:], (0, 0))

    def test_curved_surface(self):
        source = vtkSphereSource()
        source.SetRadius(1)
        source.SetThetaResolution(64)
        source.SetPhiResolution(64)
        source.Update()
        sphere = vtkPolyData()
        sphere.ShallowCopy(source.GetOutput())
        vectors = vtkFloatArray()
        vectors.SetName("Velocity")
        vectors.SetNumberOfComponents(3)
        for point in range(sphere.GetNumberOfPoints()):
            vectors.InsertNextTuple(rotation(*sphere.GetPoint(point)))
        sphere.GetPointData().AddArray(vectors)
        output, _ = trace(sphere)
        self.assertGreater(output.GetNumberOfLines(), 25)
        for line in lines_of(output):
            self.assertGreater(min(math.dist(point, (0, 0, 0)) for point in line), 0.98)

    def test_cell_vectors(self):
        image = make_image(rotation)
        vectors = vtkDoubleArray()
        vectors.SetName("CellVelocity")
        vectors.SetNumberOfComponents(3)
        vectors.SetNumberOfTuples(image.GetNumberOfCells())
        vectors.FillComponent(0, 0)
        vectors.FillComponent(1, 2)
        vectors.FillComponent(2, 0)
        image.GetCellData().AddArray(vectors)
        tracer = vtkFieldStreamlines()
        tracer.SetInputData(image)
        tracer.SetNumberOfSeeds(20)
        tracer.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "CellVelocity")
        tracer.Update()
        output = tracer.GetOutput()
        self.assertEqual(output.GetNumberOfLines(), 20)
        for line in lines_of(output):
            self.assertLess(max(p[0] for p in line) - min(p[0] for p in line), 1e-6)
        self.assertEqual(output.GetPointData().GetArray("CellVelocity").GetRange(1), (2, 2))

    def test_composite(self):
        blocks = vtkMultiBlockDataSet()
        for number, shift in enumerate((0, 2)):
            image = make_image(lambda x, y, z: (1, 0, 0))
            image.SetOrigin(-1 + shift, -1, -1)
            blocks.SetBlock(number, image)
        output, _ = trace(blocks)
        self.assertEqual(output.GetNumberOfLines(), 50)
        self.assertLess(output.GetBounds()[0], -0.85)
        self.assertGreater(output.GetBounds()[1], 2.85)

    def test_no_vectors_names_arrays(self):
        image = make_image(rotation, name="Wind")
        tracer = vtkFieldStreamlines()
        tracer.SetInputData(image)
        tracer.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Velocity")
        texts = []

        def note(_, __, text):
            texts.append(text)

        note.CallDataType = "string0"
        tracer.AddObserver("ErrorEvent", note)
        tracer.GetExecutive().AddObserver("ErrorEvent", note)
        tracer.Update()
        self.assertIn("named 'Velocity'", texts[0])
        self.assertIn("Wind (points, 3)", texts[0])
        self.assertEqual(tracer.GetOutput().GetNumberOfPoints(), 0)

    def test_progress_and_abort(self):
        tracer = vtkFieldStreamlines()
        tracer.SetInputData(make_image(rotation))
        tracer.SetNumberOfSeeds(400)
        progress = []

        def stop(algorithm, _):
            progress.append(algorithm.GetProgress())
            if progress[-1] > 0.5:
                algorithm.SetAbortExecute(True)

        tracer.AddObserver("ProgressEvent", stop)
        tracer.Update()
        self.assertGreater(len(progress), 5)
        self.assertEqual(progress, sorted(progress))
        self.assertLess(max(p for p in progress if p < 1), 0.6)


if __name__ == "__main__":
    unittest.main()
