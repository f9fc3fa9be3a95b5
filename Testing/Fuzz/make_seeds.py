#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Write the files that the fuzz targets start from: make_seeds.py FOLDER

FOLDER/READER/ gets small valid files for the target of each reader.
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "Python"))

import tractograms  # noqa: E402: the folder that it is in has to be known first

LINES = [[(1, 2, 3), (4, 5, 6)], [(7, 8, 9)]]
LINES_WITH_SCALAR = [[(1, 2, 3, 0.5), (4, 5, 6, 1.5)], [(7, 8, 9, 2.5)]]

SEEDS = {
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
