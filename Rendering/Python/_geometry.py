# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Poly data from arrays of NumPy, and point arrays of it."""

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkObjectBase, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCompositeDataSet, vtkPolyData

from ._arguments import class_name


def line_data(lines):
    """Poly data of what add_lines() takes."""
    if isinstance(lines, (vtkPolyData, vtkCompositeDataSet)):
        return lines
    lines = _sequence(lines, "lines")
    if len(lines) and numpy.ndim(lines[0]) == 1:
        lines = [lines]
    parts = [_point_array(line, "lines") for line in lines]
    data = vtkPolyData()
    data.SetPoints(_points(numpy.concatenate(parts or [numpy.empty((0, 3))])))
    data.SetLines(_cells([len(part) for part in parts]))
    return data


def point_data(points):
    """Poly data of what add_points() takes."""
    if isinstance(points, vtkPolyData):
        if points.GetNumberOfVerts():
            return points
        data = vtkPolyData()
        data.SetPoints(points.GetPoints())
        data.GetPointData().ShallowCopy(points.GetPointData())
    else:
        data = vtkPolyData()
        data.SetPoints(_points(_point_array(_sequence(points, "points"), "points")))
    data.SetVerts(_cells([1] * data.GetNumberOfPoints()))
    return data


def with_point_array(data, argument, values):
    """Data that has these values as a point array, and its name; values may be the name, or None."""
    if values is None or isinstance(values, str):
        return data, values
    array = numpy.asarray(values)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{argument}: expected numbers or the name of an array, found {values!r}")
    if not isinstance(data, vtkPolyData):
        raise TypeError(f"{argument}: of {class_name(data)}, expected the name of an array")
    count = data.GetNumberOfPoints()
    if array.shape[:1] != (count,) or array.ndim > 2:
        raise ValueError(f"{argument}: expected {count} values, one for each point, found an array of "
                         f"shape {array.shape}")
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    name = argument.title()
    point_array = numpy_to_vtk(_of_type_of_vtk(array), deep=True)
    point_array.SetName(name)
    copy.GetPointData().AddArray(point_array)
    return copy, name


def leaves_of(data):
    """The poly data that it holds, or is."""
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    leaves = []
    iterator = data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        leaves.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return [leaf for leaf in leaves if isinstance(leaf, vtkPolyData)]


def check_scalar_array(data, argument, name):
    """That data, unless it has no points, has a point array of that name and one component."""
    leaves = [leaf for leaf in leaves_of(data) if leaf.GetNumberOfPoints()]
    names = {array.GetName() for leaf in leaves for array in map(
        leaf.GetPointData().GetArray, range(leaf.GetPointData().GetNumberOfArrays()))
             if array and array.GetNumberOfComponents() == 1}
    if leaves and name not in names:
        raise ValueError(f"{argument}: there is no point array {name!r} of one component; "
                         f"there are {', '.join(sorted(filter(None, names))) or 'none'}")


def _sequence(argument, name):
    if isinstance(argument, vtkObjectBase) or not hasattr(argument, "__len__"):
        raise TypeError(f"{name}: expected vtkPolyData or an array of points, found "
                        f"{class_name(argument)}; vtkGeometryFilter makes poly data of other data")
    return argument


def _point_array(points, name):
    array = numpy.asarray(points)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name}: expected numbers, found {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: expected points as an array of shape (n, 3), found {array.shape}")
    return array if array.dtype == numpy.float32 else array.astype(float)


def _of_type_of_vtk(array):
    """VTK has no bool, half and long double, and reads bytes in the order of the machine."""
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "b":
        return array.astype(numpy.uint8)
    if kind == "f" and size not in (4, 8):
        return array.astype(float)
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def _points(array):
    points = vtkPoints()
    points.SetData(numpy_to_vtk(array, deep=True))
    return points


def _cells(lengths):
    """Cells of so many points each, one after the other."""
    offsets = numpy.concatenate(([0], numpy.cumsum(lengths, dtype=numpy.int64)))
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets.astype(numpy.int64), deep=True),
                  numpy_to_vtkIdTypeArray(numpy.arange(offsets[-1], dtype=numpy.int64), deep=True))
    return cells
