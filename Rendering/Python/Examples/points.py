# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Points of the air in an office; slow air fades where it hides fast air: points.py picture.png"""

import pathlib
import sys

import numpy
import pyvista

import pellucid

DATA = pathlib.Path(__file__).parents[3] / "Data"

office = pyvista.read(DATA / "office.vtk")
random = numpy.random.default_rng(0)
low, high = numpy.reshape(office.bounds, (3, 2)).T
cloud = pyvista.PolyData(random.uniform(low, high, (20000, 3))).sample(office)
speed = numpy.linalg.norm(cloud["Velocity"], axis=1)

plotter = pyvista.Plotter(off_screen=True, window_size=(360, 270))
pellucid.add_points(
    plotter, cloud.points, radius=0.06, scalars=speed, clim=(0, 0.3), cmap="plasma",
    show_scalar_bar=False, importance=speed, importance_range=(0.1, 0.25))
plotter.camera_position = [(5, -14, 7), (2.25, 2.25, 1.25), (0, 0, 1)]
plotter.camera.zoom(1.9)
plotter.screenshot(sys.argv[1])
