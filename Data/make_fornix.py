#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Make fornix.trk, every fifth line of dipy's file: make_fornix.py tracks300.trk"""

import pathlib
import struct
import sys

HEADER = 1000
COUNT_AT = 988


def main(source):
    content = pathlib.Path(source).read_bytes()
    lines = []
    place = HEADER
    while place < len(content):
        (points,) = struct.unpack_from("<i", content, place)
        end = place + 4 + 12 * points  # the file has neither scalars nor properties
        lines.append(content[place:end])
        place = end
    kept = lines[::5]
    header = bytearray(content[:HEADER])
    struct.pack_into("<i", header, COUNT_AT, len(kept))
    pathlib.Path(__file__).with_name("fornix.trk").write_bytes(header + b"".join(kept))


if __name__ == "__main__":
    main(*sys.argv[1:])
