# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Add lines, points and surfaces to a renderer or a PyVista plotter."""

import numbers

from vtkmodules.vtkRenderingCore import vtkActor, vtkRenderer

from ._appearance import (
    PLOTTER_ARGUMENTS,
    RENDERER_ARGUMENTS,
    SURFACE_ARGUMENTS,
    checked_appearance,
    set_appearance,
)
from ._arguments import check_names, check_number, class_name, number_of
from ._geometry import check_radii, line_data, point_data, surface_data, with_arrays
from ._opacities import OPTIMIZATION_PARAMETERS, attach_optimization, make_optimization, warn_of_even_importance
from ._renderers import install
from .vtkPellucidRendering import vtkTrajectoryMapper

OPACITY_ARGUMENTS = ("importance", "importance_range", "preset") + OPTIMIZATION_PARAMETERS
TUBE_ARGUMENTS = ("radius",) + OPACITY_ARGUMENTS


def add_lines(view, lines, *, radius=0.0, importance=None, importance_range=None, preset=None,
              **arguments):
    """Add lines as tubes, and make what shows them exact as install() does.

    view: PyVista plotter, of which the active renderer takes the lines, or vtkRenderer.
    lines: vtkPolyData with lines, or composite data of it; or an array of points, n x 3, for one
        line; or several of these, as a list or as an array m x n x 3.
    radius: of the tubes, in the units of the points, at least 0; 0 finds one that suits the data. Or
        a radius for each point: values, or the name of an array.
    importance: values, or the name of an array of one component. The lines then fade as optimize()
        makes them. Default: they keep their opacity.
    importance_range: the values that mean importance 0 and 1; default: 0 and 1.
    preset: one of presets(); default: "clear-front".
    arguments: over the preset, occlusion_weight, clutter_weight, emphasis, smoothing_iterations and
        self_occlusion of optimize(); the others are those of PyVista's `add_mesh`:

        color: name, "#rrggbb", or red, green and blue in [0, 1]
        scalars: name of a point or cell array to colour by, or values; default: the active array
        clim: the two scalars at the ends of the colours, or one, which stands for that and its
            negative; default: the range of the finite ones
        cmap: colours in [0, 1], n x 3 or n x 4; or, for a plotter, a name, a list of names of colours or
            pyvista.LookupTable; or, for a renderer, vtkScalarsToColors, which gets the range of clim and
            keeps its mode for vectors and its colour of NaN
        opacity: number in [0, 1]; for a plotter, of data that are not composite, all that PyVista takes
        nan_color, lighting, pickable; ambient, diffuse, specular in [0, 1]; specular_power in [0, 128]

        and for a plotter also above_color, annotations, below_color, categories, component,
        flip_scalars, interpolate_before_map, label, log_scale, n_colors, name, nan_opacity,
        preference, render, reset_camera, rgb, scalar_bar_args, show_scalar_bar and user_matrix. Scalars that
        are mapped to colours have a bar of their range, of composite data and with any opacity too. Composite
        data have no annotations, categories, component and user_matrix.

    Values are one for each point, for lines from arrays also m x n of them or a list for each line; or
    one for each cell, that is for each line (a radius or importance of a point is then the mean of the
    cells around it; of composite data it has to be a point array). They become arrays of a copy of the
    data, under names that nothing else has. Masked values count as NaN: it is drawn in nan_color, is of
    importance 0, and a point with a radius that is not finite is left out, with a warning. None
    means the default everywhere.

    Returns the actor, whose mapper is a vtkTrajectoryMapper. Raises TypeError for arguments that are
    unknown or of the wrong kind and ValueError for wrong values; the view is then as it was.
    """
    data, lengths = line_data(lines)
    return _add(view, data, {
        "radius": radius, "importance": importance, "importance_range": importance_range,
        "preset": preset, **arguments}, TUBE_ARGUMENTS, lengths=lengths)


def add_points(view, points, *, radius=0.0, importance=None, importance_range=None, preset=None,
               **arguments):
    """Add points as balls, and make what shows them exact as install() does.

    points: array n x 3; or vtkPolyData, or composite data of it: the vertices, or of data without all
        points.
    preset: one of presets(); default: "points".

    All else is that of add_lines().
    """
    return _add(view, point_data(points), {
        "radius": radius, "importance": importance, "importance_range": importance_range,
        "preset": preset, **arguments}, TUBE_ARGUMENTS, default_preset="points")


def add_surface(view, mesh, *, importance=None, importance_range=None, preset=None, **arguments):
    """Add a surface that can fade, and make what shows it exact as install() does.

    mesh: vtkPolyData with polygons or strips, or composite data of it. Its lines become tubes.
    arguments: those of add_lines(), and for a plotter also backface_params, culling, edge_color,
        edge_opacity, feature_angle, line_width, metallic, pbr, roughness, show_edges, smooth_shading,
        split_sharp_edges, style and texture.

    All else is that of add_lines(), but for the radius. What need not fade is exact with PyVista's own
    `add_mesh` too.
    """
    return _add(view, surface_data(mesh), {
        "importance": importance, "importance_range": importance_range, "preset": preset, **arguments},
        OPACITY_ARGUMENTS, for_plotters=SURFACE_ARGUMENTS)


def _add(view, data, arguments, own, *, for_plotters=PLOTTER_ARGUMENTS, default_preset="clear-front",
         lengths=()):
    """arguments: of the function, None for its default; own: the names of those PyVista has not."""
    is_plotter = hasattr(view, "add_mesh")
    if not is_plotter and not isinstance(view, vtkRenderer):
        raise TypeError(f"expected a PyVista plotter or a vtkRenderer, found {class_name(view)}")
    check_names(arguments, own + (for_plotters if is_plotter else RENDERER_ARGUMENTS))
    arguments = {name: number_of(value) for name, value in arguments.items() if value is not None}
    opacity = {name: arguments.pop(name) for name in OPACITY_ARGUMENTS if name in arguments}
    if opacity and "importance" not in opacity:
        raise ValueError(f"{', '.join(opacity)}: only with importance, which is missing")

    scalars, radius = arguments.get("scalars"), arguments.pop("radius", 0.0)
    data, names = with_arrays(
        data, lengths, radius=None if isinstance(radius, numbers.Real) else radius,
        importance=opacity.get("importance"), scalars=scalars)
    arguments = checked_appearance(data, {**arguments, "scalars": names["scalars"]})
    mapper = vtkTrajectoryMapper()
    mapper.SetInputDataObject(data)
    _set_radius(mapper, data, names["radius"] or radius)
    actor = vtkActor()
    actor.SetMapper(mapper)

    # Before the view changes, so that it does not where this raises an exception.
    optimization = opacity and make_optimization(actor, **{
        "preset": default_preset, "importance_range": (0.0, 1.0), **opacity, "importance": names["importance"]})
    if optimization:
        warn_of_even_importance(data, optimization)

    def follow_importance(chosen):
        if optimization:
            attach_optimization(chosen, optimization)

    if not is_plotter:
        follow_importance(actor)
        set_appearance(actor, data, **arguments)
        view.AddActor(actor)
        install(view)
        return actor
    from ._plotters import add_to_plotter  # imports PyVista
    bar_title = scalars if scalars is None or isinstance(scalars, str) else ""
    render = arguments.pop("render", True)
    actor = add_to_plotter(view, data, mapper, bar_title, follow_importance, arguments)
    install(view.renderer)
    if render:
        view.render()
    return actor


def _set_radius(mapper, data, radius):
    """radius: of all, or the name of an array."""
    if isinstance(radius, str):
        check_radii(data, radius)
        mapper.SetRadiusArray(radius)
    else:
        check_number("radius", radius, 0)
        mapper.SetRadius(radius)
