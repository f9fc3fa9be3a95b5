# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours and materials, named as PyVista names them."""

import numbers
import re

import numpy
from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkScalarsToColors

from ._arguments import finite_pair
from ._geometry import leaves_of

RENDERER_ARGUMENTS = (
    "color", "scalars", "clim", "cmap", "opacity", "nan_color", "lighting", "ambient", "diffuse",
    "specular", "specular_power", "pickable")

PLOTTER_ARGUMENTS = RENDERER_ARGUMENTS + (
    "above_color", "annotations", "below_color", "categories", "component", "flip_scalars",
    "interpolate_before_map", "label", "log_scale", "n_colors", "name", "nan_opacity", "preference",
    "render", "reset_camera", "rgb", "scalar_bar_args", "show_scalar_bar", "user_matrix")


def set_appearance(actor, data, *, color=None, scalars=None, clim=None, cmap=None, opacity=1.0,
                   nan_color=None, lighting=True, pickable=True, **material):
    """Do for an actor without PyVista what its `add_mesh` would; data is the mapper's."""
    appearance = actor.GetProperty()
    for name, value in material.items():
        getattr(appearance, "Set" + name.title().replace("_", ""))(value)
    appearance.SetLighting(lighting)
    appearance.SetOpacity(_checked_opacity(opacity))
    actor.SetPickable(pickable)
    if color is not None:
        appearance.SetColor(_rgb("color", color))
        actor.GetMapper().ScalarVisibilityOff()
    else:
        _color_by(actor.GetMapper(), data, scalars, clim, _color_map(cmap, nan_color))


def _checked_opacity(opacity):
    if not isinstance(opacity, numbers.Real):
        raise TypeError(f"opacity: expected a number from 0 to 1, found {opacity!r}")
    if not 0 <= opacity <= 1:
        raise ValueError(f"opacity: expected a number from 0 to 1, found {opacity!r}")
    return opacity


def _rgb(argument, color):
    if isinstance(color, str):
        if re.fullmatch("#[0-9a-fA-F]{6}", color):
            return [int(color[i:i + 2], 16) / 255 for i in (1, 3, 5)]
        named = vtkNamedColors()
        if not named.ColorExists(color):
            raise ValueError(f"{argument}: there is no color {color!r}; give a name of the CSS colors, "
                             "'#rrggbb', or red, green and blue in [0, 1]")
        return named.GetColor3d(color)
    array = numpy.asarray(color, float)
    if array.shape != (3,) or not ((0 <= array) & (array <= 1)).all():
        raise ValueError(f"{argument}: expected red, green and blue in [0, 1], found {color!r}")
    return array.tolist()


def _color_map(cmap, nan_color):
    """That, or a table of its colours; blue to red by default."""
    if isinstance(cmap, vtkScalarsToColors):
        return cmap
    table = vtkLookupTable()
    if cmap is None:
        table.SetHueRange(2 / 3, 0)
    else:
        if isinstance(cmap, str):
            raise TypeError("cmap: only a PyVista plotter knows names; give a vtkScalarsToColors, or "
                            "colors as an array of shape (n, 3) or (n, 4)")
        colors = numpy.asarray(cmap, float)
        if colors.ndim != 2 or colors.shape[1] not in (3, 4) or not len(colors):
            raise ValueError("cmap: expected colors as an array of shape (n, 3) or (n, 4), found "
                             f"{colors.shape}")
        table.SetNumberOfTableValues(len(colors))
        for i, value in enumerate(colors):
            table.SetTableValue(i, *value)
    if nan_color is not None:
        table.SetNanColor(*_rgb("nan_color", nan_color), 1)
    table.Build()
    return table


def _color_by(mapper, data, scalars, clim, table):
    fields, arrays = _find_scalars(data, scalars)
    if not arrays:
        if scalars is not None:
            raise ValueError(f"scalars: there is no array {scalars!r} of points or cells")
        mapper.ScalarVisibilityOff()
        return
    if scalars is not None:
        mapper.SelectColorArray(scalars)
        getattr(mapper, f"SetScalarModeToUse{fields}FieldData")()
    if arrays[0].GetNumberOfComponents() > 1:
        table.SetVectorModeToMagnitude()
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(_finite_range(arrays) if clim is None else finite_pair("clim", clim))


def _finite_range(arrays):
    """That of the finite values of all of them, or 0 to 1 where there are none."""
    ranges = [array.GetFiniteRange(-1 if array.GetNumberOfComponents() > 1 else 0) for array in arrays]
    low, high = min(low for low, _ in ranges), max(high for _, high in ranges)
    return (low, high) if low <= high else (0, 1)


def _find_scalars(data, name):
    """Whether it is of points or cells, and the arrays of that name, or the active ones."""
    for fields in ("Point", "Cell"):
        attributes = [getattr(leaf, f"Get{fields}Data")() for leaf in leaves_of(data)]
        arrays = [attribute.GetScalars() if name is None else attribute.GetArray(name)
                  for attribute in attributes]
        if any(arrays):
            return fields, [array for array in arrays if array]
    return None, []
