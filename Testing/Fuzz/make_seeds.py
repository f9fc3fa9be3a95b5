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

import tractograms  # noqa: E402: the folder that it is in has to be known first

LINES = [[(1, 2, 3), (4, 5, 6)], [(7, 8, 9)]]
LINES_WITH_SCALAR = [[(1, 2, 3, 0.5), (4, 5, 6, 1.5)], [(7, 8, 9, 2.5)]]

ARRAYS = {
    "dpv/fa.float16": [0.5, 1.5, 2.5],
    "dps/color.3.uint8": [1, 2, 3, 4, 5, 6],
    "groups/all.uint32": [0, 1],
    "dpg/all/mean.float32": [0.5],
}

SEEDS = {
    "vtkMRtrixTracksReader": {
        "float.tck": tractograms.tck(LINES),
        "double.tck": tractograms.tck(LINES, datatype="Float64BE"),
    },
    "vtkTRXReader": {
        "stored.trx": tractograms.trx(LINES, ARRAYS),
        "deflated.trx": tractograms.trx(
            LINES, ARRAYS, compression=zipfile.ZIP_DEFLATED, offset_type="uint64", last=True),
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
