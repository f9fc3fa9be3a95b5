#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The example of an application in C++ draws what the reference renderer draws of the same scene."""

import os
import pathlib
import subprocess
import tempfile
import unittest

from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

import pellucid
from pictures import read_png, reference_picture

LINES = pathlib.Path(__file__).resolve().parents[2] / "Data" / "combustor-lines.vtk"


def make_renderer(importance):
    reader = vtkPolyDataReader()
    reader.SetFileName(str(LINES))
    mapper = pellucid.vtkTrajectoryMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    reader.Update()
    mapper.SetScalarRange(reader.GetOutput().GetScalarRange())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetOpacity(0.4)
    if importance:
        criterion = pellucid.vtkImportance()
        criterion.SetInputConnection(reader.GetOutputPort())
        criterion.AddCriterion(importance, 50, 99, 1, True, True)
        mapper.SetInputConnection(criterion.GetOutputPort())
        actor.GetProperty().SetOpacity(1)
        pellucid.optimize(actor)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.SetBackground(1, 1, 1)
    renderer.ResetCamera()
    return renderer


class TestApplicationPictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.picture = pathlib.Path(folder.name) / "lines.png"

    def run_program(self, *arguments):
        return subprocess.run(
            [os.environ["TRANSLUCENT_LINES"], *map(str, arguments)], capture_output=True, encoding="utf-8",
            timeout=120)

    def compare(self, importance, *arguments):
        result = self.run_program(LINES, "--output", self.picture, *arguments)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
        found = read_png(self.picture)
        height, width, _ = found.shape
        renderer = make_renderer(importance)
        expected = reference_picture(renderer, width, height)
        self.assertGreater((expected < 255).mean(), 0.05)
        error = ((found - expected) ** 2).mean() ** 0.5
        print(f"{error:.3f} of 255")
        self.assertLess(error, 1.0)
        return found

    def test_lines(self):
        self.compare("")

    def test_importance(self):
        even = self.compare("")
        self.assertGreater(abs(self.compare("Velocity", "--importance", "Velocity") - even).mean(), 1.0)

    def refuse(self, text, *arguments):
        result = self.run_program(*arguments)
        self.assertEqual(result.returncode, 1)
        self.assertIn(text, result.stderr)
        self.assertFalse(self.picture.exists())

    def test_refusals(self):
        usage = "Usage: translucent-lines FILE.vtk"
        self.refuse(usage)
        self.refuse(usage, LINES, "--output")
        self.refuse(usage, LINES, "--colour", "red")
        lines = "expected a legacy VTK file of poly data with lines"
        self.refuse(lines, "missing.vtk", "--output", self.picture)
        self.refuse(lines, LINES.with_name("combustor.vtk"), "--output", self.picture)
        unwritable = self.picture.with_name("missing") / "lines.png"
        result = self.run_program(LINES, "--output", unwritable)
        self.assertEqual((result.returncode, result.stderr), (1, f"{unwritable}: cannot be written\n"))
        self.refuse("Volume", LINES, "--importance", "Volume", "--output", self.picture)
