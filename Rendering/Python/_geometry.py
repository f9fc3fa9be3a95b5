# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Poly data from arrays of NumPy, and point and cell arrays of it."""

import itertools
import os

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkBitArray, vtkObjectBase, vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkCompositeDataSet, vtkDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData

from ._arguments import brief, class_name


def line_data(lines):
    """Poly data of what add_lines() takes, and how many points each line has; () if that is not asked."""
    if isinstance(lines, vtkObjectBase):
        return _with_cells("lines", lines, ("Lines",)), ()
    lines = _sequence("lines", lines)
    if len(lines) and numbers_of("lines", lines[0]).ndim == 1:
        lines = [lines]
    parts = [_point_array("lines", line) for line in lines]
    data = vtkPolyData()
    data.SetPoints(_points("lines", numpy.concatenate(parts or [numpy.empty((0, 3))])))
    lengths = [len(part) for part in parts]
    data.SetLines(_cells(lengths))
    return data, lengths


def point_data(points):
    """Poly data of what add_points() takes."""
    if not isinstance(points, vtkObjectBase):
        data = vtkPolyData()
        data.SetPoints(_points("points", _point_array("points", _sequence("points", points))))
        return _with_vertices(data)
    _check_poly_data("points", points)
    if isinstance(points, vtkPolyData):
        return _with_vertices(points)
    data = points.NewInstance()
    data.CopyStructure(points)
    iterator = points.NewIterator()
    while not iterator.IsDoneWithTraversal():
        data.SetDataSet(iterator, _with_vertices(iterator.GetCurrentDataObject()))
        iterator.GoToNextItem()
    return data


def surface_data(mesh):
    """Poly data of what add_surface() takes."""
    return _with_cells("mesh", mesh, ("Polys", "Strips"))


def with_arrays(data, lengths=(), **values):
    """Data that has these values as arrays of names that nothing else has, and all names.

    lengths: of lines, where there may be a list of values for each.
    values: of each argument the name of an array of the data, or values of one, or None.
    """
    arrays = {argument: array for argument, array in (
        (argument, value if argument == "scalars" else _values_of_cells(data, value))
        for argument, value in values.items()) if array is not None and not isinstance(array, str)}
    if not arrays:
        return data, values
    if not isinstance(data, vtkPolyData):
        raise TypeError(f"{', '.join(arrays)}: of {class_name(data)}, expected the name of an array")
    copy = vtkPolyData()
    copy.ShallowCopy(data)
    for argument, value in arrays.items():
        array = _joined(argument, value, lengths)
        field = _field_of(data, argument, array)
        if field == "Cell" and argument != "scalars":
            field, array = "Point", _moved_to_points(data, array)
        values[argument] = _unused_name(argument.title(), copy, values.values())
        getattr(copy, f"Get{field}Data")().AddArray(_vtk_array(array, values[argument]))
    return copy, values


def numbers_of(name, values, expected="numbers"):
    """The array of NumPy that they are, or make; NaN where one is masked."""
    try:
        array = numpy.asarray(values)
    except ValueError:
        raise ValueError(f"{name}: expected {expected}, found rows of unequal lengths") from None
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{name}: expected {expected}, found {brief(values)}")
    if numpy.ma.is_masked(values):
        return numpy.where(numpy.ma.getmaskarray(values), numpy.nan, array)
    return array


def leaves_of(data):
    """The poly data that it holds, or is."""
    return [leaf for leaf in _all_leaves(data) if isinstance(leaf, vtkPolyData)]


def check_scalar_array(data, argument, name):
    """That data, unless it has no points, has a point array of that name and one component."""
    if not isinstance(name, str):
        raise TypeError(f"{argument}: expected the name of a point array, found {brief(name)}; put the "
                        "values into the data as one, or give them to add_lines(), add_points() or "
                        "add_surface()")
    leaves = [leaf for leaf in leaves_of(data) if leaf.GetNumberOfPoints()]
    names = {array.GetName() for leaf in leaves for array in map(
        leaf.GetPointData().GetArray, range(leaf.GetPointData().GetNumberOfArrays()))
             if array and array.GetNumberOfComponents() == 1}
    if leaves and name not in names:
        raise ValueError(f"{argument}: there is no point array {name!r} of one component; "
                         f"there are {listed(names)}")


def scalars_of_points(data, name):
    """The values of that array at all points, NaN where data has no such array of one component."""
    parts = [numpy.empty(0)]
    for leaf in leaves_of(data):
        array = leaf.GetPointData().GetArray(name)
        has_scalars = array and array.GetNumberOfComponents() == 1
        parts.append(_numbers_in(array) if has_scalars else numpy.full(leaf.GetNumberOfPoints(), numpy.nan))
    return numpy.concatenate(parts)


def _numbers_in(array):
    if not isinstance(array, vtkBitArray):
        return vtk_to_numpy(array)
    numbers = vtkUnsignedCharArray()
    numbers.DeepCopy(array)
    return vtk_to_numpy(numbers)


def check_radii(data, name):
    """That data has a point array of that name, and no value of it is negative."""
    check_scalar_array(data, "radius", name)
    arrays = filter(None, (leaf.GetPointData().GetArray(name) for leaf in leaves_of(data)))
    least = min((array.GetFiniteRange()[0] for array in arrays), default=0)
    if least < 0:
        raise ValueError(f"radius: expected numbers of at least 0, found {least:g} among them")


def array_names(data):
    """Those of points and of cells."""
    return {attributes.GetArrayName(i) for leaf in leaves_of(data)
            for attributes in (leaf.GetPointData(), leaf.GetCellData())
            for i in range(attributes.GetNumberOfArrays())}


def listed(names):
    return ", ".join(sorted(filter(None, names))) or "none"


def _all_leaves(data):
    if not isinstance(data, vtkCompositeDataSet):
        return [data]
    leaves = []
    iterator = data.NewIterator()
    while not iterator.IsDoneWithTraversal():
        leaves.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return leaves


def _check_poly_data(name, data):
    for leaf in _all_leaves(data):
        if not isinstance(leaf, vtkPolyData):
            _refuse(name, "vtkPolyData or composite data of it", leaf)


def _with_cells(name, data, kinds):
    """That data; which, unless it has no points, has cells of these kinds."""
    _check_poly_data(name, data)
    leaves = leaves_of(data)
    points = sum(leaf.GetNumberOfPoints() for leaf in leaves)
    if points and not any(getattr(leaf, f"GetNumberOf{kind}")() for leaf in leaves for kind in kinds):
        raise ValueError(f"{name}: expected poly data with {' or '.join(kinds).lower()}, found {points} "
                         "points and none; there are add_lines(), add_points() and add_surface()")
    return data


def _with_vertices(data):
    """That poly data, or its points as vertices where it has none."""
    if data.GetNumberOfVerts():
        return data
    vertices = vtkPolyData()
    vertices.SetPoints(data.GetPoints())
    vertices.GetPointData().ShallowCopy(data.GetPointData())
    vertices.SetVerts(_cells([1] * data.GetNumberOfPoints()))
    return vertices


def _sequence(name, argument):
    is_sequence = _has_length(argument) and hasattr(argument, "__getitem__")
    if not is_sequence or isinstance(argument, (str, bytes, dict)):
        _refuse(name, "vtkPolyData or an array of points", argument)
    if hasattr(argument, "__array__") and not isinstance(argument, numpy.ma.MaskedArray):
        return numpy.asarray(argument)
    return argument


def _has_length(argument):
    """An array of NumPy without dimensions has none."""
    return hasattr(argument, "__len__") and getattr(argument, "ndim", 1) > 0


def _refuse(name, expected, found):
    hint = ""
    if isinstance(found, (str, os.PathLike)):
        hint = "; read the file first, with one of VTK's readers or pyvista.read()"
    elif isinstance(found, vtkDataSet):
        hint = "; vtkGeometryFilter, or extract_surface() of PyVista, makes poly data of it"
    raise TypeError(f"{name}: expected {expected}, found {brief(found)}{hint}")


def _point_array(name, points):
    array = numbers_of(name, points)
    if not array.size:
        return numpy.empty((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: expected points as an array of shape (n, 3), found {array.shape}")
    return array if array.dtype == numpy.float32 else array.astype(float)


def _values_of_cells(data, value):
    """The values of the cell array of that name, where no point array has it; or just what that is."""
    if not isinstance(value, str) or not isinstance(data, vtkPolyData):
        return value
    array = None if data.GetPointData().HasArray(value) else data.GetCellData().GetArray(value)
    return vtk_to_numpy(array) if array else value


def _joined(argument, values, lengths):
    """One array of them; the lists of lines one after the other."""
    if _has_length(values) and len(values) == len(lengths) and all(map(_has_length, values)):
        parts = [numbers_of(argument, part) for part in values]
        if [len(part) for part in parts] == lengths and len({part.shape[1:] for part in parts}) == 1:
            return numpy.concatenate(parts)
    return numbers_of(argument, values, "numbers or the name of an array")


def _field_of(data, argument, array):
    """Whether these are values of points or of cells; only colours may be vectors."""
    points, cells = data.GetNumberOfPoints(), data.GetNumberOfCells()
    if array.ndim == 1 or (array.ndim == 2 and argument == "scalars"):
        if len(array) == points:
            return "Point"
        if len(array) == cells:
            return "Cell"
    raise ValueError(f"{argument}: expected {points} values, one for each point, or {cells}, one for each "
                     f"cell, found an array of shape {array.shape}")


def _moved_to_points(data, array):
    """For each point the mean of the cells around it."""
    cells = vtkPolyData()
    cells.CopyStructure(data)
    cells.GetCellData().AddArray(_vtk_array(array.astype(float), "values"))
    move = vtkCellDataToPointData()
    move.SetInputData(cells)
    move.Update()
    return vtk_to_numpy(move.GetOutput().GetPointData().GetArray("values"))


def _unused_name(wanted, data, others):
    used = array_names(data).union(other for other in others if isinstance(other, str))
    names = itertools.chain([wanted], (f"{wanted} {i}" for i in itertools.count(2)))
    return next(name for name in names if name not in used)


def _vtk_array(array, name):
    copy = numpy_to_vtk(_of_type_of_vtk(array), deep=True)
    copy.SetName(name)
    return copy


def _of_type_of_vtk(array):
    """VTK has no bool, half and long double, and reads bytes in the order of the machine."""
    kind, size = array.dtype.kind, array.dtype.itemsize
    if kind == "b":
        return array.astype(numpy.uint8)
    if kind == "f" and size not in (4, 8):
        return array.astype(float)
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def _points(name, array):
    wrong = numpy.count_nonzero(~numpy.isfinite(array).all(axis=1))
    if wrong:
        raise ValueError(f"{name}: expected finite coordinates, found others in {wrong} of {len(array)} "
                         "points; leave these out, or split the line there")
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
