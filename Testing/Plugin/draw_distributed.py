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
displays = [plugin.show(source, view, opacity=1.0) for source in (shells, lines)]
if "--in-parts" not in sys.argv:
    stock = simple.Slice(Input=wavelet)
    stock.SliceType.Normal = [1.0, 0.0, 0.3]
    displays.append(plugin.show(stock, view, "Surface", opacity=1.0))
    displays[-1].ColorArrayName = ["POINTS", ""]  # ParaView finds other ranges of colours in parts
for display in displays:
    display.UseDataPartitions = 1  # the pieces are cut by their bounds and stay where they are
plugin.place_camera(view)
# Each process draws what is opaque; what becomes translucent has to move to one, and back.
for opacity, one in ((1.0, 1), (0.5, 1), (0.5, 0), (0.5, 1), (1.0, 1)):
    for display in displays:
        display.Opacity = opacity
        display.DrawOnOneProcess = one
    simple.Render(view)
for display, opacity in zip(displays, (0.3, 0.6)):
    display.Opacity = opacity
    display.TubeRadius = 0.4
    if "--in-parts" in sys.argv:
        display.DrawOnOneProcess = 0
if "--in-parts" not in sys.argv:
    displays[1].ImportanceArray = ["POINTS", "Result"]
    displays[1].AutomaticImportanceRange = 0
    displays[1].ImportanceRange = [-6.0, 6.0]
plugin.save(sys.argv[1], view)
print("partitions:", servermanager.ActiveConnection.GetNumberOfDataPartitions())
display.SMProxy.UpdatePropertyInformation()
print("sees all fragments:", display.GetPropertyValue("SeesAllFragments"))
print("fragments:", plugin.fragments(view))  # of this process
