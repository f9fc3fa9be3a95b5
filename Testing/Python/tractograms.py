# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The bytes of small tractogram files, valid ones and, by their options, wrong ones."""

import struct

IDENTITY = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)


def trk(lines, scalars=(), properties=(), line_properties=(), order="<", **header):
    """A TrackVis file.

    `lines`: for each line the rows of its points, (x, y, z, scalars...). `scalars` and `properties`:
    names, where a name may be bytes such as b"color\\0" b"3". `line_properties`: a row for each line.
    `header`: values of the header that differ from the defaults.
    """
    fields = {
        "magic": b"TRACK", "dim": (10, 20, 30), "voxel_size": (1, 1, 1), "origin": (0, 0, 0),
        "n_scalars": len(lines[0][0]) - 3 if lines and lines[0] else 0, "scalar_name": scalars,
        "n_properties": len(line_properties[0]) if line_properties else 0,
        "property_name": properties, "vox_to_ras": IDENTITY, "voxel_order": b"RAS",
        "n_count": len(lines), "version": 2, "hdr_size": 1000,
    }
    fields.update(header)

    def names(values):
        values = [value.encode() if isinstance(value, str) else value for value in values]
        return b"".join(value.ljust(20, b"\0") for value in values)

    content = struct.pack(
        order + "6s3h3f3fh200sh200s16f444x4s4x24x2x6xiii",
        fields["magic"], *fields["dim"], *fields["voxel_size"], *fields["origin"],
        fields["n_scalars"], names(fields["scalar_name"]),
        fields["n_properties"], names(fields["property_name"]),
        *fields["vox_to_ras"], fields["voxel_order"],
        fields["n_count"], fields["version"], fields["hdr_size"])
    for number, line in enumerate(lines):
        content += struct.pack(order + "i", len(line))
        for row in line:
            content += struct.pack(f"{order}{len(row)}f", *row)
        if line_properties:
            row = line_properties[number]
            content += struct.pack(f"{order}{len(row)}f", *row)
    return content
