# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Draw the scene of plugin.py, or what a state file or a script draws, in a process of its own."""

import argparse
import json
import pathlib

from paraview import simple

import plugin

parser = argparse.ArgumentParser()
parser.add_argument("folder", type=pathlib.Path, help="gets opaque.png and transparent.png")
parser.add_argument("--port", type=int, help="of a server")
parser.add_argument("--threshold", type=float, default=1e9, help="MiB from which on the server draws")
parser.add_argument("--loaded", action="store_true", help="whether the plugin is loaded already")
parser.add_argument("--state", help="state file of ParaView, or a Python script")
arguments = parser.parse_args()

if arguments.port:
    simple.Connect("127.0.0.1", arguments.port, timeout=20)
if not arguments.loaded:
    plugin.load_plugin()

if not arguments.state:
    view = plugin.create_view()
    view.RemoteRenderThreshold = arguments.threshold
    plugin.draw_scene(view)
elif arguments.state.endswith(".pvsm"):
    simple.LoadState(arguments.state)
else:
    exec(pathlib.Path(arguments.state).read_text())
view = simple.GetActiveView()
view.StillRender()  # simple.Render() would reset the camera of a state file
print("statistics:", json.dumps(plugin.statistics(view)))
size = list(view.ViewSize)
arguments.folder.mkdir(parents=True, exist_ok=True)
for name, transparent in (("opaque", 0), ("transparent", 1)):
    plugin.save(
        arguments.folder / f"{name}.png", view, ImageResolution=size, TransparentBackground=transparent
    )
print("fragments:", plugin.fragments(view))
