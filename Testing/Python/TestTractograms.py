#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Pellucid contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Readers of tractograms, on files made here, whose content is known, and on damaged ones."""

import math
import pathlib
import resource
import struct
import sys
import time
import unittest
import zipfile

import numpy
import readers
import tractograms
from tractograms import tck, trk, trx, trx_entries, zip_of
from vtkmodules.test.Testing import VTK_DATA_ROOT, VTK_TEMP_DIR
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray

from pellucid import (
    vtkMRtrixTracksReader,
    vtkTrackVisReader,
    vtkTrajectoryReaderFactory,
    vtkTRXReader,
)

LINES = [[(1, 2, 3), (4, 5, 6)], [(7, 8, 9)], [(10, 11, 12), (13, 14, 15), (16, 17, 18)]]
POINTS = numpy.arange(1, 19).reshape(6, 3)
WITH_EMPTY_LINE = [LINES[0], [], LINES[1]]


def write(content, name):
    path = pathlib.Path(VTK_TEMP_DIR, name)
    path.write_bytes(content)
    return str(path)


def write_folder(entries, name):
    for entry, content in entries.items():
        path = pathlib.Path(VTK_TEMP_DIR, name, entry)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    return str(pathlib.Path(VTK_TEMP_DIR, name))


def arrays_of(data):
    """Every array as numpy array, by name."""
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in arrays}


def lines_of(output):
    """The point ids of every line."""
    cells = output.GetLines()
    offsets = vtk_to_numpy(cells.GetOffsetsArray())
    ids = vtk_to_numpy(cells.GetConnectivityArray())
    return [list(ids[a:b]) for a, b in zip(offsets, offsets[1:])]


class TestCase(readers.TestCase):
    reader = None

    def read(self, content):
        """The output of a file that gives no message."""
        reader = self.reader()
        output, messages = readers.read(reader, content)
        self.assertEqual(messages, [])
        self.assertEqual(reader.CanReadFile(reader.GetFileName()), 1)
        return output

    def expect(self, content, message):
        """One error that says `message`, and an empty output."""
        reader = self.reader()
        self.assert_error(reader, content, message)
        self.assertNotEqual(reader.GetErrorCode(), 0)

    def warn(self, content, message):
        """The output of a file that gives one warning."""
        output, messages = readers.read(self.reader, content)
        self.assertEqual([event for event, _ in messages], ["WarningEvent"], messages)
        self.assertIn(message, messages[0][1])
        return output

    def expect_points(self, output, points=POINTS):
        coordinates = output.GetPoints().GetData()
        numpy.testing.assert_array_equal(vtk_to_numpy(coordinates), points)
        self.assertEqual(coordinates.GetInformation().Get(vtkDataArray.UNITS_LABEL()), "mm")

    def expect_lines(self, output):
        """LINES, whole."""
        self.expect_points(output)
        self.assertEqual(lines_of(output), [[0, 1], [2], [3, 4, 5]])
        self.assertEqual(list(arrays_of(output.GetCellData())["TrajectoryId"]), [0, 1, 2])

    def expect_truncations(self, content, first=1):
        """An error and nothing else, wherever the file is cut off."""
        for length in range(first, len(content), max(1, len(content) // 150)):
            with self.subTest(length=length):
                self.expect(content[:length], "")


class TestTrackVis(TestCase):
    reader = vtkTrackVisReader

    # World = voxel-millimetres minus half a voxel, with the matrix of trk().
    CORNER = POINTS - 0.5

    def test_lines(self):
        for order in "<>":
            for count in (3, 0):
                output = self.read(trk(LINES, order=order, n_count=count))
                self.expect_points(output, self.CORNER)
                self.assertEqual(lines_of(output), [[0, 1], [2], [3, 4, 5]])

    def test_without_matrix(self):
        self.expect_lines(self.read(trk(LINES, version=1)))
        self.expect_lines(self.read(trk(LINES, vox_to_ras=(0,) * 16)))

    def test_matrix(self):
        matrix = (2, 0, 0, 100, 0, 3, 0, 200, 0, 0, 4, 300, 0, 0, 0, 1)
        options = {"voxel_size": (2, 3, 4), "vox_to_ras": matrix}
        voxel = (0.5 * 2, 1.5 * 3, 2.5 * 4)  # the centre of voxel (0, 1, 2)
        for voxel_order, expected in (
                (b"RAS", (100, 203, 308)),
                (b"LAS", (100 + 9 * 2, 203, 308)),
                (b"", (100 + 9 * 2, 200 + 18 * 3, 308)),  # LPS
                (b"ras", (100, 203, 308)),
                (b"RAI", (100, 203, 300 + 27 * 4))):
            output = self.read(trk([[voxel]], voxel_order=voxel_order, **options))
            self.expect_points(output, [expected])
        # Voxel (0, 1, 2) of a file whose axes are up, right and back, is (1, 19 - 2, 0) of the matrix:
        # the length of an axis counts in the order of the file.
        output = self.read(trk([[voxel]], voxel_order=b"SRP", dim=(30, 10, 20), **options))
        self.expect_points(output, [(102, 200 + 17 * 3, 300)])

    def test_arrays(self):
        lines = [[(*row, *row, 0.5) for row in line] for line in LINES]
        output = self.read(trk(
            lines, scalars=[b"xyz\x003", "FA"], properties=["id", "", "size"],
            line_properties=[[1, 2, 3, 4, 5], [6, 7, 8, 9, 10], [11, 12, 13, 14, 15]]))
        self.expect_points(output, self.CORNER)
        points = arrays_of(output.GetPointData())
        numpy.testing.assert_array_equal(points["xyz"], POINTS)
        numpy.testing.assert_array_equal(points["FA"], [0.5] * 6)
        cells = arrays_of(output.GetCellData())
        self.assertEqual(list(cells["id"]), [1, 6, 11])
        self.assertEqual(list(cells["properties_1"]), [2, 7, 12])
        self.assertEqual(list(cells["size"]), [3, 8, 13])
        self.assertEqual(cells["properties"].tolist(), [[4, 5], [9, 10], [14, 15]])
        self.assertEqual(len(points) + len(cells), 2 + 5)

    def test_names(self):
        rows = [[(0, 0, 0, 1, 2, 3)]]
        names = arrays_of(self.read(trk(rows, scalars=["a", "a", b"\xb5"])).GetPointData())
        self.assertEqual(list(names), ["a", "a_2", "\u00b5"])
        names = arrays_of(self.read(trk(rows)).GetPointData())
        self.assertEqual(names["scalars"].tolist(), [[1, 2, 3]])

    def test_empty_lines(self):
        output = self.read(trk(WITH_EMPTY_LINE, line_properties=[[1], [2], [3]], properties=["id"]))
        self.assertEqual(lines_of(output), [[0, 1], [2]])
        cells = arrays_of(output.GetCellData())
        self.assertEqual(list(cells["id"]), [1, 3])
        self.assertEqual(list(cells["TrajectoryId"]), [0, 2])
        self.assertEqual(self.read(trk([])).GetNumberOfCells(), 0)

    def test_errors(self):
        for content, message in (
                (b"TRACK" + bytes(995), "expected \"TRACK\" at the beginning and hdr_size 1000"),
                (trk(LINES, magic=b"track"), "this is no TrackVis file"),
                (trk(LINES, hdr_size=1001), "this is no TrackVis file"),
                (trk(LINES, version=4), "expected version 1, 2 or 3 of the format, found 4"),
                (trk(LINES, n_count=-1), "expected n_count of 0 or more, found -1"),
                (trk(LINES, n_count=4), "expected 4 bytes of the number of points of a line at byte"),
                (trk(LINES, n_count=2), "after n_count = 2 lines, found 40 more bytes"),
                (trk(LINES, n_scalars=-1), "expected a number of scalars of 0 or more, found -1"),
                (trk(LINES, n_properties=-2), "expected a number of properties of 0 or more"),
                (trk(LINES, n_scalars=32767), "bytes of the values of a line at byte 1004"),
                (trk(LINES, n_scalars=2, scalars=[b"a\x003"]),
                 "expected names for 2 scalars, found \"a\" with 3 components from number 0"),
                (trk(LINES, voxel_order=b"RLS"), "expected three letters in voxel_order"),
                (trk(LINES, voxel_order=b"R"), "one each of LR, PA and IS, found \"R\""),
                (trk(LINES, voxel_order=b"LAS", dim=(0, 1, 1)), "expected a dim above 0"),
                (trk(LINES, voxel_size=(1, 0, 1)), "expected a voxel_size above 0, found 0"),
                (trk(LINES, voxel_size=(1, math.nan, 1)), "expected a voxel_size above 0"),
                (trk(LINES, vox_to_ras=(0,) * 15 + (1,)), "expected three independent axes"),
                (trk(LINES, vox_to_ras=(math.inf,) * 16), "expected finite elements in vox_to_ras"),
                (trk([LINES[1], [(0, 0, 0), (0, math.nan, 0)]]),
                 "found NaN or infinity at point 1 of line 1"),
                (trk(LINES)[:1000] + struct.pack("<i", -1) + bytes(92),
                 "expected a number of points of 0 or more in line 0, found -1"),
                (trk(LINES)[:1000] + struct.pack("<i", 2**31 - 1) + bytes(92),
                 "expected 25769803764 bytes of the values of a line"),
                (b"", "the file is empty")):
            with self.subTest(message=message):
                self.expect(content, message)

    def test_truncation(self):
        self.expect_truncations(trk(LINES))
        self.expect_truncations(trk(LINES, n_count=0)[:-1], first=1025)

    def test_sample(self):
        output = self.read(str(pathlib.Path(VTK_DATA_ROOT, "fornix.trk")))
        self.assertEqual((output.GetNumberOfLines(), output.GetNumberOfPoints()), (60, 3128))


class TestMRtrixTracks(TestCase):
    reader = vtkMRtrixTracksReader

    def test_lines(self):
        for datatype, data_type in (("Float32LE", "float"), ("Float32BE", "float"),
                                    ("Float64LE", "double"), ("float64be", "double"),
                                    ("Float32", "float")):
            content = tck(LINES, datatype=datatype.replace("be", "BE"))
            output = self.read(content.replace(b"Float64BE", datatype.encode()))
            self.expect_lines(output)
            self.assertEqual(output.GetPoints().GetData().GetDataTypeAsString(), data_type)

    def test_header(self):
        self.expect_lines(self.read(tck(LINES, count=None)))
        self.expect_lines(self.read(tck(LINES, count="0000003", step_size="0.5: 1", roi="a b")))
        self.expect_lines(self.read(tck(LINES).replace(b"mrtrix tracks    ", b"mrtrix tracks\r   ")))

    def test_empty_and_unfinished_lines(self):
        output = self.read(tck(WITH_EMPTY_LINE))
        self.assertEqual(lines_of(output), [[0, 1], [2]])
        self.assertEqual(list(arrays_of(output.GetCellData())["TrajectoryId"]), [0, 2])
        content = tck(LINES)  # the last line ends with the file
        self.expect_lines(self.read(content[:-24] + content[-12:]))
        self.assertEqual(self.read(tck([])).GetNumberOfPoints(), 0)

    def test_warnings(self):
        self.expect_lines(self.warn(tck(LINES, count=4), "its header counts 4 lines, but there are 3"))
        self.expect_lines(self.warn(tck(LINES) + b"more", "4 bytes behind the end of the lines"))

    def test_errors(self):
        lines = [LINES[0], [(0, 0, math.nan)]]
        for content, message in (
                (b"mrtrix track scalars\nEND\n", "this is no MRtrix tracks file"),
                (b"mrtrix tracks\ndatatype: Float32LE\n", "expected a line \"END\" after the header"),
                (tck(LINES, datatype="Int8"), "expected \"datatype: Float32LE\""),
                (tck(LINES, datatype="Float32XE"), "Float64BE in the header, found \"Float32XE\""),
                (tck(LINES, file=None), "expected \"file: . OFFSET\" in the header"),
                (tck(LINES, file="other.dat 0"), "found \"other.dat 0\""),
                (tck(LINES, file="."), "expected the offset of the numbers"),
                (tck(LINES, file=". -4"), "found \"-4\""),
                (tck(LINES, file=". 10"), "expected numbers behind the header"),
                (tck(LINES, file=". 9999999999999999999"), "of the header and what follows it"),
                (tck(LINES, count="many"), "expected a number of lines in \"count\", found \"many\""),
                (tck(lines), "found a mixture of them in row 3"),
                (tck(LINES, end=False), "expected a row of infinities at the end, found the end of "
                                        "the file after 3 lines"),
                (b"", "the file is empty")):
            with self.subTest(message=message):
                self.expect(content, message)

    def test_truncation(self):
        self.expect_truncations(tck(LINES))
        self.expect_truncations(tck(LINES, datatype="Float64BE"))


class TestTRX(TestCase):
    reader = vtkTRXReader

    def test_lines(self):
        for point_type, data_type in (("float16", "float"), ("float32", "float"),
                                      ("float64", "double")):
            for options in ({}, {"compression": zipfile.ZIP_DEFLATED, "offset_type": "uint64"},
                            {"last": True}):
                output = self.read(trx(LINES, point_type=point_type, **options))
                self.expect_lines(output)
                self.assertEqual(output.GetPoints().GetData().GetDataTypeAsString(), data_type)

    def test_folder(self):
        entries = trx_entries(LINES, {"dpv/a.uint8": range(6), "dpg/g/mean.float32": [0.5]})
        output = self.read(write_folder(entries, "folder.trx"))
        self.expect_lines(output)
        self.assertEqual(list(arrays_of(output.GetPointData())["a"]), list(range(6)))
        self.assertEqual(list(arrays_of(output.GetFieldData())["dpg/g/mean"]), [0.5])

    def test_types(self):
        for name in ("int8", "int16", "int32", "int64", "uint8", "uint16", "uint32", "uint64",
                     "float16", "float32", "float64", "bit"):
            low, high = (0, 1) if name == "bit" else (1, 2)
            if name not in ("bit", "float16"):
                limits = numpy.finfo(name) if "float" in name else numpy.iinfo(name)
                low, high = limits.min, limits.max
            values = [low, high, low]
            output = self.read(trx(LINES, {f"dpv/a.2.{name}": values * 4, f"dps/b.{name}": values}))
            point_array = arrays_of(output.GetPointData())["a"]
            self.assertEqual(point_array.shape, (6, 2))
            self.assertEqual(list(point_array.ravel()), values * 4)
            line_array = arrays_of(output.GetCellData())["b"]
            expected = {"bit": "uint8", "float16": "float32"}.get(name, name)
            self.assertEqual((line_array.dtype.name, list(line_array)), (expected, values))

    def test_float16(self):
        halves = [bits for bits in range(0, 2**16, 7)]
        content = struct.pack(f"<{len(halves)}H", *halves)
        entries = trx_entries([[(0, 0, 0)]] * len(halves))
        entries["dps/half.float16"] = content
        values = arrays_of(self.read(zip_of(entries)).GetCellData())["half"]
        with numpy.errstate(invalid="ignore"):
            expected = numpy.frombuffer(content, "<f2").astype("f4")
        numpy.testing.assert_array_equal(values, expected)

    def test_groups(self):
        output = self.read(trx(LINES, {
            "groups/a.uint32": [0, 2], "groups/b.uint8": [], "dpg/a/color.3.uint8": [1, 2, 3],
            "dpg/a/sizes.float64": [4, 5]}))
        cells = arrays_of(output.GetCellData())
        self.assertEqual(list(cells["groups/a"]), [1, 0, 1])
        self.assertEqual(list(cells["groups/b"]), [0, 0, 0])
        fields = arrays_of(output.GetFieldData())
        self.assertEqual(fields["dpg/a/color"].tolist(), [[1, 2, 3]])
        self.assertEqual(fields["dpg/a/sizes"].tolist(), [[4, 5]])
        self.assertEqual(fields["VOXEL_TO_RASMM"].tolist(), [list(tractograms.IDENTITY)])
        self.assertEqual(fields["DIMENSIONS"].tolist(), [[10, 20, 30]])

    def test_empty_lines(self):
        for lines, offsets in ((WITH_EMPTY_LINE, [0, 2, 2]), ([[], *LINES[:1], LINES[1]], [0, 0, 2]),
                               ([LINES[0], LINES[1], []], [0, 2, 3])):
            kept = [number for number, line in enumerate(lines) if line]
            output = self.read(trx(lines, {"dps/a.int64": [5, 6, 7], "groups/g.uint32": [1]}))
            self.assertEqual(lines_of(output), [[0, 1], [2]])
            cells = arrays_of(output.GetCellData())
            self.assertEqual(list(cells["TrajectoryId"]), kept)
            self.assertEqual(list(cells["a"]), [5 + number for number in kept])
            self.assertEqual(list(cells["groups/g"]), [int(number == 1) for number in kept])
        entries = trx_entries([])
        self.assertEqual(self.read(zip_of(entries)).GetNumberOfCells(), 0)
        self.assertEqual(
            self.read(zip_of({"header.json": entries["header.json"]})).GetNumberOfCells(), 0)

    def test_names(self):
        output = self.read(trx(LINES, {
            "dpv/a.uint8": range(6), "dpv/a.float32": range(6), "dpv/b.c.2.int8": range(12),
            "dps/TrajectoryId.uint8": range(3)}))
        self.assertEqual(set(arrays_of(output.GetPointData())), {"a", "a_2", "b.c"})
        self.assertEqual(set(arrays_of(output.GetCellData())), {"TrajectoryId", "TrajectoryId_2"})
        entries = trx_entries(LINES)
        entries.update({"dps/": b"", "dps/algorithm.json": b"{}"})
        self.expect_lines(self.read(zip_of(entries)))
        self.expect_lines(self.read(zip_of({"./" + name: entries[name] for name in entries})))

    def test_many_names(self):
        """Names that are all taken cost little, and there are not too many."""
        def content(count):  # with positions and offsets
            return trx([], {f"dpv/a.{number}.uint8": [] for number in range(1, count - 1)})

        begin = time.monotonic()
        arrays = self.read(content(4096)).GetPointData()
        self.assertLess(time.monotonic() - begin, 10)
        names = [arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())]
        self.assertEqual(set(names), {"a", *(f"a_{number}" for number in range(2, 4095))})
        self.expect(content(4097), "expected at most 4096 arrays in it, found more")

    def test_warnings(self):
        entries = trx_entries(LINES)
        entries.update({"README.txt": b"", "other/a.uint8": b"123"})
        self.expect_lines(self.warn(zip_of(entries), "2 files in it are not of the format and not "
                                                     "read, such as \"README.txt\""))
        count = 4000
        many = {f"groups/{number}.uint32": [] for number in range(200)}
        output = self.warn(trx([[(0, 0, 0)]] * count, many, compression=zipfile.ZIP_DEFLATED),
                           "its 200 groups are not read; for 4000 lines")
        self.assertEqual(output.GetCellData().GetNumberOfArrays(), 1)
        self.assertEqual(output.GetNumberOfLines(), count)

    def test_header_errors(self):
        for header, message in (
                (None, "expected header.json in it, found none"),
                (b"", "expected a JSON object in header.json"),
                (b"[" * 100000, "expected a JSON object in header.json"),
                (b"[1]", "expected a JSON object in header.json"),
                (b"{}", "expected NB_STREAMLINES in header.json, a whole number of 0 or more, found none"),
                (b'{"NB_STREAMLINES": -3}', "of 0 or more, found -3"),
                (b'{"NB_STREAMLINES": 3}', "expected NB_VERTICES in header.json"),
                (b'{"NB_STREAMLINES": 3, "NB_VERTICES": "6"}', "of 0 or more, found string"),
                (b'{"NB_STREAMLINES": 3, "NB_VERTICES": ' + b"[" * 9999 + b"]" * 9999 + b"}",
                 "of 0 or more, found array"),
                (b" " * (2**20 + 1), "expected header.json of at most 1048576 bytes")):
            entries = trx_entries(LINES)
            entries["header.json"] = header
            with self.subTest(message=message):
                self.expect(zip_of({name: entries[name] for name in entries if entries[name] is not None}),
                            message)

    def test_array_errors(self):
        lines, points = {"NB_STREAMLINES": 4}, {"NB_VERTICES": 7}
        for changes, message in (
                (points, "\"positions.3.float32\" in it: expected 7 tuples, which header.json tells, found 6"),
                (lines, "\"offsets.uint32\" in it: expected 4 tuples"),
                ({"NB_STREAMLINES": 2**64 - 1}, "expected 18446744073709551615 tuples"),
                ({"NB_STREAMLINES": 0}, "expected 1 tuples, which header.json tells, found 3"),
                ({"arrays": {"dpv/a.uint8": [1]}}, "\"dpv/a.uint8\" in it: expected 6 tuples"),
                ({"arrays": {"dps/a.2.uint8": [1, 2]}}, "\"dps/a.2.uint8\" in it: expected 3 tuples"),
                ({"arrays": {"dps/a.2.uint8": [1, 2, 3]}}, "expected tuples of 2 bytes, found 3"),
                ({"arrays": {"dps/a.0.uint8": []}}, "expected 1 to 99999 components, found 0"),
                ({"arrays": {"dps/a.4294967297.uint8": []}}, "expected 1 to 99999 components"),
                ({"arrays": {"groups/a.float32": [1]}}, "expected the type an integer"),
                ({"arrays": {"groups/a.int32": [3]}}, "expected ids of lines from 0 to below 3, found 3"),
                ({"arrays": {"groups/a.int32": [-1]}}, "expected ids of lines from 0 to below 3"),
                ({"arrays": {"dpg/a/b.int32": []}}, "expected 1 to 99999 values, found 0 bytes"),
                ({"arrays": {"positions.3.float64": range(18)}},
                 "expected one array \"positions\" in it, found 2"),
                ({"arrays": {"offsets.uint64": range(3)}}, "expected one array \"offsets\" in it"),
                ({"point_type": "int32"}, "expected the type float16, float32 or float64, with 3"),
                ({"offset_type": "int32"}, "expected the type uint32 or uint64, with 1 component")):
            with self.subTest(message=message):
                self.expect(trx(LINES, **changes), message)
        for name, content, message in (
                ("dpv/a", b"", "\"dpv/a\" in it: expected the type int8 to int64"),
                ("dpv/a.float128", b"", "float64 or bit; the end of the name tells it"),
                ("positions.3.float32", None, "expected one array \"positions\" in it, found 0"),
                ("offsets.uint32", None, "expected one array \"offsets\" in it, found 0"),
                ("offsets.uint32", struct.pack("<3I", 1, 2, 3),
                 "expected offsets from 0 to 6 that do not decrease, found 1 at number 0"),
                ("offsets.uint32", struct.pack("<3I", 0, 4, 3), "found 3 at number 2"),
                ("offsets.uint32", struct.pack("<3I", 0, 4, 7), "found 7 at number 2"),
                ("offsets.uint32", struct.pack("<4I", 0, 4, 5, 5), "found 5 at number 3"),
                ("offsets.uint64", struct.pack("<3Q", 0, 2, 2**64 - 1),
                 "found 18446744073709551615 at number 2"),
                ("positions.3.float32", struct.pack("<18f", *range(17), math.inf),
                 "found NaN or infinity at point 2 of line 2")):
            entries = trx_entries(LINES, offset_type="uint64" if name == "offsets.uint64" else "uint32")
            entries[name] = content
            with self.subTest(message=message):
                self.expect(zip_of({name: entries[name] for name in entries if entries[name] is not None}),
                            message)
        entries = trx_entries([], NB_VERTICES=1)
        entries["positions.3.float32"] = bytes(12)
        self.expect(zip_of(entries), "expected no points without lines, found NB_VERTICES 1")

    def test_archive_errors(self):
        content = trx(LINES, {"dpv/a.uint8": range(6)})
        self.expect(b"PK\3\4" + bytes(100), "found a damaged or cut one")
        self.expect(b"zip" + content, "expected a zip archive or a folder, found neither")
        self.expect(write_folder({"a": b""}, "empty.trx"), "expected header.json in it, found none")
        self.expect(trx(LINES, compression=zipfile.ZIP_LZMA), "expected it stored or deflated")
        data = content.index(b"positions.3.float32") + len("positions.3.float32")
        damaged = bytearray(content)
        damaged[data + 20] ^= 1
        self.expect(bytes(damaged), "\"positions.3.float32\" in it: ")
        encrypted = bytearray(content)
        for magic, flags in ((b"PK\3\4", 6), (b"PK\1\2", 8)):
            place = encrypted.index(magic)
            encrypted[place + flags] |= 1
        self.expect(bytes(encrypted), ", encrypted")
        # Sizes in the list at the end and before the data: far more than the archive's length.
        lying = bytearray(content)
        size = struct.pack("<I", 2**31)
        for magic, place in ((b"PK\3\4", 18), (b"PK\1\2", 20)):
            start = lying.index(b"positions", lying.index(magic)) - (30 if place == 18 else 46)
            if place == 20:
                start = lying.rindex(b"positions") - 46
            lying[start + place:start + place + 8] = size * 2
        self.expect(bytes(lying), "bytes, which is more than the archive of")
        twice = {"dpv/a.uint8": range(6), "dpv/b.uint8": range(6)}
        self.expect(trx(LINES, twice).replace(b"dpv/b", b"dpv/a"),
                    "expected \"dpv/a.uint8\" in it once, found it twice")

    def test_changed_folder(self):
        arrays = {"dpv/a.uint8": range(6), "dpv/b.uint8": range(6), "groups/a.uint32": [0]}
        folder = write_folder(trx_entries(LINES, arrays), "changed.trx")
        pathlib.Path(folder, "groups/new.uint32").unlink(missing_ok=True)
        reader = self.reader()

        def change(caller, _):
            if caller.GetProgress() > 0:
                write_folder({"groups/new.uint32": b""}, "changed.trx")

        reader.AddObserver("ProgressEvent", change)
        self.assert_error(reader, folder, "\"groups/new.uint32\" in it was not there")

    def test_truncation(self):
        self.expect_truncations(trx(LINES, {"dps/a.uint8": range(3)}))
        self.expect_truncations(trx(LINES, compression=zipfile.ZIP_DEFLATED))
        entries = trx_entries(LINES)
        for name in entries:
            for length in range(len(entries[name])):
                self.expect(write_folder({**entries, name: entries[name][:length]}, "cut.trx"), "")


class TestRecognition(unittest.TestCase):
    FILES = {vtkTrackVisReader: trk(LINES), vtkMRtrixTracksReader: tck(LINES), vtkTRXReader: trx(LINES)}

    def test_content_decides(self):
        others = (b"", b"PK\3\4", zip_of({"a": b""}), zip_of({"header.json": b"{}"}), b"TRACK",
                  b"mrtrix", b"mrtrix track scalars\nEND\n", bytes(2000))
        for reader in self.FILES:
            for other, content in self.FILES.items():
                self.assertEqual(reader().CanReadFile(write(content, "a.dat")), int(reader is other))
            for content in others:
                self.assertEqual(reader().CanReadFile(write(content, "a.trk")), 0)
            for path in ("", VTK_TEMP_DIR, VTK_TEMP_DIR + "/none", None):
                self.assertEqual(reader().CanReadFile(path), 0)

    def test_folders_are_not_searched(self):
        """Only header.json is looked for, whatever else a folder holds."""
        def seconds(folder):
            def once():
                begin = time.perf_counter()
                self.assertEqual(vtkTRXReader().CanReadFile(folder), int("header" in folder))
                return time.perf_counter() - begin

            return min(once() for _ in range(10))

        entries = {f"dpv/{number}": b"" for number in range(3000)}
        few, many, header = write_folder({"a": b""}, "few"), write_folder(entries, "many"), write_folder(
            {**entries, **trx_entries(LINES)}, "header")
        for folder in (many, header):
            self.assertLess(seconds(folder), 10 * seconds(few) + 1e-3)

    @unittest.skipUnless(sys.platform == "linux", "the limit is not the same elsewhere")
    def test_without_memory(self):
        path = write(zip_of({"header.json": b"[" * 2**20}), "a.trx")
        pages = int(pathlib.Path("/proc/self/statm").read_text(encoding="ascii").split()[0])
        limit, hard = resource.getrlimit(resource.RLIMIT_AS)
        resource.setrlimit(
            resource.RLIMIT_AS, (pages * resource.getpagesize() + 2**23, hard))
        try:
            readable = vtkTRXReader().CanReadFile(path)
        finally:
            resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
        self.assertEqual(readable, 0)

    def test_progress_and_abort(self):
        many = LINES * 400
        for reader, content in ((vtkTrackVisReader(), trk(many)), (vtkMRtrixTracksReader(), tck(many)),
                                (vtkTRXReader(), trx(many))):
            progress = []
            reader.AddObserver("ProgressEvent", lambda caller, _: progress.append(caller.GetProgress()))
            output, messages = readers.read(reader, content)
            self.assertEqual((output.GetNumberOfLines(), messages), (1200, []))
            self.assertEqual(progress, sorted(progress))
            self.assertEqual((progress[0], progress[-1]), (0, 1))
            self.assertLess(len(progress), 110)
            abort = reader.AddObserver("ProgressEvent", lambda caller, _: caller.AbortExecuteOn())
            reader.Modified()
            output, messages = readers.read(reader, content)
            self.assertEqual((output.GetNumberOfLines(), messages), (0, []))
            reader.RemoveObserver(abort)
            reader.AbortExecuteOff()
            reader.Modified()
            self.assertEqual(readers.read(reader, content)[0].GetNumberOfLines(), 1200)

    def test_factory(self):
        for reader, content in self.FILES.items():
            made = vtkTrajectoryReaderFactory.CreateReader(write(content, "a.dat"))
            self.assertIsInstance(made, reader)
            made.Update()
            self.assertEqual(made.GetOutput().GetNumberOfLines(), 3)
            self.assertTrue(made.GetFileExtensions().startswith("."))
            self.assertTrue(made.GetDescriptiveName())


del TestCase
