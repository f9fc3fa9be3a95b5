# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of the functions are checked here."""

import math
import numbers
import sys
import warnings

import numpy
from vtkmodules.vtkCommonCore import vtkObjectBase

# Names of PyVista, of Matplotlib and of the papers' equations, by what they are called here.
OTHER_NAMES = {
    "radius": ("line_width", "point_size"),
    "color": ("colour",),
    "opacity": ("alpha",),
    "occlusion_weight": ("q",),
    "clutter_weight": ("r",),
    "emphasis": ("lambda", "lambda_", "lam"),
    "smoothing_iterations": ("s",),
    "importance_weight": ("m",),
    "coverage_weight": ("c",),
    "directional_variance_weight": ("v",),
    "depth_weight": ("d",),
    "importance_exponent": ("lambda", "lambda_", "lam"),
}
# What PyVista has and the function at hand has not.
HINTS = {
    "render_lines_as_tubes": "leave it out: lines are tubes already, with the radius of add_lines()",
    "render_points_as_spheres": "leave it out: points are balls already, with the radius of add_points()",
    "style": "lines are tubes and points balls; only add_surface() to a PyVista plotter has it",
    "use_transparency": "use opacity, which is 1 - transparency",
}
LARGEST_PICTURE = 65536  # pixels in width and height, as pellucid-render has it


def class_name(argument):
    """That of VTK, which classes of newer VTK override in Python, or of Python."""
    return getattr(argument, "GetClassName", lambda: type(argument).__name__)()


def brief(value):
    """What a message shows of a value."""
    if isinstance(value, numpy.ndarray) and value.ndim:
        return f"an array of {value.dtype.name} of shape {value.shape}"
    if isinstance(value, vtkObjectBase):
        return f"a {class_name(value)}"
    if isinstance(value, (list, tuple)) and len(value) > 8:
        return f"a {class_name(value)} of {len(value)}"
    text = repr(value)
    return text if len(text) <= 80 else f"{text[:60]}... ({class_name(value)})"


def number_of(value):
    """The number that an array without dimensions holds; else just the value."""
    return value[()] if isinstance(value, numpy.ndarray) and not value.ndim else value


def checked(argument, expected):
    if not isinstance(argument, expected):
        raise TypeError(f"expected a {expected.__name__}, found {class_name(argument)}")
    return argument


def check_names(arguments, known):
    for name in arguments:
        if name not in known:
            meant = [ours for ours, others in OTHER_NAMES.items() if name in others and ours in known]
            hint = f"use {meant[0]}" if meant else HINTS.get(name, f"there are {', '.join(known)}")
            raise TypeError(f"unknown parameter {name!r}; {hint}")


def check_choice(name, value, choices):
    if not isinstance(value, str) or value not in list(choices):
        raise ValueError(f"{name}: expected one of {', '.join(choices)}; found {brief(value)}")


def check_string(name, value):
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected a string, found {brief(value)}")


def check_flag(name, value):
    if not isinstance(value, (numbers.Integral, numpy.bool_)) or value not in (0, 1):
        raise TypeError(f"{name}: expected True or False, found {brief(value)}")


def check_number(name, value, least, most=sys.float_info.max, kind=numbers.Real):
    noun = "an integer" if kind is numbers.Integral else "a number"
    limits = f"from {least:g} to {most:g}" if most < 1e30 else f"of at least {least:g}"
    message = f"{name}: expected {noun} {limits}, found {brief(value)}"
    if not isinstance(value, kind):
        raise TypeError(message)
    if not least <= _as_float(value) <= most:
        raise ValueError(message)


def finite_pair(name, value):
    return tuple(map(float, _pair(
        name, value, "finite numbers", numbers.Real, lambda end: math.isfinite(_as_float(end)))))


def size_of_picture(name, value):
    return _pair(name, value, f"integers from 1 to {LARGEST_PICTURE}", numbers.Integral,
                 lambda end: not isinstance(end, bool) and 0 < end <= LARGEST_PICTURE)


def set_parameters(target, parameters, known):
    """Set those of an object of VTK, whose own limits hold."""
    check_names(parameters, known)
    for name, value in parameters.items():
        member = name.title().replace("_", "")
        kind = type(getattr(target, "Get" + member)())
        if kind is bool:
            check_flag(name, value)
        else:
            least, most = (getattr(target, f"Get{member}{end}Value")() for end in ("Min", "Max"))
            check_number(name, value, least, most, numbers.Integral if kind is int else numbers.Real)
        getattr(target, "Set" + member)(value)


def warn(message):
    """At the line of the program that called into this package."""
    level, frame = 1, sys._getframe()
    while frame and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    warnings.warn(message, stacklevel=level)


def _as_float(number):
    """That, or NaN where it is too large for one."""
    try:
        return float(number)
    except OverflowError:
        return math.nan


def _pair(name, value, expected, kind, is_valid):
    message = f"{name}: expected two {expected}, found {brief(value)}"
    try:
        ends = tuple(value)
    except TypeError:
        raise TypeError(message) from None
    if not all(isinstance(end, kind) for end in ends):
        raise TypeError(message)
    if len(ends) != 2 or not all(map(is_valid, ends)):
        raise ValueError(message)
    return ends
