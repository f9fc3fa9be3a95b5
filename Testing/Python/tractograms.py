# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The bytes of small tractogram files, valid ones and, by their options, wrong ones."""

import io
import json
import math
import struct
import zipfile

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


def tck(lines, datatype="Float32LE", end=True, **header):
    """An MRtrix tracks file. `header`: entries that differ from the defaults; None: left out."""
    entries = {"datatype": datatype, "count": len(lines), "file": ". 128"}
    entries.update(header)
    text = "mrtrix tracks    \n"
    text += "".join(f"{key}: {value}\n" for key, value in entries.items() if value is not None)
    letter = (">" if datatype.endswith("BE") else "<") + ("3d" if "64" in datatype else "3f")
    rows = []
    for line in lines:
        rows += [*line, (math.nan,) * 3]
    if end:
        rows.append((math.inf,) * 3)
    content = (text + "END\n").encode().ljust(128, b"\0")
    return content + b"".join(struct.pack(letter, *row) for row in rows)


LETTERS = {
    "int8": "b", "int16": "h", "int32": "i", "int64": "q", "uint8": "B", "uint16": "H",
    "uint32": "I", "uint64": "Q", "float16": "e", "float32": "f", "float64": "d", "bit": "?",
}


def trx_entries(lines, arrays=None, point_type="float32", offset_type="uint32", last=False,
                **header):
    """The files of a TRX tractogram, by their names.

    `arrays`: by name, such as "dpv/fa.float16", all values. `last`: the offsets end with the number
    of points. `header`: values of header.json that differ from the defaults; None: left out.
    """
    points = [value for line in lines for row in line for value in row]
    offsets = [sum(map(len, lines[:line])) for line in range(len(lines) + last)]
    values = {
        "VOXEL_TO_RASMM": [IDENTITY[row:row + 4] for row in range(0, 16, 4)],
        "DIMENSIONS": [10, 20, 30], "NB_STREAMLINES": len(lines), "NB_VERTICES": len(points) // 3,
    }
    values.update(header)
    entries = {
        "header.json": json.dumps(
            {key: value for key, value in values.items() if value is not None}).encode(),
    }
    for name, content in {f"positions.3.{point_type}": points, f"offsets.{offset_type}": offsets,
                          **(arrays or {})}.items():
        entries[name] = struct.pack(f"<{len(content)}{LETTERS[name.split('.')[-1]]}", *content)
    return entries


def zip_of(entries, compression=zipfile.ZIP_STORED):
    """A zip archive; an entry named "NAME/" is a folder."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", compression) as archive:
        for name, value in entries.items():
            archive.writestr(name, value)
    return content.getvalue()


def trx(lines, arrays=None, compression=zipfile.ZIP_STORED, **options):
    """A TRX archive: see trx_entries()."""
    return zip_of(trx_entries(lines, arrays, **options), compression)
