# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the Python tests share."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

import pellucid


def picture(window):
    """The colours of a window that has rendered: integers, rows x columns x 3."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    grab.Update()
    width, height, _ = grab.GetOutput().GetDimensions()
    scalars = vtk_to_numpy(grab.GetOutput().GetPointData().GetScalars())
    return scalars.reshape(height, width, 3).astype(int)


def reference_picture(renderer, width, height):
    """The colours that vtkReferenceRenderer finds for the scene, 0 to 255, rows x columns x 3."""
    reference = pellucid.vtkReferenceRenderer()
    reference.SetRenderer(renderer)
    reference.SetSize(width, height)
    reference.Update()
    scalars = vtk_to_numpy(reference.GetImage().GetPointData().GetScalars())
    return 255.0 * scalars.reshape(height, width, 4)[:, :, :3]


def read_png(path):
    """The colours of a file, with its alpha if there is one: integers, rows x columns x components."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    scalars = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return scalars.reshape(height, width, -1).astype(int)


def assert_same_picture(expected, found, tolerance=2.0):
    """Two PNG files of the same size whose colours differ by less than `tolerance` of 255 (RMS)."""
    before, after = read_png(expected), read_png(found)
    assert before.shape == after.shape, f"{found}: {after.shape}, expected {before.shape}"
    error = ((before - after) ** 2).mean() ** 0.5
    assert error < tolerance, f"{found} differs from {expected} by {error:.2f} of 255"
    print(f"{found}: {error:.2f} of 255")
