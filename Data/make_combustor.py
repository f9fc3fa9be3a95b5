#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make combustor.vtk and combustor-lines.vtk: make_combustor.py combxyz.bin combq.bin

The arguments are the PLOT3D files of VTK's examples. Needs the built package `pellucid`.
"""

import pathlib
import sys

from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersExtraction import vtkExtractGrid
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkStructuredGridWriter
from vtkmodules.vtkIOParallel import vtkMultiBlockPLOT3DReader

from pellucid import vtkFieldStreamlines

HERE = pathlib.Path(__file__).parent
VELOCITY = 200  # of the reader's functions


def keep(data, names):
    for name in [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]:
        if name not in names:
            data.RemoveArray(name)


def write(writer, data, name, header):
    writer.SetInputData(data)
    writer.SetFileName(str(HERE / name))
    writer.SetHeader(header)
    writer.SetFileTypeToBinary()
    writer.Write()


def main(grid, solution):
    reader = vtkMultiBlockPLOT3DReader()
    reader.SetXYZFileName(grid)
    reader.SetQFileName(solution)
    reader.AutoDetectFormatOn()
    reader.AddFunction(VELOCITY)
    reader.Update()
    field = reader.GetOutput().GetBlock(0)
    field.GetFieldData().Initialize()
    keep(field.GetPointData(), ("Density", "Velocity"))
    field.GetPointData().SetActiveVectors("Velocity")

    every_other = vtkExtractGrid()
    every_other.SetInputData(field)
    every_other.SetSampleRate(2, 2, 2)
    every_other.IncludeBoundaryOn()
    every_other.Update()
    write(vtkStructuredGridWriter(), every_other.GetOutput(), "combustor.vtk",
          "Combustor, every other point")

    tracer = vtkFieldStreamlines()
    tracer.SetInputData(field)
    tracer.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "Velocity")
    tracer.SetNumberOfSeeds(150)
    tracer.Update()
    write(vtkPolyDataWriter(), tracer.GetOutput(), "combustor-lines.vtk",
          "Combustor, 150 streamlines")


if __name__ == "__main__":
    main(*sys.argv[1:])
