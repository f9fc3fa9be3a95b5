#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make pacific-streams.nc: make_streams.py gfs-pacific.nc

The argument holds 3825 trajectories in Met.3D's layout. Needs netCDF4 and numpy. Kept are the
positions alone, rounded, of the trajectories that rise, and of some of the others.
"""

import pathlib
import sys

import netCDF4
import numpy

HERE = pathlib.Path(__file__).parent
LEAST_RISE = 150  # hPa
EVERY = 8  # which of the others
DIGITS = {"lon": 2, "lat": 2, "pressure": 1}  # after the point


def main(name):
    source = netCDF4.Dataset(name)
    pressure = source["pressure"][0]
    rise = pressure.max(axis=1) - pressure.min(axis=1)
    kept = numpy.flatnonzero((rise > LEAST_RISE) | (numpy.arange(len(rise)) % EVERY == 0))

    with netCDF4.Dataset(HERE / "pacific-streams.nc", "w") as target:
        target.setncatts({key: source.getncattr(key) for key in source.ncattrs()})
        target.createDimension("time", len(source.dimensions["time"]))
        target.createDimension("trajectory", len(kept))
        target.createDimension("ensemble", 1)
        for variable_name in ("time", *DIGITS):
            variable = source[variable_name]
            attributes = {key: variable.getncattr(key) for key in variable.ncattrs()}
            digits = DIGITS.get(variable_name)
            copy = target.createVariable(
                variable_name, variable.dtype, variable.dimensions, zlib=digits is not None,
                complevel=9, least_significant_digit=digits,
                fill_value=attributes.pop("_FillValue", None))
            copy.setncatts(attributes)
            copy[:] = variable[:, kept] if digits is not None else variable[:]


if __name__ == "__main__":
    main(*sys.argv[1:])
