# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Air over the Pacific: what rises fast stays, what hides it fades: weather.py picture.png"""

import pathlib
import sys

import pyvista

import pellucid

DATA = pathlib.Path(__file__).parents[3] / "Data"

reader = pellucid.vtkMet3DReader()
reader.SetFileName(str(DATA / "pacific-streams.nc"))
reader.SetVerticalScale(25)
attributes = pellucid.vtkTrajectoryAttributes()
attributes.SetInputConnection(reader.GetOutputPort())
importance = pellucid.vtkImportance()  # 0 for lines that rise by 200 hPa, 1 from 550 hPa on
importance.SetInputConnection(attributes.GetOutputPort())
importance.AddCriterion("TotalPressureDifference", 200, 550)
importance.Update()
air = pyvista.wrap(importance.GetOutput())

plotter = pyvista.Plotter(off_screen=True, window_size=(480, 180))
pellucid.add_lines(
    plotter, air, radius=0.25, scalars="pressure", clim=(400, 1000), cmap="coolwarm",
    show_scalar_bar=False, importance="Importance", preset="clear-back")
plotter.camera_position = [(197, -90, 70), (197, 36, 12), (0, 0, 1)]
plotter.camera.view_angle = 19
plotter.screenshot(sys.argv[1])
