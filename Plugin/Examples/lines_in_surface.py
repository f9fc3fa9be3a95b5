# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface of equal density in a combustor, which fades only where it hides fast gas inside.

Run with the folder of the plugin in PV_PLUGIN_PATH: pvpython lines_in_surface.py picture.png [state.pvsm]
"""

import sys

from paraview import simple

combustor = simple.LegacyVTKReader(FileNames=["Data/combustor.vtk"])
surface = simple.Contour(Input=combustor, ContourBy=["POINTS", "Density"], Isosurfaces=[0.3])
# The surface itself is nowhere important: its density is the one that means 0.
context = simple.Importance(Input=surface, Criteria=["Density", "0.3", "1", "1", "0", "0"])
seeds = simple.MaskPoints(Input=combustor, OnRatio=67)
lines = simple.StreamTracerWithCustomSource(
    Input=combustor, SeedSource=seeds, Vectors=["POINTS", "Velocity"]
)
lines.MaximumStreamlineLength = 30.0
fast = simple.Importance(Input=lines, Criteria=["Velocity", "300", "900", "1", "0", "0"])

view = simple.CreateView("RenderView", ViewSize=[540, 360], OrientationAxesVisibility=0)
simple.AssignViewToLayout(view)
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.CameraPosition = [4.0, -28.0, 38.0]
view.CameraFocalPoint = [8.6, 0.0, 29.0]
view.CameraViewUp = [0.0, 0.0, 1.0]

shell = simple.Show(context, view)
simple.ColorBy(shell, None)
shell.AmbientColor = shell.DiffuseColor = [0.35, 0.6, 0.85]
shell.Specular = 0.4
display = simple.Show(fast, view)
simple.ColorBy(display, ("POINTS", "Velocity", "Magnitude"))
speed = simple.GetColorTransferFunction("Velocity")
speed.ApplyPreset("Inferno (matplotlib)", True)
speed.RescaleTransferFunction(0.0, 1000.0)
for each in (shell, display):
    each.Representation = "Pellucid"
    each.ImportanceArray = "Importance"
display.TubeRadius = 0.08

if len(sys.argv) > 1:
    simple.SaveScreenshot(sys.argv[1], view, ImageResolution=[540, 360])
if len(sys.argv) > 2:
    simple.SaveState(sys.argv[2])
