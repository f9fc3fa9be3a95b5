# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of equal density with streamlines inside: surfaces.py picture.png"""

import pathlib
import sys

import numpy
import pyvista

import pellucid

DATA = pathlib.Path(__file__).parents[3] / "Data"

combustor = pyvista.read(DATA / "combustor.vtk")
shells = combustor.contour([0.22, 0.36], scalars="Density")
seeds = pyvista.PolyData(numpy.array(combustor.points[::40]))
lines = combustor.streamlines_from_source(seeds, "Velocity")

plotter = pyvista.Plotter(off_screen=True, window_size=(360, 270))
plotter.add_mesh(shells, scalars="Density", cmap="coolwarm", opacity=0.4,
                 smooth_shading=True, show_scalar_bar=False)
pellucid.add_lines(plotter, lines, radius=0.05, color="gold")
pellucid.install(plotter)  # add_lines has done so already; without lines it takes this
plotter.camera_position = [(4, -24, 37), (8, 0, 29.6), (0, 0, 1)]
plotter.screenshot(sys.argv[1])
