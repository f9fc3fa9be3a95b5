# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Opacity that follows from importance: optimize, avoid, restore."""

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkPolyData
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer

from ._arguments import check_choice, checked, class_name, finite_pair, set_parameters, warn
from ._geometry import check_scalar_array, leaves_of, scalars_of_points
from .vtkPellucidFilters import vtkSurfaceSegments, vtkTrajectorySegments
from .vtkPellucidRendering import (
    vtkImportanceDrivenOpacity,
    vtkOcclusionAvoidance,
    vtkOpacityOptimization,
    vtkTrajectoryMapper,
    vtkTransparencyInstaller,
)


OPTIMIZATION_PARAMETERS = (
    "occlusion_weight", "clutter_weight", "emphasis", "smoothing_iterations", "self_occlusion")


def presets():
    """The names of the settings that optimize() takes, the default first."""
    return [vtkOpacityOptimization.GetPresetName(i)
            for i in range(vtkOpacityOptimization.GetNumberOfPresets())]


def optimize(actor, preset="clear-front", importance="Importance", importance_range=(0.0, 1.0),
             **parameters):
    """Fade an actor where it hides, or clutters, what is more important.

    actor: vtkActor of a renderer that install() has made exact, as add_lines(), add_points() and
        add_surface() return. Lines and points need a vtkTrajectoryMapper, surfaces that or a
        vtkPolyDataMapper; the vtkDataSetMapper of PyVista's `add_mesh` is none.
    preset: one of presets(). The smoothing of presets is for lines; surfaces take 5 steps of it at
        most.
    importance: name of a point array of one component: any, or one that vtkImportance makes.
    importance_range: the values of that array that mean importance 0 and 1. Where the first is the
        greater one, small values are important.
    parameters: over the preset: occlusion_weight (q), clutter_weight (r), emphasis (lambda),
        smoothing_iterations (s) and self_occlusion, as vtkOpacityOptimization has them.

    Data without segments gets them: a vtkTrajectorySegments or vtkSurfaceSegments takes its place
    between the actor's mapper and what the mapper was connected to. For a vtkTrajectoryMapper data that is
    still empty counts as lines.

    Returns the vtkOpacityOptimization; actors whose data has segments can have the same by `Attach`.
    restore() ends it, and takes the segments from all actors with the same mapper.
    Raises ValueError or TypeError, and changes nothing, where an argument is wrong. Warns where values
    that differ all mean the same importance, or all are NaN. Equal values let an actor give way, or stay,
    as a whole, and are warned of only where the range has equal ends, too.
    """
    optimization = make_optimization(
        actor, preset=preset, importance=importance, importance_range=importance_range, **parameters)
    warn_of_even_importance(_own_input(actor.GetMapper()), optimization)
    attach_optimization(actor, optimization)
    return optimization


def make_optimization(actor, *, preset, importance, importance_range, **parameters):
    """That of optimize(), which the actor can have by attach_optimization(); changes nothing."""
    optimization = vtkOpacityOptimization()
    check_choice("preset", preset, presets())
    optimization.UsePreset(preset)
    set_parameters(optimization, parameters, OPTIMIZATION_PARAMETERS)
    optimization.SetImportanceRange(*finite_pair("importance_range", importance_range))
    _check_importance(actor, importance)
    optimization.SetImportanceArray(importance)
    _check_kind(actor.GetMapper())
    if not _draws_lines(actor.GetMapper()) and "smoothing_iterations" not in parameters:
        for_surfaces = vtkOpacityOptimization()
        for_surfaces.UsePreset(preset, True)
        optimization.SetSmoothingIterations(for_surfaces.GetSmoothingIterations())
    return optimization


def attach_optimization(actor, optimization):
    """With segments, where the data has none."""
    mapper = actor.GetMapper()
    draws_lines = _draws_lines(mapper)
    if (draws_lines or _has_surfaces(mapper)) and not _has_segments(mapper):
        segments = vtkTrajectorySegments() if draws_lines else vtkSurfaceSegments()
        segments._pellucid_inserted = True
        segments.SetInputConnection(mapper.GetInputConnection(0, 0))
        mapper.SetInputConnection(segments.GetOutputPort())
    vtkImportanceDrivenOpacity.Attach(actor, optimization)


def avoid(actor, mode="penalty", importance="Importance", importance_range=(0.0, 1.0),
          **parameters):
    """Fade an actor by what else is in each pixel; cheaper than optimize(), and needs more care.

    actor: vtkActor with a mapper as optimize() has it.
    mode: "penalty", one factor on all that is in front of the most important thing, or "weighting".
    importance, importance_range: a point array and two of its values, as optimize() has them.
    parameters: penalty, importance_weight, coverage_weight, directional_variance_weight,
        depth_weight, importance_exponent, global_opacity and smooth_attributes, as vtkOcclusionAvoidance has
        them.

    Returns the vtkOcclusionAvoidance; other actors can have the same by `Attach`. restore() ends it.
    Raises ValueError or TypeError, and changes nothing, where an argument is wrong; warns as optimize().
    """
    avoidance = vtkOcclusionAvoidance()
    modes = {"penalty": avoidance.PENALTY, "weighting": avoidance.WEIGHTING}
    check_choice("mode", mode, modes)
    avoidance.SetMode(modes[mode])
    set_parameters(avoidance, parameters, (
        "penalty", "importance_weight", "coverage_weight", "directional_variance_weight",
        "depth_weight", "importance_exponent", "global_opacity", "smooth_attributes"))
    avoidance.SetImportanceRange(*finite_pair("importance_range", importance_range))
    _check_importance(actor, importance)
    avoidance.SetImportanceArray(importance)
    warn_of_even_importance(_own_input(actor.GetMapper()), avoidance)
    vtkImportanceDrivenOpacity.Attach(actor, avoidance)
    return avoidance


def restore(actor):
    """Give an actor its own opacity back, and its mapper the connection that optimize() changed.

    Other actors with the same mapper then lack the segments too: optimize() them again, or give each actor
    a mapper of its own.
    """
    vtkImportanceDrivenOpacity.Attach(checked(actor, vtkActor), None)
    mapper = actor.GetMapper()
    segments = mapper.GetInputAlgorithm() if mapper else None
    if hasattr(segments, "_pellucid_inserted"):
        mapper.SetInputConnection(segments.GetInputConnection(0, 0))


def optimized_opacities(renderer, actor):
    """The opacities that an actor was last drawn with.

    renderer: vtkRenderer that has rendered the actor.

    Returns an array of float32 with one value in [0, 1] for each segment of the actor's data, in the
    order of its segment numbers, and NaN for a segment that no pixel has shown. Raises ValueError
    where the last frame has optimised nothing for this actor.
    """
    transparency = vtkTransparencyInstaller.GetPass(checked(renderer, vtkRenderer))
    found = transparency and transparency.GetOptimizedOpacities(checked(actor, vtkActor))
    if not found:
        raise ValueError("expected an actor whose opacities the last frame has optimised; see optimize()")
    opacities = vtk_to_numpy(found).copy()
    opacities[opacities < 0] = numpy.nan
    return opacities


def warn_of_even_importance(data, opacity):
    """Where values that differ, or are no numbers, are all of the same importance.

    Equal numbers are left alone unless their range has equal ends too: they let an actor give way as a
    whole.
    """
    name, (low, high) = opacity.GetImportanceArray(), opacity.GetImportanceRange()
    values = scalars_of_points(data, name)
    known = values[~numpy.isnan(values)]
    ends = (known.min(), known.max()) if len(known) else ()
    levels = {_importance_of(end, low, high) for end in ends}
    if len(known) < len(values):
        levels.add(0.0)
    if len(levels) == 1 and (not ends or low == high or ends[0] < ends[1]):
        expected = f"on both sides of importance_range {low:g}" if low == high else (
            f"that differ within importance_range ({low:g}, {high:g})")
        found, advice = ("them from {:g} to {:g}".format(*ends), "other limits or another array") if ends else (
            "NaN alone", "another array")
        warn(f"importance is {levels.pop():g} everywhere in this actor, so that within it nothing fades in favour "
             f"of anything else; expected values of {name!r} {expected}, found {found}; choose {advice}")


def _importance_of(value, low, high):
    """As vtkImportanceDrivenOpacity defines it."""
    return float(value >= low) if low == high else min(max((value - low) / (high - low), 0.0), 1.0)


def _own_input(mapper):
    """Without the segments, which would take their time here."""
    algorithm = mapper.GetInputAlgorithm()
    return algorithm.GetInputDataObject(0, 0) if hasattr(algorithm, "_pellucid_inserted") else _input(mapper)


def _input(mapper):
    mapper.GetInputAlgorithm().Update()
    data = mapper.GetInputDataObject(0, 0)
    return data if isinstance(data, vtkCompositeDataSet) else checked(data, vtkPolyData)


def _check_importance(actor, importance):
    mapper = checked(actor, vtkActor).GetMapper()
    if not mapper or not mapper.GetNumberOfInputConnections(0):
        raise ValueError("the actor has no mapper with an input")
    is_composite = isinstance(mapper.GetInputDataObject(0, 0), vtkCompositeDataSet)
    if not isinstance(mapper, vtkTrajectoryMapper if is_composite else vtkPolyDataMapper):
        raise TypeError("expected a vtkTrajectoryMapper, or a vtkPolyDataMapper of one vtkPolyData, "
                        f"found a {class_name(mapper)}; pellucid.add_surface(), add_lines() and "
                        "add_points() add data with such a mapper, where PyVista's add_mesh() does not")
    check_scalar_array(_input(mapper), "importance", importance)


def _has_segments(mapper):
    return hasattr(mapper.GetInputAlgorithm(), "_pellucid_inserted") or any(
        leaf.GetPointData().HasArray(name)
        for leaf in leaves_of(_input(mapper)) for name in ("SegmentBase", "SegmentIds"))


def _has_lines(mapper):
    return any(leaf.GetNumberOfLines() + leaf.GetNumberOfVerts() for leaf in leaves_of(_input(mapper)))


def _has_surfaces(mapper):
    return any(leaf.GetNumberOfPolys() + leaf.GetNumberOfStrips() for leaf in leaves_of(_input(mapper)))


def _draws_lines(mapper):
    """Or points; or, as long as the data is empty, may do so."""
    return _has_lines(mapper) or (not _has_surfaces(mapper) and isinstance(mapper, vtkTrajectoryMapper))


def _check_kind(mapper):
    if _has_lines(mapper) and not _has_segments(mapper):
        if not isinstance(mapper, vtkTrajectoryMapper):
            raise TypeError("lines and points: expected a vtkTrajectoryMapper, found a "
                            f"{class_name(mapper)}; add_lines() and add_points() make one")
        if _has_surfaces(mapper):
            raise ValueError("the actor has both lines or points and surfaces; give each of them an "
                             "actor of its own")
