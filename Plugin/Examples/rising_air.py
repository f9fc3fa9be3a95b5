# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Paths of air over the Pacific: those that rise by far show through all others.

Run with the folder of the plugin in PV_PLUGIN_PATH: pvpython rising_air.py picture.png [state.pvsm]
"""

import sys

from paraview import simple

paths = simple.OpenDataFile("Data/pacific-streams.nc", VerticalScale=25.0)
attributes = simple.TrajectoryAttributes(Input=paths)
# What rises by 200 hPa is not important, what rises by 550 hPa is.
importance = simple.Importance(
    Input=attributes, Criteria=["TotalPressureDifference", "200", "550", "1", "0", "0"]
)

view = simple.CreateView("RenderView", ViewSize=[630, 220], OrientationAxesVisibility=0)
simple.AssignViewToLayout(view)
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.CameraPosition = [197.0, -90.0, 70.0]
view.CameraFocalPoint = [197.0, 36.0, 12.0]
view.CameraViewUp = [0.0, 0.0, 1.0]
view.CameraParallelProjection = 1
view.CameraParallelScale = 25.0

display = simple.Show(importance, view)
simple.ColorBy(display, ("POINTS", "pressure"))
pressure = simple.GetColorTransferFunction("pressure")
pressure.ApplyPreset("Cool to Warm", True)
pressure.RescaleTransferFunction(400.0, 1000.0)
display.Representation = "Pellucid"
display.TubeRadius = 0.25
display.ImportanceArray = "Importance"
display.OpacityPreset = "Clear Back"

if len(sys.argv) > 1:
    simple.SaveScreenshot(sys.argv[1], view, ImageResolution=[630, 220])
if len(sys.argv) > 2:
    simple.SaveState(sys.argv[2])
