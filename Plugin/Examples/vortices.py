# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Streamlines of a combustor: the vortices show through what flows straight on.

Run with the folder of the plugin in PV_PLUGIN_PATH: pvpython vortices.py picture.png [state.pvsm]
"""

import sys

from paraview import simple

combustor = simple.LegacyVTKReader(FileNames=["Data/combustor.vtk"])
gradient = simple.Gradient(Input=combustor, ScalarArray=["POINTS", "Velocity"])
gradient.ComputeVorticity = 1
gradient.ComputeGradient = 0
seeds = simple.MaskPoints(Input=combustor, OnRatio=10)
lines = simple.StreamTracerWithCustomSource(
    Input=gradient, SeedSource=seeds, Vectors=["POINTS", "Velocity"]
)
lines.MaximumStreamlineLength = 30.0
# A vorticity of 300 is not important, one of 1200 is.
importance = simple.Importance(Input=lines, Criteria=["Vorticity", "300", "1200", "1", "0", "0"])

view = simple.CreateView("RenderView", ViewSize=[540, 360], OrientationAxesVisibility=0)
simple.AssignViewToLayout(view)
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.CameraPosition = [4.8, -27.0, 38.0]
view.CameraFocalPoint = [8.6, 0.0, 29.6]
view.CameraViewUp = [0.0, 0.0, 1.0]

display = simple.Show(importance, view)
simple.ColorBy(display, ("POINTS", "Vorticity", "Magnitude"))
vorticity = simple.GetColorTransferFunction("Vorticity")
vorticity.ApplyPreset("Cool to Warm (Extended)", True)
vorticity.RescaleTransferFunction(0.0, 1200.0)
display.Representation = "Pellucid"
display.TubeRadius = 0.05
display.ImportanceArray = "Importance"

if len(sys.argv) > 1:
    simple.SaveScreenshot(sys.argv[1], view, ImageResolution=[540, 360])
if len(sys.argv) > 2:
    simple.SaveState(sys.argv[2])
