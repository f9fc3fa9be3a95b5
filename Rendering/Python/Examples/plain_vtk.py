# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Streamlines in a program of VTK alone, or in pvpython: plain_vtk.py picture.png"""

import pathlib
import sys

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import pellucid

DATA = pathlib.Path(__file__).parents[3] / "Data"

reader = vtkPolyDataReader()
reader.SetFileName(str(DATA / "combustor-lines.vtk"))
reader.Update()

renderer = vtkRenderer()
renderer.SetBackground(1, 1, 1)
pellucid.add_lines(
    renderer, reader.GetOutput(), radius=0.08, scalars="Density", clim=(0.2, 0.4), opacity=0.5)
camera = renderer.GetActiveCamera()
camera.SetPosition(5, -24, 37)
camera.SetFocalPoint(8.2, 0, 29.6)
camera.SetViewUp(0, 0, 1)
renderer.ResetCameraClippingRange()

window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(360, 270)
window.AddRenderer(renderer)
window.Render()

picture = vtkWindowToImageFilter()
picture.SetInput(window)
picture.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[1])
writer.Write()
