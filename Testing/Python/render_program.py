# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Running pellucid-render in tests.

The program is the one that the environment variable PELLUCID_RENDER names; the samples are those of
the source tree.
"""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter

PROGRAM = os.environ["PELLUCID_RENDER"]
DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"
BACKGROUND = (0, 0, 0)
PROGRESS = r"^(Tracing streamlines|Reading .*|Drawing|--\w+|\w+): \d+ %$"
NEAR = ("--camera-position", "0,0,4", "--focal-point", "0,0,0", "--view-up", "0,1,0")


def write(writer, data, path, **properties):
    writer.SetInputData(data)
    writer.SetFileName(str(path))
    for name, value in properties.items():
        getattr(writer, "Set" + name)(value)
    writer.Write()


def read_picture(path):
    """Rows from the top, columns, components."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(height, width, -1)[::-1].astype(int)


def make_polylines(lines, point_arrays=(), line_arrays=(), units=()):
    """Poly data of lists of points, and (name, values) of arrays; {name: unit}."""
    data = vtkPolyData()
    points = vtkPoints()
    cells = vtkCellArray()
    for line in lines:
        cells.InsertNextCell(len(line))
        for point in line:
            cells.InsertCellPoint(points.InsertNextPoint(point))
    data.SetPoints(points)
    data.SetLines(cells)
    for attributes, arrays in (
        (data.GetPointData(), point_arrays), (data.GetCellData(), line_arrays)
    ):
        for name, values in arrays:
            array = numpy_to_vtk(numpy.asarray(values, numpy.float32), deep=True)
            array.SetName(name)
            if name in units:
                array.GetInformation().Set(vtkDataArray.UNITS_LABEL(), units[name])
            attributes.AddArray(array)
    return data


def make_lines():
    """A horizontal and, behind it, a vertical line in the plane of the picture."""
    return make_polylines(
        (((-1, 0, 0.2), (1, 0, 0.2)), ((0, -1, -0.2), (0, 1, -0.2))),
        (("Height", (0, 0, 1, 1)), ("Constant", (1, 1, 1, 1))),
        (("Line", (0, 1)),))


class RenderTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.lines = cls.folder / "lines.vtk"
        write(vtkPolyDataWriter(), make_lines(), cls.lines, FileType=2)
        source = vtkSphereSource()
        source.SetRadius(0.6)
        source.Update()
        cls.sphere = source.GetOutput()

    def run_program(self, *arguments, environment=None):
        return subprocess.run(
            [PROGRAM, *map(str, arguments)],
            capture_output=True,
            encoding="utf-8",
            timeout=120,
            env={**os.environ, **(environment or {})},
        )

    def render(self, *arguments, environment=None):
        """The picture and the statistics; the run must be silent but for progress and choices."""
        picture = self.folder / "picture.png"
        statistics = self.folder / "statistics.json"
        picture.unlink(missing_ok=True)
        result = self.run_program(
            *arguments, "-o", picture, "--statistics", statistics, environment=environment)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"\A(Importance: .*\n)?\Z")
        for line in result.stderr.splitlines():
            self.assertRegex(line, PROGRESS)
        return read_picture(picture), json.loads(statistics.read_text())

    def draw_lines(self, *arguments):
        """From the front, where arguments do not say otherwise."""
        view = () if "--camera-position" in arguments else NEAR
        return self.render(self.lines, "--size", "120x90", "--background", "0,0,0", *view,
                           *arguments)[0]

    def refuse(self, code, text, *arguments, environment=None, output=None):
        """One line on the error stream that holds the text, and no picture."""
        picture = pathlib.Path(output or self.folder / "refused.png")
        if not output:
            picture.unlink(missing_ok=True)
        result = self.run_program(*arguments, "-o", picture, environment=environment)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertTrue(result.stderr.startswith("pellucid-render: "), result.stderr)
        self.assertIn(text, result.stderr)
        self.assertFalse(picture.exists())

    def list_arrays(self, *arguments):
        """The lines of --list-arrays, which needs neither a picture nor a display."""
        result = self.run_program(*arguments, "--list-arrays", environment={"DISPLAY": ""})
        self.assertEqual(result.returncode, 0, result.stderr)
        for line in result.stderr.splitlines():
            self.assertRegex(line, PROGRESS)
        return result.stdout.splitlines()

    @staticmethod
    def table(lines):
        """Rows of the first table by the name of the array; a row by the title of the column."""
        titles = lines[1].split()
        end = lines.index("")
        rows = [dict(zip(titles, re.split(r"\s{2,}", line))) for line in lines[2:end]]
        return {row["name"]: row for row in rows}
