# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Streamlines of a combustor as translucent tubes: streamlines.py picture.png"""

import pathlib
import sys

import numpy
import pyvista

import pellucid

DATA = pathlib.Path(__file__).parents[3] / "Data"

combustor = pyvista.read(DATA / "combustor.vtk")
seeds = pyvista.PolyData(numpy.array(combustor.points[::12]))
lines = combustor.streamlines_from_source(seeds, "Velocity")

plotter = pyvista.Plotter(off_screen=True, window_size=(360, 270))
pellucid.add_lines(
    plotter, lines, radius=0.06, scalars="Velocity", cmap="plasma", clim=(0, 1300), opacity=0.4,
    show_scalar_bar=False)
plotter.camera_position = [(5, -24, 37), (8.2, 0, 29.6), (0, 0, 1)]
plotter.screenshot(sys.argv[1])
