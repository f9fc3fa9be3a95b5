# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the Python tests share."""

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter


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
