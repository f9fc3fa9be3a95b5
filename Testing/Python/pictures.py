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


def assert_same_picture(expected, found, tolerance=2.0):
    """Two PNG files of the same size whose colours differ by less than `tolerance` of 255 (RMS)."""
    colors = []
    for path in (expected, found):
        reader = vtkPNGReader()
        reader.SetFileName(path)
        reader.Update()
        shape = reader.GetOutput().GetDimensions()
        colors.append((shape, vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())))
    (expected_shape, before), (found_shape, after) = colors
    assert expected_shape == found_shape, f"{found}: {found_shape}, expected {expected_shape}"
    error = ((before.astype(float) - after) ** 2).mean() ** 0.5
    assert error < tolerance, f"{found} differs from {expected} by {error:.2f} of 255"
    print(f"{found}: {error:.2f} of 255")
