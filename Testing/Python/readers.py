# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Read trajectory files, and look at what comes out."""

import math
import pathlib
import unittest

from vtkmodules.test import Testing
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline

GAP = -999.99
NAN = math.nan
PACIFIC = str(pathlib.Path(Testing.VTK_DATA_ROOT, "pacific.nc"))
FILE = str(pathlib.Path(Testing.VTK_TEMP_DIR, "trajectories"))


def read(reader, content=None, time=None, **properties):
    """The output, and the messages without the file's name; content: bytes, else a real file."""
    name = FILE if isinstance(content, bytes) else content or PACIFIC
    if isinstance(content, bytes):
        pathlib.Path(FILE).write_bytes(content)
    reader = reader() if isinstance(reader, type) else reader
    reader.SetFileName(name)
    for key, value in properties.items():
        getattr(reader, "Set" + key)(value)
    messages = []

    def note(_, event, text):
        messages.append((event, text.split(f"{name}: ", 1)[1].strip()))

    note.CallDataType = "string0"
    tags = [reader.AddObserver(event, note) for event in ("ErrorEvent", "WarningEvent")]
    pipeline = reader.GetExecutive()
    tags_of_pipeline = pipeline.AddObserver("ErrorEvent", lambda *_: None)
    if time is None:
        reader.Update()
    else:
        reader.UpdateTimeStep(time)
    for tag in tags:
        reader.RemoveObserver(tag)
    pipeline.RemoveObserver(tags_of_pipeline)
    return reader.GetOutput(), messages


def lines_of(output):
    """The points of every line."""
    lines = []
    for cell in range(output.GetNumberOfCells()):
        ids = output.GetCell(cell).GetPointIds()
        lines.append([output.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())])
    return lines


def xs_of(output):
    return [[x for x, _, _ in line] for line in lines_of(output)]


def values(array):
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def points(output, name):
    return values(output.GetPointData().GetArray(name))


def cells(output, name):
    return values(output.GetCellData().GetArray(name))


def units(output, name):
    return output.GetPointData().GetArray(name).GetInformation().Get(vtkDataArray.UNITS_LABEL())


def log_height(pressure, scale=10):
    return scale * math.log(1000 / pressure)


def steps_of(reader):
    info = reader.GetOutputInformation(0)
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    return [info.Get(key, i) for i in range(info.Length(key))]


class TestCase(unittest.TestCase):
    def assert_close(self, found, expected, delta=1e-4):
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertTrue(
                math.isnan(a) and math.isnan(b) or abs(a - b) <= delta, f"{found} {expected}"
            )

    def assert_error(self, reader, content, *words, **properties):
        output, messages = read(reader, content, **properties)
        self.assertEqual([event for event, _ in messages], ["ErrorEvent"], messages)
        for word in words:
            self.assertIn(word, messages[0][1])
        self.assertEqual(output.GetNumberOfPoints(), 0)
        self.assertEqual(output.GetNumberOfCells(), 0)
        return messages[0][1]
