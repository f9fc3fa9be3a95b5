#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make Pictures/viewer.png, the window of pellucid-view: make_viewer.py PROGRAM"""

import pathlib
import sys
import time

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

DATA = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(DATA.parent / "Testing" / "Python"))
import desktop  # noqa: E402

VIEW = """--size 560x700 --seeds 250 --radius 0.06 --preset balanced --importance Velocity:50%:99% --view-up 0,0,1
  --camera-position 5,-24,37 --focal-point 8.8,0,29.6 --color-by Velocity --parallel-scale 10.5""".split()


def write(pixels, path):
    height, width, _ = pixels.shape
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    colors = numpy.ascontiguousarray(pixels[::-1].reshape(-1, 3), numpy.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetCompressionLevel(9)
    writer.SetFileName(str(path))
    writer.Write()


desk = desktop.Desktop()
program = desktop.Program(desk, DATA, pathlib.Path(sys.argv[1]).resolve(), "combustor.vtk", *VIEW)
try:
    time.sleep(10)  # what the first frame shows, and the second one of its times
    write(desk.look_at(program.window), DATA / "Pictures" / "viewer.png")
finally:
    program.kill()
    desk.close()
