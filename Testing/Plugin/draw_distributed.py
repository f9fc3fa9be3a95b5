# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw translucent things that are spread over all processes.

draw_distributed.py PICTURE [--in-parts]: in parts, each process draws its own; else one draws all, and
opacities follow from importance.
"""

import sys

from paraview import servermanager, simple

import plugin

plugin.load_plugin()
view = plugin.create_view()
view.UseFXAA = 0  # it finds edges in colours that differ by rounding
wavelet = simple.Wavelet()
shells = simple.Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[130.0, 200.0])
slices = simple.Slice(Input=wavelet)
slices.SliceType.Normal = [0.0, 0.0, 1.0]
slices.SliceOffsetValues = [-6.0, 0.0, 6.0]
# Not stream lines: ParaView integrates others with more processes.
lines = simple.Calculator(
    Input=simple.Contour(Input=slices, ContourBy=["POINTS", "RTData"], Isosurfaces=[150.0]),
    Function="coordsZ")
for source, opacity in ((shells, 0.3), (lines, 0.6)):
    display = plugin.show(source, view, opacity=opacity)
    display.TubeRadius = 0.4
    if "--in-parts" in sys.argv:
        display.DrawOnOneProcess = 0
        display.UseDataPartitions = 1  # the pieces are cut by their bounds and stay where they are
    elif source is lines:
        display.ImportanceArray = ["POINTS", "Result"]
        display.AutomaticImportanceRange = 0
        display.ImportanceRange = [-6.0, 6.0]
plugin.place_camera(view)
plugin.save(sys.argv[1], view)
print("partitions:", servermanager.ActiveConnection.GetNumberOfDataPartitions())
display.SMProxy.UpdatePropertyInformation()
print("sees all fragments:", display.GetPropertyValue("SeesAllFragments"))
print("fragments:", plugin.fragments(view))  # of this process
