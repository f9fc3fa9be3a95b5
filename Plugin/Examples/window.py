# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's client (window.sh): the vortices, with their properties in the panel."""

from paraview import simple

simple.LoadState("Plugin/Examples/vortices.pvsm")
view = simple.GetRenderViews()[0]
view.CameraViewAngle = 38.0  # the view is narrower than that of the state
simple.SetActiveView(view)
simple.SetActiveSource(simple.FindSource("Importance1"))
