#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make pacific.nc and pacific-streams.nc: make_pacific.py gfs-pacific.nc

The argument holds 3825 trajectories in Met.3D's layout. Needs netCDF4 and numpy.
"""

import pathlib
import sys

import netCDF4
import numpy

HERE = pathlib.Path(__file__).parent
POSITION = ("ensemble", "trajectory", "time")
DIGITS = {"lon": 2, "lat": 2, "pressure": 1}  # after the point, in the streams


def write(source, name, kept, variables, digits, is_wrapped):
    """Write these trajectories.

    digits: of the variables that are rounded. is_wrapped: longitudes are -180..180, else as they are.
    """
    with netCDF4.Dataset(HERE / name, "w") as target:
        target.setncatts({key: source.getncattr(key) for key in source.ncattrs()})
        target.createDimension("time", len(source.dimensions["time"]))
        target.createDimension("trajectory", len(kept))
        target.createDimension("ensemble", 1)
        for variable in variables:
            attributes = {key: variable.getncattr(key) for key in variable.ncattrs()}
            is_position = variable.dimensions == POSITION
            copy = target.createVariable(
                variable.name, variable.dtype, variable.dimensions, zlib=is_position, complevel=9,
                least_significant_digit=digits.get(variable.name),
                fill_value=attributes.pop("_FillValue", None))
            copy.setncatts(attributes)
            values = variable[:, kept] if is_position else variable[:]
            if variable.name == "lon" and is_wrapped:
                values = numpy.ma.where(values > 180, values - 360, values)
            copy[:] = values


def main(name):
    source = netCDF4.Dataset(name)
    pressure = source["pressure"][0]
    rise = pressure.max(axis=1) - pressure.min(axis=1)

    def keep(least_rise, every):
        """Trajectories that rise by more, in hPa, and some of the others."""
        return numpy.flatnonzero((rise > least_rise) | (numpy.arange(len(rise)) % every == 0))

    write(source, "pacific.nc", keep(500, 60), source.variables.values(), {}, True)
    positions = [source[variable] for variable in ("time", *DIGITS)]
    write(source, "pacific-streams.nc", keep(150, 8), positions, DIGITS, False)


if __name__ == "__main__":
    main(*sys.argv[1:])
