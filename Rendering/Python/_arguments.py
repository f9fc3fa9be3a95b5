# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Arguments of the functions are checked here."""

import math
import numbers


def class_name(argument):
    """That of VTK, which classes of newer VTK override in Python, or of Python."""
    return getattr(argument, "GetClassName", lambda: type(argument).__name__)()


def checked(argument, expected):
    if not isinstance(argument, expected):
        raise TypeError(f"expected a {expected.__name__}, found {class_name(argument)}")
    return argument


def check_names(arguments, known):
    for name in arguments:
        if name not in known:
            raise TypeError(f"unknown parameter {name!r}; there are {', '.join(known)}")


def finite_pair(name, value):
    message = f"{name}: expected two finite numbers, found {value!r}"
    try:
        ends = list(value)
    except TypeError:
        raise TypeError(message) from None
    if not all(isinstance(end, numbers.Real) for end in ends):
        raise TypeError(message)
    try:
        ends = tuple(map(float, ends))
    except OverflowError:
        raise ValueError(message) from None
    if len(ends) != 2 or not all(map(math.isfinite, ends)):
        raise ValueError(message)
    return ends


def set_parameters(target, parameters, known):
    check_names(parameters, known)
    for name, value in parameters.items():
        member = name.title().replace("_", "")
        getattr(target, "Set" + member)(value)
        if getattr(target, "Get" + member)() != value:
            least, most = (
                getattr(target, f"Get{member}{end}Value", lambda: None)()
                for end in ("Min", "Max"))
            if least is None:
                expected = "True or False"
            else:
                expected = f"{least:g} to {most:g}" if most < 1e30 else f"{least:g} or more"
            raise ValueError(f"{name}: expected {expected}, found {value!r}")
