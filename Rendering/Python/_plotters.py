# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Add to plotters of PyVista; imported only for who has one."""

import numbers

import pyvista
from matplotlib.colors import ListedColormap
from vtkmodules.vtkCommonCore import vtkScalarsToColors
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet

from ._appearance import colors_of, find_scalars, finite_range
from ._arguments import brief
from ._geometry import leaves_of

# Of vtkMapper; the Python wrappers of VTK 9.2 do not name them.
VTK_COLOR_MODE_DEFAULT, VTK_COLOR_MODE_DIRECT_SCALARS = 0, 2
# PyVista's add_mesh takes these for composite data, and ignores them.
FOR_SINGLE_DATA = ("annotations", "categories", "component", "user_matrix")


def add_to_plotter(plotter, data, mapper, bar_title, follow_importance, arguments):
    """What PyVista sets on its own mapper goes over to this one, which then takes its place.

    bar_title: of the scalar bar, unless scalar_bar_args has one; None: the name of the active scalars.
    follow_importance: called with the actor.
    """
    scalar_bar_args = arguments.pop("scalar_bar_args", {})
    show_scalar_bar = arguments.pop("show_scalar_bar", plotter.theme.show_scalar_bar or bool(scalar_bar_args))
    _check_scalar_bar(scalar_bar_args)
    if isinstance(data, vtkCompositeDataSet):
        _check_composite(arguments)
    mapped = _mapped_scalars(data, arguments)
    bar = {"title": mapped if bar_title is None else bar_title, **scalar_bar_args}
    has_bar = show_scalar_bar and mapped is not None
    if has_bar:
        _check_room_for(plotter, bar)

    actor = _add_mesh(plotter, data, _with_color_map(arguments))
    replaced = actor.GetMapper()
    mapper.SetInputConnection(replaced.GetInputConnection(0, 0))
    mapper.ShallowCopy(replaced)
    actor.SetMapper(mapper)
    try:
        if mapped is not None:
            _set_what_bars_show(mapper, data, mapped, arguments)
        follow_importance(actor)
        if has_bar and mapper.GetScalarVisibility():
            plotter.add_scalar_bar(mapper=mapper, render=False, **bar)
    except Exception:
        plotter.remove_actor(actor, reset_camera=False, render=False)
        raise
    plotter.mapper = mapper
    return actor


def _add_mesh(plotter, data, arguments):
    """Where PyVista refuses an argument only once the actor is there, without that actor."""
    names = set(plotter.actors)
    try:
        return plotter.add_mesh(data, show_scalar_bar=False, render=False, **arguments)
    except Exception:
        for name in set(plotter.actors) - names:
            plotter.remove_actor(name, reset_camera=False, render=False)
        raise


def _check_composite(arguments):
    ignored = [name for name in FOR_SINGLE_DATA if name in arguments]
    if ignored:
        raise TypeError(f"{', '.join(ignored)}: PyVista has this for single data sets alone; add the blocks one by one")
    if not isinstance(arguments.get("opacity", 1.0), numbers.Real):
        raise TypeError("opacity: expected a number for composite data, found "
                        f"{brief(arguments['opacity'])}; add the blocks one by one")


def _mapped_scalars(data, arguments):
    """The name of the scalars that PyVista maps to colours, or None."""
    name = arguments["scalars"]
    if name is None:
        if {"color", "texture"}.intersection(arguments):
            return None
        name = _active_scalars_name(data, arguments.get("preference"))
    is_rgb = arguments.get("rgb", (name or "").endswith(("_rgb", "_rgba")))
    return None if is_rgb else name


def _active_scalars_name(data, preference):
    if not isinstance(data, vtkCompositeDataSet):
        return pyvista.wrap(data).active_scalars_name
    # PyVista maps those that are active in all blocks.
    of_points, of_cells = (_common_scalars_name(data, fields) for fields in ("Point", "Cell"))
    return of_cells if of_points is None or (preference == "cell" and of_cells is not None) else of_points


def _common_scalars_name(data, fields):
    arrays = [getattr(leaf, f"Get{fields}Data")().GetScalars() for leaf in leaves_of(data)]
    names = {array.GetName() if array else None for array in arrays}
    return names.pop() if len(names) == 1 else None


def _set_what_bars_show(mapper, data, scalars, arguments):
    """Where PyVista leaves a mapper with colours, or with a range, that its scalar bar would not have."""
    if mapper.GetColorMode() == VTK_COLOR_MODE_DEFAULT:  # of composite data: bytes would be greys
        mapper.SetColorModeToMapScalars()
    elif (mapper.GetColorMode() == VTK_COLOR_MODE_DIRECT_SCALARS  # an opacity for each point or cell
          and not isinstance(arguments.get("cmap"), pyvista.LookupTable)):
        table = mapper.GetLookupTable()
        arrays = find_scalars(data, scalars, arguments.get("preference"))[1]
        mapper.SetScalarRange(arguments.get("clim") or finite_range(arrays, arguments.get("component", -1)))
        table.SetRange(mapper.GetScalarRange())
        # Neither was heeded when the colours of the points or cells were made.
        table.SetScaleToLinear()
        if arguments.get("flip_scalars"):
            table.values[:] = table.values[::-1]


def _with_color_map(arguments):
    """The arguments with a cmap that PyVista takes."""
    cmap = arguments.get("cmap")
    if isinstance(cmap, vtkScalarsToColors) and not isinstance(cmap, pyvista.LookupTable):
        raise TypeError("cmap: expected the name of a color map, colors or a pyvista.LookupTable for a "
                        f"PyVista plotter, found {brief(cmap)}")
    is_array = hasattr(cmap, "__array__") or (
        isinstance(cmap, (list, tuple)) and not all(isinstance(color, str) for color in cmap))
    if not is_array:
        return arguments
    colors = colors_of(cmap)
    return {"n_colors": len(colors), **arguments, "cmap": ListedColormap(colors)}


def _check_room_for(plotter, bar):
    """PyVista finds that there is none only once the mesh has taken the place of another."""
    has_place = bar["title"] in plotter.scalar_bars.keys() or (
        bar.get("position_x") is not None and bar.get("position_y") is not None)
    if not has_place and not getattr(plotter.renderer, "_scalar_bar_slots", True):
        raise ValueError(f"show_scalar_bar: expected room for another, found {len(plotter.scalar_bars)} "
                         "scalar bars; remove one, give scalar_bar_args a position_x and position_y, or "
                         "pass show_scalar_bar=False")


def _check_scalar_bar(arguments):
    """In a plotter that is never shown: PyVista tells what is wrong only once the mesh is there."""
    if not isinstance(arguments, dict):
        raise TypeError(f"scalar_bar_args: expected a dict, found {brief(arguments)}")
    if not arguments:
        return
    rehearsal = pyvista.Plotter(off_screen=True)
    try:
        rehearsal.add_scalar_bar(mapper=pyvista.DataSetMapper(), render=False, **{"title": "", **arguments})
    except Exception as error:
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"scalar_bar_args: expected what PyVista's add_scalar_bar() takes, found "
                   f"{brief(arguments)}: {error}") from error
    finally:
        rehearsal.close()
