#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make pacific.nc: make_pacific.py gfs-pacific.nc

The argument holds 3825 trajectories in Met.3D's layout. Needs netCDF4 and numpy.
"""

import pathlib
import sys

import netCDF4
import numpy

HERE = pathlib.Path(__file__).parent
EVERY = 60  # which trajectories to keep, besides those that rise most
LEAST_RISE = 500  # hPa
POSITION = ("ensemble", "trajectory", "time")


def main(name):
    source = netCDF4.Dataset(name)
    pressure = source["pressure"][0]
    rise = pressure.max(axis=1) - pressure.min(axis=1)
    kept = numpy.flatnonzero((rise > LEAST_RISE) | (numpy.arange(len(rise)) % EVERY == 0))

    with netCDF4.Dataset(HERE / "pacific.nc", "w") as target:
        target.setncatts({key: source.getncattr(key) for key in source.ncattrs()})
        target.createDimension("time", len(source.dimensions["time"]))
        target.createDimension("trajectory", len(kept))
        target.createDimension("ensemble", 1)
        for variable in source.variables.values():
            attributes = {key: variable.getncattr(key) for key in variable.ncattrs()}
            is_position = variable.dimensions == POSITION
            copy = target.createVariable(
                variable.name, variable.dtype, variable.dimensions, zlib=is_position, complevel=9,
                fill_value=attributes.pop("_FillValue", None))
            copy.setncatts(attributes)
            values = variable[:, kept] if is_position else variable[:]
            if variable.name == "lon":
                values = numpy.ma.where(values > 180, values - 360, values)
            copy[:] = values


if __name__ == "__main__":
    main(*sys.argv[1:])
