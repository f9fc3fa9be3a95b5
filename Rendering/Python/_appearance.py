# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Colours and materials, named as PyVista names them."""

import numbers
import re

from vtkmodules.vtkCommonColor import vtkNamedColors
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkScalarsToColors

from ._arguments import brief, check_flag, class_name, check_number, check_string, finite_pair
from ._geometry import array_names, leaves_of, listed, numbers_of

RENDERER_ARGUMENTS = (
    "color", "scalars", "clim", "cmap", "opacity", "nan_color", "lighting", "ambient", "diffuse",
    "specular", "specular_power", "pickable")

PLOTTER_ARGUMENTS = RENDERER_ARGUMENTS + (
    "above_color", "annotations", "below_color", "categories", "component", "flip_scalars",
    "interpolate_before_map", "label", "log_scale", "n_colors", "name", "nan_opacity", "preference",
    "render", "reset_camera", "rgb", "scalar_bar_args", "show_scalar_bar", "user_matrix")

SURFACE_ARGUMENTS = PLOTTER_ARGUMENTS + (
    "backface_params", "culling", "edge_color", "edge_opacity", "feature_angle", "line_width",
    "metallic", "pbr", "roughness", "show_edges", "smooth_shading", "split_sharp_edges", "style",
    "texture")


def checked_appearance(data, arguments):
    """What of these is the same for renderers and plotters, checked; PyVista checks the rest."""
    for name in ("label", "name"):
        check_string(name, arguments.get(name, ""))
    for name in ("lighting", "pickable"):
        check_flag(name, arguments.get(name, True))
    for name, most in (("ambient", 1), ("diffuse", 1), ("specular", 1), ("specular_power", 128)):
        check_number(name, arguments.get(name, 0), 0, most)
    scalars = arguments.get("scalars")
    if isinstance(scalars, str) and not find_scalars(data, scalars)[1]:
        raise ValueError(f"scalars: there is no array {scalars!r} of points or cells; there are "
                         f"{listed(array_names(data))}")
    if "clim" not in arguments:
        return arguments
    clim = arguments["clim"]
    low, high = finite_pair("clim", (-clim, clim) if isinstance(clim, numbers.Real) else clim)
    if low > high:
        raise ValueError(f"clim: expected the lower number first, found {brief(clim)}")
    return {**arguments, "clim": (low, high)}


def set_appearance(actor, data, *, color=None, scalars=None, clim=None, cmap=None, opacity=1.0,
                   nan_color=None, lighting=True, pickable=True, **material):
    """Do for an actor without PyVista what its `add_mesh` would; data is the mapper's."""
    appearance = actor.GetProperty()
    for name, value in material.items():
        getattr(appearance, "Set" + name.title().replace("_", ""))(value)
    appearance.SetLighting(bool(lighting))
    check_number("opacity", opacity, 0, 1)
    appearance.SetOpacity(opacity)
    actor.SetPickable(bool(pickable))
    if color is not None:
        appearance.SetColor(_rgb("color", color))
        actor.GetMapper().ScalarVisibilityOff()
    else:
        _color_by(actor.GetMapper(), data, scalars, clim, _color_map(cmap, nan_color))


def _rgb(argument, color):
    if isinstance(color, str):
        if re.fullmatch("#[0-9a-fA-F]{6}", color):
            return [int(color[i:i + 2], 16) / 255 for i in (1, 3, 5)]
        named = vtkNamedColors()
        if not named.ColorExists(color):
            raise ValueError(f"{argument}: there is no color {color!r}; give a name of the CSS colors, "
                             "'#rrggbb', or red, green and blue in [0, 1]")
        return named.GetColor3d(color)
    array = numbers_of(argument, color)
    if array.shape != (3,) or not ((0 <= array) & (array <= 1)).all():
        raise ValueError(f"{argument}: expected red, green and blue in [0, 1], found {brief(color)}")
    return array.tolist()


def _color_map(cmap, nan_color):
    """That, or a table of its colours; blue to red by default."""
    if isinstance(cmap, vtkScalarsToColors):
        if nan_color is not None:
            raise ValueError("nan_color: expected with colors as an array or without cmap, found with a "
                             f"{class_name(cmap)}; set it there")
        return cmap
    table = vtkLookupTable()
    table.SetVectorModeToMagnitude()
    if cmap is None:
        table.SetHueRange(2 / 3, 0)
    else:
        if isinstance(cmap, str):
            raise TypeError("cmap: only a PyVista plotter knows names; give a vtkScalarsToColors, or "
                            "colors as an array of shape (n, 3) or (n, 4)")
        colors = colors_of(cmap)
        table.SetNumberOfTableValues(len(colors))
        for i, value in enumerate(colors):
            table.SetTableValue(i, *value)
    if nan_color is not None:
        table.SetNanColor(*_rgb("nan_color", nan_color), 1)
    table.Build()
    return table


def colors_of(cmap):
    """The array of them that a cmap is."""
    colors = numbers_of("cmap", cmap)
    if (colors.ndim != 2 or colors.shape[1] not in (3, 4) or not len(colors)
            or not ((0 <= colors) & (colors <= 1)).all()):
        raise ValueError("cmap: expected colors in [0, 1] as an array of shape (n, 3) or (n, 4), found "
                         f"{brief(cmap)}")
    return colors


def _color_by(mapper, data, scalars, clim, table):
    fields, arrays = find_scalars(data, scalars)
    if not arrays:
        mapper.ScalarVisibilityOff()
        return
    if scalars is not None:
        mapper.SelectColorArray(scalars)
        getattr(mapper, f"SetScalarModeToUse{fields}FieldData")()
    mapper.SetLookupTable(table)
    component = table.GetVectorComponent() if table.GetVectorMode() == table.COMPONENT else -1
    mapper.SetScalarRange(finite_range(arrays, component) if clim is None else clim)


def finite_range(arrays, component):
    """Of the finite values of all, of magnitudes where the component is -1; without any 0 to 1."""
    ranges = [array.GetFiniteRange(min(component, array.GetNumberOfComponents() - 1)
                                   if array.GetNumberOfComponents() > 1 else 0) for array in arrays]
    low, high = min(low for low, _ in ranges), max(high for _, high in ranges)
    return (low, high) if low <= high else (0, 1)


def find_scalars(data, name, preference="point"):
    """Whether it is of points or cells, and the arrays of that name, or the active ones."""
    for fields in ("Cell", "Point") if preference == "cell" else ("Point", "Cell"):
        attributes = [getattr(leaf, f"Get{fields}Data")() for leaf in leaves_of(data)]
        arrays = [attribute.GetScalars() if name is None else attribute.GetArray(name)
                  for attribute in attributes]
        if any(arrays):
            return fields, [array for array in arrays if array]
    return None, []
