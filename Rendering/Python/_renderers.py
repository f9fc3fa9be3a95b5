# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make renderers exact."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from ._arguments import checked, class_name, size_of_picture
from .vtkPellucidRendering import vtkReferenceRenderer, vtkTransparencyInstaller


def install(view):
    """Make a renderer, or all that a window or plotter has now, exact from the next frame on.

    view: vtkRenderer, vtkRenderWindow or PyVista plotter; ParaView:
        `view.GetClientSideObject().GetRenderer()`.

    Returns the vtkExactTransparencyPass that draws the renderer, for its parameters (`memory_limit`,
    the size of the fragment lists in MiB, at least 1; less counts as 1) and statistics
    (`statistics`); of a plotter that of its active renderer, of a window that of its first. Each
    renderer has a pass of its own, which a second call returns:
    `[pellucid.install(renderer) for renderer in plotter.renderers]`. Raises TypeError for anything
    else, and ValueError for a window without a renderer.

    Notebooks get the exact picture with PyVista's back end "static", and with "server" and "trame"
    while the server renders. What a browser renders itself (vtk.js; "client", "html", and
    `export_html`) is not exact, and lacks what add_lines() and add_points() add.
    """
    renderers = renderers_of(view)
    if not renderers:
        raise ValueError("expected a window with a renderer, found none; add it first")
    passes = [vtkTransparencyInstaller.Install(renderer) for renderer in renderers]
    active = getattr(view, "renderer", None)  # of a plotter
    return passes[renderers.index(active) if active in renderers else 0]


def uninstall(view):
    """Give what install() takes back to VTK; does nothing where it was not installed."""
    for renderer in renderers_of(view):
        vtkTransparencyInstaller.Uninstall(renderer)


def reference_picture(renderer, size=None):
    """The exact picture of a renderer, in double precision and without OpenGL.

    renderer: vtkRenderer. What vtkReferenceRenderer cannot draw, such as volumes, is left out.
    size: width and height in pixels, from 1 to 65536; default: those of the renderer in its window, which has
        rendered.

    Returns an array of float64, height x width x 4: red, green, blue and alpha in [0, 1], the top row
    first. Takes seconds for thousands of lines.
    """
    checked(renderer, vtkRenderer)
    if size is None:
        size = renderer.GetSize()
        if 0 in size:
            raise ValueError("size: the renderer has none before its window has rendered; give "
                             "width and height")
    width, height = size_of_picture("size", size)
    reference = vtkReferenceRenderer()
    reference.SetRenderer(renderer)
    reference.SetSize(width, height)
    reference.Update()
    colors = vtk_to_numpy(reference.GetImage().GetPointData().GetScalars())
    return colors.reshape(height, width, 4)[::-1].copy()


def renderers_of(view):
    """The renderers of what install() takes."""
    if isinstance(view, vtkRenderer):
        return [view]
    if isinstance(view, vtkRenderWindow):
        return list(view.GetRenderers())
    renderers = list(getattr(view, "renderers", ()))  # a plotter, without an import of PyVista
    if not renderers or not all(isinstance(renderer, vtkRenderer) for renderer in renderers):
        raise TypeError("expected a vtkRenderer, a vtkRenderWindow or a PyVista plotter, found "
                        f"{class_name(view)}")
    return renderers
