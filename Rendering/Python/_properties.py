# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties in snake case, as VTK's wrappers have them since 9.4, for wrappers of older tools."""

import re

from vtkmodules.vtkCommonCore import vtkObjectBase


def add_properties(names):
    """Give the VTK classes of a package that lack properties subclasses that have them.

    names: the dict of the package. A subclass takes the place of its class there and, by VTK's
        override, wherever VTK makes or returns an object of it.
    """
    for name, wrapped in list(names.items()):
        if isinstance(wrapped, type) and issubclass(wrapped, vtkObjectBase):
            missing = _missing_properties(wrapped)
            if missing:
                # VTK refuses the name of a class of its own.
                subclass = type(name[len("vtk"):], (wrapped,), {
                    "__doc__": wrapped.__doc__, "__module__": wrapped.__module__,
                    "__init__": _set_properties, **missing})
                wrapped.override(subclass)
                names[name] = subclass


def _missing_properties(wrapped):
    getters = {_snake_case(name[3:]): name[3:] for name in dir(wrapped) if _is_getter(wrapped, name)}
    if any(name in vars(wrapped) for name in getters):
        return {}
    return {name: _property(wrapped, getter) for name, getter in getters.items()}


def _is_getter(wrapped, name):
    """Whether that gets something without arguments, as the wrapper writes it."""
    return bool(re.match("Get[A-Z]", name)
                and re.match(rf"{name}\((self)?\) ->", getattr(wrapped, name).__doc__ or ""))


def _snake_case(name):
    return re.sub("(?<=[a-z])(?=[A-Z])|(?<=.)(?=[A-Z][a-z])", "_", name).lower()


def _property(wrapped, name):
    getter = getattr(wrapped, "Get" + name)
    setter = getattr(wrapped, "Set" + name, None)
    if not setter:
        return property(lambda self: getter(self), doc=f"read-only, Calls Get{name}\n")

    def set_value(self, value):
        setter(self, *(value if isinstance(value, tuple) else (value,)))

    return property(lambda self: getter(self), set_value, doc=f"read-write, Calls Get{name}/Set{name}\n")


def _set_properties(self, **values):
    for name, value in values.items():
        if not isinstance(getattr(type(self), name, None), property):
            raise TypeError(f"Unexpected keyword argument '{name}' for '{self.GetClassName()}' constructor")
        setattr(self, name, value)
