# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A fornix in the colours of its directions: tractogram.py picture.png"""

import pathlib
import sys

import numpy
import pyvista

import pellucid

DATA = pathlib.Path(__file__).parents[3] / "Data"

reader = pellucid.vtkTrackVisReader()
reader.SetFileName(str(DATA / "fornix.trk"))
reader.Update()
fornix = pyvista.wrap(reader.GetOutput())

# Red for left and right, green for front and back, blue for up and down.
directions = numpy.gradient(fornix.points, axis=0)
lengths = numpy.linalg.norm(directions, axis=1, keepdims=True)
fornix["Directions"] = (255 * numpy.abs(directions / lengths)).astype(numpy.uint8)

plotter = pyvista.Plotter(off_screen=True, window_size=(360, 270))
plotter.background_color = "black"
pellucid.add_lines(plotter, fornix, radius=0.4, scalars="Directions", rgb=True, opacity=0.4)
plotter.camera_position = "yz"
plotter.camera.zoom(1.7)
plotter.screenshot(sys.argv[1])
