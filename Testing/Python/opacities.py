# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of pellucid-render's opacities share."""

import numpy
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter

from render_program import RenderTest, make_polylines, write

# The lines of render_program.make_lines(): the first has importance 0 and is in front.
CROSSING = (45, 60)  # row and column
BEHIND = ("--camera-position", "0,0,-4", "--focal-point", "0,0,0", "--view-up", "0,1,0")
FLAT = ("--radius", "0.1", "--lighting", "off", "--color-by", "Height")
HEIGHT = ("--importance", "Height:0:1")
# The lines of make_lines(): the first has importance 0 and is in front, the second 1.


class OpacityTest(RenderTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.mixed = cls.folder / "mixed.vtk"
        write(vtkPolyDataWriter(), cls.make_mixture(), cls.mixed, FileType=2)

    @staticmethod
    def make_mixture():
        """In one data set crossing lines, two points in front of them and squares behind; x tells
        what is important."""
        points = [(-1, 0, 0.2), (1, 0, 0.2), (0, -1, -0.2), (0, 1, -0.2), (-0.5, 0, 0.5), (0.5, 0, 0.5)]
        squares = vtkCellArray()
        for x in numpy.linspace(-0.8, 0.6, 8):
            squares.InsertNextCell(4)
            for corner in ((x, -0.5), (x + 0.2, -0.5), (x + 0.2, 0.5), (x, 0.5)):
                squares.InsertCellPoint(len(points))
                points.append((*corner, -0.5))
        data = make_polylines([points], (("x", [point[0] for point in points]),))
        data.SetLines(make_polylines((points[0:2], points[2:4])).GetLines())
        vertices = vtkCellArray()
        for point in (4, 5):
            vertices.InsertNextCell(1)
            vertices.InsertCellPoint(point)
        data.SetVerts(vertices)
        data.SetPolys(squares)
        return data

    def assert_reference(self, *arguments):
        """The picture is that of the reference renderer but for outlines; returns it."""
        picture, statistics = self.render(*arguments)
        reference, _ = self.render(*arguments, "--reference", environment={"DISPLAY": ""})
        difference = abs(picture - reference).max(axis=2)
        self.assertLess((difference > 1).mean(), 0.002, arguments)
        return picture, statistics

    def assert_same(self, first, second, tolerance=0):
        difference = abs(self.draw_lines(*first) - self.draw_lines(*second)).max()
        self.assertLessEqual(difference, tolerance)

    def opacity_at_crossing(self, arguments, view=()):
        """That of the line in front, as the colours at the crossing tell."""
        opaque = self.draw_lines(*FLAT, "--opacity", "1", *view)
        # Away from the crossing, on the same lines.
        horizontal, vertical = opaque[45, 20], opaque[10, 60]
        front, back = (vertical, horizontal) if view else (horizontal, vertical)
        found = self.draw_lines(*arguments, *view)[CROSSING]
        return numpy.dot(found - back, front - back) / numpy.dot(front - back, front - back)
