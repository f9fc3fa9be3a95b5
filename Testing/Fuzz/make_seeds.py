#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the files that the fuzz targets start from: make_seeds.py FOLDER

FOLDER/READER/ gets small valid files for the target of each reader.
"""

import pathlib
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "Python"))

import geographic  # noqa: E402: the folder that they are in has to be known first
import tractograms  # noqa: E402

LINES = [[(1, 2, 3), (4, 5, 6)], [(7, 8, 9)]]
LINES_WITH_SCALAR = [[(1, 2, 3, 0.5), (4, 5, 6, 1.5)], [(7, 8, 9, 2.5)]]

# Of two trajectories each, one across the edge of the map, and with a gap.
LON = [[178.5, 179.5, -179.5, -178.5], [10, 11, -999.99, 13]]
LAT = [[40, 41, 42, 43], [-5, -6, -999.99, -8]]
PRESSURE = [[900, 800, 600, 300], [850, 840, -999.99, 820]]
TEMPERATURE = [[280, 270, 260, 240], [290, 289, 288, 287]]
ROWS = [[[hour, *position] for hour, position in enumerate(zip(lon, lat, pressure))]
        for lon, lat, pressure in zip(LON, LAT, PRESSURE)]

# Those of FuzzTRXEntries.cxx, whose types are in the order of tractograms.LETTERS.
ENTRY_NAMES = ["positions.3.", "offsets.", "dpv/a.", "dpv/b.2.", "dps/a.", "dps/b.3.", "groups/a.",
               "groups/b.", "dpg/a/b.", "dpg/a/b.2.", "header.", "c."]

ARRAYS = {
    "dpv/a.float16": [0.5, 1.5, 2.5],
    "dps/b.3.uint8": [1, 2, 3, 4, 5, 6],
    "groups/a.uint32": [0, 1],
    "dpg/a/b.float32": [0.5],
}


def choose_entries(lines, arrays):
    """What makes FuzzTRXEntries.cxx write this archive.

    It takes the contents from the beginning, and a byte for each choice from the end.
    """
    entries = tractograms.trx_entries(lines, arrays)
    del entries["header.json"]
    points = sum(map(len, lines))
    contents = b""
    choices = [0, 1, len(lines) + 1, points + 1, len(entries)]
    for name, content in entries.items():
        kind = name.split(".")[-1]
        choices += [ENTRY_NAMES.index(name[:-len(kind)]), list(tractograms.LETTERS).index(kind),
                    len(content)]
        contents += content
    return contents + bytes(reversed(choices))


def with_properties(files):
    """The files, each with the properties' defaults and with others behind it.

    FuzzReader.cxx takes a byte from the end for each property, two for the central
    longitude: 1, 104 for 0 degrees.
    """
    choices = {
        "default": [0, 0, 0, 0, 1, 104, 0],
        "cut": [0, 0, 0, 1, 1, 104, 1],
        "height": [0, 1, 2, 0, 1, 104, 0],
    }
    return {f"{choice}-{name}": content + bytes(reversed(properties))
            for name, content in files.items() for choice, properties in choices.items()}


SEEDS = {
    "vtkLagrantoNetCDFReader": with_properties({
        "plain.nc": geographic.lagranto_netcdf(LON, LAT, PRESSURE, range(4)),
        "traced.nc": geographic.lagranto_netcdf(
            LON, LAT, PRESSURE, range(4), {"T": TEMPERATURE}, {"ref_year": ("i", [2011])}),
    }),
    "vtkLagrantoReader": with_properties({
        "plain.lsl": geographic.lagranto_text(ROWS),
        "old.lsl": geographic.lagranto_text(ROWS, title="time period 2006 131 18 UTC -120.00 h"),
    }),
    "vtkMet3DReader": with_properties({
        "plain.nc": geographic.met3d(LON, LAT, PRESSURE),
        "members.nc": geographic.met3d(
            [LON, LON], [LAT, LAT], [PRESSURE, PRESSURE], version=2,
            extra={"temperature": ("f", None, [TEMPERATURE] * 2, {"auxiliary_data": "yes"})}),
        "doubles.nc": geographic.met3d(LON, LAT, PRESSURE, kind="d", version=5),
        "height.nc": geographic.met3d(
            LON, LAT, None, {"z": ("f", None, PRESSURE, {"units": "km"})}),
    }),
    "vtkTRXReaderEntries": {"entries": choose_entries(LINES, ARRAYS)},
    "vtkMRtrixTracksReader": {
        "float.tck": tractograms.tck(LINES),
        "double.tck": tractograms.tck(LINES, datatype="Float64BE"),
    },
    "vtkTRXReader": {
        "stored.trx": tractograms.trx(LINES, ARRAYS),
        "deflated.trx": tractograms.trx(
            LINES, ARRAYS, compression=zipfile.ZIP_DEFLATED, offset_type="uint64", last=True),
        "equal-names.trx": tractograms.trx(
            [], {f"dpv/a.{components}.uint8": [] for components in range(1, 500)}),
    },
    "vtkTrackVisReader": {
        "plain.trk": tractograms.trk(LINES),
        "arrays.trk": tractograms.trk(
            LINES_WITH_SCALAR, scalars=["FA"], properties=["id"], line_properties=[[1], [2]]),
        "big-endian.trk": tractograms.trk(LINES, order=">", n_count=0, voxel_order=b"LPS"),
    },
}


def main(folder):
    for reader, files in SEEDS.items():
        target = pathlib.Path(folder, reader)
        target.mkdir(parents=True, exist_ok=True)
        for name, content in files.items():
            (target / name).write_bytes(content)


if __name__ == "__main__":
    main(*sys.argv[1:])
