# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Add lines and points to a renderer or a PyVista plotter."""

import numbers

from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

from ._appearance import PLOTTER_ARGUMENTS, RENDERER_ARGUMENTS, set_appearance
from ._arguments import check_names, class_name
from ._geometry import check_scalar_array, line_data, point_data, with_point_array
from ._opacities import OPTIMIZATION_PARAMETERS, optimize
from ._renderers import install
from .vtkPellucidRendering import vtkTrajectoryMapper


def add_lines(view, lines, *, radius=0.0, importance=None, importance_range=(0.0, 1.0),
              preset="clear-front", **arguments):
    """Add lines as tubes, and make what shows them exact as install() does.

    view: PyVista plotter, of which the active renderer takes the lines, or vtkRenderer.
    lines: vtkPolyData with lines, or composite data of it; or an array of points, n x 3, for one
        line; or several of these, as a list or as an array m x n x 3.
    radius: of the tubes, in the units of the points, at least 0; 0 finds one that suits the data. Or
        a radius for each point: n values, or the name of a point array.
    importance: n values, one for each point, or the name of a point array of one component. The
        lines then fade as optimize() makes them. Default: they keep their opacity.
    importance_range: the values that mean importance 0 and 1.
    preset: one of presets().
    arguments: over the preset, occlusion_weight, clutter_weight, emphasis, smoothing_iterations and
        self_occlusion of optimize(); the others are those of PyVista's `add_mesh`:

        color: name, "#rrggbb", or red, green and blue in [0, 1]
        scalars: name of a point or cell array to colour by, or n values; default: the active one
        clim: the two scalars at the ends of the colours; default: their range
        cmap: name of a colour map (plotter), vtkScalarsToColors, or colours in [0, 1], n x 3 or n x 4
        opacity: number in [0, 1]; for a plotter all that PyVista takes
        nan_color, lighting, ambient, diffuse, specular, specular_power, pickable

        and for a plotter also above_color, annotations, below_color, categories, component,
        flip_scalars, interpolate_before_map, label, log_scale, n_colors, name, nan_opacity,
        preference, render, reset_camera, rgb, scalar_bar_args, show_scalar_bar and user_matrix.

    Returns the actor, whose mapper is a vtkTrajectoryMapper. Raises TypeError for arguments that are
    unknown or of the wrong kind and ValueError for wrong values; the view is then as it was.
    """
    return _add(view, line_data(lines), radius, importance, importance_range, preset, arguments)


def add_points(view, points, *, radius=0.0, importance=None, importance_range=(0.0, 1.0),
               preset="points", **arguments):
    """Add points as balls, and make what shows them exact as install() does.

    points: array n x 3, or vtkPolyData: its vertices, or all points if it has none.

    All else is that of add_lines().
    """
    return _add(view, point_data(points), radius, importance, importance_range, preset, arguments)


def _add(view, data, radius, importance, importance_range, preset, arguments):
    is_plotter = hasattr(view, "add_mesh")
    if not is_plotter and not isinstance(view, vtkRenderer):
        raise TypeError(f"expected a PyVista plotter or a vtkRenderer, found {class_name(view)}")
    parameters = {name: arguments.pop(name)
                  for name in OPTIMIZATION_PARAMETERS if name in arguments}
    check_names(arguments, PLOTTER_ARGUMENTS if is_plotter else RENDERER_ARGUMENTS)
    if parameters and importance is None:
        raise ValueError(f"{', '.join(parameters)}: only with importance, which is missing")

    mapper = vtkTrajectoryMapper()
    data = _set_radius(mapper, data, radius)
    data, importance = with_point_array(data, "importance", importance)
    data, arguments["scalars"] = with_point_array(data, "scalars", arguments.get("scalars"))
    mapper.SetInputDataObject(data)
    actor = vtkActor()
    actor.SetMapper(mapper)

    def follow_importance(chosen):
        if importance is not None:
            optimize(chosen, preset, importance, importance_range, **parameters)

    # Before the view changes, so that it does not where this raises an exception.
    follow_importance(actor)
    if is_plotter:
        actor = _add_to_plotter(view, data, mapper, arguments)
        follow_importance(actor)
        install(view.renderer)
    else:
        set_appearance(actor, data, **arguments)
        view.AddActor(actor)
        install(view)
    return actor


def _set_radius(mapper, data, radius):
    if isinstance(radius, numbers.Real):
        if not 0 <= radius < float("inf"):
            raise ValueError(f"radius: expected 0 or more, found {radius!r}")
        mapper.SetRadius(radius)
        return data
    data, name = with_point_array(data, "radius", radius)
    check_scalar_array(data, "radius", name)
    mapper.SetRadiusArray(name)
    return data


def _add_to_plotter(plotter, data, mapper, arguments):
    """What PyVista sets on its own mapper goes over to this one, which then takes its place."""
    show_scalar_bar = arguments.pop("show_scalar_bar", None)
    scalar_bar_args = arguments.pop("scalar_bar_args", None) or {}
    render = arguments.pop("render", True)
    actor = plotter.add_mesh(data, show_scalar_bar=False, render=False, **arguments)
    replaced = actor.GetMapper()
    mapper.SetInputConnection(replaced.GetInputConnection(0, 0))
    mapper.ShallowCopy(replaced)
    actor.SetMapper(mapper)
    plotter.mapper = mapper

    if show_scalar_bar is None:
        show_scalar_bar = plotter.theme.show_scalar_bar
    title = replaced.GetArrayName()
    if show_scalar_bar and title and mapper.GetScalarVisibility() and not arguments.get("rgb"):
        plotter.add_scalar_bar(mapper=mapper, render=False, **{"title": title, **scalar_bar_args})
    if render:
        plotter.render()
    return actor
