# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Run by ParaView's client (window.sh): the vortices, with their properties in the panel."""

from paraview import simple

simple.LoadState("Plugin/Examples/vortices.pvsm")
simple.SetActiveView(simple.GetRenderViews()[0])
simple.SetActiveSource(simple.FindSource("Importance1"))
