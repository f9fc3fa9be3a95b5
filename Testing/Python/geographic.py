# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Small files of geographic trajectories: NetCDF in the classic formats, and LAGRANTO's text."""

import itertools
import math
import struct

TYPES = {
    "b": (1, ">b"),
    "c": (2, ">c"),
    "h": (3, ">h"),
    "i": (4, ">i"),
    "f": (5, ">f"),
    "d": (6, ">d"),
}


def netcdf(dimensions, variables, attributes=None, version=1, records=None):
    """The bytes of a NetCDF file.

    dimensions: {name: length}; the one that `records` names is the record dimension.
    variables: {name: (type, names of dimensions, flat values, attributes)}, type a key of TYPES.
    attributes: {name: text or (type, numbers)}
    version: 1, 2 or 5, of the format.
    """
    number, offset = (">q", ">q") if version == 5 else (">i", ">i" if version == 1 else ">q")

    def pad(data):
        return data + bytes(-len(data) % 4)

    def integer(value, form=number):
        return struct.pack(form, value)

    def name_of(text):
        return integer(len(text)) + pad(text.encode())

    def list_of(tag, items):
        return integer(tag if items else 0, ">i") + integer(len(items)) + b"".join(items)

    def values_of(kind, numbers):
        return b"".join(struct.pack(TYPES[kind][1], value) for value in numbers)

    def attribute(name, value):
        kind, data = (
            ("c", value.encode()) if isinstance(value, str) else (value[0], values_of(*value))
        )
        count = len(data) // struct.calcsize(TYPES[kind][1])
        return name_of(name) + integer(TYPES[kind][0], ">i") + integer(count) + pad(data)

    def list_of_attributes(items):
        return list_of(12, [attribute(name, value) for name, value in (items or {}).items()])

    def header(begins):
        entries = []
        for (name, (kind, over, _, items)), begin in zip(variables.items(), begins):
            ids = [integer(list(dimensions).index(dimension)) for dimension in over]
            entries.append(
                name_of(name)
                + integer(len(ids))
                + b"".join(ids)
                + list_of_attributes(items)
                + integer(TYPES[kind][0], ">i")
                + integer(sizes[name])
                + integer(begin, offset)
            )
        lengths = [
            name_of(name) + integer(0 if name == records else length)
            for name, length in dimensions.items()
        ]
        return (
            b"CDF"
            + bytes([version])
            + integer(dimensions.get(records, 0))
            + list_of(10, lengths)
            + list_of_attributes(attributes)
            + list_of(11, entries)
        )

    sizes = {}  # of each variable, of one record or of all of it
    blocks = {}
    for name, (kind, over, numbers, _) in variables.items():
        data = values_of(kind, numbers)
        step = struct.calcsize(TYPES[kind][1]) * math.prod(
            dimensions[dimension] for dimension in over if dimension != records
        )
        count = dimensions[records] if records in over else 1
        blocks[name] = [pad(data[i * step : (i + 1) * step]) for i in range(count)]
        sizes[name] = step + -step % 4
    fixed = [name for name in variables if records not in variables[name][1]]
    recorded = [name for name in variables if records in variables[name][1]]

    begins, position = {}, len(header(itertools.repeat(0)))
    for name in fixed + recorded:
        begins[name] = position
        position += sizes[name]
    data = [blocks[name][0] for name in fixed]
    data += [blocks[name][i] for i in range(dimensions.get(records, 0)) for name in recorded]
    return header([begins[name] for name in variables]) + b"".join(data)


def met3d(
    lon,
    lat,
    pressure,
    extra=None,
    time=None,
    order=("ensemble", "trajectory", "time"),
    dimensions=None,
    kind="f",
    pressure_attributes=None,
    **options,
):
    """A file of Met.3D; the coordinates are lists of trajectories, or nested once more by member.

    extra: further variables. dimensions: further dimensions. order: of all three, or without the
    ensemble. The fill value is -999.99.
    """

    def nested(values):
        return values if isinstance(values[0][0], (list, tuple)) else [values]

    def flat(values):
        members = nested(values)
        lengths = {
            "ensemble": len(members),
            "trajectory": len(members[0]),
            "time": len(members[0][0]),
        }
        result = []
        for index in itertools.product(*(range(lengths[name]) for name in order)):
            at = dict(zip(order, index))
            result.append(members[at.get("ensemble", 0)][at["trajectory"]][at["time"]])
        return lengths, result

    lengths, lon = flat(lon)
    fill = {"_FillValue": (kind, [-999.99])}
    variables = {
        "time": (
            "d",
            ("time",),
            range(lengths["time"]) if time is None else time,
            {"units": "hours since 2011-01-15 12:00:00"},
        ),
        "lon": (kind, order, lon, {"units": "degrees_east", **fill}),
        "lat": (kind, order, flat(lat)[1], {"units": "degrees_north", **fill}),
    }
    if pressure:
        variables["pressure"] = (
            kind,
            order,
            flat(pressure)[1],
            {"units": "hPa", **fill, **(pressure_attributes or {})},
        )
    for name, (extra_kind, over, values, items) in (extra or {}).items():
        variables[name] = (
            extra_kind,
            order if over is None else over,
            flat(values)[1] if over is None else values,
            items,
        )
    used = {name: lengths[name] for name in lengths if name in order}
    return netcdf({**used, **(dimensions or {})}, variables, **options)


def lagranto_netcdf(
    lon,
    lat,
    p,
    time,
    extra=None,
    attributes=None,
    names=("ntim", "ntra"),
    time_attributes=None,
    vertical="p",
):
    """A file of LAGRANTO, time-major; the coordinates are lists of trajectories."""

    def flat(values):
        return [trajectory[i] for i in range(len(time)) for trajectory in values]

    variables = {"time": ("f", names[:1], time, time_attributes or {})}
    for name, values in {"lon": lon, "lat": lat, vertical: p, **(extra or {})}.items():
        variables[name] = ("f", names, flat(values), {})
    return netcdf({names[0]: len(time), names[1]: len(lon)}, variables, attributes)


def lagranto_text(
    blocks,
    names=("time", "lon", "lat", "p"),
    title="Reference date 20110123_1030 / Time range   -1440 min",
    end="\n",
):
    """A text of LAGRANTO; blocks of rows, numbers or words."""

    def word(value):
        return value if isinstance(value, str) else "NaN" if math.isnan(value) else f"{value:.3f}"

    lines = [title, "", " ".join(f"{name:>9}" for name in names), "-" * 10 * len(names)]
    for block in blocks:
        lines += [""] + [" ".join(f"{word(value):>9}" for value in row) for row in block]
    return (end.join(lines) + end).encode()
