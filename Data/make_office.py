#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make office.vtk, the velocities of VTK's example on the same grid: make_office.py office.binary.vtk

Needs VTK and numpy.
"""

import pathlib
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkIOLegacy import vtkRectilinearGridWriter, vtkStructuredGridReader


def main(source):
    reader = vtkStructuredGridReader()
    reader.SetFileName(source)
    reader.Update()
    field = reader.GetOutput()
    shape = [0, 0, 0]
    field.GetDimensions(shape)
    grid = vtkRectilinearGrid()
    grid.SetDimensions(shape)
    points = vtk_to_numpy(field.GetPoints().GetData()).reshape(*shape[::-1], 3)
    for i, set_coordinates in enumerate(
            (grid.SetXCoordinates, grid.SetYCoordinates, grid.SetZCoordinates)):
        along = numpy.moveaxis(points[..., i], 2 - i, 0).reshape(shape[i], -1)
        if (along != along[:, :1]).any():
            sys.exit(f"{source}: the grid is not rectilinear")
        set_coordinates(numpy_to_vtk(along[:, 0].copy(), deep=True))
    velocities = field.GetPointData().GetVectors()
    velocities.SetName("Velocity")
    grid.GetPointData().SetVectors(velocities)

    writer = vtkRectilinearGridWriter()
    writer.SetInputData(grid)
    writer.SetFileName(str(pathlib.Path(__file__).with_name("office.vtk")))
    writer.SetHeader("Air flow in an office")
    writer.SetFileTypeToBinary()
    writer.Write()


if __name__ == "__main__":
    main(*sys.argv[1:])
